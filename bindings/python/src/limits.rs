//! Computes the limit of continuous motion β_lim and the limit of sliding β*_lim over frequency.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, LoadKeywords, Measure, check_size, measure, setting,
    without,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::{Stop, without_lock};
use frictiongen::study::columns::{
    Frequency, JoinedLimitsRow, JoinedTable, LimitsAsked, LimitsRow, LimitsTable,
};
use frictiongen::study::joined::JoinedError;
use frictiongen::{OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::sync::Arc;

/// Number of frequencies after which the program checks if the user has pressed Ctrl-C.
const PORTION: usize = 4096;

fn all(
    table: &LimitsTable<'_>,
    frequencies: &[Frequency],
    stop: &Stop,
) -> Result<Vec<LimitsRow>, OutOfDomain> {
    let portions = frequencies.par_chunks(PORTION).map(|portion| {
        if !stop.goes_on() {
            return Ok(Vec::new());
        }
        portion.iter().map(|at| table.row(*at)).collect()
    });
    let portions: Vec<Vec<LimitsRow>> = portions.collect::<Result<_, OutOfDomain>>()?;
    Ok(portions.into_iter().flatten().collect())
}

/// Computes the limits of a scene with several contacts over frequency.
fn joined<'py>(
    py: Python<'py>,
    system: &Arc<System>,
    (frequencies, measure): (&FrequencyValues, Measure),
) -> PyResult<Bound<'py, PyDict>> {
    if !system.scene().has_linear_states() {
        return Err(domain(JoinedError::NotLinear));
    }
    let joined = system.joined().map_err(domain)?;
    let table = JoinedTable {
        setting: setting(system, measure, frequencies.unit(&measure), &[]),
        joined: &joined,
        orders: None,
    };
    let columns = table.limits_columns();
    check_size(frequencies.r.len(), columns.len())?;
    let asked = frequencies.all(system);
    let found = without_lock(py, |stop| {
        let found = asked.par_iter().map(|at| match stop.goes_on() {
            true => table.limits(*at).map(Some),
            false => Ok(None),
        });
        found.collect::<Result<Vec<Option<JoinedLimitsRow>>, JoinedError>>()
    })?;
    let rows: Vec<JoinedLimitsRow> = found.map_err(domain)?.into_iter().flatten().collect();
    let mut arrays = NamedArrays::new(py, &frequencies.shape());
    arrays.table(&columns, &rows)?;
    Ok(arrays.done())
}

/// Computes β_lim (limit of continuous motion) and β*_lim (limit of sliding) over frequency. If `estimates` is true,
/// the answer also has the two bounds on β_lim. If `search` is false, the answer has β*_lim and the upper bound on
/// β_lim that needs no search.
#[pyfunction]
pub fn limits<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    load: LoadKeywords<'py>,
    estimates: bool,
    search: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = FrequencyValues::of(system, &frequency, false)?;
    let measure = measure::of(system, &load)?;
    if system.scene().is_joined() {
        without(&[(estimates, "estimates"), (!search, "limits_without_search")])?;
        return joined(py, system, (&frequencies, measure));
    }
    let table = LimitsTable {
        setting: setting(system, measure, frequencies.unit(&measure), &[]),
        asked: match (search, estimates) {
            (false, _) => LimitsAsked::WithoutSearch,
            (true, false) => LimitsAsked::Exact,
            (true, true) => LimitsAsked::All,
        },
    };
    let columns = table.columns();
    check_size(frequencies.r.len(), columns.len())?;
    let asked = frequencies.all(system);
    let found = without_lock(py, |stop| all(&table, &asked, stop))?.map_err(domain)?;
    let mut arrays = NamedArrays::new(py, &frequencies.shape());
    arrays.table(&columns, &found)?;
    Ok(arrays.done())
}
