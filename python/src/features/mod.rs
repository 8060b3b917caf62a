//! Features of a response without a sweep: thresholds, invariant points, ranges and peaks.

mod found;
mod sheet;
mod tables;

use crate::asked::{
    Band, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, Optional, measure, parts,
};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use found::Found;
use frictiongen::Of;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sheet::Counted;

/// Largest number of frictions in one call, the same as that of the command.
const MOST_FRICTIONS: usize = 16;

/// Returns each list by its name: its columns, and the derivatives of its numbers with respect to every parameter.
#[pyfunction]
pub fn features<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let measure = measure::of(system, &load)?;
    let band = Band::of_or_usual(system, &frequency, &measure)?;
    let frictions = match friction {
        (None, None) => Vec::new(),
        given => Frictions::listed(&given, &measure)?.beta,
    };
    if MOST_FRICTIONS < frictions.len() {
        return Err(domain(format_args!(
            "at most {MOST_FRICTIONS} frictions are possible, because each has its own list"
        )));
    }
    let mut parts = parts(system, "of", of.as_ref())?;
    if of.is_none() && !system.modal().on_moving_base {
        // A mass that rubs on a support at rest moves as the contact does, so that it is listed only once.
        let rubbing = system.modal().rubbing().map(Of::Mass);
        parts.retain(|part| Some(part.of) != rubbing);
    }
    let range = [band.from, band.to];
    let found = without_lock(py, |_| {
        let features = system.features(measure.load()).map_err(domain)?;
        Found::of(&features, &parts, &frictions, range).map_err(domain)
    })??;
    let counted = Counted {
        system,
        band: &band,
        measure: &measure,
    };
    let all = PyDict::new(py);
    let whole = tables::whole(py, counted, &found)?;
    let of_frictions = tables::of_frictions(py, counted, &found)?;
    for (name, table) in whole.into_iter().chain(of_frictions) {
        all.set_item(name, table)?;
    }
    Ok(all)
}
