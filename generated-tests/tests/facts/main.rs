//! Numbers that the thesis prints, each as a test named by its row: `f01` … `f32`.
//!
//! "Printed" is the thesis's number, "comes out" what the governing equations give to more digits.
//! A printed number is held to half a unit of its last digit, unless the test says why it is off;
//! a number that comes out of a search for a root is held to half a unit of the last digit stated.
//!
//! Left out: F09 (largest transmissibility of any sliding state), F34 (time responses), and of F10
//! the integration.

use frictiongen::study::{System, SystemMotion};

mod chains;
mod oscillating;
mod single;
mod stops;

/// A fixed-free chain m1, m2, … with springs base - m1, m1 - m2, …; `gamma` and `kappa` list the
/// ratios.
fn chain(gamma: &[f64], kappa: &[f64], contact: &str, excitation: &str, rest: &str) -> System {
    let masses: Vec<String> = (1..)
        .zip(gamma)
        .map(|(i, gamma)| format!("m{i}: {gamma:?}"))
        .collect();
    let springs: Vec<String> = (1..)
        .zip(kappa)
        .map(|(i, kappa)| match i {
            1 => format!("base - m1: {kappa:?}"),
            _ => format!("m{} - m{i}: {kappa:?}", i - 1),
        })
        .collect();
    let text = format!(
        "struct Scene {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact}, \
         excitation: {excitation}, {rest} }}",
        masses.join(", "),
        springs.join(", "),
    );
    text.parse().expect("a valid scene")
}

/// A chain of equal masses and springs.
fn unit(n: usize, contact: &str, excitation: &str) -> System {
    chain(&vec![1.0; n], &vec![1.0; n], contact, excitation, "")
}

fn limit(system: &System, r: f64) -> f64 {
    system.at(r).expect("in the domain").continuous_limit()
}

fn sliding_limit(system: &System, r: f64) -> f64 {
    system.at(r).expect("in the domain").sliding_limit()
}

/// A question to the continuous motion at r and β.
fn ask(system: &System, r: f64, beta: f64, question: impl Fn(&SystemMotion) -> f64) -> f64 {
    let at = system.at(r).expect("in the domain");
    question(&at.motion(beta).expect("continuous"))
}

/// The monoharmonic estimate (5.50) of a mass's amplitude.
fn estimate(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        motion.mass(mass).expect(mass).amplitude_monoharmonic()
    })
}

/// The exact amplitude of a mass.
fn amplitude(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        motion.mass(mass).expect(mass).amplitude()
    })
}

/// The fundamental of a mass's motion.
fn fundamental(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        motion.mass(mass).expect(mass).harmonic(1).norm()
    })
}

/// The place where f changes sign, to the last bits.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    assert!(
        sign * f(high) < 0.0,
        "no change of sign in [{low}, {high}]: {}, {}",
        f(low),
        f(high)
    );
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if sign * f(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The place of the largest value of a function with one peak in [low, high].  Where it is flat,
/// rounding leaves √ε ≈ 1e-8 of the place undecided.
fn peak(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            low += third;
        } else {
            high -= third;
        }
    }
    0.5 * (low + high)
}

/// `got` is `want`, a number stated to `tolerance`.
#[track_caller]
fn close(got: f64, want: f64, tolerance: f64) {
    assert!(
        (got - want).abs() <= tolerance,
        "{got} instead of {want}, which is stated to {tolerance}"
    );
}
