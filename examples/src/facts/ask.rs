//! Scenes of the table, short questions to them, and searches for places.
//!
//! A question that a scene does not answer gives NaN, with which no comparison holds: the row then
//! has no verdict, and its test fails.

pub use crate::draw::chain;
use frictiongen::study::{System, SystemMotion, SystemOrbit};

/// A chain of equal masses and springs.
#[must_use]
pub fn unit(n: usize, contact: &str, excitation: &str) -> System {
    chain(&vec![1.0; n], &vec![1.0; n], contact, excitation, "")
}

/// One mass against a fixed wall.
#[must_use]
pub fn wall(rest: &str) -> System {
    chain(&[1.0], &[1.0], "m1 - wall", "m1", rest)
}

/// One mass, the wall on its moving base.
#[must_use]
pub fn base(mu: f64) -> System {
    let rest = format!("stiction: {mu:?}");
    chain(&[1.0], &[1.0], "m1 - base", "base", &rest)
}

/// β_lim.
#[must_use]
pub fn limit(system: &System, r: f64) -> f64 {
    system.at(r).map_or(f64::NAN, |at| at.continuous_limit())
}

/// β*_lim.
#[must_use]
pub fn sliding_limit(system: &System, r: f64) -> f64 {
    system.at(r).map_or(f64::NAN, |at| at.sliding_limit())
}

/// A question to the continuous motion at r and β.
pub fn ask(system: &System, r: f64, beta: f64, question: impl Fn(&SystemMotion) -> f64) -> f64 {
    let motion = system.at(r).ok().and_then(|at| at.motion(beta).ok());
    motion.as_ref().map_or(f64::NAN, question)
}

/// The monoharmonic estimate (5.50) of a mass's amplitude.
#[must_use]
pub fn estimate(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.amplitude_monoharmonic())
    })
}

/// The exact amplitude of a mass in continuous motion.
#[must_use]
pub fn amplitude(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.amplitude())
    })
}

/// The fundamental of a mass's motion.
#[must_use]
pub fn fundamental(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.harmonic(1).norm())
    })
}

/// The amplitude of a mass while the contact is stuck.
#[must_use]
pub fn stuck(system: &System, mass: &str, r: f64) -> f64 {
    let stuck = system.at(r).ok().and_then(|at| at.stuck().ok());
    stuck
        .and_then(|stuck| stuck.mass(mass).ok())
        .map_or(f64::NAN, |x| x.norm())
}

/// The steady state in any regime.
#[must_use]
pub fn orbit(system: &System, r: f64, beta: f64) -> Option<SystemOrbit<'_>> {
    system.at(r).ok()?.orbit(beta).ok()
}

/// max|x̄| of a mass in a steady state.
#[must_use]
pub fn orbit_amplitude(orbit: &SystemOrbit<'_>, mass: &str) -> f64 {
    let mass = orbit.mass(mass);
    mass.map_or(f64::NAN, |mass| mass.amplitude())
}

/// The place where f changes sign, to the last bits; NaN where it does not.
pub fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    let opposite = sign * f(high) < 0.0;
    if !opposite {
        return f64::NAN;
    }
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
pub fn peak(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            low += third;
        } else {
            high -= third;
        }
    }
    0.5 * (low + high)
}

/// Where the contact's motion does not depend on β (6.9): its phase is there 0 or π for every β,
/// and changes sign.  β is this share of β_lim.
#[must_use]
pub fn contact_invariant(system: &System, share: f64, low: f64, high: f64) -> f64 {
    let sine = |r| {
        let beta = share * limit(system, r);
        ask(system, r, beta, |motion| motion.contact().phase().sin())
    };
    root(sine, low, high)
}

/// Where a quantity of the continuous motion at r and β does not depend on β: that of two shares of
/// β_lim is compared.
pub fn invariant(system: &System, of: impl Fn(f64, f64) -> f64, low: f64, high: f64) -> f64 {
    root(|r| growth(system, &of, r), low, high)
}

/// What a quantity gains from 0.45 to 0.9 times β_lim.
pub fn growth(system: &System, of: impl Fn(f64, f64) -> f64, r: f64) -> f64 {
    let beta = 0.9 * limit(system, r);
    of(r, beta) - of(r, 0.5 * beta)
}
