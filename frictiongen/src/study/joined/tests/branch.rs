//! Branches of steady states along a parameter.

use super::{apart, system};
use crate::study::joined::{
    BranchEnd, BranchEvent, BranchRequest, JoinedBranch, JoinedBranchPoint, JoinedError,
    JoinedOrbit,
};
use crate::study::sensitivity::OperatingPoint;
use crate::study::units::Load;

/// One mass whose contact rubs on the moving base, with three steady states at r = 0.55 and β = 0.1.
const THREE_STATES: &str = "struct Block {
    masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base, stiction: 1.5,
}";
const FRAME: &str = "struct Frame {
    masses: { lower: 3.27, upper: 3.25 }, springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall, excitation: base, damping: modal[0.010, 0.012],
}";
/// A rigid and an elastic contact, and a dashpot.
const TWO_CONTACTS: &str = "struct Frame {
    masses: { lower: 2.0, upper: 1.5 }, springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: lower - upper { share: 0.6 } },
    dampers: { base - upper: 2.0 }, excitation: base, damping: modal(0.01),
}";

/// Calls `check` with the branches along a parameter.
fn branches(
    text: &str,
    request: (OperatingPoint, &str, (f64, f64)),
    change: impl FnOnce(&mut BranchRequest),
    check: impl FnOnce(&[JoinedBranch<'_>]),
) {
    let (point, along, interval) = request;
    let system = system(text);
    let joined = system.joined().unwrap();
    let along = joined.parameter_named(along, point).unwrap();
    let mut request = BranchRequest::new(point, along, interval);
    change(&mut request);
    check(&joined.branches(&request).unwrap());
}

/// Returns the points of a branch at which an event occurs.
fn at<'b>(branch: &'b JoinedBranch<'_>, event: BranchEvent) -> Vec<&'b JoinedBranchPoint<'b>> {
    let points = branch.points.iter();
    points
        .filter(|point| point.events.contains(&event))
        .collect()
}

#[test]
fn an_unstable_state_of_three() {
    let point = OperatingPoint::Groups { r: 0.8, beta: 0.1 };
    branches(
        THREE_STATES,
        (point, "r", (0.8, 0.55)),
        |_| {},
        |all| {
            let last = all[0].points.last().unwrap();
            assert_eq!((all[0].end, last.value), (BranchEnd::Bound, 0.55));
            // The symmetric state of an independent program, which has 12 digits.
            let contact = last.orbit.contact("contact").unwrap();
            assert!(apart(contact.displacement(), 0.436_472_360_457) < 1e-11);
            assert!(!last.orbit.is_stable() && last.is_symmetric);
            assert!((last.orbit.multipliers()[0].re - 1.76).abs() < 5e-3);
            // Stops are born where the state has none above. There a multiplier jumps out of the unit circle.
            assert_eq!(at(&all[0], BranchEvent::Jump).len(), 1);
        },
    );
}

#[test]
fn asymmetric_states_begin_where_the_symmetry_breaks() {
    let point = OperatingPoint::Groups { r: 0.8, beta: 0.1 };
    branches(
        THREE_STATES,
        (point, "r", (0.8, 0.4)),
        |request| request.switches = 1,
        |all| {
            let [breaks] = at(&all[0], BranchEvent::SymmetryBreaking)[..] else {
                panic!("one symmetry breaking")
            };
            assert!((breaks.orbit.multipliers()[0].re - 1.0).abs() < 1e-6);
            let asymmetric = &all[1];
            assert_eq!(asymmetric.points[0].value, breaks.value);
            // Folds have a multiplier 1. At the last fold the branch turns from r 0.5684 back to the symmetric states.
            let folds = at(asymmetric, BranchEvent::Fold);
            let smooth = folds.iter().filter(|fold| fold.events.len() == 1);
            assert!(smooth.clone().count() >= 2);
            for fold in smooth {
                assert!((fold.orbit.multipliers()[0].re - 1.0).abs() < 1e-6);
            }
            // There it ends: a stop of the symmetric states appears in the same point.
            let last = asymmetric.points.last().unwrap();
            let [jump] = at(&all[0], BranchEvent::Jump)[..] else {
                panic!("one jump")
            };
            assert!((last.value - jump.value).abs() < 1e-6, "{}", last.value);
            // The states between the folds are those that motion from rest reaches, with 9 digits of an independent program
            // at r = 0.55.
            let system = system(THREE_STATES);
            let joined = system.joined().unwrap();
            let rest = |r: f64| joined.at(r).unwrap().orbit(0.1).unwrap();
            let displacement =
                |orbit: &JoinedOrbit<'_>| orbit.contact("contact").unwrap().displacement();
            assert!(apart(displacement(&rest(0.55)), 0.472_891_905) < 2e-9);
            let stable = asymmetric
                .points
                .iter()
                .filter(|point| point.orbit.is_stable() && (0.53..0.56).contains(&point.value));
            assert!(stable.clone().count() > 3);
            for point in stable {
                let from_rest = displacement(&rest(point.value));
                assert!(
                    apart(displacement(&point.orbit), from_rest) < 1e-9,
                    "{}",
                    point.value
                );
            }
        },
    );
}

#[test]
fn points_of_a_branch_are_the_states_from_rest_where_only_one_exists() {
    let point = OperatingPoint::Groups { r: 0.3, beta: 0.3 };
    for (text, along, interval) in [
        (FRAME, "r", (0.3, 2.0)),
        (FRAME, "beta", (0.05, 0.9)),
        (FRAME, "k.base-lower", (800.0, 1600.0)),
        (TWO_CONTACTS, "r", (0.3, 1.4)),
        (TWO_CONTACTS, "share.pads", (0.2, 1.5)),
        (TWO_CONTACTS, "c.base-upper", (0.5, 20.0)),
    ] {
        branches(
            text,
            (point, along, interval),
            |_| {},
            |all| {
                assert_eq!(all[0].end, BranchEnd::Bound, "{along}");
                let points = all[0].points.iter().step_by(7);
                for own in points.chain(all[0].points.last()) {
                    let mut changed = system(text).scene().clone();
                    match along {
                        "k.base-lower" => changed.springs[0].stiffness = own.value,
                        "share.pads" => changed.joints.contacts[1].law.share = own.value,
                        "c.base-upper" => changed.joints.dampers[0].coefficient = own.value,
                        _ => {}
                    }
                    let OperatingPoint::Groups { r, beta } = own.point else {
                        panic!("groups")
                    };
                    let system = crate::System::<f64>::try_from(changed).unwrap();
                    let rest = system.joined().unwrap().at(r).unwrap().orbit(beta).unwrap();
                    for (one, other) in own.orbit.amplitudes().iter().zip(rest.amplitudes()) {
                        assert!(
                            (one - other).abs() <= 1e-9 * (1.0 + other),
                            "{along} {}",
                            own.value
                        );
                    }
                    assert!(own.orbit.is_stable());
                }
            },
        );
    }
}

#[test]
fn a_load_in_units_gives_the_branch_in_units() {
    let load = Load::Base(0.001);
    let point = OperatingPoint::Physical {
        hertz: 1.0,
        friction: 0.4,
        load,
    };
    branches(
        FRAME,
        (point, "hz", (1.0, 7.0)),
        |_| {},
        |all| {
            let last = all[0].points.last().unwrap();
            assert!((last.orbit.omega() - 7.0 * std::f64::consts::TAU).abs() < 1e-9);
            let largest = all[0]
                .points
                .iter()
                .map(|point| point.orbit.amplitudes()[1]);
            let largest = largest.fold(0.0, f64::max);
            assert!((0.001..0.1).contains(&largest), "{largest}");
        },
    );
}

#[test]
fn an_unknown_parameter_is_named_with_the_known_ones() {
    let frame = system(FRAME);
    let point = OperatingPoint::Groups { r: 1.0, beta: 1.0 };
    let error = frame
        .joined()
        .unwrap()
        .parameter_named("m.roof", point)
        .unwrap_err();
    assert!(matches!(error, JoinedError::UnknownParameter(..)));
    let text = error.to_string();
    assert!(text.contains("m lower") && text.contains("beta"), "{text}");
}
