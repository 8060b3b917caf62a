//! Computes the response spectrum of a recorded base motion.

use super::recording::NativeRecording;
use crate::asked::one;
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement};
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::measure::columns::{spectrum_columns, spectrum_rows};
use frictiongen::study::scene::Excitation;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Computes the response spectrum of the recorded base motion for a damping ratio, with the natural periods of the scene.
#[pyfunction]
pub fn response_spectrum<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recording: &NativeRecording,
    damping: Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = Arc::clone(&system.system);
    let zeta = one("damping", &damping)?;
    if !(0.0..1.0).contains(&zeta) {
        return Err(domain(format_args!(
            "damping is {zeta:?}: a damping ratio must be 0 or above, and below 1"
        )));
    }
    if system.scene().is_joined() {
        return Err(domain(
            "a response spectrum has the natural periods of a scene with one contact; leave `contacts`, `dampers` and `stops` out of the description",
        ));
    }
    if system.scene().excitation != Excitation::Base {
        return Err(domain(
            "a response spectrum belongs to a moving base; write `excitation: base` in the description",
        ));
    }
    let (owned, record) = (Arc::clone(&system), recording.recording.clone());
    let rows = left_at_interrupt(py, move |_| spectrum_rows(&owned, &record, zeta))?;
    let rows = rows.map_err(|error| measurement(py, recording.source.as_deref(), &error))?;
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&spectrum_columns(&system), &rows)?;
    Ok(arrays.done())
}
