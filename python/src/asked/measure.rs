//! Determines the units of the answers from the load arguments.

use super::numbers::one;
use crate::errors::domain;
use frictiongen::System;
pub use frictiongen::study::columns::Measure;
use frictiongen::study::units::{Load, LoadError};
use pyo3::prelude::*;

/// The arguments `force` and `base`.
pub type LoadArguments<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// Returns the units under the load that the arguments give. Without a load the units are non-dimensional groups.
pub fn of(system: &System, (force, base): &LoadArguments<'_>) -> PyResult<Measure> {
    let (name, load) = match (force, base) {
        (None, None) => return Ok(Measure::groups(system)),
        (Some(_), Some(_)) => {
            return Err(domain(
                "force and base: a scene has one load, give one of them",
            ));
        }
        (Some(force), None) => ("force", Load::Force(one("force", force)?)),
        (None, Some(base)) => ("base", Load::Base(one("base", base)?)),
    };
    Measure::under(system, load).map_err(|error| match error {
        LoadError::DrivenByBase | LoadError::DrivenByForce(_) => domain(format_args!(
            "{name}: {error}; its load is given by {}",
            argument(&Measure::groups(system))
        )),
        _ => domain(format_args!("{name}: {error}")),
    })
}

/// Returns the name of the Python argument for the load: `base` if the base drives the scene, otherwise `force`.
pub fn argument(measure: &Measure) -> &'static str {
    if measure.is_base_motion() {
        "base"
    } else {
        "force"
    }
}
