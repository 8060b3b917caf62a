//! Reads Python's argument `start`: the initial state of motions to a steady state.

use super::measure::{self, LoadKeywords, Measure};
use super::{Optional, numbers};
use crate::errors::domain;
use frictiongen::System;
use frictiongen::study::InitialState;
use frictiongen::study::units::LoadScale;
use pyo3::prelude::*;
use std::sync::Arc;

/// The Python arguments of the load, and the argument `start`: `None`, the text `"rest"`, or displacements and
/// velocities.
pub type DrivenKeywords<'py> = (LoadKeywords<'py>, Optional<'py>);

/// Reads the load and the initial state from Python. Returns the units of the answers, and the system that starts from
/// this state.
pub fn driven(
    system: &Arc<System>,
    (load, start): &DrivenKeywords<'_>,
) -> PyResult<(Measure, Arc<System>)> {
    let measure = measure::of(system, load)?;
    let system = started(system, start.as_ref(), &measure)?;
    Ok((measure, system))
}

/// Returns the system that starts from the given state, or the system itself if the caller gives no state.
pub fn started(
    system: &Arc<System>,
    start: Option<&Bound<'_, PyAny>>,
    measure: &Measure,
) -> PyResult<Arc<System>> {
    let Some(start) = start else {
        return Ok(Arc::clone(system));
    };
    let state = if is_rest(start)? {
        InitialState::rest(system.scene().masses.len())
    } else {
        let reference = system.angular_frequency(1.0);
        let groups = state(start, system, (measure.scale(), reference))?;
        match measure.scale() {
            Some(_) => InitialState::at_ratio(groups, 1.0, measure.fall()),
            None => InitialState::groups(groups),
        }
    };
    Ok(Arc::new(System::clone(system).starting_from(state)))
}

/// Returns true if the caller gave the text `"rest"`. Fails for any other text.
pub fn is_rest(start: &Bound<'_, PyAny>) -> PyResult<bool> {
    match start.extract::<String>() {
        Ok(text) if text == "rest" => Ok(true),
        Ok(text) => Err(domain(format_args!(
            "start: `{text}` is no state; write \"rest\", or the displacements of all masses and their velocities"
        ))),
        Err(_) => Ok(false),
    }
}

/// Reads displacements and velocities of all masses from Python. Under a load, which gives the `scale`, returns both as
/// non-dimensional groups.
pub fn state(
    start: &Bound<'_, PyAny>,
    system: &System,
    (scale, omega): (Option<LoadScale>, f64),
) -> PyResult<(Vec<f64>, Vec<f64>)> {
    let (displacements, velocities): (Bound<'_, PyAny>, Bound<'_, PyAny>) = start.extract()?;
    let half = |what: &str, given: &Bound<'_, PyAny>, ratio: &dyn Fn(f64) -> f64| {
        let given = numbers(what, given)?.values;
        let masses = system.scene().masses.len();
        if given.len() != masses {
            return Err(domain(format_args!(
                "{what}: {masses} numbers are needed, one for each mass, but these are {}",
                given.len()
            )));
        }
        let all: Vec<f64> = given.into_iter().map(ratio).collect();
        if let Some(value) = all.iter().find(|value| !value.is_finite()) {
            return Err(domain(format_args!(
                "{what}: every number must be finite, but one is {value:?}"
            )));
        }
        Ok(all)
    };
    Ok((
        half("start[0], the displacements", &displacements, &|x| {
            scale.map_or(x, |scale| scale.displacement_ratio(x))
        })?,
        half("start[1], the velocities", &velocities, &|v| {
            scale.map_or(v, |scale| scale.velocity_ratio(v, omega))
        })?,
    ))
}
