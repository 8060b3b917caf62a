//! Identifies friction and damping from the recording of a free vibration.

use super::once::once;
use super::recording::NativeRecording;
use crate::asked::{Optional, one};
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement};
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::measure::columns::{decay_values, extreme_columns, extremes};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Finds friction and damping from a free vibration. Returns single values, and the extremes of the vibration as
/// columns.
#[pyfunction]
pub fn free_decay<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recording: &NativeRecording,
    damping: Optional<'py>,
    find_damping: bool,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
    let system = &system.system;
    let damping = damping.map(|given| one("damping", &given)).transpose()?;
    let known = match (damping, find_damping) {
        (Some(_), true) => {
            return Err(domain("give either damping or find_damping, not both"));
        }
        (Some(ratio), false) if !(0.0..1.0).contains(&ratio) => {
            return Err(domain(format_args!(
                "damping is {ratio:?}: a damping ratio must be 0 or above, and below 1"
            )));
        }
        (Some(ratio), false) => Some(ratio),
        (None, true) => None,
        // If the caller does not request a fit of the damping, the damping of the description is taken as known.
        (None, false) => system.described_damping(),
    };
    let (owned, record) = (Arc::clone(system), recording.recording.clone());
    let found = left_at_interrupt(py, move |_| owned.free_decay(&record, known))?;
    let found = found.map_err(|error| measurement(py, recording.source.as_deref(), &error))?;
    let rows = extremes(&found);
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&extreme_columns(system), &rows)?;
    Ok((once(py, decay_values(&found))?, arrays.done()))
}
