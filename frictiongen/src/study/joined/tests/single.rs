//! Compares two solvers for a scene with one contact: the solver for several contacts, and the solver for a single
//! contact.

use super::{FRAME, apart, system};
use crate::study::joined::Waveform;
use crate::study::orbit::SystemOrbitMotion;
use crate::study::response::MotionQuantity;
use crate::{Of, Regime};

const SINGLE: &str = "struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
    damping: modal[0.010, 0.012],
}";

/// Compares phases, harmonics and values of a motion. The phase `origin` of the single contact's motion belongs to the
/// maximum of the load.
fn courses_agree(course: &Waveform, expected: &SystemOrbitMotion<'_, '_>, origin: f64) {
    // Amplitudes are over the unit of displacement, about 1. A mass that a contact holds at the wall only rounds.
    let moves = expected.amplitude() > 1e-9;
    let size = expected.amplitude().max(1e-3);
    assert!((course.amplitude() - expected.amplitude()).abs() <= 1e-10 * size);
    let (fastest, wanted) = (course.largest_velocity(), expected.largest_velocity());
    assert!(
        (fastest - wanted).abs() <= 1e-9 * (size + wanted),
        "{fastest} {wanted}"
    );
    let near = |one: f64, other: f64, within: f64| {
        // Lags of π and −π are the same.
        let turn = (one - other).abs();
        turn.min(std::f64::consts::TAU - turn) <= within
    };
    // At a flat maximum, a change of the motion by 1e-11 moves the instant of its maximum by 1e-6.
    let (phase, other) = (course.phase(), expected.phase());
    assert!(!moves || near(phase, other, 3e-6), "{phase} {other}");
    let (phase, other) = (course.fundamental_phase(), expected.fundamental_phase());
    assert!(!moves || near(phase, other, 1e-9), "{phase} {other}");
    for n in [0, 1, 2, 3, 5, 9, 40] {
        let apart = (course.harmonic(n) - expected.harmonic(n)).norm();
        assert!(apart <= 1e-10 * size, "harmonic {n}: {apart}");
    }
    for step in 0..50 {
        let tau = 0.37 * f64::from(step) - 5.0;
        let apart = course.displacement(tau) - expected.displacement(tau - origin);
        assert!(apart.abs() <= 1e-10 * size, "{tau}: {apart}");
        let apart = course.velocity(tau) - expected.velocity(tau - origin);
        assert!(apart.abs() <= 1e-9 * (size + wanted), "{tau}: {apart}");
    }
}

/// Compares steady states of the two solvers, from continuous motion to six stops in a cycle.
#[test]
fn steady_states_are_those_of_a_single_contact() {
    let one = system(SINGLE);
    let joined = one.joined().expect("answers");
    let (mut seen, mut worst) = (Vec::new(), 0.0_f64);
    for (r, beta) in [(0.9, 0.3), (0.9, 0.6), (0.3, 0.4), (0.05, 0.1), (2.0, 0.8)] {
        let expected = one.at(r).expect("r").orbit(beta).expect("an orbit");
        let orbit = joined.at(r).expect("r").orbit(beta).expect("an orbit");
        let contact = orbit.contact("pads").expect("a contact");
        assert_eq!(
            (contact.stops(), contact.reversals()),
            (expected.stops(), expected.reversals()),
            "r {r}, beta {beta}"
        );
        let stuck = (contact.stuck_fraction() - expected.stuck_fraction()).abs();
        assert!(stuck < 1e-9, "r {r}, beta {beta}: {stuck}");
        for name in ["lower", "upper"] {
            let amplitude = expected.mass(name).expect("a mass").amplitude();
            let got = orbit.amplitude(name).expect("a mass");
            // While the contact sticks at the wall, its mass does not move.
            let differs = if got == amplitude {
                0.0
            } else {
                apart(got, amplitude)
            };
            assert!(differs < 1e-10, "r {r}, beta {beta}: {got} {amplitude}");
            worst = worst.max(differs);
        }
        let displacement = expected.contact_named("pads").expect("a contact");
        let displacement = displacement.amplitude();
        let found = contact.displacement();
        assert!(found == displacement || apart(found, displacement) < 1e-10);
        let single = expected.contact_named("pads").expect("a contact");
        let course = contact.motion().expect("a motion");
        courses_agree(&course, &single, expected.origin());
        for name in ["lower", "upper"] {
            let course = orbit.mass(name).expect("a motion");
            courses_agree(
                &course,
                &expected.mass(name).expect("a mass"),
                expected.origin(),
            );
        }
        let symmetric = orbit.is_symmetric().expect("a motion");
        assert_eq!(
            (orbit.is_stable(), symmetric),
            (expected.is_stable(), expected.is_symmetric()),
            "r {r}, beta {beta}"
        );
        assert_eq!(
            orbit.is_marginal(),
            expected.is_marginal(),
            "r {r}, beta {beta}"
        );
        // For a stuck contact, the solver for a single contact lists the multiplier 1 in addition.
        if !expected.is_marginal() {
            let rate = expected.multipliers().iter().map(|m| m.norm());
            let rate = rate.fold(0.0, f64::max);
            let got = orbit.multipliers().first().map_or(0.0, |m| m.norm());
            assert!(
                (got - rate).abs() < 1e-9,
                "r {r}, beta {beta}: {got} {rate}"
            );
        }
        seen.push(contact.stops());
    }
    println!("stops {seen:?}: {worst:.1e}");
    assert!(
        seen.contains(&0) && seen.iter().any(|stops| *stops > 2),
        "{seen:?}"
    );
}

