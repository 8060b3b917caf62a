//! Computes the limit of continuous motion β_lim and the limit of sliding β*_lim over frequency.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, LoadKeywords, check_size, measure, setting,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::{Stop, without_lock};
use frictiongen::OutOfDomain;
use frictiongen::study::columns::{Frequency, LimitsAsked, LimitsRow, LimitsTable};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

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
