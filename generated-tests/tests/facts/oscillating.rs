//! Contacts between oscillating parts, and the rig: F27, F28, F30, F32.

use super::{amplitude, ask, chain, close, estimate, limit, root};
use frictiongen::study::System;
use std::f64::consts::TAU;

/// Two masses that rub on each other, γ = κ = 0.5, force on m₁.
fn between() -> System {
    chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "")
}

/// Printed β_n 0.785 and 0.393, β_∞ 0.179, β*_∞ 0.333.
#[test]
fn f27() {
    let system = between();
    let found = system.resonance_thresholds();
    let (continuous, sliding) = system.high_frequency_limits();
    let rows = [
        (found[0].unwrap(), 0.785, 0.785398, 5e-7),
        (found[1].unwrap(), 0.393, 0.392699, 5e-7),
        (continuous, 0.179, 0.17901, 5e-6),
        (sliding, 0.333, 0.333333, 5e-7),
    ];
    for (got, printed, comes_out, digits) in rows {
        close(got, printed, 5e-4);
        close(got, comes_out, digits);
    }
    // Far above the resonances the limits differ from these by some 1/r².
    let at = system.at(1e4).unwrap();
    close(at.continuous_limit(), continuous, 1e-7);
    close(at.sliding_limit(), sliding, 1e-7);
}

/// Printed 0.778 and 1.213 for the estimate, 0.770 and 1.226 for the exact amplitude.
#[test]
fn f28() {
    let system = between();
    let crossing = |of: fn(&System, &str, f64, f64) -> f64, one, other, low, high| {
        root(
            |r| of(&system, "m1", r, one) - of(&system, "m1", r, other),
            low,
            high,
        )
    };
    for (one, other) in [(0.05, 0.1), (0.02, 0.2)] {
        let first = crossing(estimate, one, other, 0.75, 0.8);
        let second = crossing(estimate, one, other, 1.19, 1.24);
        close(first, 0.778, 5e-4);
        close(first, 0.777873, 5e-7);
        // Printed 1.213, cut off rather than rounded.
        close(second, 1.21352, 5e-6);
    }
    // The exact amplitudes do not meet in one point: it moves with the pair of β.
    for (one, other, first, second) in [
        (0.01, 0.02, 0.7776, 1.2143),
        (0.05, 0.2, 0.7755, 1.2199),
        (0.2, 0.3, 0.7737, 1.2241),
    ] {
        close(crossing(amplitude, one, other, 0.75, 0.8), first, 5e-5);
        close(crossing(amplitude, one, other, 1.19, 1.24), second, 5e-5);
    }
}

const GAMMA: f64 = 0.9772;
const KAPPA: f64 = 1.1119;
/// Printed as r₁ = (0.3419 s)ω.
const RATIO: f64 = 0.3419;

/// Printed r₁/ω = 0.3419 s, γ = 0.9772, κ = 1.1119, from ω₀, ω₁, ω₂ by (6.17) to (6.19).
#[test]
fn f30() {
    // √(m₁/k₁) = 0.3419 s/2π: see below.
    let mass = 3.27;
    let stiffness = mass * (TAU / RATIO).powi(2);
    let system = chain(
        &[mass, GAMMA * mass],
        &[stiffness, KAPPA * stiffness],
        "m1 - base",
        "base",
        "",
    );
    let natural = system.natural_frequencies();
    let antiresonance = f64::sqrt(KAPPA * stiffness / (GAMMA * mass));
    let relative = antiresonance * f64::sqrt(1.0 + GAMMA);
    let product = natural[0] * natural[1];
    close(antiresonance / product * TAU, RATIO, 1e-13);
    close((relative / antiresonance).powi(2) - 1.0, GAMMA, 1e-13);
    close(
        GAMMA * (antiresonance.powi(2) / product).powi(2),
        KAPPA,
        1e-13,
    );
    // Each of them is what its name says: without friction m₁ stands still at ω₀, and moves with
    // the base at ω_z0.
    let free = |omega| amplitude(&system, "m1", system.frequency_ratio(omega), 0.0);
    close(free(antiresonance), 0.0, 1e-12);
    let slip = |omega| {
        let r = system.frequency_ratio(omega);
        ask(&system, r, 0.0, |motion| motion.contact().amplitude())
    };
    close(slip(relative), 0.0, 1e-12);
    // With ω in rad/s, 0.3419 s would put √(k₁/m₁) at 0.466 Hz, where the one-storey rig of the
    // same plates and bars has 3.086 Hz (F31); with the frequency in Hz it is 2.925 Hz.  Hence 2π.
    close(1.0 / RATIO, 2.925, 5e-4);
    close(1.0 / (TAU * RATIO), 0.4655, 5e-5);
    println!("natural frequencies: {natural:?} rad/s");
}

/// Printed 1.09; comes out as √(κ/γ) = 1.0667, for the fundamental.
#[test]
fn f32() {
    let system = chain(&[1.0, GAMMA], &[1.0, KAPPA], "m1 - base", "base", "");
    let fundamental = |r: f64, beta: f64| {
        ask(&system, r, beta, |motion| {
            motion.contact().harmonic(1).norm()
        })
    };
    let difference = |r: f64| {
        let beta = 0.9 * limit(&system, r);
        fundamental(r, beta) - fundamental(r, 0.3 * beta)
    };
    let invariant = root(difference, 1.04, 1.12);
    close(invariant, 1.0667, 5e-5);
    close(invariant, f64::sqrt(KAPPA / GAMMA), 1e-9);
    // m₂ swings freely there and lets m₁ have no fundamental at all.
    for beta in [0.1, 0.3, 0.5] {
        let r = f64::sqrt(KAPPA / GAMMA);
        close(fundamental(r, beta), 1.0, 1e-12);
    }
}