/// Compares β*_lim, and the amplitudes while the contact sticks, with those of the solver for a single contact.
#[test]
fn stuck_states_are_those_of_a_single_contact() {
    let one = system(SINGLE);
    let joined = one.joined().expect("answers");
    for r in [0.2, 0.9, 1.3, 2.2] {
        let at = one.at(r).expect("r");
        let stuck = joined.at(r).expect("r").stuck().expect("a state");
        assert!(apart(stuck.limit(), at.sliding_limit()) < 1e-12, "r {r}");
        assert_eq!(stuck.first(), "pads");
        let expected = at
            .stuck()
            .expect("a response")
            .mass("lower")
            .expect("a mass")
            .norm();
        let got = stuck.mass("lower").expect("a mass").norm();
        assert!(apart(got, expected) < 1e-12, "r {r}: {got} {expected}");
        let force = stuck.force("pads").expect("a contact");
        assert!(apart(force, stuck.limit()) < 1e-12, "r {r}");
    }
}

/// Compares the steady state of an elastic contact with that of the solver for a single contact.
#[test]
fn an_elastic_contact_has_the_same_steady_state() {
    let one = system(&SINGLE.replace("- wall", "- wall { stiffness: 5.0e3 }"));
    let joined = one.joined().expect("answers");
    for (r, beta) in [(0.9, 0.3), (0.9, 0.6), (1.6, 0.2)] {
        let expected = one.at(r).expect("r").orbit(beta).expect("an orbit");
        let orbit = joined.at(r).expect("r").orbit(beta).expect("an orbit");
        let amplitude = expected.mass("lower").expect("a mass").amplitude();
        let got = orbit.amplitude("lower").expect("a mass");
        assert!(
            apart(got, amplitude) < 1e-10,
            "r {r}, beta {beta}: {got} {amplitude}"
        );
        assert_eq!(orbit.regime(), Regime::StickSlip);
    }
}

/// Checks that the solver for several contacts accepts a scene with a single `contact`, and that the name of this
/// contact is `contact`.
#[test]
fn a_single_contact_has_these_answers_too() {
    let one = system(&SINGLE.replace("contacts: { pads: upper - wall }", "contact: upper - wall"));
    let orbit = one
        .joined()
        .expect("answers")
        .at(0.9)
        .expect("r")
        .orbit(0.6);
    let orbit = orbit.expect("an orbit");
    assert!(orbit.contact("contact").expect("a contact").stops() > 0);
    let unknown = orbit
        .contact("pads")
        .map(|_| ())
        .expect_err("no such contact");
    assert_eq!(
        unknown.to_string(),
        "there is no contact `pads`; the contacts are contact"
    );
}

