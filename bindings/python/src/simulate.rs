//! Computes the motion under a harmonic load over time: samples and events.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, LoadKeywords, Measure,
    Optional, measure, numbers, parts, setting, whole,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::study::columns::HistoryTable;
use frictiongen::study::history::{HistoryError, HistoryRequest, MOST_SAMPLES};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Largest number of cycles, of skipped cycles, and of samples in one cycle.
const MOST: u32 = MOST_SAMPLES as u32;

/// Python arguments of a run: number of cycles, number of skipped cycles, samples in a cycle, and initial state. The
/// last argument is a flag for one period of the steady state.
type RunKeywords<'py> = (
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    Option<(Bound<'py, PyAny>, Bound<'py, PyAny>)>,
    bool,
);

/// Reads displacements and velocities of all masses from Python, and returns both as non-dimensional groups.
fn start(
    (displacements, velocities): &(Bound<'_, PyAny>, Bound<'_, PyAny>),
    system: &System,
    (measure, omega): (&Measure, f64),
) -> PyResult<(Vec<f64>, Vec<f64>)> {
    let scale = measure.scale();
    let half = |what: &str, given: &Bound<'_, PyAny>, ratio: &dyn Fn(f64) -> f64| {
        let given = numbers(what, given)?.values;
        let masses = system.scene().masses.len();
        if given.len() != masses {
            return Err(domain(format_args!(
                "{what}: {masses} numbers are needed, one for each mass, but these are {}",
                given.len()
            )));
        }
        let all: Vec<f64> = given.into_iter().map(ratio).collect();
        if let Some(value) = all.iter().find(|value| !value.is_finite()) {
            return Err(domain(format_args!(
                "{what}: every number must be finite, but one is {value:?}"
            )));
        }
        Ok(all)
    };
    Ok((
        half("start[0], the displacements", displacements, &|x| {
            scale.map_or(x, |scale| scale.displacement_ratio(x))
        })?,
        half("start[1], the velocities", velocities, &|v| {
            scale.map_or(v, |scale| scale.velocity_ratio(v, omega))
        })?,
    ))
}

/// Computes samples and events of a motion over time, or of one period of the steady state.
#[pyfunction]
pub fn simulate<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: LoadKeywords<'py>,
    of: Optional<'py>,
    extent: RunKeywords<'py>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
    let (cycles, skip, samples, from, steady) = extent;
    let system = &system.system;
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    let measure = measure::constant(system, &load)?;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let (frequency, friction) = (frequencies.only(system)?, frictions.only()?);
    let (r, beta, omega) = (frequency.r, friction.beta, frequency.omega);
    let parts = parts(system, "of", of.as_ref())?;
    let number = |argument, given: &Option<Bound<'py, PyAny>>, least, default| {
        given
            .as_ref()
            .map_or(Ok(default), |given| whole(argument, given, least..=MOST))
    };
    if steady && (cycles.is_some() || skip.is_some() || from.is_some()) {
        return Err(domain(
            "steady=True gives one period of the steady state; leave out cycles, skip and start, which belong to a run",
        ));
    }
    let request = HistoryRequest {
        of: parts.iter().map(|part| part.of).collect(),
        from: from
            .map(|from| start(&from, system, (&measure, omega)))
            .transpose()?,
        amplitude: measure.load().map(|load| load.amplitude()),
        skip: number("skip", &skip, 0, 0)?.into(),
        cycles: number("cycles", &cycles, 1, 10)?,
        samples: number("samples", &samples, 2, 200)?,
    };
    let owned = Arc::clone(system);
    let history = left_at_interrupt(py, move |_| match steady {
        false => owned.history(r, beta, &request),
        true => {
            let response = owned.at(r)?.response(beta)?;
            response.history(&request.of, request.samples)
        }
    })?
    .map_err(|error: HistoryError| domain(error))?;

    let table = HistoryTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
        at: frequency,
        in_seconds: true,
    };
    let rows: Vec<_> = table.samples(&history).collect();
    let mut samples = NamedArrays::new(py, &[rows.len()]);
    samples.table(&table.sample_columns(), &rows)?;
    let rows: Vec<_> = table.events(&history).collect();
    let mut events = NamedArrays::new(py, &[rows.len()]);
    events.table(&table.event_columns(), &rows)?;
    Ok((samples.done(), events.done()))
}
