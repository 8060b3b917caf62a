//! Physical units: calculations by hand, refusals, and the same answers in any order of masses and springs.

use frictiongen::System;
use frictiongen::study::units::{angular_frequency, hertz, reversed_phase};
use frictiongen::study::{
    StudyError,
    units::{Load, LoadError},
};
use std::f64::consts::{PI, TAU};

fn block(contact: &str, excitation: &str) -> System {
    format!(
        "struct Block {{ masses: {{ block: 2.0 }}, springs: {{ base - block: 50.0 }},
         contact: {contact}, excitation: {excitation} }}"
    )
    .parse()
    .unwrap()
}

fn close(value: f64, expected: f64) {
    assert!(
        (value - expected).abs() <= 1e-12 * expected.abs(),
        "{value} {expected}"
    );
}

/// Checks m = 2 kg, k = 50 N/m, P = 10 N, F = 2 N, ω = 8 rad/s against a calculation by hand in newtons and metres.
#[test]
fn one_mass_by_hand() {
    let (m, k, p, f, omega) = (2.0_f64, 50.0_f64, 10.0, 2.0, 8.0);
    // X² = (P/(k − mω²))² − (F u)² with u = tan(π ω_n/2ω)·ω_n/(kω).
    let natural = (k / m).sqrt();
    let v = p / (k - m * omega * omega);
    let u = f * (PI * natural / (2.0 * omega)).tan() * natural / (k * omega);
    let expected = (v * v - u * u).sqrt();

    let system = block("block - wall", "block");
    let scale = system.load_scale(Load::Force(p)).unwrap();
    close(scale.length(), 0.2);
    close(scale.force(), 10.0);
    let r = system.frequency_ratio(omega);
    close(r, 1.6);
    let at = system.at(r).unwrap();
    let motion = at.motion(scale.friction_ratio(f)).unwrap();
    close(
        scale.displacement(motion.mass("block").unwrap().amplitude()),
        expected,
    );
    // Undamped and without stiction, the block slides under any friction below P.
    close(scale.friction(at.sliding_limit()), p);
}

#[test]
fn base_motion_by_hand() {
    let system = block("block - wall", "base");
    let scale = system.load_scale(Load::Base(0.003)).unwrap();
    close(scale.length(), 0.003);
    close(scale.force(), 0.15);
    close(scale.friction_ratio(0.03), 0.2);
    close(scale.friction(0.2), 0.03);
    close(scale.displacement(2.0), 0.006);
}

#[test]
fn frequencies_there_and_back() {
    let system = block("block - wall", "block");
    close(angular_frequency(1.0), TAU);
    close(hertz(TAU), 1.0);
    close(system.frequency_ratio_at_hertz(5.0 / TAU), 1.0);
    close(system.hertz(1.0), 5.0 / TAU);
    close(system.angular_frequency(1.6), 8.0);
    assert!(system.frequency_ratio_at_hertz(f64::INFINITY).is_infinite());
    let mut compared = 0;
    for hz in [1e-9, 0.3, 1.0, 50.0, 1e12] {
        close(system.hertz(system.frequency_ratio_at_hertz(hz)), hz);
        compared += 1;
    }
    assert_eq!(compared, 5);
}

#[test]
fn loads_that_do_not_fit() {
    let (pushed, shaken) = (
        block("block - wall", "block"),
        block("block - wall", "base"),
    );
    assert_eq!(
        shaken.load_scale(Load::Force(1.0)),
        Err(LoadError::DrivenByBase)
    );
    let driven = LoadError::DrivenByForce("block".to_owned());
    assert_eq!(pushed.load_scale(Load::Base(1.0)), Err(driven.clone()));
    for amplitude in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let force = pushed.load_scale(Load::Force(amplitude));
        assert_eq!(force, Err(LoadError::Amplitude));
        let base = shaken.load_scale(Load::Base(amplitude));
        assert_eq!(base, Err(LoadError::Amplitude));
    }
    assert_eq!(
        pushed.load_scale(Load::Force(5e-324)),
        Err(LoadError::OutOfRange)
    );
    assert_eq!(
        shaken.load_scale(Load::Base(1e308)),
        Err(LoadError::OutOfRange)
    );
    assert_eq!(
        driven.to_string(),
        "the scene is driven by a force on `block`"
    );
    assert_eq!(
        LoadError::DrivenByBase.to_string(),
        "the scene is driven by its base"
    );
    let study = StudyError::from(LoadError::Amplitude);
    assert_eq!(
        study.to_string(),
        "the amplitude of a load must be above 0 and finite"
    );
}

