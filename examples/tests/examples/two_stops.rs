//! Compares Den Hartog's two-stop motion with the orbit, a steady state with stops.

use frictiongen::System;
use frictiongen_examples::two_stops::TwoStops;

/// Compares both over a grid of r and β. They must find two-stop motions at the same points, with the same values.
#[test]
fn den_hartog() {
    let wall: System = "struct Block {
        masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block,
    }"
    .parse()
    .expect("a scene");
    let (mut seen, mut none, mut other) = (0, 0, 0);
    for i in 1..=50 {
        let r = 0.05 * f64::from(i);
        let at = wall.at(r).expect("in the domain");
        for j in 1..40 {
            let beta = 0.025 * f64::from(j);
            let what = format!("r = {r}, β = {beta}");
            let found = TwoStops::new(r, beta);
            let Ok(orbit) = at.orbit(beta) else {
                assert!(found.is_none(), "{what}: {found:?}");
                none += 1;
                continue;
            };
            let two = orbit.stops() == 2 && orbit.reversals() == 0;
            assert_eq!(found.is_some(), two, "{what}");
            let Some(found) = found else {
                other += 1;
                continue;
            };
            seen += 1;
            // τ₀ follows from β through a function that may be flat, so up to half of the digits may be lost.
            let apart = found.amplitude() - orbit.contact().amplitude();
            assert!(apart.abs() < 1e-11, "{what}: {apart:e}");
            let apart = found.stuck_fraction() - orbit.stuck_fraction();
            assert!(apart.abs() < 1e-10, "{what}: {apart:e}");
            let apart = found.phase() - orbit.origin();
            assert!(apart.sin().abs() < 1e-10, "{what}: {apart:e}");
        }
    }
    println!(
        "{seen} orbits compared, skipped: {other} of other courses, {none} points without one"
    );
    assert_eq!(seen + other + none, 50 * 39);
    // Points without a steady state are those on the resonance with β below π/4.
    assert_eq!(none, 31);
    assert!(seen > 500, "{seen}");
}
