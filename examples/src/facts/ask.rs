//! Scenes of the table, short questions to them, and searches for places.
//!
//! A question that a scene does not answer gives NaN, with which no comparison holds: the row then
//! has no verdict, and its test fails.

pub use crate::draw::chain;
use frictiongen::study::{Features, Measured, RegimeRange, System, SystemMotion, SystemOrbit};
use frictiongen::{Of, Regime};

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

/// The features of a system, in groups: no load, so that none can be refused.
fn features(system: &System) -> Option<Features<'_>> {
    system.features(None).ok()
}

/// The invariant points of a motion between two r, by their conditions (6.9), (6.10) or of the fundamental component.
#[must_use]
pub fn invariant_points(system: &System, of: Of, measured: Measured, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.invariant_points(of, measured, range).ok());
    let found = found.unwrap_or_default();
    found.into_iter().map(|point| point.r).collect()
}

/// The ends of the ranges between two r in which friction enlarges a motion.
#[must_use]
pub fn inversions(system: &System, of: Of, measured: Measured, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.inversions(of, measured, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// Where the exact amplitudes of two frictions cross, and how large they are.
#[must_use]
pub fn crossings(system: &System, of: Of, frictions: [f64; 2], range: [f64; 2]) -> Vec<(f64, f64)> {
    let found = features(system).and_then(|all| all.crossings(of, frictions, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.map(|found| (found.r, found.amplitude)).collect()
}

/// Where a motion vanishes without friction.
#[must_use]
pub fn antiresonances(system: &System, of: Of, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.antiresonances(of, range).ok());
    let found = found.unwrap_or_default();
    found.into_iter().map(|zero| zero.r).collect()
}

/// The ends of the ranges in which the contact slides at β.
#[must_use]
pub fn sliding_ranges(system: &System, beta: f64, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.sliding_ranges(beta, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// The regimes between two r at β.
#[must_use]
pub fn regimes(system: &System, beta: f64, range: [f64; 2]) -> Vec<RegimeRange> {
    let found = features(system).and_then(|all| all.regimes(beta, range).ok());
    found.map_or_else(Vec::new, |(found, _)| found)
}

/// The ends of the ranges of continuous motion between two r at β.
#[must_use]
pub fn continuous(system: &System, beta: f64, range: [f64; 2]) -> Vec<f64> {
    let found = regimes(system, beta, range).into_iter();
    let found = found.filter(|found| found.regime == Regime::Continuous);
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// One of so many places; NaN if there are more or fewer.
#[must_use]
pub fn one_of(places: &[f64], count: usize, index: usize) -> f64 {
    if places.len() == count {
        places.get(index).copied().unwrap_or(f64::NAN)
    } else {
        f64::NAN
    }
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
