//! Returns the single values of a measurement to Python, by key.

use frictiongen::measure::Estimate;
use frictiongen::measure::columns::{Keyed, SingleValue};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Returns the best estimate of a value, with the lower and upper bound of its uncertainty interval.
fn interval(found: Estimate) -> (f64, f64, f64) {
    (found.value, found.from, found.to)
}

/// Returns a Python dictionary of single values by key.
pub fn once<'py>(py: Python<'py>, values: Vec<Keyed>) -> PyResult<Bound<'py, PyDict>> {
    let once = PyDict::new(py);
    for (key, value) in values {
        match value {
            SingleValue::Number(value) => once.set_item(key, value)?,
            SingleValue::Count(value) => once.set_item(key, value)?,
            SingleValue::Flag(value) => once.set_item(key, value)?,
            SingleValue::Text(text) => once.set_item(key, text)?,
            SingleValue::Estimate(found) => once.set_item(key, found.map(interval))?,
            SingleValue::Estimates(all) => {
                let all = all.into_iter().map(interval);
                once.set_item(key, all.collect::<Vec<_>>())?;
            }
            SingleValue::Named(all) => {
                let all = all.into_iter().map(|(name, found)| (name, interval(found)));
                once.set_item(key, all.collect::<Vec<_>>())?;
            }
            SingleValue::Names(names) => once.set_item(key, names)?,
        }
    }
    Ok(once)
}
