//! Den Hartog's two-stop motion against the orbit.

use frictiongen::System;
use frictiongen_kernel::two_stops::TwoStops;

/// Both over a plane of r and β: where one has two stops so has the other, and they are the same.
#[test]
fn den_hartog() {
    let wall: System = "struct Block {
        masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block,
    }"
    .parse()
    .expect("a scene");
    let mut seen = 0;
    for i in 1..=50 {
        let r = 0.05 * f64::from(i);
        let at = wall.at(r).expect("in the domain");
        for j in 1..40 {
            let beta = 0.025 * f64::from(j);
            let what = format!("r = {r}, β = {beta}");
            let found = TwoStops::new(r, beta);
            let Ok(orbit) = at.orbit(beta) else {
                assert!(found.is_none(), "{what}: {found:?}");
                continue;
            };
            let two = orbit.stops() == 2 && orbit.reversals() == 0;
            assert_eq!(found.is_some(), two, "{what}");
            let Some(found) = found else { continue };
            seen += 1;
            // τ₀ follows from β through a function that may be flat: half the digits at worst.
            let apart = found.amplitude() - orbit.contact().amplitude();
            assert!(apart.abs() < 1e-11, "{what}: {apart:e}");
            let apart = found.stuck_fraction() - orbit.stuck_fraction();
            assert!(apart.abs() < 1e-10, "{what}: {apart:e}");
            let apart = found.phase() - orbit.state().origin();
            assert!(apart.sin().abs() < 1e-10, "{what}: {apart:e}");
        }
    }
    assert!(seen > 500, "{seen}");
}
