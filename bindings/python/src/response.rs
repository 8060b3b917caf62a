//! Computes the response in every regime over frequency and friction.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Optional,
    check_size, driven, harmonics, put_grid, quantities, setting,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::JoinedQuestion;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::OutOfDomain;
use frictiongen::study::columns::{ResponseRow, ResponseTable};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

/// Computes the response in every regime, over frequency and friction.
#[pyfunction]
pub fn response<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let orders: Vec<u32> = (1..=harmonics(highest.as_ref())?).step_by(2).collect();
    if system.system.scene().has_joined_states() {
        let system = &system.system;
        let frequencies = FrequencyValues::of(system, &frequency, true)?;
        let question = JoinedQuestion::of(system, frequencies, &friction, &load, of.as_ref())?;
        return question.with_harmonics(orders).grid(py);
    }
    let frequencies = FrequencyValues::of(&system.system, &frequency, load.1.is_some())?;
    let (measure, system) = driven(&system.system, &load)?;
    let system = &*system;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let parts = quantities(system, "of", of.as_ref())?;
    let table = ResponseTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
        orders: &orders,
        stuck: true,
    };
    let columns = table.columns();
    let points = frequencies.r.len().saturating_mul(frictions.beta.len());
    check_size(points, columns.len())?;
    let (along, up) = (frequencies.all(system), frictions.all());
    let found = without_lock(py, |stop| {
        let along = along.par_iter().with_max_len(16);
        let found = along.map(|at| {
            if stop.goes_on() {
                table.rows(*at, up.iter().copied())
            } else {
                Ok(Vec::new())
            }
        });
        found.collect::<Result<Vec<Vec<ResponseRow>>, OutOfDomain>>()
    })?
    .map_err(domain)?;
    let rows: Vec<ResponseRow> = found.into_iter().flatten().collect();

    let mut arrays = NamedArrays::new(py, &[]);
    let grid = (&frequencies, &frictions);
    put_grid(&mut arrays, grid, &table.setting, (&columns, &rows))?;
    Ok(arrays.done())
}
