//! Computes the steady states of scenes with several contacts, with the numbers of each contact.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Optional,
    check_size, driven, names, put_grid, setting,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::{JoinedRow, JoinedTable, MovingPart};
use frictiongen::study::joined::JoinedError;
use frictiongen::{Of, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

/// Returns the motions with the given names. Without names, returns all masses.
pub fn motions(system: &System, given: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<MovingPart>> {
    let mut asked = names("of", given)?;
    if asked.is_empty() {
        let masses = system.scene().masses.iter();
        asked = masses.map(|mass| mass.name.clone()).collect();
    }
    let parts = asked.iter().map(|name| {
        let part = MovingPart::named(system, name);
        let part = part.map_err(|error| domain(format_args!("of: {error}")))?;
        match part.of {
            Of::Contact => Err(domain(format_args!(
                "of: `{name}` is no motion of masses; the answer has every contact by its name"
            ))),
            _ => Ok(part),
        }
    });
    parts.collect()
}

/// Computes the steady state that motion from rest or from another state reaches, for a scene with several contacts,
/// over frequency and friction.
#[pyfunction]
pub fn by_contact<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let (measure, system) = driven(&system.system, &load)?;
    let system = &*system;
    let joined = system.joined().map_err(domain)?;
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let parts = motions(system, of.as_ref())?;
    let table = JoinedTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
        joined: &joined,
        orders: None,
    };
    let columns = table.columns();
    let (along, up) = (frequencies.all(system), frictions.all());
    check_size(along.len().saturating_mul(up.len()), columns.len())?;
    let found = without_lock(py, |stop| {
        let rows = along.par_iter().with_max_len(1).map(|at| {
            let rows = up.iter().take_while(|_| stop.goes_on());
            rows.map(|friction| table.row(*at, *friction)).collect()
        });
        rows.collect::<Result<Vec<Vec<JoinedRow>>, JoinedError>>()
    })?
    .map_err(domain)?;
    let rows: Vec<JoinedRow> = found.into_iter().flatten().collect();

    let mut arrays = NamedArrays::new(py, &[]);
    let grid = (&frequencies, &frictions);
    put_grid(&mut arrays, grid, &table.setting, (&columns, &rows))?;
    Ok(arrays.done())
}