/// Another order of masses and springs changes the non-dimensional groups, but not the metres, newtons, hertz and
/// radians.
#[test]
fn the_order_of_a_description() {
    let frame = |masses: &str, springs: &str| -> System {
        format!(
            "struct Frame {{ masses: {{ {masses} }}, springs: {{ {springs} }}, contact: lower - upper,
             excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }}"
        )
        .parse()
        .unwrap()
    };
    let (masses, springs) = (
        ["lower: 3.27", "upper: 3.25"],
        ["base - lower: 1190.0", "lower - upper: 1323.0"],
    );
    let answers = |masses: [&str; 2], springs: [&str; 2]| {
        let system = frame(&masses.join(", "), &springs.join(", "));
        let scale = system.load_scale(Load::Base(0.002)).unwrap();
        let at = system.at(system.frequency_ratio_at_hertz(2.7)).unwrap();
        let beta = scale.friction_ratio(0.4);
        let motion = at.motion(beta).unwrap();
        let half_turn = if system.contact_is_reversed() {
            PI
        } else {
            0.0
        };
        let upper = motion.mass("upper").unwrap();
        let physical = [
            scale.friction(at.continuous_limit()),
            scale.friction(at.sliding_limit()),
            scale.displacement(upper.amplitude()),
            scale.displacement(motion.contact().amplitude()),
            upper.phase(),
            (motion.contact().phase() + half_turn).rem_euclid(TAU),
        ];
        (physical, beta, system.frequency_ratio_at_hertz(2.7))
    };
    let (expected, beta, r) = answers(masses, springs);
    let turned = [masses[1], masses[0]];
    let (swapped, other_beta, other_r) = answers(turned, [springs[1], springs[0]]);
    assert!((beta - other_beta).abs() > 0.01 && (r - other_r).abs() > 0.01);
    for values in [
        swapped,
        answers(turned, springs).0,
        answers(masses, [springs[1], springs[0]]).0,
    ] {
        for (value, expected) in values.into_iter().zip(expected) {
            close(value, expected);
        }
    }
}

/// The reversed motion of the contact is the motion of the description with its masses in the other order, including
/// stops.
#[test]
fn a_contact_turned_round() {
    let system = |masses: &str| -> System {
        format!(
            "struct Frame {{ masses: {{ {masses} }}, springs: {{ base - lower: 1190, lower - upper: 1323 }},
             contact: lower - upper, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }}"
        )
        .parse()
        .unwrap()
    };
    let written = system("lower: 3.27, upper: 3.25");
    let reversed = system("upper: 3.25, lower: 3.27");
    assert!(!written.contact_is_reversed() && reversed.contact_is_reversed());
    let (mut compared, mut stops) = (0, 0);
    for hz in (1..20).map(|index| 0.4 * f64::from(index)) {
        for share in [0.0, 0.3, 0.6, 0.9, 0.97, 1.5] {
            let orbits = [&written, &reversed].map(|system| {
                let at = system.at(system.frequency_ratio_at_hertz(hz)).unwrap();
                let orbit = at.orbit(share * at.sliding_limit()).ok()?;
                let contact = orbit.contact();
                let phases = (contact.phase(), orbit.reversed_contact_phase());
                Some((contact.amplitude(), phases, orbit.stops()))
            });
            let [Some((amplitude, phases, stopped)), Some((_, others, _))] = orbits else {
                continue;
            };
            for (phase, turned) in [(phases.0, others.1), (others.0, phases.1)] {
                assert!((-PI..=PI).contains(&turned));
                let difference = (phase - turned).abs();
                let difference = difference.min((TAU - difference).abs());
                assert!(
                    difference < 1e-9 || amplitude < 1e-9,
                    "{hz} {share}: {phase} {turned}"
                );
            }
            compared += 1;
            stops += usize::from(stopped > 0);
        }
    }
    println!("{compared} states, {stops} with stops");
    assert!(compared > 90 && stops > 20);
}

/// Reversing a motion shifts its phase by half a turn. Both phases lie in (−π, π], so the reversed phase of 0 is π.
#[test]
fn a_reversed_phase_stays_in_its_turn() {
    for (lag, expected) in [(0.0, PI), (PI, 0.0), (0.5, 0.5 - PI), (-0.5, PI - 0.5)] {
        assert_eq!(reversed_phase(lag), expected, "{lag}");
    }
}
