//! Computes the motion over time under a harmonic load, or without a load: samples and events.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, LoadKeywords,
    MOST_HARMONICS, Measure, Optional, measure, one, parts, setting, start, whole, without,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::{JoinedQuestion, motions};
use crate::measure::drive::signals;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::measure::{Signal, SignalInputs};
use frictiongen::study::columns::{
    Column, Frequency, FrequencyUnit, FrictionSetting, HistoryTable, JoinedEventRow, JoinedSample,
    JoinedTable,
};
use frictiongen::study::history::{
    FreeRequest, History, HistoryError, HistoryRequest, MOST_SAMPLES, Spectrum,
};
use frictiongen::study::joined::{JoinedError, JoinedHistory};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Largest number of cycles, of skipped cycles, and of samples in one cycle.
const MOST: u32 = MOST_SAMPLES as u32;

/// Python arguments of a run: number of cycles, number of skipped cycles, samples in a cycle, and initial state. The end
/// of a motion without a harmonic load in s follows, with the texts of inputs over time. Flags ask for one period of the
/// steady state and for the spectra.
type RunKeywords<'py> = (
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    (Optional<'py>, Vec<String>),
    (bool, bool),
);

/// Displacements and velocities of all masses.
type State = (Vec<f64>, Vec<f64>);

/// The samples, the events and the spectra of a motion, each as arrays by the names of the columns. The spectra are
/// missing unless the caller asks for them.
type Arrays<'py> = (
    Bound<'py, PyDict>,
    Bound<'py, PyDict>,
    Option<Bound<'py, PyDict>>,
);

/// Computes the motion of a scene with several contacts, or under inputs over time, from a state.
fn history(
    system: &System,
    (from, inputs): (&State, &[Signal]),
    (until, samples): (f64, u32),
    friction: f64,
) -> Result<JoinedHistory, String> {
    let joined = system.joined().map_err(|error| error.to_string())?;
    let state = (from.0.as_slice(), from.1.as_slice());
    if inputs.is_empty() {
        let run = joined.simulation_without_load(friction, state);
        let history = run.and_then(|mut run| run.until(until, samples, false));
        return history.map_err(|error| error.to_string());
    }
    let extent = (until, samples as usize);
    let inputs = SignalInputs::new(inputs, extent, friction).map_err(|error| error.to_string())?;
    let history = inputs.history(&joined, Some(state));
    history.map_err(|error| error.to_string())
}

/// Computes samples and events of the motion from a state, or from rest, in SI units: the free vibration, or the motion
/// under inputs over time.
fn free<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    (from, inputs, until, samples): (Option<&Bound<'py, PyAny>>, &[String], f64, u32),
    (friction, of): (&FrictionKeywords<'py>, Optional<'py>),
) -> PyResult<Arrays<'py>> {
    let measure = Measure::si(system);
    let friction = FrictionValues::of(friction, &measure)?.only()?.force();
    let masses_at_zero = || vec![0.0; system.scene().masses.len()];
    let from = match from {
        Some(from) if !start::is_rest(from)? => start::state(from, system, (measure.scale(), 1.0))?,
        _ => (masses_at_zero(), masses_at_zero()),
    };
    let inputs = signals(system, inputs)?;
    let mut at = Frequency::at(system, 1.0);
    // The history has times in s in place of phases.
    at.omega = 1.0;
    let owned = Arc::clone(system);
    if system.scene().is_joined() || !inputs.is_empty() {
        if !samples.is_multiple_of(2) {
            return Err(domain(HistoryError::Samples));
        }
        let joined = system.joined().map_err(domain)?;
        let parts = motions(system, of.as_ref())?;
        let table = JoinedTable {
            setting: setting(system, measure, FrequencyUnit::Hertz, &parts),
            joined: &joined,
            orders: None,
        };
        table.check_in_time("of").map_err(domain)?;
        let history = left_at_interrupt(py, move |_| {
            history(&owned, (&from, &inputs), (until, samples), friction)
        })?;
        return several(py, &table, (&history.map_err(domain)?, at.omega));
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
    tabulated(py, &table, (&history, None))
}

