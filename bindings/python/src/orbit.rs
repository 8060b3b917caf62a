//! Computes the steady state at one frequency and one friction.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, Measure,
    MovingPart, Optional, driven, harmonics, quantities, setting,
};
use crate::columns::NamedArrays;
use crate::errors::{defect, domain};
use crate::joined::JoinedQuestion;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::study::SystemAt;
use frictiongen::study::columns::{Frequency, FrictionSetting, OrbitRow, OrbitTable};
use frictiongen::{OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Arguments of the Python functions `orbit` and `states`.
#[derive(Clone)]
struct OrbitKeywords {
    system: Arc<System>,
    measure: Measure,
    frequencies: FrequencyValues,
    frictions: FrictionValues,
    parts: Vec<MovingPart>,
    orders: Vec<u32>,
}

/// Function that computes the rows of the answer at one frequency and one friction, one row for each steady state.
type Rows = fn(
    &OrbitTable<'_>,
    &SystemAt<'_>,
    Frequency,
    FrictionSetting,
) -> Result<Vec<OrbitRow>, OutOfDomain>;

impl OrbitKeywords {
    fn table(&self) -> OrbitTable<'_> {
        let unit = self.frequencies.unit(&self.measure);
        OrbitTable {
            setting: setting(&self.system, self.measure, unit, &self.parts),
            orders: &self.orders,
        }
    }

    /// Returns one dictionary of columns for each steady state. The function `rows` computes the steady states.
    fn answer<'py>(&self, py: Python<'py>, rows: Rows) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let frequency = self.frequencies.only(&self.system)?;
        let (table, friction) = (self.table(), self.frictions.only()?);
        let owned = self.clone();
        let rows = left_at_interrupt(py, move |_| {
            let at = owned.system.at(frequency.r)?;
            rows(&owned.table(), &at, frequency, friction)
        })?
        .map_err(domain)?;
        let columns = table.columns();
        let each = rows.iter().map(|row| {
            let mut arrays = NamedArrays::new(py, &[]);
            arrays.table(&columns, std::slice::from_ref(row))?;
            Ok(arrays.done())
        });
        each.collect()
    }
}

/// Computes the steady states of a scene with several contacts. Returns `None` for a scene with a single contact.
fn joined<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    (frequency, friction): (&FrequencyKeywords<'py>, &FrictionKeywords<'py>),
    load: &DrivenKeywords<'py>,
    (of, highest, all): (Option<&Bound<'py, PyAny>>, &Optional<'py>, bool),
) -> PyResult<Option<Vec<Bound<'py, PyDict>>>> {
    let system = &system.system;
    if !system.scene().has_joined_states() {
        return Ok(None);
    }
    let frequencies = FrequencyValues::of(system, frequency, true)?;
    let question = JoinedQuestion::of(system, frequencies, friction, load, of)?;
    let question = question.with_harmonics(orders(highest.as_ref())?);
    question.states(py, all).map(Some)
}

/// Reads the orders of the harmonics, which begin with the mean value, order 0.
fn orders(highest: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<u32>> {
    Ok(match highest {
        None => Vec::new(),
        highest => (0..=harmonics(highest)?).collect(),
    })
}

/// Reads the arguments of `orbit` and `states`.
fn question<'py>(
    system: &NativeSystem,
    (frequency, friction): (&FrequencyKeywords<'py>, &FrictionKeywords<'py>),
    load: &DrivenKeywords<'py>,
    of: Option<&Bound<'py, PyAny>>,
    highest: Optional<'py>,
) -> PyResult<OrbitKeywords> {
    let (measure, system) = driven(&system.system, load)?;
    Ok(OrbitKeywords {
        frequencies: FrequencyValues::of(&system, frequency, true)?,
        parts: quantities(&system, "of", of)?,
        system,
        measure,
        frictions: FrictionValues::of(friction, &measure)?,
        orders: orders(highest.as_ref())?,
    })
}

/// Computes the steady state that the motion from rest or from another state reaches, at one frequency and one friction.
#[pyfunction]
pub fn orbit<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let at = (&frequency, &friction);
    let several = joined(py, system, at, &load, (of.as_ref(), &highest, false))?;
    let found = match several {
        Some(found) => found,
        None => {
            let question = question(system, at, &load, of.as_ref(), highest)?;
            question.answer(py, |table, at, frequency, friction| {
                Ok(vec![table.row(at, frequency, friction)?])
            })?
        }
    };
    let only = found.into_iter().next();
    only.ok_or_else(|| defect("a steady state is missing: please report this with the description"))
}

/// Computes every steady state that the search finds at one frequency and one friction.
#[pyfunction]
pub fn states<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: DrivenKeywords<'py>,
    of: Optional<'py>,
    highest: Optional<'py>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let at = (&frequency, &friction);
    if let Some(found) = joined(py, system, at, &load, (of.as_ref(), &highest, true))? {
        return Ok(found);
    }
    let question = question(system, at, &load, of.as_ref(), highest)?;
    question.answer(py, |table, at, frequency, friction| {
        table.states(at, frequency, friction)
    })
}
