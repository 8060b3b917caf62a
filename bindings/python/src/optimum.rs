//! Finds the friction that minimises the largest amplitude over a frequency range. Bounds on other quantities may
//! restrict this friction. For several quantities, the module finds the friction that minimises the largest quotient
//! of a quantity and its divisor.

use crate::asked::{
    DrivenKeywords, FrequencyKeywords, FrequencyRange, Measure, MovingPart, driven, one, quantity,
    setting,
};
use crate::columns::NamedArrays;
use crate::errors::{defect, domain, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::study::columns::{Cell, Column, Further, OptimumLine, OptimumTable};
use frictiongen::study::optimum::{
    FrequencyBand, KeptQuantity, Optimum, OptimumError, OptimumRequest, ShareRange, Tuning,
    Weighted,
};
use frictiongen::study::response::MotionQuantity;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// Names of two lists in the library's lines about an optimum: the quantities with divisors, and the quantities with
/// bounds.
const LISTS: [&str; 2] = ["weighted", "kept"];
/// Name of the list of the best shares.
const SHARES: &str = "shares";

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
    if let Ok(quantities) = of.cast::<PyDict>() {
        for (given, name) in [(vary.is_some(), "vary"), (keep.is_some(), "keep")] {
            if given {
                return Err(domain(format_args!(
                    "{name} needs a single quantity: give its name as of, without a value"
                )));
            }
        }
        let all = valued(system, &measure, (&OF, quantities))?;
        return weighted(py, system, (&band, measure), &all);
    }
    let Ok(name) = of.cast::<PyString>() else {
        return Err(wrong_type(
            "of: the name of a mass is needed, or `contact`; for several quantities a dict {name: value}",
        ));
    };
    let part = quantity(system, "of", name.to_str()?)?;
    let request = request(&part, &band, &measure);
    if let Some((name, from, to)) = &vary
        && let Some(contacts) = named_shares(system, name)?
    {
        if keep.is_some() {
            return Err(domain(
                "keep does not work with vary share; leave one of them out",
            ));
        }
        let ranges = contacts.into_iter().map(|contact| ShareRange {
            contact,
            from: *from,
            to: *to,
        });
        let table = OptimumTable {
            setting: setting(
                system,
                measure,
                band.unit(&measure),
                std::slice::from_ref(&part),
            ),
        };
        return shares(py, &table, &request, &ranges.collect::<Vec<_>>());
    }
    let tuning = vary.map(|(name, from, to)| {
        let of = system.tunable_named(&name);
        let of = of.map_err(|error| domain(format_args!("vary: {error}")))?;
        Ok::<_, PyErr>(Tuning { of, from, to })
    });
    let tuning = tuning.transpose()?;
    let bounds = match &keep {
        Some(keep) => valued(system, &measure, (&KEEP, keep))?,
        None => Vec::new(),
    };
    let found = without_lock(py, |stop| {
        best(system, &request, (tuning.as_ref(), &bounds), &|| {
            stop.goes_on()
        })
    })?;
    let found =
        found.map_err(|error| failure(system, &measure, (tuning.as_ref(), &bounds), error))?;
    let parts = [part];
    let table = OptimumTable {
        setting: setting(system, measure, band.unit(&measure), &parts),
    };
    let answer = answer(py, &table, &found.optimum)?;
    let [once, ..] = &answer;
    once.set_item("value", found.value)?;
    let values = largest_of(&bounds, &found.largest);
    let lines = table.lines_with(&found.optimum, None, Further::Kept(&values));
    Ok((answer, quantities(py, &values, &lines)?))
}

/// Returns the contacts whose shares `vary` names, if it names shares.
fn named_shares(system: &System, name: &str) -> PyResult<Option<Vec<usize>>> {
    let named = system.shares_named(name);
    named.map_err(|problem| domain(format_args!("vary: {problem}")))
}

/// Finds the best friction together with the best shares of contacts.
fn shares<'py>(
    py: Python<'py>,
    table: &OptimumTable<'_>,
    request: &OptimumRequest,
    ranges: &[ShareRange],
) -> PyResult<OptimumAnswer<'py>> {
    let system = table.setting.system;
    let found = without_lock(py, |stop| {
        system.best_shares(request, ranges, &|| stop.goes_on())
    })?;
    let found = found.map_err(|error| domain(format_args!("vary: {error}")))?;
    let answer = answer(py, table, &found.optimum)?;
    let ([once, ..], shares) = (&answer, PyDict::new(py));
    for line in table.share_lines(&found) {
        let Cell::Number(value) = line.value else {
            continue;
        };
        match line.list {
            Some(_) => shares.set_item(line.key, value)?,
            None => once.set_item(line.key, value)?,
        }
    }
    once.set_item(SHARES, shares)?;
    Ok((answer, Vec::new()))
}

