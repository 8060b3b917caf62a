//! Tests of the stepper for several contacts, in which every contact has its own friction force.

use super::{FRAME, system};
use crate::study::joined::JoinedInput;

/// Checks a block under a constant force of 5 N while its friction force falls. The contact first sticks, then slides,
/// and finally has no friction force.
#[test]
fn friction_forces_change_from_step_to_step() {
    let block = system(
        "struct Block { masses: { block: 2.0 }, contacts: { floor: block - wall { stiction: 1.2 } },
        excitation: block, input: hold, provide: [stepper] }",
    );
    let joined = block.joined().expect("answers");
    let dt = 0.01;
    let mut stepper = joined.stepper(dt).expect("a stepper");
    let forces = [("block", 5.0)];
    let mut take = |friction: f64, steps: usize| {
        let mut events = 0;
        for _ in 0..steps {
            let frictions = [("floor", friction)];
            let input = JoinedInput {
                forces: &forces,
                frictions: &frictions,
                ..JoinedInput::default()
            };
            events += stepper.advance(input).expect("a step");
        }
        let floor = stepper.contact_named("floor").expect("a contact");
        (stepper.mass("block").expect("a mass"), floor, events)
    };
    // The static friction force μF = 6 N withstands the force of 5 N.
    let ((x, v), floor, _) = take(5.0, 100);
    assert_eq!((x, v), (0.0, 0.0));
    assert!(
        floor.is_sticking && (floor.force - 5.0).abs() < 1e-14,
        "{floor:?}"
    );
    // With F = 3 N the block accelerates by (5 − 3)/2 m/s².
    let ((x, v), floor, _) = take(3.0, 100);
    assert!(
        (x - 0.5).abs() < 1e-12 && (v - 1.0).abs() < 1e-12,
        "{x} {v}"
    );
    assert!(!floor.is_sticking && floor.force == 3.0);
    // Without friction the block accelerates by 5/2 m/s².
    let ((x, v), floor, _) = take(0.0, 100);
    assert!(
        (x - (0.5 + 1.0 + 1.25)).abs() < 1e-11 && (v - 3.5).abs() < 1e-11,
        "{x} {v}"
    );
    assert_eq!(floor.force, 0.0);
}

/// Checks an elastic contact whose force exceeds the kinetic friction force, but never the static one. It sticks while
/// the level jumps in every step, and the block oscillates as on a spring: x = P/k (1 − cos Ωt).
#[test]
fn an_elastic_contact_keeps_its_static_friction() {
    let block = system(
        "struct Block { masses: { block: 2.0 },
        contacts: { brace: block - wall { stiffness: 900.0, stiction: 1.5 } },
        excitation: block, input: hold, provide: [stepper] }",
    );
    let joined = block.joined().expect("answers");
    let mut stepper = joined.stepper(0.01).expect("a stepper");
    let mut most = 0.0_f64;
    for step in 1..=100_u32 {
        let input = JoinedInput {
            forces: &[("block", 1.2)],
            frictions: &[("brace", if step % 2 == 0 { 1.9 } else { 1.8 })],
            ..JoinedInput::default()
        };
        assert_eq!(stepper.advance(input), Ok(0));
        let brace = stepper.contact_named("brace").expect("a contact");
        let force = 1.2 * (1.0 - (450.0_f64.sqrt() * 0.01 * f64::from(step)).cos());
        assert!((brace.force - force).abs() < 1e-12, "{step}: {brace:?}");
        assert_eq!((brace.slip, brace.energy), (0.0, 0.0));
        most = most.max(force);
    }
    assert!(2.3 < most);
}

