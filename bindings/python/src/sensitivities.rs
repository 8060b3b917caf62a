//! Computes the derivatives of a response and of β_lim and β*_lim with respect to every parameter.

use crate::asked::{
    FrequencyKeywords, FrequencyValues, FrictionKeywords, FrictionValues, LoadKeywords, measure,
    part, setting,
};
use crate::columns::NamedArrays;
use crate::errors::{domain, wrong_type};
use crate::joined::JoinedQuestion;
use crate::system::NativeSystem;
use crate::work::left_at_interrupt;
use frictiongen::study::columns::{JoinedPart, JoinedSensitivityTable, SensitivityTable};
use frictiongen::study::joined::JoinedError;
use frictiongen::study::words;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Returns the derivatives of a response and of the limits at one point as columns, with one row for each parameter.
#[pyfunction]
pub fn sensitivities<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyKeywords<'py>,
    friction: FrictionKeywords<'py>,
    load: LoadKeywords<'py>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let system = &system.system;
    if system.scene().has_joined_states() {
        let frequencies = FrequencyValues::of(system, &frequency, true)?;
        let question = JoinedQuestion::of(system, frequencies, &friction, &(load, None), None)?;
        return joined(py, &question, &of);
    }
    let part = part(system, "of", &of)?;
    let frequencies = FrequencyValues::of(system, &frequency, true)?;
    let measure = measure::of(system, &load)?;
    let frictions = FrictionValues::of(&friction, &measure)?;
    let (frequency, friction) = (frequencies.only(system)?, frictions.only()?);
    let parts = [part];
    let table = SensitivityTable {
        setting: setting(system, measure, frequencies.unit(&measure), &parts),
    };
    let point = table.setting.point(frequency, friction);
    let [part] = &parts;
    let (owned, of) = (Arc::clone(system), part.of);
    let known = left_at_interrupt(py, move |_| owned.response_sensitivities(point, of))?;
    let known = known.map_err(|error| match words::no_derivative(&error) {
        Some(word) => domain(format_args!("no derivative ({word}): {error}")),
        None => domain(error),
    })?;
    let regime = words::regime(known.regime).to_owned();
    let rows = table.rows(frequency, friction, Ok(known)).map_err(domain)?;
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&table.parameter_columns(), &rows)?;
    Ok((regime, arrays.done()))
}

/// Returns the derivatives of the motion of a mass, or of the numbers of a contact, for a scene with several contacts.
fn joined<'py>(
    py: Python<'py>,
    question: &JoinedQuestion,
    of: &Bound<'py, PyAny>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let system = &question.system;
    let (frequency, friction) = (
        question.frequencies.only(system)?,
        question.frictions.only()?,
    );
    let joined = system.joined().map_err(domain)?;
    let Ok(name) = of.extract::<String>() else {
        return Err(wrong_type(
            "of: the name of a mass or of a contact is needed",
        ));
    };
    let part = JoinedPart::named(&joined, "of", &name).map_err(domain)?;
    let (owned, own_part) = (question.clone(), part.clone());
    let rows = left_at_interrupt(py, move |_| {
        let joined = owned.system.joined()?;
        let table = JoinedSensitivityTable {
            setting: owned.table(&joined).setting,
            joined: &joined,
            of: &own_part,
        };
        table.rows(frequency, friction)
    })?;
    let rows = rows.map_err(|error: JoinedError| domain(error))?;
    let regime = match rows.first() {
        Some(row) if row.itself().is_none() => {
            return Err(domain(format_args!("no derivative: {}", row.answer)));
        }
        row => row.map_or("", |row| row.regime).to_owned(),
    };
    let table = JoinedSensitivityTable {
        setting: question.table(&joined).setting,
        joined: &joined,
        of: &part,
    };
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&table.parameter_columns(), &rows)?;
    Ok((regime, arrays.done()))
}
