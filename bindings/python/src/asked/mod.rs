//! Reads Python arguments: numbers, names, frequencies, frictions and loads.

mod frequency;
mod friction;
pub mod measure;
mod numbers;
pub mod periodic;
pub mod start;

pub use frequency::{FrequencyKeywords, FrequencyRange, FrequencyValues};
pub use friction::{FrictionKeywords, FrictionValues};
pub use measure::{LoadKeywords, Measure};
pub use numbers::{numbers, one, whole};
pub use start::{DrivenKeywords, driven};

use crate::columns::NamedArrays;
use crate::errors::{domain, wrong_type};
use frictiongen::System;
pub use frictiongen::study::columns::MovingPart;
use frictiongen::study::columns::{Column, ColumnAxis, FrequencyUnit, Setting};
use pyo3::prelude::*;
use pyo3::types::PyString;

/// Number of evenly spaced frequencies at which an answer evaluates a frequency range `(from, to)`.
const ACROSS: u32 = 161;

/// Number of evenly spaced frictions at which an answer evaluates a friction range `(from, to)`.
const UP: u32 = 81;

/// Largest number of points (frequency, friction) in an answer. The command has the same limit.
pub const MOST_POINTS: usize = 10_000_000;

/// Largest number of floating-point numbers in an answer. This many numbers take 800 MB.
const MOST_NUMBERS: usize = 100_000_000;

/// Largest order of a harmonic that the caller may request.
pub const MOST_HARMONICS: u32 = 9999;

/// A Python argument that the caller may leave out.
pub type Optional<'py> = Option<Bound<'py, PyAny>>;

/// Returns the settings with which the library builds its tables. The lists of given frequencies and frictions are
/// empty, because only printed tables use them, to choose the numbers of decimals.
pub fn setting<'a>(
    system: &'a System,
    measure: Measure,
    frequency: FrequencyUnit,
    parts: &'a [MovingPart],
) -> Setting<'a> {
    Setting {
        parts,
        ..Setting::new(system, measure, frequency)
    }
}

/// Fails if the caller gives one of these arguments, which a scene with several contacts does not have.
pub fn without(arguments: &[(bool, &str)]) -> PyResult<()> {
    match arguments.iter().find(|(given, _)| *given) {
        None => Ok(()),
        Some((_, argument)) => Err(domain(format_args!(
            "{argument} has no answer for a scene with several `contacts`, `dampers` or `friction: stribeck`; leave it out"
        ))),
    }
}

/// Adds the columns of an answer over frequency and friction: frequencies, frictions, and results. The results are in
/// the order of the frequencies. The results at one frequency are in the order of the frictions.
pub fn put_grid<R>(
    arrays: &mut NamedArrays<'_>,
    (frequencies, frictions): (&FrequencyValues, &FrictionValues),
    setting: &Setting<'_>,
    (columns, rows): (&[Column<'_, R>], &[R]),
) -> PyResult<()> {
    arrays.reshape(&frequencies.shape());
    frequencies.put(arrays, setting)?;
    arrays.reshape(&frictions.shape());
    frictions.put(arrays, setting)?;
    arrays.reshape(&[frequencies.shape(), frictions.shape()].concat());
    arrays.along(ColumnAxis::Row, columns, rows)
}

/// Reads one name, or a list of names, from Python.
pub fn names(argument: &str, given: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<String>> {
    let Some(given) = given else {
        return Ok(Vec::new());
    };
    if let Ok(name) = given.cast::<PyString>() {
        return Ok(vec![name.to_str()?.to_owned()]);
    }
    given.extract().map_err(|_| {
        wrong_type(format_args!(
            "{argument}: a name or a list of names is needed"
        ))
    })
}

/// Returns the quantities with the given names, each only once: displacements, velocities, accelerations, and forces,
/// energies and equivalent damping of the contact. Without names, returns the contact and all masses.
pub fn quantities(
    system: &System,
    argument: &str,
    given: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<MovingPart>> {
    let mut asked = names(argument, given)?;
    if asked.is_empty() {
        let masses = system.scene().masses.iter();
        asked = std::iter::once(system.scene().contact_name.clone())
            .chain(masses.map(|mass| mass.name.clone()))
            .collect();
    }
    let mut parts: Vec<MovingPart> = Vec::new();
    for name in asked {
        if parts.iter().any(|part| part.name == name) {
            return Err(domain(format_args!("{argument}: `{name}` is given twice")));
        }
        let part = MovingPart::named(system, &name);
        parts.push(part.map_err(|error| domain(format_args!("{argument}: {error}")))?);
    }
    Ok(parts)
}

/// Returns the contact and masses with the given names, as [`quantities`] does. Fails for a quantity that is neither a
/// displacement nor a spring force.
pub fn parts(
    system: &System,
    argument: &str,
    given: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<MovingPart>> {
    let parts = quantities(system, argument, given)?;
    match parts.iter().find(|part| part.has_rate()) {
        None => Ok(parts),
        Some(part) => Err(domain(format_args!(
            "{argument}: `{}`: write the motion alone; `response`, `orbit`, `curve` and `optimum` have velocities, accelerations, and force, energy and equivalent damping of the contact",
            part.name
        ))),
    }
}

/// Returns the contact or mass with this name.
pub fn part(system: &System, argument: &str, given: &Bound<'_, PyAny>) -> PyResult<MovingPart> {
    let Ok(name) = given.cast::<PyString>() else {
        return Err(wrong_type(format_args!(
            "{argument}: the name of a mass is needed, or `contact`"
        )));
    };
    let mut parts = parts(system, argument, Some(name.as_any()))?;
    parts.pop().ok_or_else(|| {
        domain(format_args!(
            "{argument}: give the name of a mass, or `contact`"
        ))
    })
}

/// Returns the quantity with this name: a displacement, a velocity, an acceleration or a force, such as `accel(roof)`.
pub fn quantity(system: &System, argument: &str, name: &str) -> PyResult<MovingPart> {
    MovingPart::named(system, name).map_err(|error| domain(format_args!("{argument}: {error}")))
}

/// Reads the highest order of the harmonics in an answer. The default is 0, which means no harmonics.
pub fn harmonics(given: Option<&Bound<'_, PyAny>>) -> PyResult<u32> {
    given.map_or(Ok(0), |given| whole("harmonics", given, 1..=MOST_HARMONICS))
}

/// Fails if an answer of `points` points, each with `numbers` numbers, would be too large.
pub fn check_size(points: usize, numbers: usize) -> PyResult<()> {
    if points <= MOST_POINTS && points.saturating_mul(numbers) <= MOST_NUMBERS {
        return Ok(());
    }
    Err(domain(format_args!(
        "{points} points of {numbers} numbers each: at most {MOST_POINTS} points and {MOST_NUMBERS} numbers fit in one answer"
    )))
}