/// Returns the samples and the events of a motion of several contacts as arrays.
fn several<'py>(
    py: Python<'py>,
    table: &JoinedTable<'_>,
    (history, omega): (&JoinedHistory, f64),
) -> PyResult<Arrays<'py>> {
    let rows = (0..history.taus.len()).map(|index| JoinedSample {
        history,
        index,
        omega,
    });
    let events = (0..history.events.len()).map(|index| JoinedEventRow {
        history,
        index,
        omega,
    });
    let samples = arrays(py, &table.sample_columns(), &rows.collect::<Vec<_>>())?;
    let events = arrays(py, &table.event_columns(), &events.collect::<Vec<_>>())?;
    Ok((samples, events, None))
}

/// Length of a motion: number of skipped cycles, of cycles, and of samples in a cycle. Flags ask for one period of the
/// steady state instead, and for the spectra.
#[derive(Clone, Copy)]
struct Extent {
    skip: u32,
    cycles: u32,
    samples: u32,
    steady: bool,
    spectrum: bool,
}

/// Computes samples and events of a motion of several contacts under a harmonic load.
fn driven<'py>(
    py: Python<'py>,
    question: &JoinedQuestion,
    start: Option<&Bound<'py, PyAny>>,
    extent: Extent,
) -> PyResult<Arrays<'py>> {
    let system = &question.system;
    let (frequency, friction) = (
        question.frequencies.only(system)?,
        question.frictions.only()?,
    );
    let joined = system.joined().map_err(domain)?;
    let table = question.table(&joined);
    table.check_in_time("of").map_err(domain)?;
    let samples = u64::from(extent.cycles) * u64::from(extent.samples);
    if !extent.samples.is_multiple_of(2) {
        return Err(domain(HistoryError::Samples));
    }
    if MOST_SAMPLES < samples.saturating_mul(table.parts().len() as u64) {
        return Err(domain(HistoryError::TooManySamples));
    }
    let beta = friction.at(&question.measure, frequency).beta;
    let scale = question.measure.scale_at(frequency.omega);
    let from = match start {
        Some(start) if !extent.steady && !start::is_rest(start)? => {
            Some(start::state(start, system, (scale, frequency.omega))?)
        }
        _ => None,
    };
    let owned = question.clone();
    let history = left_at_interrupt(py, move |_| {
        let joined = owned.system.joined()?;
        let at = owned.table(&joined).at(frequency)?;
        if extent.steady {
            let orbit = at.orbit(beta)?;
            let cycles = u32::try_from(orbit.period()).unwrap_or(u32::MAX);
            return orbit.simulation()?.history(0, cycles, extent.samples);
        }
        let mut run = match &from {
            Some((x, v)) => at.simulation_from(beta, (x, v))?,
            None => at.simulation(beta)?,
        };
        run.history(extent.skip, extent.cycles, extent.samples)
    })?;
    let history = history.map_err(|error: JoinedError| domain(error))?;
    several(py, &table, (&history, frequency.omega))
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