/// The best friction, the best value of a further variable, and the largest value of each kept quantity.
struct Found {
    optimum: Optimum,
    value: Option<f64>,
    largest: Vec<f64>,
}

/// Finds the best friction, with the further variable and the bounds that are given.
fn best(
    system: &System,
    request: &OptimumRequest,
    (tuning, bounds): (Option<&Tuning>, &[Valued]),
    watch: &(dyn Fn() -> bool + Sync),
) -> Result<Found, OptimumError> {
    let kept: Vec<KeptQuantity> = bounds
        .iter()
        .map(|bound| KeptQuantity {
            of: bound.part.of,
            size: bound.part.size,
            most: bound.value,
        })
        .collect();
    let (optimum, value, largest) = match (tuning, kept.is_empty()) {
        (None, true) => (system.optimum_watched(request, watch)?, None, Vec::new()),
        (None, false) => {
            let found = system.kept_optimum(request, &kept, watch)?;
            (found.optimum, None, found.largest)
        }
        (Some(tuning), true) => {
            let found = system.tuned_optimum_watched(request, tuning, watch)?;
            (found.optimum, Some(found.value), Vec::new())
        }
        (Some(tuning), false) => {
            let (found, largest) = system.kept_tuned_optimum(request, tuning, &kept, watch)?;
            (found.optimum, Some(found.value), largest)
        }
    };
    Ok(Found {
        optimum,
        value,
        largest,
    })
}

/// Returns the exception for a search without a result. If no friction satisfies a bound, the message names the bound
/// and the smallest possible value, in the unit of the argument.
fn failure(
    system: &System,
    measure: &Measure,
    (tuning, bounds): (Option<&Tuning>, &[Valued]),
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
    match tuning {
        Some(_) if is_of_vary || bounds.is_empty() => domain(format_args!("vary: {error}")),
        _ => domain(error),
    }
}

/// Returns each quantity with its divisor or bound and its largest value over the frequency range.
fn largest_of(all: &[Valued], largest: &[f64]) -> Vec<(MovingPart, f64, f64)> {
    let values = all.iter().zip(largest);
    values
        .map(|(valued, largest)| (valued.part.clone(), valued.value, *largest))
        .collect()
}

fn request(part: &MovingPart, band: &FrequencyRange, measure: &Measure) -> OptimumRequest {
    OptimumRequest {
        of: part.of,
        size: part.size,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
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

/// Finds the friction that minimises the largest quotient of a quantity and its divisor.
fn weighted<'py>(
    py: Python<'py>,
    system: &System,
    (band, measure): (&FrequencyRange, Measure),
    all: &[Valued],
) -> PyResult<OptimumAnswer<'py>> {
    let missing = || defect("a quantity is missing: please report this with the description");
    let first = all.first().ok_or_else(missing)?;
    let request = request(&first.part, band, &measure);
    let of: Vec<Weighted> = all
        .iter()
        .map(|valued| Weighted {
            of: valued.part.of,
            size: valued.part.size,
            over: valued.value,
        })
        .collect();
    let found = without_lock(py, |stop| {
        system.weighted_optimum(&request, &of, &|| stop.goes_on())
    })?
    .map_err(domain)?;
    let parts = [all.get(found.decisive).ok_or_else(missing)?.part.clone()];
    let table = OptimumTable {
        setting: setting(system, measure, band.unit(&measure), &parts),
    };
    let values = largest_of(all, &found.largest);
    let lines = table.lines_with(&found.optimum, None, Further::Weighted(&values));
    let answer = answer(py, &table, &found.optimum)?;
    let ([once, ..], [decisive]) = (&answer, &parts);
    once.set_item("decisive", &decisive.name)?;
    once.set_item("quotient", found.ratio)?;
    Ok((answer, quantities(py, &values, &lines)?))
}

/// Returns the answer about each of several quantities, or about each kept quantity: its name, its unit and its numbers.
fn quantities<'py>(
    py: Python<'py>,
    values: &[(MovingPart, f64, f64)],
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
