//! Computes the steady states of scenes with any number of contacts, with the numbers of each contact.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Measure,
    Optional, check_size, driven, names, put_grid, setting,
};
use crate::columns::NamedArrays;
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::{Stop, left_at_interrupt};
use frictiongen::System;
use frictiongen::study::columns::{JoinedRow, JoinedTable, MovingPart};
use frictiongen::study::joined::{Joined, JoinedError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Returns the motions with the given names. Without names, returns all masses.
pub fn motions(system: &System, given: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<MovingPart>> {
    MovingPart::of_joined(system, "of", &names("of", given)?).map_err(domain)
}

/// A question about steady states of a scene with any number of contacts, over frequency and friction.
#[derive(Clone)]
pub struct JoinedQuestion {
    /// The system, which starts from the given state.
    pub system: Arc<System>,
    /// Units of the answer.
    pub measure: Measure,
    /// The given frequencies.
    pub frequencies: FrequencyValues,
    /// The given frictions.
    pub frictions: FrictionValues,
    /// The motions in the answer, besides those of the contacts.
    pub parts: Vec<MovingPart>,
    /// Orders of the harmonics in the answer, which then also has phases. `None` for amplitudes alone.
    orders: Option<Vec<u32>>,
}

impl JoinedQuestion {
    /// Reads a question from Python.
    pub fn of(
        system: &Arc<System>,
        frequencies: FrequencyValues,
        friction: &FrictionKeywords<'_>,
        load: &DrivenKeywords<'_>,
        of: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let (measure, system) = driven(system, load)?;
        Ok(Self {
            frictions: FrictionValues::of(friction, &measure)?,
            parts: motions(&system, of)?,
            system,
            measure,
            frequencies,
            orders: None,
        })
    }

    /// Requests the phases of all motions, and their harmonics of these orders.
    pub fn with_harmonics(self, orders: Vec<u32>) -> Self {
        Self {
            orders: Some(orders),
            ..self
        }
    }

    /// Returns the tables of the answer.
    pub fn table<'a>(&'a self, joined: &'a Joined<'a>) -> JoinedTable<'a> {
        let unit = self.frequencies.unit(&self.measure);
        JoinedTable {
            setting: setting(&self.system, self.measure, unit, &self.parts),
            joined,
            orders: self.orders.as_deref(),
        }
    }

    /// Computes the steady state at every frequency and friction, and returns its columns as arrays.
    pub fn grid<'py>(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let joined = self.system.joined().map_err(domain)?;
        let table = self.table(&joined);
        let columns = table.columns();
        let points = self.frequencies.r.len();
        let points = points.saturating_mul(self.frictions.beta.len());
        check_size(points, columns.len())?;
        let owned = self.clone();
        let rows = left_at_interrupt(py, move |stop| owned.rows(stop))?.map_err(domain)?;
        let mut arrays = NamedArrays::new(py, &[]);
        let grid = (&self.frequencies, &self.frictions);
        put_grid(&mut arrays, grid, &table.setting, (&columns, &rows))?;
        Ok(arrays.done())
    }

    fn rows(&self, stop: &Stop) -> Result<Vec<JoinedRow>, JoinedError> {
        let joined = self.system.joined()?;
        let table = self.table(&joined);
        let (along, up) = (self.frequencies.all(&self.system), self.frictions.all());
        let mut all = Vec::new();
        table.rows(&along, &up, |rows| match stop.goes_on() {
            true => {
                all.extend(rows);
                Ok(())
            }
            false => Err(JoinedError::Stopped),
        })?;
        Ok(all)
    }

    /// Computes the steady state at the only frequency and friction, or every steady state there if `all` is true.
    /// Returns the columns of each state.
    pub fn states<'py>(self, py: Python<'py>, all: bool) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let joined = self.system.joined().map_err(domain)?;
        let columns = self.table(&joined).columns();
        let (frequency, friction) = (self.frequencies.only(&self.system)?, self.frictions.only()?);
        let owned = self.clone();
        let rows = left_at_interrupt(py, move |_| {
            let joined = owned.system.joined()?;
            let table = owned.table(&joined);
            match all {
                true => table.states(frequency, friction),
                false => Ok(vec![table.row(frequency, friction)?]),
            }
        })?;
        let rows: Vec<JoinedRow> = rows.map_err(domain)?;
        let each = rows.iter().map(|row| {
            let mut arrays = NamedArrays::new(py, &[]);
            arrays.table(&columns, std::slice::from_ref(row))?;
            Ok(arrays.done())
        });
        each.collect()
    }
}

/// Computes the steady state that motion from rest or from another state reaches, over frequency and friction, with the
/// numbers of each contact.
#[pyfunction]
pub fn by_contact<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    JoinedQuestion::of(system, frequencies, &friction, &load, of.as_ref())?.grid(py)
}
