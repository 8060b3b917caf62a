//! Determines the units of the answers from Python's arguments for the load.

use super::numbers::one;
use crate::errors::domain;
use frictiongen::System;
pub use frictiongen::study::columns::Measure;
use frictiongen::study::columns::{base_load, unbalance};
use frictiongen::study::units::{Load, LoadError};
use pyo3::prelude::*;

/// The Python arguments `force` and `base`, of which the caller gives one or none.
pub type LoadKeywords<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// Reads the load from Python, and returns the units of the answers. Without a load the answers are non-dimensional
/// groups.
pub fn of(system: &System, (force, base): &LoadKeywords<'_>) -> PyResult<Measure> {
    let (name, load) = match (force, base) {
        (None, None) => return Ok(Measure::groups(system)),
        (Some(_), Some(_)) => {
            return Err(domain(
                "force and base: a scene has one load, give one of them",
            ));
        }
        (Some(force), None) => match force.extract::<String>() {
            Ok(text) => ("force", text_load("force", &text, unbalance)?),
            Err(_) => ("force", Load::Force(one("force", force)?)),
        },
        (None, Some(base)) => match base.extract::<String>() {
            Ok(text) => ("base", text_load("base", &text, base_load)?),
            Err(_) => ("base", Load::Base(one("base", base)?)),
        },
    };
    Measure::under(system, load).map_err(|error| match error {
        LoadError::DrivenByBase | LoadError::DrivenByForce(_) => domain(format_args!(
            "{name}: {error}; its load is given by {}",
            argument(&Measure::groups(system))
        )),
        _ => domain(format_args!("{name}: {error}")),
    })
}

/// Reads a load from a Python text such as "3 N". The function `read` parses the text.
fn text_load(
    argument: &str,
    text: &str,
    read: impl Fn(&str) -> Result<Load, String>,
) -> PyResult<Load> {
    read(text).map_err(|problem| domain(format_args!("{argument} `{text}`: {problem}")))
}

/// Reads the load from Python, and returns the units of the answers. Fails if the load's amplitude varies with
/// frequency.
pub fn constant(system: &System, load: &LoadKeywords<'_>) -> PyResult<Measure> {
    let measure = of(system, load)?;
    if let Some(load) = measure.load() {
        let argument = argument(&measure);
        let constant = system.constant_scale(load);
        constant.map_err(|error| domain(format_args!("{argument}: {error}")))?;
    }
    Ok(measure)
}

/// Returns the name of the Python argument for the load: `base` if the base drives the scene, otherwise `force`.
pub fn argument(measure: &Measure) -> &'static str {
    if measure.is_base_motion() {
        "base"
    } else {
        "force"
    }
}
