//! Finds the friction that minimises the largest amplitude over a frequency range. Bounds on other quantities may
//! restrict this friction. For several quantities, the module finds the friction that minimises the largest quotient
//! of a quantity and its divisor.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyRange, Measure, MovingPart, driven, one, quantity,
    setting,
};
use crate::columns::NamedArrays;
use crate::errors::{domain, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::study::columns::{Cell, Column, OptimumLine, OptimumTable};
use frictiongen::study::optimum::{
    FrequencyBand, Optimum, OptimumError, OptimumOptions, OptimumRequest, QuantityValue, Tuning,
};
use frictiongen::study::response::MotionQuantity;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// Names of two lists in the library's lines about an optimum: the quantities with divisors, and the quantities with
/// bounds.
const LISTS: [&str; 2] = ["weighted", "kept"];

/// An argument that is a dict of quantities and their values.
struct ValuedArgument {
    /// Name of the argument.
    name: &'static str,
    /// Words for the value of a quantity in messages, such as `the bound of a quantity`.
    value: &'static str,
}

/// The argument `of`: quantities with their divisors. The search minimises the largest quotient of a quantity and its
/// divisor.
const OF: ValuedArgument = ValuedArgument {
    name: "of",
    value: "the value that divides a quantity",
};

/// The argument `keep`: quantities that the search keeps within bounds.
const KEEP: ValuedArgument = ValuedArgument {
    name: "keep",
    value: "the bound of a quantity",
};

/// A quantity with its divisor or its bound. The value is non-dimensional, as the amplitudes of an optimum are, and
/// refers to the load at r = 1.
struct Valued {
    part: MovingPart,
    value: f64,
}

/// A further variable of the optimisation, with its interval, and quantities with their bounds.
type Constraints<'py> = (Option<(String, f64, f64)>, Option<Bound<'py, PyDict>>);

/// The answer: columns of the optimum, of its peaks, of its tolerances and of its sensitivities, and an entry for
/// each of several quantities and for each kept quantity.
type OptimumAnswer<'py> = ([Bound<'py, PyDict>; 4], Vec<QuantityAnswer<'py>>);

/// Answer about one of several quantities, or about a kept quantity: its name, its unit, and its numbers by the keys of
/// the library.
type QuantityAnswer<'py> = (String, &'static str, Bound<'py, PyDict>);

/// Finds the best friction for a quantity, or for several quantities that are each divided by a value. With `keep`, the
/// best friction satisfies a bound on each quantity of this dict.
#[pyfunction]
pub fn optimum<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyKeywords<'py>,
    load: DrivenKeywords<'py>,
    constraints: Constraints<'py>,
) -> PyResult<OptimumAnswer<'py>> {
    let (vary, keep) = constraints;
    let (measure, system) = driven(&system.system, &load)?;
    let system = &*system;
    let band = FrequencyRange::of(system, &frequency)?;
    let several = several(system, &measure, (&of, [vary.is_some(), keep.is_some()]))?;
    let mut part = match several.first() {
        Some(first) => first.part.clone(),
        None => quantity(system, "of", of.cast::<PyString>()?.to_str()?)?,
    };
    let vary = vary
        .as_ref()
        .map(|vary| tunings(system, vary))
        .transpose()?;
    let vary = vary.unwrap_or_default();
    let bounds = keep.map(|keep| valued(system, &measure, (&KEEP, &keep)));
    let bounds = bounds.transpose()?.unwrap_or_default();
    let request = OptimumRequest {
        of: part.of,
        size: part.size,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    };
    let found = without_lock(py, |stop| {
        let options = OptimumOptions {
            kept: &values(&bounds),
            weighted: &values(&several),
            vary: &vary,
            watch: Some(&|| stop.goes_on()),
            ..OptimumOptions::default()
        };
        system.optimum_with(&request, &options)
    })?;
    let found = found.map_err(|error| failure(system, &measure, (&vary, &bounds), error))?;
    let [kept, weighted] = [&bounds, &several].map(|all| {
        let parts = all.iter().map(|one| (one.part.clone(), one.value));
        parts.collect::<Vec<(MovingPart, f64)>>()
    });
    if let Some(decisive) = several.get(found.decisive) {
        part = decisive.part.clone();
    }
    let table = OptimumTable {
        setting: setting(
            system,
            measure,
            band.unit(&measure),
            std::slice::from_ref(&part),
        ),
        kept: &kept,
        weighted: &weighted,
    };
    let (answer, lines) = (answer(py, &table, &found)?, table.lines(&found));
    let [once, ..] = &answer;
    put_tuned(once, &lines)?;
    let mut quotients = weighted.iter().zip(&found.largest);
    if let Some(((part, over), largest)) = quotients.nth(found.decisive) {
        once.set_item("decisive", &part.name)?;
        once.set_item("quotient", largest / over)?;
    }
    let quantities = quantities(py, &[kept, weighted].concat(), &lines)?;
    Ok((answer, quantities))
}

