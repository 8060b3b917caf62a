//! Tests coexisting steady states, at run time and emitted.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::{System, friction_system};

friction_system! {
    struct Block {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - base,
        excitation: base,
        stiction: 2.0,
        provide: [limits, orbit],
    }
}

const BLOCK: &str = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
    contact: block - base, excitation: base, stiction: ";

fn block(stiction: f64) -> System {
    format!("{BLOCK}{stiction} }}").parse().expect("a scene")
}

/// Returns all states that the system finds. A state may occur twice.
fn states(system: &System, r: f64, beta: f64) -> Vec<SystemOrbit<'_>> {
    let at = system.at(r).expect("in the domain");
    at.states(beta).expect("in the domain").collect()
}

/// Returns the amplitude of Den Hartog's solution, divided by Y, for a load of r²Y: z̄₀² = V² − β²U².
fn closed_form(r: f64, beta: f64) -> f64 {
    let angle = std::f64::consts::PI / r;
    let (v, u) = (1.0 / (1.0 - r * r), angle.sin() / (r * (1.0 + angle.cos())));
    let load = r * r;
    load * (v * v - (beta / load * u).powi(2)).sqrt()
}

/// Checks that the closed form and the stuck state coexist between the limits 0.605 and 0.881.
#[test]
fn the_closed_form_beside_the_stuck_state() {
    let (r, beta) = (1.1, 0.65);
    let system = block(2.0);
    let found = states(&system, r, beta);
    let expected = closed_form(r, beta);
    assert!((4.02..4.04).contains(&expected));
    let sliding: Vec<_> = found
        .iter()
        .filter(|orbit| orbit.stuck_fraction() == 0.0)
        .collect();
    let stuck: Vec<_> = found
        .iter()
        .filter(|orbit| orbit.stuck_fraction() > 0.999)
        .collect();
    assert_eq!((sliding.len(), stuck.len()), (1, 1), "of {}", found.len());
    let amplitude = sliding[0].contact().amplitude();
    assert!(
        (amplitude / expected - 1.0).abs() < 1e-9,
        "{amplitude} for {expected}"
    );
    assert_eq!((sliding[0].stops(), sliding[0].reversals()), (0, 2));
    assert_eq!((stuck[0].stops(), stuck[0].reversals()), (0, 0));
    assert!(stuck[0].is_marginal() && found.iter().all(|orbit| orbit.is_stable()));

    let at = Block::at(r).expect("in the domain");
    let emitted: Vec<_> = at.states(beta).expect("in the domain").collect();
    assert_eq!(emitted.len(), found.len());
    for (emitted, found) in emitted.iter().zip(&found) {
        let [a, b] = [emitted.contact().amplitude(), found.contact().amplitude()];
        assert!((a - b).abs() <= 1e-12 * b, "{a} for {b}");
        assert_eq!(
            (emitted.period(), emitted.stops(), emitted.reversals()),
            (found.period(), found.stops(), found.reversals())
        );
    }
}

/// Checks that with μ = 1 the system finds one state, or one continuum of states.
#[test]
fn one_state_without_excess_of_static_friction() {
    let system = block(1.0);
    for (r, beta) in [(1.1, 0.65), (1.1, 1.3), (0.4, 0.1), (0.8, 0.6), (2.2, 1.0)] {
        assert_eq!(states(&system, r, beta).len(), 1, "r = {r}, β = {beta}");
    }
}

/// Checks a stick-slip motion that coexists with a stuck state. The test compares each state with a simulation from
/// the state's own initial state.
#[test]
fn stick_slip_beside_the_stuck_state() {
    let system = block(2.0);
    let mut beside = 0;
    for r in [0.3, 0.4, 0.5, 0.6, 0.7] {
        let at = system.at(r).expect("in the domain");
        let limit = at.sliding_limit();
        for factor in [1.01, 1.05, 1.1, 1.2] {
            let beta = limit * factor;
            let found = states(&system, r, beta);
            let stuck = found.iter().filter(|orbit| orbit.stuck_fraction() > 0.999);
            assert_eq!(stuck.count(), 1, "r = {r}, β = {beta}");
            for orbit in found.iter().filter(|orbit| orbit.stops() > 0) {
                beside += 1;
                let tau = -orbit.origin();
                let motion = orbit.mass("block").expect("a mass");
                let state = ([motion.displacement(tau)], [motion.velocity(tau)]);
                let again = at.orbit_from(beta, (&state.0, &state.1)).expect("a state");
                assert_eq!(
                    (again.period(), again.stops()),
                    (orbit.period(), orbit.stops()),
                    "r = {r}, β = {beta}"
                );
                let [a, b] = [&again, orbit].map(|orbit| orbit.contact().centred_amplitude());
                assert!(
                    (a / b - 1.0).abs() < 1e-6,
                    "r = {r}, β = {beta}: {a} for {b}"
                );
            }
        }
    }
    println!("{beside} stick-slip states beside stuck ones");
    assert!(beside > 0);
}