/// Checks the regime at a common friction above the limit of the stuck state, just below this limit, and close to 0.
#[test]
fn regimes_are_told_with_the_contacts_that_stick() {
    let system = system(FRAME);
    let at = system.joined().expect("answers").at(0.6).expect("r");
    let stuck = at.stuck().expect("a state");
    let above = at.orbit(1.5 * stuck.limit()).expect("an orbit");
    // The motion from rest overshoots. A contact may therefore have slipped before it sticks, and then keeps its
    // position.
    assert_eq!(above.regime(), Regime::Stuck);
    assert_eq!(above.marginal_contacts(), ["brace", "pads"]);
    assert!(above.is_marginal());
    let between = at.orbit(0.9 * stuck.limit()).expect("an orbit");
    assert_eq!(between.regime(), Regime::StickSlip);
    let sticks = between.marginal_contacts();
    assert!(
        sticks.len() < 2 && !sticks.contains(&stuck.first().to_owned()),
        "{sticks:?}"
    );
    let rigid = FRAME.replace(" { stiffness: 4.0e3 }", "");
    let rigid = super::system(&rigid);
    let sliding = rigid
        .joined()
        .expect("answers")
        .at(0.6)
        .expect("r")
        .orbit(0.01);
    assert_eq!(sliding.expect("an orbit").regime(), Regime::Continuous);
}

/// Compares the steady state without friction with the closed form of the linear response.
#[test]
fn the_response_without_friction_is_linear() {
    let system = system(FRAME);
    for r in [0.4, 0.9, 1.7] {
        let at = system.joined().expect("answers").at(r).expect("r");
        let (linear, orbit) = (at.linear().expect("a response"), at.orbit(0.0));
        let orbit = orbit.expect("a steady state");
        for name in ["lower", "upper"] {
            let expected = linear.mass(name).expect("a mass").norm();
            let got = orbit.amplitude(name).expect("a mass");
            assert!(apart(got, expected) < 1e-10, "r {r}: {got} {expected}");
        }
    }
}

/// Checks that a dashpot c between the only mass m of a chain and the resting base acts as modal damping ζ =
/// c/(2√(km)).
#[test]
fn a_dashpot_beside_one_contact_is_modal_damping_of_one_mass() {
    let modal = system(
        "struct Block { masses: { block: 2.0 }, springs: { base - block: 800.0 }, contact: block - wall,
        stiction: 1.2, excitation: block, damping: modal(0.05) }",
    );
    // The damping coefficient is 2ζ√(km) = 4 N·s/m, with ζ = 0.05, k = 800 N/m and m = 2 kg.
    let dashpot = system(
        "struct Block { masses: { block: 2.0 }, springs: { base - block: 800.0 }, contact: block - wall,
        stiction: 1.2, excitation: block, dampers: { base - block: 4.0 } }",
    );
    let joined = dashpot.joined().expect("answers");
    for (r, beta) in [(0.3, 0.4), (0.9, 0.3), (1.5, 0.6)] {
        let expected = modal.at(r).expect("r").orbit(beta).expect("an orbit");
        let at = joined.at(r).expect("r");
        let state = ([0.3], [0.1]);
        for orbit in [at.orbit(beta), at.orbit_from(beta, (&state.0, &state.1))] {
            let orbit = orbit.expect("an orbit");
            let amplitude = expected.mass("block").expect("a mass").amplitude();
            let got = orbit.amplitude("block").expect("a mass");
            assert!(
                apart(got, amplitude) < 1e-10,
                "r {r}, beta {beta}: {got} {amplitude}"
            );
            let contact = orbit.contact("contact").expect("a contact");
            assert_eq!(contact.stops(), expected.stops(), "r {r}, beta {beta}");
        }
    }
}