/// Reads several quantities with their divisors from the argument `of`. The list is empty for the name of a single
/// quantity. `others` has a flag for each argument that needs a single quantity: `vary` and `keep`.
fn several(
    system: &System,
    measure: &Measure,
    (of, others): (&Bound<'_, PyAny>, [bool; 2]),
) -> PyResult<Vec<Valued>> {
    let Ok(quantities) = of.cast::<PyDict>() else {
        if of.cast::<PyString>().is_err() {
            return Err(wrong_type(
                "of: the name of a mass is needed, or `contact`; for several quantities a dict {name: value}",
            ));
        }
        return Ok(Vec::new());
    };
    for (given, name) in others.into_iter().zip(["vary", "keep"]) {
        if given {
            return Err(domain(format_args!(
                "{name} needs a single quantity: give its name as of, without a value"
            )));
        }
    }
    valued(system, measure, (&OF, quantities))
}

/// Returns the numbers of the description that `vary` names, with their interval.
fn tunings(system: &System, (name, from, to): &(String, f64, f64)) -> PyResult<Vec<Tuning>> {
    let named = system.tunables_named(name);
    let named = named.map_err(|error| domain(format_args!("vary: {error}")))?;
    let (from, to) = (*from, *to);
    let tunings = named.into_iter().map(|of| Tuning { of, from, to });
    Ok(tunings.collect())
}

fn values(all: &[Valued]) -> Vec<QuantityValue> {
    let values = all.iter().map(|valued| QuantityValue {
        of: valued.part.of,
        size: valued.part.size,
        value: valued.value,
    });
    values.collect()
}

/// Adds the best values of the varied numbers to the answer: one number, or the shares of all contacts and the amplitude
/// with the shares of the description.
fn put_tuned(once: &Bound<'_, PyDict>, lines: &[OptimumLine]) -> PyResult<()> {
    let shares = PyDict::new(once.py());
    for line in lines {
        let Cell::Number(value) = line.value else {
            continue;
        };
        match line.list {
            Some("shares") => shares.set_item(&line.key, value)?,
            Some("tuned") => once.set_item("value", value)?,
            None if line.key.starts_with("amplitude_before") => {
                once.set_item(&line.key, value)?;
            }
            _ => {}
        }
    }
    once.set_item("shares", shares)
}

/// Returns the exception for a search without a result. If no friction satisfies a bound, the message names the bound
/// and the smallest possible value, in the unit of the argument.
fn failure(
    system: &System,
    measure: &Measure,
    (vary, bounds): (&[Tuning], &[Valued]),
    error: OptimumError,
) -> PyErr {
    if let OptimumError::Unreachable {
        index, least, beta, ..
    } = error
        && let Some(bound) = bounds.get(index)
    {
        let reference = system.angular_frequency(1.0);
        let dimension = bound.part.dimension();
        let [least, most] =
            [least, bound.value].map(|value| measure.convert(dimension, value, reference));
        let unit = measure.unit_or_reference(dimension);
        let before = match index {
            0 => "",
            _ => " together with the bounds before it",
        };
        let friction = match measure.scale() {
            Some(_) => format!("{:?} N", measure.force(beta)),
            None => format!("beta {beta:?}"),
        };
        return domain(format_args!(
            "keep[{:?}] is {most:?}: no friction holds this bound{before}; the least value is {}, with the friction {friction}",
            bound.part.name,
            format!("{least:?} {unit}").trim_end(),
        ));
    }
    let is_of_vary = matches!(error, OptimumError::Interval | OptimumError::Scene(_));
    match is_of_vary || (bounds.is_empty() && !vary.is_empty()) {
        true => domain(format_args!("vary: {error}")),
        false => domain(error),
    }
}

/// Reads a dict of quantities and their values in SI units from Python.
fn valued(
    system: &System,
    measure: &Measure,
    (argument, given): (&ValuedArgument, &Bound<'_, PyDict>),
) -> PyResult<Vec<Valued>> {
    let of = argument.name;
    if given.is_empty() {
        return Err(domain(format_args!(
            "{of}: the dict is empty; give at least one quantity with {}",
            argument.value
        )));
    }
    // The result of an optimum has non-dimensional groups that refer to the load at r = 1, so the values are converted
    // with this load.
    let reference = system.angular_frequency(1.0);
    let read = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract().map_err(|_| {
            wrong_type(format_args!(
                "{of}: the names of quantities are needed, as in {{\"accel(roof)\": 5.0}}"
            ))
        })?;
        let part = quantity(system, of, &name)?;
        if part.size == MotionQuantity::Damping {
            return Err(domain(format_args!(
                "{of}: `{name}`: an equivalent damping ratio has no upper bound; leave it out"
            )));
        }
        let place = format!("{of}[{name:?}]");
        let value = one(&place, &value)?;
        let over = value / measure.convert(part.dimension(), 1.0, reference);
        if !(0.0 < value && value.is_finite()) {
            return Err(domain(format_args!(
                "{place} is {value:?}: {} must be above 0 and finite",
                argument.value
            )));
        }
        if !(0.0 < over && over.is_finite()) {
            return Err(domain(format_args!(
                "{place} is {value:?}: with this load it is too small or too large to compute with"
            )));
        }
        Ok(Valued { part, value: over })
    };
    given.iter().map(read).collect()
}

/// Returns the answer about each of several quantities, or about each kept quantity: its name, its unit and its numbers.
fn quantities<'py>(
    py: Python<'py>,
    values: &[(MovingPart, f64)],
    lines: &[OptimumLine],
) -> PyResult<Vec<QuantityAnswer<'py>>> {
    let each = (1..).zip(values).map(|(row, (part, ..))| {
        let (numbers, mut unit) = (PyDict::new(py), "");
        let of_row = |line: &&OptimumLine| {
            line.list.is_some_and(|list| LISTS.contains(&list)) && line.row == Some(row)
        };
        for line in lines.iter().filter(of_row) {
            if let Cell::Number(value) = line.value {
                numbers.set_item(&line.key, value)?;
            }
            // The quotient of a quantity has no unit. The unit of the answer is therefore the first unit that is not
            // empty.
            if unit.is_empty() {
                unit = line.unit;
            }
        }
        Ok((part.name.clone(), unit, numbers))
    });
    each.collect()
}

/// Returns the columns of an optimum, of its peaks, of its tolerances and of its sensitivities.
fn answer<'py>(
    py: Python<'py>,
    table: &OptimumTable<'_>,
    optimum: &Optimum,
) -> PyResult<[Bound<'py, PyDict>; 4]> {
    let mut once = NamedArrays::new(py, &[]);
    once.table(&table.columns(), std::slice::from_ref(optimum))?;
    Ok([
        once.done(),
        list(py, &table.peak_columns(), &table.peaks(optimum))?,
        list(py, &table.tolerance_columns(), &optimum.tolerances)?,
        list(
            py,
            &table.sensitivity_columns(),
            &table.sensitivities(optimum),
        )?,
    ])
}

/// Returns the rows of a list, such as the peaks of an optimum, as columns.
fn list<'py, R>(
    py: Python<'py>,
    columns: &[Column<'_, R>],
    rows: &[R],
) -> PyResult<Bound<'py, PyDict>> {
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(columns, rows)?;
    Ok(arrays.done())
}