/// Returns the samples and the events of a motion as arrays, and its spectra if they are given.
fn tabulated<'py>(
    py: Python<'py>,
    table: &HistoryTable<'_>,
    (history, spectra): (&History, Option<&[Spectrum]>),
) -> PyResult<Arrays<'py>> {
    let samples: Vec<_> = table.samples(history).collect();
    let events: Vec<_> = table.events(history).collect();
    let spectra = spectra.map(|spectra| {
        let lines: Vec<_> = table.lines(spectra).collect();
        arrays(py, &table.spectrum_columns(), &lines)
    });
    Ok((
        arrays(py, &table.sample_columns(), &samples)?,
        arrays(py, &table.event_columns(), &events)?,
        spectra.transpose()?,
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
    let (cycles, skip, samples, from, (until, inputs), (steady, spectrum)) = extent;
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
        let loaded = steady || spectrum || loads.iter().any(|given| given.is_some());
        if loaded || (from.is_none() && inputs.is_empty()) {
            return Err(domain(
                "until= gives a free vibration: give start and friction too, and leave out the load, its frequency, cycles, skip, steady and spectrum; inputs= gives loads over time",
            ));
        }
        let until = one("until", &until)?;
        let samples = number("samples", &samples, 2, 1000)?;
        let run = (from.as_ref(), inputs.as_slice(), until, samples);
        return free(py, system, run, (&friction, of));
    }
    if !inputs.is_empty() {
        return Err(domain("inputs= needs until=, the end of the motion in s"));
    }
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    if steady && (cycles.is_some() || skip.is_some()) {
        return Err(domain(
            "steady=True gives one period of the steady state; leave out cycles and skip, which belong to a run",
        ));
    }
    let extent = Extent {
        skip: number("skip", &skip, 0, 0)?,
        cycles: number("cycles", &cycles, 1, 10)?,
        samples: number("samples", &samples, 2, 200)?,
        steady,
        spectrum,
    };
    let scene = system.scene();
    if scene.is_joined() || steady && scene.has_joined_states() {
        without(&[(spectrum, "spectrum")])?;
        let load = (load, from.clone().filter(|_| steady));
        let of = of.as_ref();
        let question = JoinedQuestion::of(system, frequencies, &friction, &load, of)?;
        return driven(py, &question, from.as_ref(), extent);
    }
    let measure = measure::constant(system, &load)?;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let point = (&frequencies, frictions.only()?);
    one_contact(py, (system, measure), point, (from, of), extent)
}

/// Computes samples, events and spectra of a motion of a single contact under a harmonic load.
fn one_contact<'py>(
    py: Python<'py>,
    (system, measure): (&Arc<System>, Measure),
    (frequencies, friction): (&FrequencyValues, FrictionSetting),
    (from, of): (Optional<'py>, Optional<'py>),
    extent: Extent,
) -> PyResult<Arrays<'py>> {
    let frequency = frequencies.only(system)?;
    let (r, beta, omega) = (frequency.r, friction.beta, frequency.omega);
    let Extent { steady, .. } = extent;
    let parts = parts(system, "of", of.as_ref())?;
    let system = &start::started(system, from.as_ref().filter(|_| steady), &measure)?;
    let from = match from {
        Some(from) if !steady && !start::is_rest(&from)? => {
            Some(start::state(&from, system, (measure.scale(), omega))?)
        }
        _ => None,
    };
    let request = HistoryRequest {
        of: parts.iter().map(|part| part.of).collect(),
        from,
        amplitude: measure.load().map(|load| load.amplitude()),
        skip: extent.skip.into(),
        cycles: extent.cycles,
        samples: extent.samples,
    };
    let owned = Arc::clone(system);
    let (history, spectra) = left_at_interrupt(py, move |_| {
        let of = request.of.iter();
        if !steady {
            let history = owned.history(r, beta, &request)?;
            let of = of.filter(|_| extent.spectrum);
            let spectra = of.filter_map(|of| history.spectrum(*of)).collect();
            return Ok((history, spectra));
        }
        let response = owned.at(r)?.response(beta)?;
        let history = response.history(&request.of, request.samples)?;
        let highest = match extent.spectrum {
            true => (request.samples / 2).min(MOST_HARMONICS),
            false => 0,
        };
        let spectra = of.filter_map(|of| response.spectrum(*of, highest));
        let spectra: Vec<Spectrum> = spectra.collect();
        Ok((history, spectra))
    })?
    .map_err(|error: HistoryError| domain(error))?;
    let table = HistoryTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
        at: frequency,
        in_seconds: true,
    };
    let spectra = Some(spectra.as_slice()).filter(|_| extent.spectrum);
    tabulated(py, &table, (&history, spectra))
}
