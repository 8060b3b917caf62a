//! Computes the driving frequency, the transmissibility and the phase of recordings.

use super::recording::NativeRecording;
use crate::columns::NamedArrays;
use crate::errors::measurement;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::measure::columns::TransmissibilityTable;
use frictiongen::measure::{MeasureError, Measured};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Finds the steady motion in each of several recordings.
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

/// Returns the transmissibilities of the recorded masses as columns. The columns have one row for each recording.
#[pyfunction]
pub fn transmissibility<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recordings: Vec<Py<NativeRecording>>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let found = measured(py, system, &recordings)?;
    let columns = TransmissibilityTable::of(system, &found).columns();
    let mut arrays = NamedArrays::new(py, &[found.len()]);
    arrays.table(&columns, &found)?;
    Ok(arrays.done())
}
