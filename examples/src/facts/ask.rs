//! Scenes of the table, short queries to them, and searches for frequencies.
//!
//! A query that a scene cannot answer returns NaN. No comparison with NaN is true, so the row then does not agree and
//! its test fails.

pub use crate::draw::chain;
use frictiongen::study::{
    System,
    features::{Features, InvariantQuantity, RegimeRange},
    orbit::SystemOrbit,
    response::SystemMotion,
};
use frictiongen::{Of, Regime};

/// Returns a chain of `n` equal masses and equal springs, with the given contact and excitation.
#[must_use]
pub fn unit(n: usize, contact: &str, excitation: &str) -> System {
    chain(&vec![1.0; n], &vec![1.0; n], contact, excitation, "")
}

/// Returns one mass that rubs on a fixed wall. `rest` is the remainder of the description.
#[must_use]
pub fn wall(rest: &str) -> System {
    chain(&[1.0], &[1.0], "m1 - wall", "m1", rest)
}

/// Returns one mass that rubs on a wall on its moving base. `mu` is the ratio of static to kinetic friction.
#[must_use]
pub fn base(mu: f64) -> System {
    let rest = format!("stiction: {mu:?}");
    chain(&[1.0], &[1.0], "m1 - base", "base", &rest)
}

/// Returns the limit of continuous motion β_lim at the frequency ratio r, or NaN.
#[must_use]
pub fn limit(system: &System, r: f64) -> f64 {
    system.at(r).map_or(f64::NAN, |at| at.continuous_limit())
}

/// Returns the limit of sliding β*_lim at the frequency ratio r, or NaN.
#[must_use]
pub fn sliding_limit(system: &System, r: f64) -> f64 {
    system.at(r).map_or(f64::NAN, |at| at.sliding_limit())
}

/// Returns the result of `question` for the continuous motion at the frequency ratio r and the friction ratio β.
/// Returns NaN if there is no continuous motion at r and β.
pub fn ask(system: &System, r: f64, beta: f64, question: impl Fn(&SystemMotion) -> f64) -> f64 {
    let motion = system.at(r).ok().and_then(|at| at.motion(beta).ok());
    motion.as_ref().map_or(f64::NAN, question)
}

/// Returns the monoharmonic estimate (5.50) of a mass's amplitude.
#[must_use]
pub fn estimate(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.amplitude_monoharmonic())
    })
}

/// Returns the exact amplitude of a mass in continuous motion.
#[must_use]
pub fn amplitude(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.amplitude())
    })
}

/// Returns the amplitude of the fundamental of a mass's motion.
#[must_use]
pub fn fundamental(system: &System, mass: &str, r: f64, beta: f64) -> f64 {
    ask(system, r, beta, |motion| {
        let mass = motion.mass(mass);
        mass.map_or(f64::NAN, |mass| mass.harmonic(1).norm())
    })
}

/// Returns the amplitude of a mass while the contact is stuck.
#[must_use]
pub fn stuck(system: &System, mass: &str, r: f64) -> f64 {
    let stuck = system.at(r).ok().and_then(|at| at.stuck().ok());
    stuck
        .and_then(|stuck| stuck.mass(mass).ok())
        .map_or(f64::NAN, |x| x.norm())
}

/// Returns the steady state at r and β that motion from rest reaches, in any regime.
#[must_use]
pub fn orbit(system: &System, r: f64, beta: f64) -> Option<SystemOrbit<'_>> {
    system.at(r).ok()?.orbit(beta).ok()
}

/// Returns the amplitude max|x̄| of a mass in a steady state.
#[must_use]
pub fn orbit_amplitude(orbit: &SystemOrbit<'_>, mass: &str) -> f64 {
    let mass = orbit.mass(mass);
    mass.map_or(f64::NAN, |mass| mass.amplitude())
}

/// Returns the features of a system over frequency, in non-dimensional groups. Without a load the request cannot
/// fail.
fn features(system: &System) -> Option<Features<'_>> {
    system.features(None).ok()
}

