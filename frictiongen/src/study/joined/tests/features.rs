//! Tests of the antiresonances and of the friction from which no contact slides, with closed forms.

use super::{FRAME, apart, system};
use crate::study::features::FeatureError;
use crate::study::joined::JoinedError;

/// Asserts the antiresonances of a mass, as angular frequencies. `is_stuck` is true if all contacts stick.
fn assert_zeros(text: &str, (mass, is_stuck): (usize, bool), wanted: &[f64]) {
    let system = system(text);
    let joined = system.joined().expect("a solver");
    let found = joined.antiresonances(mass, [0.01, 50.0], is_stuck);
    let found = found.expect("antiresonances");
    assert_eq!(found.len(), wanted.len(), "{text}: {found:?}");
    for (r, omega) in found.into_iter().zip(wanted) {
        assert!(apart(system.angular_frequency(r), *omega) < 1e-12, "{r}");
    }
}

/// A mass under a force rests at the natural frequency of what hangs on it.
#[test]
fn antiresonances_of_the_loaded_mass() {
    let elastic = "struct Pair { masses: { a: 2, b: 0.5 }, springs: { base - a: 100, a - b: 40 },
        contacts: { one: b - wall { stiffness: 60 }, two: a - wall { stiffness: 9 } }, excitation: a }";
    assert_zeros(elastic, (0, false), &[80.0_f64.sqrt()]);
    assert_zeros(elastic, (0, true), &[200.0_f64.sqrt()]);
    assert_zeros(elastic, (1, false), &[]);
    // The stuck contact joins b and c: 40 and 20 N/m for 2.5 kg.
    let joined = "struct Chain { masses: { a: 2, b: 0.5, c: 2 }, springs: { base - a: 100, a - b: 40, c - wall: 20 },
        contacts: { pads: b - c, elastic: a - wall { stiffness: 3 } }, excitation: a }";
    assert_zeros(joined, (0, false), &[80.0_f64.sqrt()]);
    assert_zeros(joined, (0, true), &[24.0_f64.sqrt()]);
}

/// A contact joins the first two masses, which changes the reference mass of the joined chain. Another contact holds
/// the last mass.
#[test]
fn antiresonances_if_the_first_mass_is_joined() {
    let text = "struct Chain { masses: { a: 3, b: 5, c: 0.5, d: 1 }, springs: { base - a: 7, b - c: 18, c - d: 14 },
        contacts: { pads: a - b, floor: d - wall }, excitation: b }";
    assert_zeros(text, (0, true), &[8.0]);
    assert_zeros(text, (1, true), &[8.0]);
    assert_zeros(text, (3, true), &[]);
}

/// Without a support, the loaded mass has an antiresonance, and the other mass has none. A mass that sticks to the
/// moving base never rests.
#[test]
fn antiresonances_without_a_support_and_on_a_moving_base() {
    let pair = "struct Pair { masses: { a: 2, b: 3 }, springs: { a - b: 48 },
        contacts: { clutch: a - b { stiffness: 27 } }, excitation: a }";
    assert_zeros(pair, (0, false), &[4.0]);
    assert_zeros(pair, (0, true), &[5.0]);
    assert_zeros(pair, (1, false), &[]);
    let moved =
        "struct Pair { masses: { a: 2, b: 3 }, springs: { base - a: 10, a - b: 40, b - wall: 5 },
        contacts: { ride: base - b, other: a - b { stiffness: 1 } }, excitation: base }";
    assert_zeros(moved, (1, true), &[]);
    assert_zeros(moved, (0, true), &[]);
    // k₁ and k₂ in a row from the base: x_b vanishes nowhere, and x_a where b is an absorber.
    assert_zeros(moved, (0, false), &[15.0_f64.sqrt()]);
}

#[test]
fn damped_chains_have_no_antiresonance() {
    let frame = system(FRAME);
    let joined = frame.joined().expect("a solver");
    let found = joined.antiresonances(0, [0.5, 2.0], false);
    assert_eq!(found, Err(FeatureError::Damped));
    let empty = joined.antiresonances(0, [2.0, 2.0], false);
    assert_eq!(empty, Err(FeatureError::Range));
}

/// One mass with an elastic contact of stiffness k_c: no contact slides from P k_c/|k + k_c − mω² + icω| on. With a
/// dashpot, this friction is largest at ω² = (1 − 2ζ²)(k + k_c)/m.
#[test]
fn friction_from_which_no_contact_slides() {
    let scene = |damper: &str| {
        system(&format!(
            "struct Block {{ masses: {{ block: 2 }}, springs: {{ base - block: 50 }},
            contacts: {{ pads: block - wall {{ stiffness: 150 }}, lid: block - wall {{ stiffness: 150, share: 2 }} }},
            {damper} excitation: block }}"
        ))
    };
    let damped = scene("dampers: { base - block: 8 },");
    let joined = damped.joined().expect("a solver");
    let zeta = 8.0 / (2.0 * (2.0_f64 * 350.0).sqrt());
    let found = joined.largest_stuck_limit([0.5, 4.0], &[7.0_f64.sqrt()]);
    let found = found.expect("a limit").expect("a limit");
    assert_eq!(found.first, "pads");
    assert!(apart(found.r, (7.0 * (1.0 - 2.0 * zeta * zeta)).sqrt()) < 1e-6);
    let limit = 150.0 / 350.0 / (2.0 * zeta * (1.0 - zeta * zeta).sqrt());
    assert!(apart(found.limit, limit) < 1e-12);
    let undamped = scene("");
    let joined = undamped.joined().expect("a solver");
    let at = joined.stuck_limit(2.0).expect("a limit");
    assert!(apart(at.limit, 150.0 / 150.0) < 1e-13);
    let at = joined.stuck_limit(7.0_f64.sqrt()).expect("a limit");
    assert_eq!((at.limit, &at.first[..]), (f64::INFINITY, "pads"));
    let largest = joined.largest_stuck_limit([0.5, 4.0], &[7.0_f64.sqrt()]);
    assert_eq!(largest, Ok(Some(at)));
    let belt = system(
        "struct Belt { masses: { block: 1 }, springs: { block - wall: 1 },
        contacts: { pads: block - wall { speed: 0.3 } }, excitation: block }",
    );
    let joined = belt.joined().expect("a solver").with_length(1.0);
    assert_eq!(joined.stuck_limit(1.0), Err(JoinedError::NotLinear));
}

/// The default range contains the resonances of all sets: √(50/2) and √(200/2) rad/s.
#[test]
fn the_default_range_contains_all_sets() {
    let block = system(
        "struct Block { masses: { block: 2 }, springs: { base - block: 50 }, dampers: { base - block: 1e-3 },
        contacts: { pads: block - wall { stiffness: 150 } }, excitation: block }",
    );
    let [from, to] = block.about_resonances();
    assert!(
        apart(from, 0.55) < 1e-6 && apart(to, 3.0) < 1e-6,
        "{from} {to}"
    );
}
