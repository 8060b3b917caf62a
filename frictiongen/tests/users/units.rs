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

/// Reversing a motion shifts its phase by half a turn. Both phases lie in (−π, π], so the reversed phase of 0 is π.
#[test]
fn a_reversed_phase_stays_in_its_turn() {
    for (lag, expected) in [(0.0, PI), (PI, 0.0), (0.5, 0.5 - PI), (-0.5, PI - 0.5)] {
        assert_eq!(reversed_phase(lag), expected, "{lag}");
    }
}
