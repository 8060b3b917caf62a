//! Derivatives of a response and of both limits with respect to every parameter.

use crate::asked::{
    Frequencies, FrequencyArguments, FrictionArguments, Frictions, LoadArguments, measure, part,
};
use crate::columns::{Columns, Words, cell};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::study::columns::Dimension;
use frictiongen::study::{OperatingPoint, ParameterSensitivity, Slope, words};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Function that reads an answer.
type Read = fn(&ParameterSensitivity) -> Option<Slope>;

/// Answers: names of their columns, their units, and the functions that read them.
const ANSWERS: [(&str, Dimension, Read); 4] = [
    ("amplitude", Dimension::Length, |of| Some(of.amplitude)),
    ("phase", Dimension::Angle, |of| of.phase),
    ("continuous_limit", Dimension::Force, |of| {
        of.continuous_limit
    }),
    ("sliding_limit", Dimension::Force, |of| of.sliding_limit),
];

/// Returns the derivatives at one point as columns, with one row for each parameter.
#[pyfunction]
pub fn sensitivities<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyArguments<'py>,
    friction: FrictionArguments<'py>,
    load: LoadArguments<'py>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let system = &system.system;
    let part = part(system, "of", &of)?;
    let frequencies = Frequencies::of(system, &frequency, true)?;
    let measure = measure::of(system, &load)?;
    let frictions = Frictions::of(&friction, &measure)?;
    let (r, (beta, force)) = (frequencies.only()?, frictions.only()?);
    let point = match measure.load() {
        Some(load) => OperatingPoint::Physical {
            hertz: frequencies.hertz(system, 0),
            friction: force,
            load,
        },
        None => OperatingPoint::Groups { r, beta },
    };
    let known = without_lock(py, |_| system.response_sensitivities(point, part.of))?;
    let known = known.map_err(|error| match words::no_derivative(&error) {
        Some(word) => domain(format_args!("no derivative ({word}): {error}")),
        None => domain(error),
    })?;

    let all = || known.parameters.iter();
    let mut columns = Columns::new(py, &[known.parameters.len()]);
    let symbols = all().map(|of| of.parameter.symbol(system.scene(), &point));
    columns.words("parameter", symbols.collect::<Words>())?;
    columns.numbers("value", all().map(|of| cell(Some(of.value))).collect())?;
    columns.words(
        "unit",
        all().map(|of| of.parameter.unit(&point)).collect::<Words>(),
    )?;
    for (name, unit, read) in ANSWERS {
        let is_phase = name == "phase";
        let counted = |value: f64| {
            if is_phase {
                measure.angle(value)
            } else {
                value
            }
        };
        let name = measure.name(name, unit);
        let value = |of: &ParameterSensitivity| cell(read(of).map(|slope| counted(slope.value)));
        columns.numbers(&name, all().map(value).collect())?;
        let derivative =
            |of: &ParameterSensitivity| cell(read(of).map(|slope| counted(slope.derivative)));
        columns.numbers(
            format!("{name}.derivative"),
            all().map(derivative).collect(),
        )?;
        let relative = |of: &ParameterSensitivity| {
            let slope = read(of);
            cell(match is_phase {
                true => slope.map(|slope| of.value * counted(slope.derivative)),
                false => slope.and_then(|slope| slope.relative(of.value)),
            })
        };
        columns.numbers(format!("{name}.relative"), all().map(relative).collect())?;
    }
    Ok((words::regime(known.regime).to_owned(), columns.done()))
}