/// Checks that an input with an error leaves the stepper unchanged.
#[test]
fn bad_inputs_change_nothing() {
    let forced = FRAME.replace("excitation: base", "excitation: upper");
    let frame = system(&forced);
    let joined = frame.joined().expect("answers");
    let mut stepper = joined.stepper(1e-3).expect("a stepper");
    type Named<'n> = &'n [(&'n str, f64)];
    let bad: [(Named<'_>, Named<'_>); 4] = [
        (&[("upper", f64::NAN)], &[]),
        (&[("roof", 1.0)], &[]),
        (&[], &[("brace", -1.0)]),
        (&[], &[("clutch", 1.0)]),
    ];
    for (forces, frictions) in bad {
        let input = JoinedInput {
            forces,
            frictions,
            ..JoinedInput::default()
        };
        assert!(stepper.advance(input).is_err());
        assert_eq!(stepper.time(), 0.0);
    }
    assert!(joined.stepper(0.0).is_err());
    // A force drives this scene, so that the base must be at rest.
    for base in [[0.0, 1.0], [f64::NAN, 0.0]] {
        let input = JoinedInput {
            base,
            ..JoinedInput::default()
        };
        assert!(stepper.advance(input).is_err());
        assert_eq!(stepper.time(), 0.0);
    }
}

/// Checks the energy balance. The energy that the contacts dissipate must equal the work of the load, less the kinetic
/// energy and the energy in the spring of the elastic contact. The load is constant in each step. In the elastic
/// contact, the static friction exceeds the kinetic friction. The friction forces change during the motion.
#[test]
fn energies_close_the_balance() {
    let pair = system(
        "struct Pair { masses: { a: 2.0, b: 1.0 },
        contacts: { floor: a - wall { stiffness: 900.0, stiction: 1.3 }, joint: a - b { share: 0.5 } },
        excitation: b, input: hold, provide: [stepper] }",
    );
    let joined = pair.joined().expect("answers");
    let mut stepper = joined.stepper(0.01).expect("a stepper");
    let (mut work, mut before, mut breaks) = (0.0, 0.0, 0);
    for step in 0..600_u32 {
        let force = 4.0 * (0.03 * f64::from(step)).sin();
        let friction = if step % 200 < 100 { 2.0 } else { 1.2 };
        let input = JoinedInput {
            forces: &[("b", force)],
            frictions: &[("floor", friction), ("joint", 0.5 * friction)],
            ..JoinedInput::default()
        };
        let stuck = stepper
            .contact_named("floor")
            .expect("a contact")
            .is_sticking;
        stepper.advance(input).expect("a step");
        let (x, v) = stepper.mass("b").expect("a mass");
        let (_, va) = stepper.mass("a").expect("a mass");
        work += force * (x - before);
        before = x;
        let floor = stepper.contact_named("floor").expect("a contact");
        let joint = stepper.contact_named("joint").expect("a contact");
        breaks += u32::from(stuck && !floor.is_sticking);
        let stored = va * va + 0.5 * v * v + floor.force * floor.force / 1800.0;
        let left = work - stored - floor.energy - joint.energy;
        assert!(left.abs() < 1e-11 * (1.0 + work.abs()), "{step}: {left}");
    }
    let spent = |name: &str| stepper.contact_named(name).expect("a contact").energy;
    println!(
        "{breaks} break-aways, {} J, {} J",
        spent("floor"),
        spent("joint")
    );
    assert!(breaks > 4 && spent("floor") > 0.01 && spent("joint") > 1.0);
}

/// Checks that the input of `begin` acts from the start of the first step, and that `begin` fails after this step.
#[test]
fn the_first_input_acts_from_the_start() {
    let block = system(
        "struct Block { masses: { block: 2.0 }, contacts: { floor: block - wall },
        excitation: block, provide: [stepper] }",
    );
    let joined = block.joined().expect("answers");
    let mut stepper = joined.stepper(0.1).expect("a stepper");
    let input = JoinedInput {
        forces: &[("block", 3.0), ("block", 2.0)],
        frictions: &[("floor", 1.0)],
        ..JoinedInput::default()
    };
    stepper.begin(input).expect("an input");
    stepper.advance(input).expect("a step");
    // The load and the friction force act all the time: x = (5 − 1)/2 · t²/2.
    let (x, v) = stepper.mass("block").expect("a mass");
    assert!(
        (x - 0.01).abs() < 1e-15 && (v - 0.2).abs() < 1e-15,
        "{x} {v}"
    );
    let floor = stepper.contact_named("floor").expect("a contact");
    assert!((floor.slip - 0.01).abs() < 1e-15 && (floor.energy - 0.01).abs() < 1e-15);
    assert!(stepper.begin(input).is_err());
}
