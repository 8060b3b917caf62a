//! Tests the state of the contact that a stepper reports before its first step.

use crate::stepper::independent::loads;
use crate::stepper::rig::{Load, scene};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, WALL, WALL_BASE, sticky};
use frictiongen::study::stepper::SystemStepper;
use frictiongen::{StepLoad, Stepping, System};
use frictiongen_kernel::simulation::Contact;
use frictiongen_model::scene::Node;

/// Converts a load to a `StepLoad`, and passes it to `then`.
fn with<T>(load: &Load, then: impl FnOnce(&StepLoad<'_, f64>) -> T) -> T {
    let forces: Vec<(usize, f64)> = load.forces.iter().copied().enumerate().collect();
    then(&StepLoad {
        base: load.base,
        forces: &forces,
        friction: load.friction,
    })
}

/// Returns displacements and velocities of the masses.
fn state(stepper: &SystemStepper<'_>, masses: usize) -> [Vec<f64>; 2] {
    let of = |read: fn(&frictiongen_kernel::stepper::MassNow<f64>) -> f64| {
        (0..masses)
            .map(|mass| read(&stepper.mass_at(mass)))
            .collect()
    };
    [of(|mass| mass.displacement()), of(|mass| mass.velocity())]
}

/// Checks a stepper that starts from the state and under the load of another stepper. If the contact of the earlier
/// stepper sticks, the new stepper must report sticking with the same force. If it slides, the new stepper must report
/// sliding.
#[test]
fn sticks_with_its_force_or_slides() {
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE] {
        let text = sticky(text, 1.3);
        let system: System = text.parse().expect("a scene");
        let described = scene(&text);
        let masses = described.masses.len();
        let dt = 0.3 / (described.springs[0].stiffness / described.masses[0].value).sqrt();
        let mut next = loads(&described, 4, dt);
        let mut stepper = system.stepper(dt).expect("a step");
        let ends = [described.contact.from, described.contact.to];
        let on_base = ends.contains(&Node::Base);
        let (mut stuck, mut slid, mut worst) = (0, 0, 0.0_f64);
        for _ in 0..2000 {
            let mut load = next();
            // A moving base breaks away a contact that rubs on it, unless friction is high.
            load.friction *= if on_base { 20.0 } else { 3.0 };
            with(&load, |load| stepper.step(load)).expect("a sound load");
            let [x, v] = state(&stepper, masses);
            let mut again = system.stepper_from(dt, (&x, &v)).expect("a state");
            let (want, unloaded) = (stepper.contact(), again.contact());
            // Before the new stepper gets a load, it assumes a base at rest. The states of both contacts then agree
            // only if the contact does not rub on the base.
            if !on_base {
                assert_eq!(unloaded.is_sticking(), want.is_sticking(), "{text}");
            }
            assert_eq!(unloaded.force().to_bits(), 0, "no friction is told yet");
            with(&load, |load| again.begin_with(load)).expect("a sound load");
            let found = again.contact();
            assert_eq!(found.is_sticking(), want.is_sticking(), "{text}");
            if want.is_sticking() {
                stuck += 1;
                assert_eq!(found.velocity().to_bits(), 0);
                // The acceleration of a moving base is unknown before the first step.
                if on_base {
                    continue;
                }
            } else {
                slid += 1;
                assert_eq!(found.contact(), want.contact(), "{text}");
            }
            let grip = 1.3 * load.friction;
            worst = worst.max((found.force() - want.force()).abs() / grip);
        }
        println!(
            "{}: {stuck} times stuck, {slid} times sliding, {worst:.1e}",
            described.name
        );
        assert!(stuck > 20 && slid > 20);
        // The new stepper converts the state of the masses to that of the chain with a stuck contact, and back. Both
        // conversions round.
        assert!(worst < 1e-12, "{text}: {worst:e}");
    }
}

/// Checks a state with random velocities of many masses, in which both masses of the contact have the same velocity.
/// The relative velocity is a sum over modes, of which only rounding remains. This rounding is larger than the terms
/// of the sum suggest. The contact must stick.
#[test]
fn a_given_state_sticks_but_for_its_rounding() {
    let names: Vec<String> = (0..40).map(|i| format!("m{i}")).collect();
    let masses: Vec<String> = names.iter().map(|name| format!("{name}: 1")).collect();
    let springs: Vec<String> = names
        .windows(2)
        .map(|pair| format!("{} - {}: 100", pair[0], pair[1]))
        .collect();
    let text = format!(
        "struct S {{ masses: {{ {} }}, springs: {{ base - m0: 100, {} }}, contact: m20 - m19, excitation: m0, provide: [stepper] }}",
        masses.join(", "),
        springs.join(", ")
    );
    let system: System = text.parse().expect("a scene");
    let mut random = fuzzing::Random(8);
    for _ in 0..200 {
        let x: Vec<f64> = (0..40).map(|_| 1e-3 * random.signed()).collect();
        let mut v: Vec<f64> = (0..40).map(|_| 1e3 * random.signed()).collect();
        v[20] = v[19];
        let mut stepper = system.stepper_from(1e-3, (&x, &v)).expect("a state");
        assert!(stepper.contact().is_sticking());
        let load = Load {
            base: [0.0; 2],
            forces: vec![0.0; 40],
            friction: 1e9,
        };
        with(&load, |load| stepper.begin_with(load)).expect("a sound load");
        assert!(stepper.contact().is_sticking());
        v[20] *= 1.0 + 1e-9;
        let stepper = system.stepper_from(1e-3, (&x, &v)).expect("a state");
        assert!(!stepper.contact().is_sticking());
    }
}

/// Checks a contact at rest under more than its break-away force. It must slide immediately, and the first step must
/// count the break-away.
#[test]
fn goes_at_once_beyond_the_grip() {
    let system: System = sticky(ONE, 1.5).parse().expect("a scene");
    for (force, friction, contact, held) in [
        (14.9, 10.0, Contact::Stuck, 14.9),
        (15.1, 10.0, Contact::Forward, 10.0),
        (-15.1, 10.0, Contact::Backward, -10.0),
        (15.1, 0.0, Contact::Stuck, 0.0),
    ] {
        let mut stepper = system.stepper(1e-3).expect("a step");
        let load = Load {
            base: [0.0; 2],
            forces: vec![force],
            friction,
        };
        with(&load, |load| stepper.begin_with(load)).expect("a sound load");
        let now = stepper.contact();
        assert_eq!(now.contact(), contact, "{force}, {friction}");
        assert!(
            (now.force() - held).abs() < 1e-12,
            "{} for {held}",
            now.force()
        );
        let stepped = with(&load, |load| stepper.step(load)).expect("a sound load");
        let goes = contact != Contact::Stuck;
        assert_eq!(stepped.events, u32::from(goes), "{force}, {friction}");
        if goes {
            assert_eq!(stepped.contact, contact);
        }
    }
}