/// Compares relative displacements, velocities, accelerations, spring forces and the base shear with those of the solver
/// for a single contact.
#[test]
fn other_motions_are_those_of_a_single_contact() {
    let one = system(SINGLE);
    let joined = one.joined().expect("answers");
    let names = [
        "upper-lower",
        "upper-base",
        "vel(lower)",
        "accel(lower)",
        "accel(upper-base)",
        "spring(lower-upper)",
        "shear",
        "slip(pads)",
        "force(pads)",
        "energy(pads)",
        "zeta_eq",
        "zeta_eq(lower-upper)",
    ];
    let mut compared = 0;
    for (r, beta) in [(0.9, 0.3), (0.9, 0.6), (0.3, 0.4), (0.05, 0.1), (2.0, 0.8)] {
        let response = one.at(r).expect("r").response(beta).expect("a response");
        let orbit = joined.at(r).expect("r").orbit(beta).expect("an orbit");
        for name in names {
            let (of, size) = one.quantity_named(name).expect("a quantity");
            let expected = response.largest(of, size).expect("a size");
            // In a scene of several contacts the name means the first of them.
            let of = match (of, size) {
                (Of::Contact, MotionQuantity::Damping) => of,
                (Of::Contact, _) => Of::ContactAt(0),
                _ => of,
            };
            let got = orbit.largest(of, size).expect("a size");
            // While the contact is stuck, its slip is 0 to within rounding, and its energy is 0.
            let differs = (got - expected).abs() / expected.abs().max(1e-6);
            assert!(
                differs < 1e-8,
                "r {r}, beta {beta}, {name}: {got} {expected}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 60);
}

/// Compares amplitudes of linear responses with those of the closed form at β = 0.
#[test]
fn other_motions_of_a_linear_response() {
    let one = system(SINGLE);
    let joined = one.joined().expect("answers");
    for (r, name) in [
        (0.4, "upper-lower"),
        (1.3, "accel(upper-base)"),
        (0.7, "shear"),
    ] {
        let (of, size) = one.quantity_named(name).expect("a quantity");
        let expected = one.at(r).expect("r").response(0.0).expect("a response");
        let expected = expected.largest(of, size).expect("a size");
        let linear = joined.at(r).expect("r").linear().expect("a response");
        let got = linear.amplitude(of, size).expect("an amplitude");
        assert!(apart(got, expected) < 1e-10, "{name}: {got} {expected}");
    }
}

/// Compares the limits with those of the closed form, for one contact that slides or sticks.
#[test]
fn limits_are_those_of_a_single_contact() {
    let one = system(SINGLE);
    let joined = one.joined().expect("answers");
    for r in [0.4, 0.9, 1.5, 2.2] {
        let expected = one.at(r).expect("r").limits();
        let at = joined.at(r).expect("r");
        let got = at.continuous_limit().expect("a limit");
        assert!(
            apart(got, expected.continuous) < 1e-7,
            "r {r}: {got} {expected:?}"
        );
        let got = at.stuck().expect("a state").limit();
        assert!(
            apart(got, expected.sliding) < 1e-10,
            "r {r}: {got} {expected:?}"
        );
    }
}

/// Above the limit a contact sticks at times, and below it none does.
#[test]
fn contacts_stick_above_the_continuous_limit_only() {
    let frame = system(FRAME);
    let elastic = frame.joined().expect("answers");
    let limit = elastic.at(0.5).expect("r").continuous_limit();
    assert_eq!(
        limit.expect("a limit"),
        0.0,
        "an elastic contact sticks after each reversal"
    );
    let frame = system(&FRAME.replace("{ stiffness: 4.0e3 }", ""));
    let joined = frame.joined().expect("answers");
    for r in [0.5, 1.0, 1.7] {
        let at = joined.at(r).expect("r");
        let limit = at.continuous_limit().expect("a limit");
        assert!(limit > 0.0, "r {r}");
        let regime = |share: f64| at.orbit(share * limit).expect("an orbit").regime();
        assert_eq!(regime(1.0 - 1e-6), Regime::Continuous, "r {r}");
        assert_ne!(regime(1.0 + 1e-6), Regime::Continuous, "r {r}");
    }
}
