//! Finds the friction that minimises the largest amplitude over a frequency range.

use crate::asked::{Band, FrequencyArguments, LoadArguments, measure, part, setting};
use crate::columns::Columns;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::{Column, OptimumTable};
use frictiongen::study::optimum::{FrequencyBand, OptimumRequest, Tuning};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Finds the optimal friction. Returns it with the peaks, the tolerances and the sensitivities.
#[pyfunction]
pub fn optimum<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyArguments<'py>,
    load: LoadArguments<'py>,
    vary: Option<(String, f64, f64)>,
) -> PyResult<[Bound<'py, PyDict>; 4]> {
    let system = &system.system;
    let part = part(system, "of", &of)?;
    let band = Band::of(system, &frequency)?;
    let measure = measure::of(system, &load)?;
    let request = OptimumRequest {
        of: part.of,
        size: part.size,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    };
    let tuning = vary.map(|(name, from, to)| {
        let of = system.tunable_named(&name);
        let of = of.map_err(|error| domain(format_args!("vary: {error}")))?;
        Ok::<_, PyErr>(Tuning { of, from, to })
    });
    let (optimum, value) = match tuning.transpose()? {
        None => {
            let found = without_lock(py, |stop| {
                system.optimum_watched(&request, &|| stop.goes_on())
            })?;
            (found.map_err(domain)?, None)
        }
        Some(tuning) => {
            let found = without_lock(py, |stop| {
                system.tuned_optimum_watched(&request, &tuning, &|| stop.goes_on())
            })?;
            let found = found.map_err(|error| domain(format_args!("vary: {error}")))?;
            (found.optimum, Some(found.value))
        }
    };
    let parts = [part];
    let table = OptimumTable {
        setting: setting(system, measure, band.unit(&measure), &parts),
    };
    let mut once = Columns::new(py, &[]);
    once.table(&table.columns(), std::slice::from_ref(&optimum))?;
    let once = once.done();
    once.set_item("value", value)?;
    Ok([
        once,
        list(py, &table.peak_columns(), &table.peaks(&optimum))?,
        list(py, &table.tolerance_columns(), &optimum.tolerances)?,
        list(
            py,
            &table.sensitivity_columns(),
            &table.sensitivities(&optimum),
        )?,
    ])
}

/// Returns a list of the answer as columns.
fn list<'py, R>(
    py: Python<'py>,
    columns: &[Column<'_, R>],
    rows: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let mut arrays = Columns::new(py, &[rows.len()]);
    arrays.table(columns, rows)?;
    Ok(arrays.done())
}
