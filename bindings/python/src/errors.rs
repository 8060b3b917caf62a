//! Defines the exceptions that the package raises.

use frictiongen::measure::{MeasureError as Untold, unit_of};
use frictiongen::study::Diagnostics;
use pyo3::exceptions::{PyException, PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Display;

pyo3::create_exception!(
    frictiongen,
    SceneError,
    PyException,
    "A description with mistakes.  `errors` lists every mistake, each with its line, its column (both counted \
     from 1) and a message."
);

pyo3::create_exception!(
    frictiongen,
    DomainError,
    PyValueError,
    "An invalid request, or one without an answer: a number outside its domain, an unknown name, or a load that does \
     not fit the scene."
);

pyo3::create_exception!(
    frictiongen,
    MeasureError,
    DomainError,
    "A measurement that cannot be read, or that gives no result.  `line` is the number of the faulty line of the file, \
     counted from 1.  It is None if no line is at fault."
);

/// Returns the Python exception for a failed measurement. If the recording has a name, the message begins with the
/// name.
pub fn measurement(py: Python<'_>, source: Option<&str>, error: &Untold) -> PyErr {
    let text = match error {
        // The library's messages for these errors name options of the command. The Python package therefore has its own
        // messages.
        Untold::NoUnit(channel) => {
            let unit = unit_of(channel);
            format!(
                "the channel `{channel}` has no unit: give one, as in {{{channel:?}: (samples, \"{unit}\")}}, or of a \
                 column of a file {{{channel:?}: (\"COLUMN\", \"{unit}\")}}"
            )
        }
        Untold::NoRate => {
            "the sampling rate is unknown: give rate, in Hz, or the times of the samples".to_owned()
        }
        other => other.to_string(),
    };
    let text = match source {
        Some(source) => format!("{source}: {text}"),
        None => text,
    };
    let line = match error {
        Untold::NotANumber { line, .. }
        | Untold::Format { line, .. }
        | Untold::Sweep { line, .. } => Some(*line),
        _ => None,
    };
    let error = MeasureError::new_err(text);
    match error.value(py).setattr("line", line) {
        Ok(()) => error,
        Err(failure) => failure,
    }
}

/// Returns the Python exception for an argument outside its domain.
pub fn domain(message: impl Display) -> PyErr {
    DomainError::new_err(message.to_string())
}

/// Returns the Python exception for an argument of the wrong type.
pub fn wrong_type(message: impl Display) -> PyErr {
    PyTypeError::new_err(message.to_string())
}

/// Returns the Python exception for a defect of this program.
pub fn defect(message: impl Display) -> PyErr {
    PyRuntimeError::new_err(message.to_string())
}

/// Returns the Python exception for a scene description with errors. Its attribute `errors` has `(line, column,
/// message)` for each error.
pub fn scene(py: Python<'_>, diagnostics: &Diagnostics) -> PyErr {
    let error = SceneError::new_err(diagnostics.to_string());
    let list: Vec<(usize, usize, &str)> = diagnostics
        .list
        .iter()
        .map(|found| (found.line, found.column, found.message.as_str()))
        .collect();
    match error.value(py).setattr("errors", list) {
        Ok(()) => error,
        Err(failure) => failure,
    }
}
