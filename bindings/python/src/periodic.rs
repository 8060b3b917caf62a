//! Computes steady states under a periodic load of any form.

use crate::asked::{self, FrictionValues, Measure, Optional, check_size, names, parts};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::System;
use frictiongen::study::columns::{PeriodicRow, PeriodicTable};
use frictiongen::study::periodic::{PeriodicError, PeriodicRequest};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::sync::Arc;

/// The Python arguments `load`, `period` and `hold`.
type PeriodArguments<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>, bool);

/// The answer: columns of the steady states, and columns of each motion over one period.
type PeriodicAnswer<'py> = (Bound<'py, PyDict>, Vec<Bound<'py, PyDict>>);

/// Finds the steady state under a periodic load at one friction force.
fn row(
    system: &System,
    request: &PeriodicRequest,
    friction: f64,
) -> Result<PeriodicRow, (f64, PeriodicError)> {
    let request = PeriodicRequest {
        friction,
        ..request.clone()
    };
    let state = system.periodic(&request);
    let state = state.map_err(|error| (friction, error))?;
    Ok(PeriodicRow { friction, state })
}

/// Finds the steady state under a periodic load at each friction. With `motion`, the answer also has the motion of each
/// steady state over one of its periods.
#[pyfunction]
pub fn periodic<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    load: PeriodArguments<'py>,
    friction: Bound<'py, PyAny>,
    of: Optional<'py>,
    motion: bool,
) -> PyResult<PeriodicAnswer<'py>> {
    let (load, period, hold) = load;
    let (system, load) = asked::periodic::load(&system.system, &load, &period, hold)?;
    let system = Arc::new(system);
    let frictions = FrictionValues::listed(&(None, Some(friction)), &Measure::si(&system))?;
    let mut parts = parts(&system, "of", of.as_ref())?;
    if names("of", of.as_ref())?.is_empty() {
        parts = parts
            .into_iter()
            .map(|part| part.from_base(&system))
            .collect();
    }
    let table = PeriodicTable {
        system: &system,
        parts: &parts,
    };
    let columns = table.columns();
    let forces: Vec<f64> = frictions.all().iter().map(|one| one.force()).collect();
    check_size(forces.len(), columns.len())?;
    let request = PeriodicRequest {
        load,
        friction: 0.0,
        of: parts.iter().map(|part| part.of).collect(),
    };
    let owned = Arc::clone(&system);
    let found = left_at_interrupt(py, move |stop| {
        let rows = forces.par_iter().with_max_len(1).map(|friction| {
            let goes_on = stop.goes_on();
            goes_on
                .then(|| row(&owned, &request, *friction))
                .transpose()
        });
        rows.collect::<Result<Vec<Option<PeriodicRow>>, _>>()
    })?;
    let rows: Vec<PeriodicRow> = match found {
        Ok(rows) => rows.into_iter().flatten().collect(),
        Err((friction, error)) => {
            return Err(domain(format_args!(
                "with a friction force of {friction:?} N: {error}"
            )));
        }
    };
    let mut arrays = NamedArrays::new(py, &frictions.shape());
    arrays.table(&columns, &rows)?;
    let shown: &[PeriodicRow] = if motion { &rows } else { &[] };
    Ok((arrays.done(), motions(py, &table, shown)?))
}

/// Returns the columns of the motion over one period, for each steady state.
fn motions<'py>(
    py: Python<'py>,
    table: &PeriodicTable<'_>,
    rows: &[PeriodicRow],
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let instants = rows.iter().map(|row| row.state.forces().len()).sum();
    check_size(instants, 2 * table.parts.len() + 2)?;
    let each = rows.iter().map(|row| {
        let samples: Vec<_> = row.samples().collect();
        let mut arrays = NamedArrays::new(py, &[samples.len()]);
        arrays.table(&table.sample_columns(), &samples)?;
        Ok(arrays.done())
    });
    each.collect()
}
