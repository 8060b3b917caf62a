//! Tests of steps in which each contact has a separate friction force.

use super::{FRAME, system};
use crate::study::joined::JoinedInput;

/// Checks a block under a force. The contact first holds the block, then releases it, and finally has no friction
/// force.
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
    // Here a force drives the scene, so that the base rests.
    for base in [[0.0, 1.0], [f64::NAN, 0.0]] {
        let input = JoinedInput {
            base,
            ..JoinedInput::default()
        };
        assert!(stepper.advance(input).is_err());
        assert_eq!(stepper.time(), 0.0);
    }
}
