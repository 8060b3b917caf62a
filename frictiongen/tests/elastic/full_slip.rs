//! The full-slip loop of one Jenkins element under a prescribed motion: stiffness 2, friction force 3, displacement ±5.
//!
//! A mass of 10²⁰ stays at rest to rounding, while the base moves by 5 cos τ.

use super::energy::gauss;
use frictiongen::System;
use frictiongen::answer::Contact;
use std::f64::consts::{PI, TAU};

const STIFFNESS: f64 = 2.0;
const LEVEL: f64 = 3.0;
const SWING: f64 = 5.0;

fn element() -> System {
    "struct Element { masses: { anvil: 1e20 }, springs: { base - anvil: 1.0 }, contact: anvil - base, stiffness: 2.0,
        excitation: base, provide: [orbit, simulation] }"
        .parse()
        .expect("a scene")
}

/// Returns r for ω = 1, and β.
fn point(system: &System) -> (f64, f64) {
    (system.frequency_ratio(1.0), LEVEL / SWING)
}

/// Force at a phase of the steady loop, with z = −5 cos τ: up from τ = 0, down from τ = π.
fn closed_form(tau: f64) -> f64 {
    let half = (tau / PI).floor();
    let sign = if half % 2.0 == 0.0 { 1.0 } else { -1.0 };
    let since = tau - half * PI;
    sign * LEVEL.min(STIFFNESS * SWING * (1.0 - since.cos()) - LEVEL)
}

/// From rest the element first loads without preload.  From the first reversal on it follows the steady loop.
#[test]
fn forces_follow_the_loop() {
    let system = element();
    let (r, beta) = point(&system);
    let mut run = system.simulation(r, beta).expect("a run");
    let (mut phase, mut compared) = (0.0, 0);
    for step in 1..=2000 {
        let to = f64::from(step) * 0.0123;
        while phase < to {
            phase += run.advance(to - phase).expect("a step").length;
        }
        let force = run.friction() * SWING;
        let expected = if to < PI {
            LEVEL.min(STIFFNESS * SWING * (1.0 - to.cos()))
        } else {
            closed_form(to)
        };
        // The phase of this many steps is rounded, and the force changes by up to 10 per radian.
        assert!(
            (force - expected).abs() < 2e-13,
            "{to}: {force} for {expected}"
        );
        let z = run.relative().0 * SWING;
        assert!((z + SWING * to.cos()).abs() < 2e-13);
        compared += 1;
    }
    assert_eq!(compared, 2000);
}

/// Energy 4F(X − F/k) of a cycle, the times of its events, and the harmonics of the force to 1e-14.
#[test]
fn energy_and_harmonics_are_closed_forms() {
    let system = element();
    let (r, beta) = point(&system);
    // The slider moves off when the force has changed by 2F.
    let slip = (1.0 - 2.0 * LEVEL / (STIFFNESS * SWING)).acos();
    let mut run = system.simulation(r, beta).expect("a run");
    let mut cycle = Vec::new();
    let mut passed = 0.0;
    while passed < 2.0 * TAU - 1e-9 {
        let (from, contact) = (run.relative().0, run.contact());
        let segment = run.advance(2.0 * TAU - passed).expect("a segment");
        if TAU - 1e-9 < passed {
            cycle.push((contact, passed, segment.length, run.relative().0 - from));
        }
        passed += segment.length;
    }
    let expected = [slip, PI - slip, slip, PI - slip];
    assert_eq!(cycle.len(), 4);
    for ((_, _, length, _), expected) in cycle.iter().zip(expected) {
        assert!((length - expected).abs() < 1e-13, "{length} for {expected}");
    }
    let slid = cycle
        .iter()
        .filter(|(contact, ..)| *contact != Contact::Stuck);
    let energy: f64 = slid.map(|(.., moved)| LEVEL * SWING * moved.abs()).sum();
    assert!(
        (energy - 4.0 * LEVEL * (SWING - LEVEL / STIFFNESS)).abs() < 1e-12,
        "{energy}"
    );
    let mut run = system.simulation(r, beta).expect("a run");
    let mut reached = 0.0;
    let mut harmonics = [[0.0_f64; 4]; 5];
    for (_, start, length, _) in cycle {
        for panel in 0..8 {
            let width = length / 8.0;
            for (node, weight) in gauss(width) {
                let tau = start + f64::from(panel) * width + node;
                while reached < tau {
                    reached += run.advance(tau - reached).expect("a step").length;
                }
                for (index, [re, im, exact_re, exact_im]) in harmonics.iter_mut().enumerate() {
                    let (sine, cosine) = ((2 * index + 1) as f64 * tau).sin_cos();
                    let (force, exact) = (run.friction() * SWING, closed_form(tau));
                    *re += weight * force * cosine / PI;
                    *im -= weight * force * sine / PI;
                    *exact_re += weight * exact * cosine / PI;
                    *exact_im -= weight * exact * sine / PI;
                }
            }
        }
    }
    // The fundamental of the loop in closed form: f = −F + kX(1 − cos τ) up to the slip, then F, and half a cycle later
    // the opposite.
    let (k, x, f) = (STIFFNESS, SWING, LEVEL);
    let cosine =
        k * x * (slip.sin() - slip / 2.0 - (2.0 * slip).sin() / 4.0) - 2.0 * f * slip.sin();
    let sine = k * x * (1.0 - slip.cos() - slip.sin().powi(2) / 2.0) - f * (1.0 - slip.cos())
        + f * (1.0 + slip.cos());
    let fundamental = [2.0 * cosine / PI, -2.0 * sine / PI];
    for (n, [re, im, exact_re, exact_im]) in harmonics.into_iter().enumerate() {
        let error = (re - exact_re).hypot(im - exact_im);
        assert!(
            error < 1e-14 * 4.0 * LEVEL / PI,
            "harmonic {}: {error:e}",
            2 * n + 1
        );
        if n == 0 {
            let error = (re - fundamental[0]).hypot(im - fundamental[1]);
            assert!(error < 1e-13, "{error:e}: {re}, {im} for {fundamental:?}");
        }
    }
}
