//! Digits of a stiff contact, and of single precision.

use frictiongen::System;
use frictiongen::scalar::{Dd, Plain};

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: STIFF,
    excitation: base, damping: modal[0.10, 0.12], provide: [orbit, simulation] }";

/// Returns the events of the first cycle from rest, and at its end the displacements and the contact force.
fn first_cycle<S: Plain>(stiffness: f64) -> (usize, Vec<f64>) {
    let text = FRAME.replace("STIFF", &format!("{stiffness:?}"));
    let system: System<S> = text.parse().expect("a scene");
    let number = S::constant;
    let mut run = system.simulation(number(0.9), number(0.3)).expect("a run");
    let end = S::pi() + S::pi();
    let (mut passed, mut events) = (number(0.0), 0);
    while passed < end {
        let segment = run.advance(end - passed).expect("a segment");
        passed = passed + segment.length;
        events += usize::from(segment.event.is_some());
    }
    let masses = ["lower", "upper"].map(|name| run.mass(name).expect("a mass").displacement());
    let all = masses.into_iter().chain([run.friction()]);
    (events, all.map(|value| value.to_f64()).collect())
}

/// Compares double precision with double-double.
fn compared(stiffness: f64, tolerance: f64) {
    let (events, own) = first_cycle::<f64>(stiffness);
    let (expected_events, expected) = first_cycle::<Dd>(stiffness);
    println!("k = {stiffness:e}: {events} events, {own:?}, {expected:?}");
    assert_eq!(events, expected_events);
    for (own, expected) in own.iter().zip(&expected) {
        let error = (own - expected).abs();
        assert!(error < tolerance, "k = {stiffness:e}: {own} for {expected}");
    }
}

#[test]
fn a_stiff_contact_keeps_its_digits() {
    for stiffness in [1.0, 1e3, 1e5, 1e7] {
        compared(stiffness, 1e-10);
    }
}

#[test]
#[ignore = "the contact vibrates tens of thousands of times in the cycle"]
fn the_stiffest_contact_keeps_ten_digits() {
    compared(1.1e13, 1e-10);
}

#[test]
fn single_precision_follows_double_precision() {
    for stiffness in [10.0, 1e3, 1e4, 1e5] {
        let (events, own) = first_cycle::<f32>(stiffness);
        let (expected_events, expected) = first_cycle::<f64>(stiffness);
        assert_eq!(events, expected_events, "k = {stiffness:e}");
        for (own, expected) in own.iter().zip(&expected) {
            assert!(
                (own - expected).abs() < 1e-4,
                "k = {stiffness:e}: {own} for {expected}"
            );
        }
    }
}
