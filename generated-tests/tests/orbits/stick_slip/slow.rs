//! Tests steady states near a resonance of masses that the contact does not move. Motion from rest reaches them later
//! than after the number of cycles that the search follows.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::{SteadyState, System};
use std::f64::consts::TAU;

/// Returns two equal masses, with load and contact on the lower one. While the contact is stuck, the upper mass
/// resonates at r = 1.
fn two() -> System {
    let text = "struct Two { masses: { lower: 1, upper: 1 }, springs: { base - lower: 1, lower - upper: 1 },
        contact: lower - wall, excitation: lower }";
    text.parse().expect("a scene")
}

/// Returns the largest difference during one cycle between the displacements of the orbit and those of a run. The run
/// starts from rest, and the compared cycle follows after `cycles` cycles.
fn from_a_run(system: &System, (r, beta): (f64, f64), cycles: u32, orbit: &SystemOrbit<'_>) -> f64 {
    let mut run = system.simulation(r, beta).expect("a run");
    let mut on = |mut left: f64| {
        while left > 0.0 {
            left -= run.advance(left).expect("a reach").length;
        }
        [0, 1].map(|mass| run.run().mass(mass).displacement())
    };
    for _ in 0..cycles {
        on(TAU);
    }
    let step = TAU / 48.0;
    let mut worst = 0.0_f64;
    for index in 1..=48 {
        let tau = step * f64::from(index) - orbit.origin();
        for (mass, x) in on(step).into_iter().enumerate() {
            let motion = orbit.mass_at(mass).expect("a mass");
            worst = worst.max((motion.displacement(tau) - x).abs());
        }
    }
    worst
}

/// Checks that a run finally reaches the state. At these points the largest multiplier is above 0.9990 for each
/// cycle, and after 512 cycles from rest more than half of the deviation remains. The run continues until 1e-8 of the
/// deviation remains.
#[test]
fn a_run_comes_to_the_state_at_last() {
    let system = two();
    for (r, beta) in [(1.0001, 0.8), (0.9999, 0.6)] {
        let orbit = system.at(r).expect("a ratio").orbit(beta);
        let orbit = orbit.expect("a steady state");
        assert!(
            orbit.is_settled() && orbit.is_symmetric() && orbit.is_stable() && !orbit.is_marginal()
        );
        let largest = orbit
            .multipliers()
            .iter()
            .map(|m| m.norm())
            .fold(0.0, f64::max);
        assert!((0.999..1.0).contains(&largest), "{largest}");
        let cycles = (1e-8_f64.ln() / largest.ln()).ceil() as u32;
        let away = from_a_run(&system, (r, beta), cycles, &orbit);
        assert!(
            away < 1e-6,
            "r = {r}, β = {beta}: {away} after {cycles} cycles"
        );
    }
}

/// Checks that on both sides of the resonance the amplitude tends to √(1 − β²). The difference falls as the square
/// root of the distance from the resonance. The mean of the amplitudes on both sides is closer.
#[test]
fn both_sides_tend_to_the_same() {
    let system = two();
    let beta = 0.8;
    let at = |r: f64| {
        let response = system.at(r).expect("a ratio").orbit(beta);
        response
            .expect("a steady state")
            .mass("upper")
            .expect("a mass")
            .amplitude()
    };
    let limit = f64::sqrt(1.0 - beta * beta);
    for distance in [1e-4, 1e-5] {
        let (below, above) = (at(1.0 - distance), at(1.0 + distance));
        assert!(
            below < limit && limit < above,
            "β = {beta}: {below}, {above}"
        );
        let mean = 0.5 * (below + above);
        assert!(
            (mean - limit).abs() < 2e-3,
            "β = {beta}, 1 ± {distance}: {mean}"
        );
    }
}
