//! Driving frequency, transmissibility and phase of recordings.

use super::recording::NativeRecording;
use crate::columns::{Columns, cell};
use crate::errors::measurement;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::measure::{MeasureError, Measured};
use frictiongen::study::scene::Excitation;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Returns the steady motion in each recording.
pub fn measured(
    py: Python<'_>,
    system: &System,
    recordings: &[Py<NativeRecording>],
) -> PyResult<Vec<Measured>> {
    let found = without_lock(py, |stop| {
        let mut all = Vec::with_capacity(recordings.len());
        for (place, recording) in recordings.iter().enumerate() {
            if !stop.goes_on() {
                break;
            }
            let recording = recording.get();
            match Measured::of(&recording.recording, system.scene()) {
                Ok(measured) => all.push(measured),
                Err(error) => return Err((recording.called(place, recordings.len()), error)),
            }
        }
        Ok(all)
    })?;
    found.map_err(|(source, error): (Option<String>, MeasureError)| {
        measurement(py, source.as_deref(), &error)
    })
}

/// Returns the name of the excitation and the unit of its amplitude.
pub fn drive(system: &System) -> (&'static str, &'static str) {
    match system.scene().excitation {
        Excitation::Base => ("base", "m"),
        Excitation::Force(_) => ("force", "N"),
    }
}

/// Returns the transmissibilities of the recorded masses as columns, with one row for each recording.
#[pyfunction]
pub fn transmissibility<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recordings: Vec<Py<NativeRecording>>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let found = measured(py, system, &recordings)?;
    let mut columns = Columns::new(py, &[found.len()]);
    let all = |of: &dyn Fn(&Measured) -> Option<f64>| -> Vec<f64> {
        found.iter().map(|point| cell(of(point))).collect()
    };
    columns.numbers("frequency_Hz", all(&|point| Some(point.hertz)))?;
    columns.numbers("steady_from_s", all(&|point| Some(point.steady.0)))?;
    let (drive, unit) = drive(system);
    columns.numbers(
        format!("{drive}.amplitude_{unit}"),
        all(&|point| Some(point.drive_amplitude())),
    )?;
    for (place, mass) in system.scene().masses.iter().enumerate() {
        let has = |point: &Measured| point.masses.iter().any(|(mass, _)| *mass == place);
        if !found.iter().any(has) {
            continue;
        }
        let full = |what: &str| format!("{}.{what}", mass.name);
        columns.numbers(
            full("transmissibility"),
            all(&|point| Some(point.transmissibility(place)?.amplitude())),
        )?;
        columns.numbers(
            full("lag_deg"),
            all(&|point| Some(point.transmissibility(place)?.lag().to_degrees())),
        )?;
        columns.numbers(
            full("deviation"),
            all(&|point| Some(point.transmissibility(place)?.deviation)),
        )?;
        columns.numbers(
            full("third_harmonic"),
            all(&|point| Some(point.harmonic(place, 3)?.norm())),
        )?;
    }
    Ok(columns.done())
}
