//! Computes maps of the contact's regime over frequency and friction.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Optional,
    check_size, driven, parts, setting, whole, without,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::joined::by_contact;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::OutOfDomain;
use frictiongen::study::columns::{ColumnAxis, Frequency, MapTable};
use frictiongen::study::map::{Boundary, MapRequest};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Largest number of significant digits of a boundary. The command has the same limit.
const MOST_DIGITS: u32 = 12;

/// Columns of the points, and columns of the boundaries between regions.
type MapAnswer<'py> = (Bound<'py, PyDict>, Option<Bound<'py, PyDict>>);

/// Computes the regime of the contact over frequency and friction. `asked` has the motions, and the number of significant
/// digits of the frictions at the boundaries between regions.
#[pyfunction]
pub fn map<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    asked: (Optional<'py>, Optional<'py>),
) -> PyResult<MapAnswer<'py>> {
    let (of, digits) = asked;
    if system.system.scene().has_joined_states() {
        without(&[(digits.is_some(), "boundaries")])?;
        let points = by_contact(py, system, frequency, friction, load, of)?;
        return Ok((points, None));
    }
    let digits = digits.map(|digits| whole("boundaries", &digits, 1..=MOST_DIGITS));
    let digits = digits.transpose()?;
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
    let found = without_lock(py, |stop| {
        let map = system.map_under(&request, fall, |_| stop.goes_on())?;
        let digits = digits.filter(|_| stop.goes_on());
        let boundaries = digits.map(|digits| system.boundaries(&map, digits));
        Ok((map, boundaries))
    })?;
    let (map, boundaries) = found.map_err(|error: OutOfDomain| domain(error))?;
    let (along, up) = (frequencies.all(system), frictions.all());
    let boundaries = boundaries.map(|found| bounds(py, &table, (&found, &along)));
    let limits: Vec<_> = MapTable::limits(&map, along.iter().copied()).collect();
    let rows: Vec<_> = MapTable::rows(measure, &map, along.into_iter(), up.into_iter()).collect();
    let mut arrays = NamedArrays::new(py, &frequencies.shape());
    frequencies.put(&mut arrays, &table.setting)?;
    arrays.table(&table.limits_columns(), &limits)?;
    arrays.reshape(&frictions.shape());
    frictions.put(&mut arrays, &table.setting)?;
    arrays.reshape(&[frequencies.shape(), frictions.shape()].concat());
    arrays.along(ColumnAxis::Row, &table.columns(), &rows)?;
    Ok((arrays.done(), boundaries.transpose()?))
}

/// Returns the columns of the boundaries between the regions of a map.
fn bounds<'py>(
    py: Python<'py>,
    table: &MapTable<'_>,
    (found, along): (&[Boundary], &[Frequency]),
) -> PyResult<Bound<'py, PyDict>> {
    let rows: Vec<_> = table.boundaries(found, along.iter().copied()).collect();
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&table.boundary_columns(), &rows)?;
    Ok(arrays.done())
}
