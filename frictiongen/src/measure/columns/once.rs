//! Single values of measurements, each with a key for programs.

use crate::measure::{Estimate, FreeDecay, Identified, MotionFit, SweepFit, Unknown};
use crate::study::System;
use crate::study::units::hertz;

/// A single value of a measurement, with its key for programs.
pub type Keyed = (&'static str, SingleValue);

/// A single value of a measurement.
#[derive(Clone, Debug)]
pub enum SingleValue {
    /// The value is a number. It is `None` if the number is unknown.
    Number(Option<f64>),
    /// The value is a number of items.
    Count(usize),
    /// The value is true or false.
    Flag(bool),
    /// The value is a word or a sentence.
    Text(String),
    /// The value is a number with its 95 % interval. It is `None` if the number is unknown.
    Estimate(Option<Estimate>),
    /// The value is a list of numbers, each with its 95 % interval.
    Estimates(Vec<Estimate>),
    /// The value is a list of numbers, each with a name and a 95 % interval.
    Named(Vec<(String, Estimate)>),
    /// The value is a list of names.
    Names(Vec<String>),
}

/// Returns a number and its interval, both multiplied by `scale`.
pub(super) fn scaled(found: Estimate, scale: f64) -> Estimate {
    Estimate {
        value: found.value * scale,
        from: found.from * scale,
        to: found.to * scale,
    }
}

/// Returns the fitted unknowns, each with its name for programs. The factor on all natural frequencies becomes one
/// natural frequency in Hz for each mode.
fn unknowns<'f>(
    system: &System,
    found: impl Iterator<Item = &'f (Unknown, Estimate)>,
) -> Vec<(String, Estimate)> {
    let mut all = Vec::new();
    for (unknown, estimate) in found {
        match unknown {
            Unknown::Frequencies => {
                let natural = (1..).zip(system.natural_frequencies());
                all.extend(natural.map(|(mode, omega): (u32, f64)| {
                    let name = format!("natural_frequency_{mode}_Hz");
                    (name, scaled(*estimate, hertz(omega)))
                }));
            }
            Unknown::Damping => all.push(("damping".to_owned(), *estimate)),
            Unknown::Stiction => all.push(("stiction".to_owned(), *estimate)),
            _ => all.push((unknown.symbol(system), *estimate)),
        }
    }
    all
}

/// Returns the single values of an identification, with their keys.
#[must_use]
pub fn identify_values(system: &System, found: &Identified) -> Vec<Keyed> {
    let open = found.undetermined();
    let open = found
        .unknowns
        .iter()
        .filter(|(unknown, _)| open.contains(unknown));
    let open = unknowns(system, open).into_iter().map(|(name, _)| name);
    vec![
        ("friction_N", SingleValue::Estimate(Some(found.friction))),
        ("levels", SingleValue::Estimates(found.levels.clone())),
        (
            "verdict",
            SingleValue::Text(found.verdict.word().to_owned()),
        ),
        ("says", SingleValue::Text(found.verdict.to_string())),
        (
            "unknowns",
            SingleValue::Named(unknowns(system, found.unknowns.iter())),
        ),
        ("undetermined", SingleValue::Names(open.collect())),
        ("condition", SingleValue::Number(Some(found.condition))),
        ("misfit", SingleValue::Number(found.misfit)),
        ("freedom", SingleValue::Count(found.freedom)),
        ("is_explained", SingleValue::Flag(found.is_explained())),
    ]
}

/// Returns the single values of a fit to a sweep, with their keys.
#[must_use]
pub fn fit_values(system: &System, found: &SweepFit) -> Vec<Keyed> {
    let scene = system.scene();
    let masses = scene.masses.iter().skip(1).zip(&found.masses);
    let masses = masses.map(|(mass, ratio)| (mass.name.clone(), *ratio));
    let springs = scene.springs.iter().skip(1).zip(&found.springs);
    let springs = springs.map(|(spring, ratio)| {
        let (from, to) = (scene.node_name(spring.from), scene.node_name(spring.to));
        (format!("{from} - {to}"), *ratio)
    });
    vec![
        ("reference_Hz", SingleValue::Estimate(Some(found.reference))),
        ("mass_ratios", SingleValue::Named(masses.collect())),
        ("stiffness_ratios", SingleValue::Named(springs.collect())),
        ("damping", SingleValue::Estimate(found.damping)),
        (
            "natural_frequencies_Hz",
            SingleValue::Estimates(found.natural.clone()),
        ),
        ("misfit", SingleValue::Number(found.misfit)),
        ("freedom", SingleValue::Count(found.freedom)),
        ("is_explained", SingleValue::Flag(found.is_explained())),
        ("scatter", SingleValue::Number(Some(found.scatter))),
        ("condition", SingleValue::Number(Some(found.condition))),
    ]
}

/// Returns the single values of a fit to the whole motion in a recording, with their keys.
#[must_use]
pub fn motion_values(system: &System, found: &MotionFit) -> Vec<Keyed> {
    let numbers = found.numbers.iter();
    let numbers = numbers.map(|(number, found)| (number.symbol(system.scene()), *found));
    vec![
        ("friction_N", SingleValue::Estimate(found.friction)),
        ("numbers", SingleValue::Named(numbers.collect())),
        ("scatter", SingleValue::Number(Some(found.scatter))),
        ("freedom", SingleValue::Count(found.freedom)),
        ("condition", SingleValue::Number(Some(found.condition))),
        ("runs", SingleValue::Count(found.runs)),
        ("exact_derivatives", SingleValue::Count(found.derivatives)),
        ("differences", SingleValue::Count(found.differences)),
    ]
}

/// Returns the single values of a fit to a free vibration, with their keys.
#[must_use]
pub fn decay_values(found: &FreeDecay) -> Vec<Keyed> {
    let estimate = |found| SingleValue::Estimate(Some(found));
    vec![
        ("friction_N", estimate(found.friction)),
        ("length_m", estimate(found.length)),
        ("frequency_Hz", estimate(found.hertz)),
        ("damping", estimate(found.damping)),
        (
            "linear_decrement_m",
            SingleValue::Number(Some(found.linear_decrement)),
        ),
        ("misfit", SingleValue::Number(Some(found.misfit))),
    ]
}
