//! Computes the motion over time under a harmonic load, or without a load: samples and events.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, LoadKeywords, Measure,
    Optional, measure, one, parts, setting, start, whole,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::motions;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::study::columns::{
    Column, Frequency, FrequencyUnit, HistoryTable, JoinedEventRow, JoinedSample, JoinedTable,
};
use frictiongen::study::history::{
    FreeRequest, History, HistoryError, HistoryRequest, MOST_SAMPLES,
};
use frictiongen::study::joined::JoinedError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Largest number of cycles, of skipped cycles, and of samples in one cycle.
const MOST: u32 = MOST_SAMPLES as u32;

/// Python arguments of a run: number of cycles, number of skipped cycles, samples in a cycle, and initial state. A flag
/// for one period of the steady state and the end of a free vibration in s follow.
type RunKeywords<'py> = (
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    bool,
    Optional<'py>,
);

/// The samples and the events of a motion, each as arrays by the names of the columns.
type Arrays<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Computes samples and events of the free vibration from a state, in SI units.
fn free<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    (from, until, samples): (&Bound<'py, PyAny>, f64, u32),
    (friction, of): (&FrictionKeywords<'py>, Optional<'py>),
) -> PyResult<Arrays<'py>> {
    let measure = Measure::si(system);
    let friction = FrictionValues::of(friction, &measure)?.only()?.force();
    let masses_at_zero = || vec![0.0; system.scene().masses.len()];
    let from = match start::is_rest(from)? {
        true => (masses_at_zero(), masses_at_zero()),
        false => start::state(from, system, (&measure, 1.0))?,
    };
    let mut at = Frequency::at(system, 1.0);
    // The history has times in s in place of phases.
    at.omega = 1.0;
    let owned = Arc::clone(system);
    if system.scene().is_joined() {
        let joined = system.joined().map_err(domain)?;
        let history = left_at_interrupt(py, move |_| {
            let (x, v) = &from;
            let run = owned.joined()?.simulation_without_load(friction, (x, v));
            run?.until(until, samples, false)
        })?
        .map_err(|error: JoinedError| domain(error))?;
        let parts = motions(system, of.as_ref())?;
        let zeros = vec![0.0; system.scene().masses.len()];
        if let Some(part) = parts.iter().find(|part| part.among(&zeros).is_none()) {
            return Err(domain(format_args!(
                "of: `{}` is no mass and no difference of two masses, which alone a motion in time of several contacts has",
                part.name
            )));
        }
        let table = JoinedTable {
            setting: setting(system, measure, FrequencyUnit::Hertz, &parts),
            joined: &joined,
            orders: None,
        };
        let (history, omega) = (&history, at.omega);
        let rows = (0..history.taus.len()).map(|index| JoinedSample {
            history,
            index,
            omega,
        });
        let events = 0..history.events.len();
        let events = events.map(|index| JoinedEventRow {
            history,
            index,
            omega,
        });
        let samples = arrays(py, &table.sample_columns(), &rows.collect::<Vec<_>>())?;
        let events = arrays(py, &table.event_columns(), &events.collect::<Vec<_>>())?;
        return Ok((samples, events));
    }
    let parts = parts(system, "of", of.as_ref())?;
    let request = FreeRequest {
        of: parts.iter().map(|part| part.of).collect(),
        from,
        until,
        samples,
    };
    let history = left_at_interrupt(py, move |_| owned.free_vibration(friction, &request))?;
    let history = history.map_err(|error: HistoryError| domain(error))?;
    let table = HistoryTable {
        setting: setting(system, measure, FrequencyUnit::Hertz, &parts),
        at,
        in_seconds: true,
    };
    tabulated(py, &table, &history)
}

/// Returns a table as arrays by the names of its columns.
fn arrays<'py, R>(
    py: Python<'py>,
    columns: &[Column<'_, R>],
    rows: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(columns, rows)?;
    Ok(arrays.done())
}

/// Returns the samples and the events of a motion as arrays.
fn tabulated<'py>(
    py: Python<'py>,
    table: &HistoryTable<'_>,
    history: &History,
) -> PyResult<Arrays<'py>> {
    let samples: Vec<_> = table.samples(history).collect();
    let events: Vec<_> = table.events(history).collect();
    Ok((
        arrays(py, &table.sample_columns(), &samples)?,
        arrays(py, &table.event_columns(), &events)?,
    ))
}

/// Computes samples and events of a motion over time, of one period of the steady state, or of a free vibration.
#[pyfunction]
pub fn simulate<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: LoadKeywords<'py>,
    of: Optional<'py>,
    extent: RunKeywords<'py>,
) -> PyResult<Arrays<'py>> {
    let (cycles, skip, samples, from, steady, until) = extent;
    let system = &system.system;
    let number = |argument, given: &Option<Bound<'py, PyAny>>, least, default| {
        given
            .as_ref()
            .map_or(Ok(default), |given| whole(argument, given, least..=MOST))
    };
    if let Some(until) = until {
        let (r, hz, omega) = &frequency;
        let (force, base) = &load;
        let loads = [r, hz, omega, force, base, &cycles, &skip];
        let loaded = steady || loads.iter().any(|given| given.is_some());
        let Some(from) = from.filter(|_| !loaded) else {
            return Err(domain(
                "until= gives a free vibration: give start and friction too, and leave out the load, its frequency, cycles, skip and steady",
            ));
        };
        let until = one("until", &until)?;
        let samples = number("samples", &samples, 2, 1000)?;
        return free(py, system, (&from, until, samples), (&friction, of));
    }
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    let measure = measure::constant(system, &load)?;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let (frequency, friction) = (frequencies.only(system)?, frictions.only()?);
    let (r, beta, omega) = (frequency.r, friction.beta, frequency.omega);
    let parts = parts(system, "of", of.as_ref())?;
    if steady && (cycles.is_some() || skip.is_some()) {
        return Err(domain(
            "steady=True gives one period of the steady state; leave out cycles and skip, which belong to a run",
        ));
    }
    let system = &start::started(system, from.as_ref().filter(|_| steady), &measure)?;
    let from = match from {
        Some(from) if !steady && !start::is_rest(&from)? => {
            Some(start::state(&from, system, (&measure, omega))?)
        }
        _ => None,
    };
    let request = HistoryRequest {
        of: parts.iter().map(|part| part.of).collect(),
        from,
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
    tabulated(py, &table, &history)
}
