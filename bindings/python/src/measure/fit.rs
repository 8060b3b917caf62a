//! Fits the parameters of a scene to a sweep that was measured without friction.

use super::once::once;
use super::recording::NativeRecording;
use crate::asked::{Optional, names, numbers, one};
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement};
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::measure::SweepPoint;
use frictiongen::measure::columns::{
    fit_values, fitted as fitted_rows, fitted_columns, motion_values,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// A measured mass: its name, its transmissibilities, and their standard deviations if known. A transmissibility is the
/// amplitude of the mass divided by the amplitude of the excitation.
type Swept<'py> = (String, Bound<'py, PyAny>, Option<Bound<'py, PyAny>>);

/// Results of a fit: single values, points of the sweep, and the system with the fitted parameters.
type FitAnswer<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>, NativeSystem);

/// Reads a row of numbers with one number for each frequency. If `gaps` is true, NaN stands for a missing number.
fn row(argument: &str, given: &Bound<'_, PyAny>, count: usize, gaps: bool) -> PyResult<Vec<f64>> {
    let given = numbers(argument, given)?;
    if given.values.len() != count {
        return Err(domain(format_args!(
            "{argument}: {count} numbers are needed, one for each frequency, but these are {}",
            given.values.len()
        )));
    }
    for (index, value) in given.values.iter().enumerate() {
        let sound = 0.0 < *value && value.is_finite();
        if !(sound || gaps && value.is_nan()) {
            return Err(domain(format_args!(
                "{} is {value:?}: frequencies, transmissibilities and deviations must be above 0 and finite",
                given.place(argument, index)
            )));
        }
    }
    Ok(given.values)
}

/// Returns the points of a measured sweep. The points have the same order as in the table of a sweep: by frequency,
/// then by mass.
fn points(
    system: &System,
    hertz: &Bound<'_, PyAny>,
    masses: Vec<Swept<'_>>,
    gaps: bool,
) -> PyResult<Vec<SweepPoint>> {
    let count = numbers("hz", hertz)?.values.len();
    let hertz = row("hz", hertz, count, false)?;
    let mut columns = Vec::new();
    for (name, amplitudes, deviations) in masses {
        let mass = match system.motion_named(&name) {
            Ok(frictiongen::Of::Mass(mass)) => mass,
            Ok(_) => {
                return Err(domain("a sweep contains masses only"));
            }
            Err(error) => return Err(domain(error)),
        };
        let amplitudes = row(
            &format!("transmissibility[{name:?}]"),
            &amplitudes,
            count,
            gaps,
        )?;
        let deviations = deviations
            .map(|given| row(&format!("deviation[{name:?}]"), &given, count, gaps))
            .transpose()?;
        columns.push((mass, amplitudes, deviations));
    }
    let mut points = Vec::new();
    for (place, hertz) in hertz.into_iter().enumerate() {
        for (mass, amplitudes, deviations) in &columns {
            let at = |values: &Vec<f64>| values.get(place).copied().filter(|value| !value.is_nan());
            if let Some(amplitude) = at(amplitudes) {
                points.push(SweepPoint {
                    hertz,
                    mass: *mass,
                    amplitude,
                    deviation: deviations.as_ref().and_then(at),
                });
            }
        }
    }
    Ok(points)
}

fn answer<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    points: &[SweepPoint],
    (damping, source): (bool, Option<&str>),
) -> PyResult<FitAnswer<'py>> {
    let (owned, all) = (Arc::clone(system), points.to_vec());
    let found = left_at_interrupt(py, move |_| owned.fit_sweep(&all, damping))?;
    let found = found.map_err(|error| measurement(py, source, &error))?;
    let once = once(py, fit_values(system, &found))?;
    let rows = fitted_rows(system, points, &found);
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&fitted_columns(system), &rows)?;
    let fitted = NativeSystem::from(found.system);
    Ok((once, arrays.done(), fitted))
}

/// Fits the parameters of a scene to a sweep, given as arrays. If `gaps` is true, NaN stands for a point that was not
/// measured.
#[pyfunction]
pub fn fit<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    hertz: Bound<'py, PyAny>,
    masses: Vec<Swept<'py>>,
    gaps: bool,
    damping: bool,
) -> PyResult<FitAnswer<'py>> {
    let system = &system.system;
    let points = points(system, &hertz, masses, gaps)?;
    answer(py, system, &points, (damping, None))
}

/// Fits the friction force and numbers of the description to the whole motion in a recording. `friction` is the first
/// guess of the force, or `None` for a recorded friction. `vary` names the numbers.
#[pyfunction]
pub fn fit_motion<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recording: &NativeRecording,
    friction: Optional<'py>,
    vary: Optional<'py>,
) -> PyResult<(Bound<'py, PyDict>, NativeSystem)> {
    let system = &system.system;
    let friction = friction.map(|given| one("friction", &given)).transpose()?;
    if let Some(force) = friction
        && !(0.0 < force && force.is_finite())
    {
        return Err(domain(format_args!(
            "friction is {force:?}: a force in N above 0 is needed, which is the first guess"
        )));
    }
    let named = names("vary", vary.as_ref())?.into_iter().map(|name| {
        let number = system.tunable_named(&name);
        number.map_err(|error| domain(format_args!("vary: {error}")))
    });
    let numbers = named.collect::<PyResult<Vec<_>>>()?;
    let (owned, record) = (Arc::clone(system), recording.recording.clone());
    let found = left_at_interrupt(py, move |_| owned.fit_motion(&record, friction, &numbers))?;
    let found = found.map_err(|error| measurement(py, recording.source.as_deref(), &error))?;
    Ok((
        once(py, motion_values(system, &found))?,
        found.system.into(),
    ))
}

/// Fits the parameters of a scene to a sweep, given as the text of a table.
#[pyfunction]
pub fn fit_text<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    text: &str,
    source: Option<&str>,
    damping: bool,
) -> PyResult<FitAnswer<'py>> {
    let system = &system.system;
    let points = SweepPoint::read(text, system).map_err(|error| measurement(py, source, &error))?;
    answer(py, system, &points, (damping, source))
}
