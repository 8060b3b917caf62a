//! Tests of Stribeck's law in scenes with several contacts.

use super::system;
use crate::study::joined::JoinedError;
use std::f64::consts::TAU;

const SINGLE: &str = "struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    force: lower,
    damping: modal[0.010, 0.012],
    stiction: 1.1,
    friction: stribeck(0.05: 0.7, 0.2: 0.5, 0.6: 0.8),
    provide: [stepper],
}";

/// Compares motions from rest with those of the solver for a single contact. This solver advances the modes of the
/// chain instead of the masses.
#[test]
fn motions_are_those_of_a_single_contact() {
    for (load, on_base) in [("excitation: lower", false), ("excitation: base", true)] {
        let text = SINGLE.replace("force: lower", load);
        let one = system(&text);
        let joined = one.joined().expect("answers");
        let (mut worst, mut events) = (0.0_f64, 0);
        for (r, beta) in [(0.3, 0.3), (0.9, 0.4), (1.6, 0.2)] {
            let amplitude = if on_base { 0.02 } else { 0.02 * 1190.0 };
            let omega = r * (1190.0_f64 / 3.27).sqrt();
            let mut single = one.simulation_under(r, beta, amplitude).expect("a run");
            let at = joined.under(omega, amplitude).expect("a load");
            let friction = beta * 0.02 * 1190.0;
            let mut many = at.simulation(friction).expect("a motion");
            for _ in 0..200 {
                // The solver for a single contact stops at the next event. The loop repeats the call until the phase is
                // reached.
                let mut left = TAU / 25.0;
                while left > 1e-14 {
                    left -= single.advance(left).expect("a motion").length;
                }
                events += many.advance(TAU / 25.0).expect("a motion").len();
                for name in ["lower", "upper"] {
                    let now = single.mass(name).expect("a mass");
                    let (x, v) = many.mass(name).expect("a mass");
                    let miss = (x / 0.02 - now.displacement()).abs();
                    let speed = (v / 0.02 / omega - now.velocity()).abs();
                    worst = worst.max(miss).max(speed);
                }
            }
        }
        println!("{load}: {events} events, {worst:.1e}");
        assert!(events > 60, "{events}");
        // Non-dimensional displacements and velocities are between 1 and 10. A friction law that falls with speed makes
        // small differences grow.
        assert!(worst < 1e-9, "{worst:e}");
    }
}

const TWO: &str = "struct Frame {
    masses: { lower: 2.0, upper: 1.5 },
    springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    contacts: {
        brace: base - lower { stiffness: 4.0e3, share: 1.5 },
        pads: lower - upper { stiction: 1.1 },
        guide: upper - wall { share: 0.4 },
    },
    damping: modal(0.05),
    excitation: base,
    friction: stribeck(0.05: 0.9, 0.3: 0.8),
    provide: [stepper],
}";

/// Compares steady states with the motion from rest after many cycles.
#[test]
fn steady_states_are_those_of_the_motion_from_rest() {
    let frame = system(TWO);
    let joined = frame.joined().expect("answers");
    let mut stops = Vec::new();
    for (omega, friction) in [
        (9.0, 3.0),
        (14.0, 6.0),
        (19.0, 12.0),
        (30.0, 4.0),
        (44.0, 9.0),
    ] {
        let at = joined.under(omega, 0.02).expect("a load");
        let orbit = at.orbit(friction).expect("an orbit");
        let mut run = at.simulation(friction).expect("a motion");
        let cycles = f64::from(150 * u32::try_from(orbit.period()).expect("few"));
        run.advance(cycles * TAU).expect("a motion");
        let (x, v) = orbit.state();
        let (now, speed) = run.state();
        let largest = |a: &[f64], b: &[f64]| {
            let pairs = a.iter().zip(b);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let miss = largest(&x, &now).max(largest(&v, &speed) / omega) / 0.02;
        println!("ω {omega}, F {friction}: {:?}, {miss:.1e}", orbit.regime());
        assert!(orbit.is_stable(), "ω {omega}, F {friction}");
        assert!(miss < 1e-8, "ω {omega}, F {friction}: {miss:e}");
        stops.push(orbit.contacts().map(|c| c.stops()).sum::<usize>());
    }
    assert!(stops.iter().any(|stops| *stops > 2), "{stops:?}");
}

/// Checks that a request for results in ratios returns an error. The sliding speeds of Stribeck's law have units. The
/// solver therefore needs the amplitude of the load.
#[test]
fn ratios_are_refused() {
    let frame = system(TWO);
    let joined = frame.joined().expect("answers");
    assert_eq!(joined.at(0.9).err(), Some(JoinedError::NoAmplitude));
    let refused = frame.at(0.9).map(|at| at.orbit(0.3).is_err());
    assert!(refused.unwrap_or(true));
}
