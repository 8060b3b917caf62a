//! Finds the friction force from measurements.

use super::observed::Observed;
use super::once::once;
use crate::asked::{Optional, harmonics, names, numbers};
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement};
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::Of;
use frictiongen::measure::columns::{identify_values, residual_columns, residuals};
use frictiongen::measure::{IdentifyRequest, Unknown};
use frictiongen::study::sensitivity::Quantity;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// The Python arguments `by`, `also`, `between` and `harmonics`.
type IdentifyKeywords<'py> = (Option<String>, Optional<'py>, Optional<'py>, Optional<'py>);

/// Results of an identification: single values, motions, and the system with the identified parameters.
type IdentifyAnswer<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>, NativeSystem);

fn unknowns(given: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<Unknown>> {
    let each = names("also", given)?
        .into_iter()
        .map(|name| match name.as_str() {
            "damping" => Ok(Unknown::Damping),
            "frequency" => Ok(Unknown::Frequencies),
            "stiction" => Ok(Unknown::Stiction),
            "stiffness" => Ok(Unknown::Quantity(Quantity::ContactStiffness)),
            _ => Err(domain(format_args!(
                "also: {name:?} cannot be fitted; give damping, frequency, stiction or stiffness"
            ))),
        });
    each.collect()
}

fn range(given: Option<&Bound<'_, PyAny>>) -> PyResult<Option<(f64, f64)>> {
    let Some(given) = given else { return Ok(None) };
    match *numbers("between", given)?.values.as_slice() {
        [from, to] => Ok(Some((from, to))),
        _ => Err(domain(
            "between: two friction forces in N are needed, (from, to)",
        )),
    }
}

/// Finds the friction force that fits the measurements best, in any regime. Returns the force with its uncertainty
/// interval.
#[pyfunction]
pub fn identify<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    items: Vec<Bound<'py, PyAny>>,
    of: Optional<'py>,
    asked: IdentifyKeywords<'py>,
) -> PyResult<IdentifyAnswer<'py>> {
    let system = &system.system;
    let (by, also, between, highest) = asked;
    let highest = harmonics(highest.as_ref())?;
    let mut observed = Observed::of(py, system, items, highest)?;
    if of.is_some() {
        let mut kept = Vec::new();
        for name in names("of", of.as_ref())? {
            match system.motion_named(&name) {
                Ok(Of::Mass(mass)) => kept.push(mass),
                Ok(_) => {
                    return Err(domain("of: a measured motion must be that of a mass"));
                }
                Err(error) => return Err(domain(format_args!("of: {error}"))),
            }
        }
        for seen in &mut observed.all {
            seen.motions.retain(|datum| kept.contains(&datum.mass));
        }
    }
    let request = IdentifyRequest {
        using: observed.using(by.as_deref())?,
        unknowns: unknowns(also.as_ref())?,
        range: range(between.as_ref())?,
    };
    let (owned, all) = (Arc::clone(system), observed.all.clone());
    let found = left_at_interrupt(py, move |_| owned.identify(&all, &request))?;
    let found = found.map_err(|error| measurement(py, None, &error))?;
    let once = once(py, identify_values(system, &found))?;
    let rows = residuals(system, &observed.all, &observed.known, &found);
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&residual_columns(system), &rows)?;
    let fitted = NativeSystem::from(found.system);
    Ok((once, arrays.done(), fitted))
}
