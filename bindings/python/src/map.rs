//! Computes maps of the contact's regime over frequency and friction.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Optional,
    check_size, driven, parts, setting,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::by_contact;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::{ColumnAxis, MapTable};
use frictiongen::study::map::MapRequest;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Computes the regime of the contact over frequency and friction.
#[pyfunction]
pub fn map<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    if system.system.scene().has_joined_states() {
        return by_contact(py, system, frequency, friction, load, of);
    }
    let frequencies = FrequencyValues::of(&system.system, &frequency, load.1.is_some())?;
    if let Some(index) = frequencies.r.iter().position(|r| r.is_infinite()) {
        return Err(domain(format_args!(
            "the frequency with the index {index} is infinite, but a map needs finite frequencies"
        )));
    }
    let (measure, system) = driven(&system.system, &load)?;
    let system = &*system;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let parts = parts(system, "of", of.as_ref())?;
    let table = MapTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
    };
    check_size(
        frequencies.r.len().saturating_mul(frictions.beta.len()),
        table.columns().len(),
    )?;
    let request = MapRequest {
        r: frequencies.r.clone(),
        beta: frictions.beta.clone(),
        of: parts.iter().map(|part| part.of).collect(),
    };
    let fall = measure.fall();
    let map = without_lock(py, |stop| {
        system.map_under(&request, fall, |_| stop.goes_on())
    })?;
    let map = map.map_err(domain)?;

    let (along, up) = (frequencies.all(system), frictions.all());
    let limits: Vec<_> = MapTable::limits(&map, along.iter().copied()).collect();
    let rows: Vec<_> = MapTable::rows(measure, &map, along.into_iter(), up.into_iter()).collect();
    let mut arrays = NamedArrays::new(py, &frequencies.shape());
    frequencies.put(&mut arrays, &table.setting)?;
    arrays.table(&table.limits_columns(), &limits)?;
    arrays.reshape(&frictions.shape());
    frictions.put(&mut arrays, &table.setting)?;
    arrays.reshape(&[frequencies.shape(), frictions.shape()].concat());
    arrays.along(ColumnAxis::Row, &table.columns(), &rows)?;
    Ok(arrays.done())
}