/// Finds the invariant points of a motion in a range of frequency ratios. At an invariant point the quantity `measured`
/// does not depend on friction.
#[must_use]
pub fn invariant_points(
    system: &System,
    of: Of,
    measured: InvariantQuantity,
    range: [f64; 2],
) -> Vec<f64> {
    let found = features(system).and_then(|all| all.invariant_points(of, measured, range).ok());
    let found = found.unwrap_or_default();
    found.into_iter().map(|point| point.r).collect()
}

/// Finds the intervals of frequency ratios in which friction enlarges a motion. Returns the bounds of the intervals.
#[must_use]
pub fn inversions(
    system: &System,
    of: Of,
    measured: InvariantQuantity,
    range: [f64; 2],
) -> Vec<f64> {
    let found = features(system).and_then(|all| all.inversions(of, measured, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// Finds the frequency ratios at which the exact amplitudes for two friction ratios are equal. Returns pairs of r and
/// amplitude.
#[must_use]
pub fn crossings(system: &System, of: Of, frictions: [f64; 2], range: [f64; 2]) -> Vec<(f64, f64)> {
    let found = features(system).and_then(|all| all.crossings(of, frictions, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.map(|found| (found.r, found.amplitude)).collect()
}

/// Finds the frequency ratios at which a motion vanishes without friction.
#[must_use]
pub fn antiresonances(system: &System, of: Of, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.antiresonances(of, range).ok());
    let found = found.unwrap_or_default();
    found.into_iter().map(|zero| zero.r).collect()
}

/// Finds the intervals of frequency ratios in which the contact slides at the friction ratio β. Returns the bounds of
/// the intervals.
#[must_use]
pub fn sliding_ranges(system: &System, beta: f64, range: [f64; 2]) -> Vec<f64> {
    let found = features(system).and_then(|all| all.sliding_ranges(beta, range).ok());
    let found = found.unwrap_or_default().into_iter();
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// Finds the regimes over a range of frequency ratios, at the friction ratio β.
#[must_use]
pub fn regimes(system: &System, beta: f64, range: [f64; 2]) -> Vec<RegimeRange> {
    let found = features(system).and_then(|all| all.regimes(beta, range).ok());
    found.map_or_else(Vec::new, |(found, _)| found)
}

/// Finds the intervals of frequency ratios with continuous motion at the friction ratio β. Returns the bounds of the
/// intervals.
#[must_use]
pub fn continuous(system: &System, beta: f64, range: [f64; 2]) -> Vec<f64> {
    let found = regimes(system, beta, range).into_iter();
    let found = found.filter(|found| found.regime == Regime::Continuous);
    found.flat_map(|found| [found.from, found.to]).collect()
}

/// Returns the number with this index if the list has exactly `count` numbers, and otherwise NaN.
#[must_use]
pub fn one_of(places: &[f64], count: usize, index: usize) -> f64 {
    if places.len() == count {
        places.get(index).copied().unwrap_or(f64::NAN)
    } else {
        f64::NAN
    }
}

/// Finds the argument between `low` and `high` at which the function f changes its sign, to the last bits. Returns
/// NaN if f has the same sign at both bounds.
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

/// Finds the maximum of a function with one peak between `low` and `high`. A smooth peak is flat, so rounding leaves
/// its position uncertain by √ε ≈ 1e-8.
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

/// Finds the frequency ratio at which the contact's motion does not depend on the friction ratio β (6.9). At this
/// frequency ratio the phase of the contact is 0 or π for every β, and the sine of the phase changes sign. `share` is
/// β/β_lim.
#[must_use]
pub fn contact_invariant(system: &System, share: f64, low: f64, high: f64) -> f64 {
    let sine = |r| {
        let beta = share * limit(system, r);
        ask(system, r, beta, |motion| motion.contact().phase().sin())
    };
    root(sine, low, high)
}

/// Finds the frequency ratio at which a quantity of the continuous motion does not depend on the friction ratio. The
/// function compares two friction ratios.
pub fn invariant(system: &System, of: impl Fn(f64, f64) -> f64, low: f64, high: f64) -> f64 {
    root(|r| growth(system, &of, r), low, high)
}

/// Returns by how much a quantity increases when β rises from 0.45 to 0.9 times β_lim.
pub fn growth(system: &System, of: impl Fn(f64, f64) -> f64, r: f64) -> f64 {
    let beta = 0.9 * limit(system, r);
    of(r, beta) - of(r, 0.5 * beta)
}
