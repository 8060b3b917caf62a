//! Finds the friction that minimises the largest amplitude over a frequency range. For several quantities, finds the
//! friction that minimises the largest quotient of a quantity and its value.

use crate::asked::{
    FrequencyKeywords, FrequencyRange, LoadKeywords, Measure, MovingPart, measure, one, quantity,
    setting,
};
use crate::columns::NamedArrays;
use crate::errors::{defect, domain, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::study::columns::{Cell, Column, Further, OptimumLine, OptimumTable};
use frictiongen::study::optimum::{FrequencyBand, Optimum, OptimumRequest, Tuning, Weighted};
use frictiongen::study::response::MotionQuantity;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// Key of the list with several quantities in the library's lines about an optimum.
const WEIGHTED: &str = "weighted";

/// A quantity, and the value by which the search divides it. The value has the unit in which an optimum gives
/// amplitudes.
struct Valued {
    part: MovingPart,
    value: f64,
}

/// The answer: columns of the optimum, of its peaks, of its tolerances and of its sensitivities. The list has an entry
/// for each quantity if the caller gave several quantities.
type OptimumAnswer<'py> = ([Bound<'py, PyDict>; 4], Vec<QuotientAnswer<'py>>);

/// Answer about one quantity of several: the name, the unit, and the numbers by the keys of the library.
type QuotientAnswer<'py> = (String, &'static str, Bound<'py, PyDict>);

/// Finds the best friction for a quantity, or for several quantities that are each divided by a value.
#[pyfunction]
pub fn optimum<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    of: Bound<'py, PyAny>,
    frequency: FrequencyKeywords<'py>,
    load: LoadKeywords<'py>,
    vary: Option<(String, f64, f64)>,
) -> PyResult<OptimumAnswer<'py>> {
    let system = &system.system;
    let measure = measure::of(system, &load)?;
    let band = FrequencyRange::of(system, &frequency)?;
    if let Ok(quantities) = of.cast::<PyDict>() {
        if vary.is_some() {
            return Err(domain(
                "vary needs a single quantity: give its name as of, without a value",
            ));
        }
        let all = valued(system, &measure, quantities)?;
        return weighted(py, system, (&band, measure), &all);
    }
    let Ok(name) = of.cast::<PyString>() else {
        return Err(wrong_type(
            "of: the name of a mass is needed, or `contact`; for several quantities a dict {name: value}",
        ));
    };
    let part = quantity(system, "of", name.to_str()?)?;
    let request = request(&part, &band, &measure);
    let tuning = vary.map(|(name, from, to)| {
        let of = system.tunable_named(&name);
        let of = of.map_err(|error| domain(format_args!("vary: {error}")))?;
        Ok::<_, PyErr>(Tuning { of, from, to })
    });
    let (optimum, value) = match tuning.transpose()? {
        None => {
            let found = without_lock(py, |stop| {
                system.optimum_watched(&request, &|| stop.goes_on())
            })?;
            (found.map_err(domain)?, None)
        }
        Some(tuning) => {
            let found = without_lock(py, |stop| {
                system.tuned_optimum_watched(&request, &tuning, &|| stop.goes_on())
            })?;
            let found = found.map_err(|error| domain(format_args!("vary: {error}")))?;
            (found.optimum, Some(found.value))
        }
    };
    let parts = [part];
    let table = OptimumTable {
        setting: setting(system, measure, band.unit(&measure), &parts),
    };
    let answer = answer(py, &table, &optimum)?;
    let [once, ..] = &answer;
    once.set_item("value", value)?;
    Ok((answer, Vec::new()))
}

fn request(part: &MovingPart, band: &FrequencyRange, measure: &Measure) -> OptimumRequest {
    OptimumRequest {
        of: part.of,
        size: part.size,
        band: FrequencyBand::Ratio(band.from, band.to),
        load: measure.load(),
    }
}

/// Reads quantities from Python, each with the value by which the search divides it, in SI units.
fn valued(system: &System, measure: &Measure, given: &Bound<'_, PyDict>) -> PyResult<Vec<Valued>> {
    if given.is_empty() {
        return Err(domain(
            "of: the dict is empty; give at least one quantity with the value that divides it",
        ));
    }
    // The result of an optimum has non-dimensional groups that refer to the load at r = 1, so the values are converted
    // with this load.
    let reference = system.angular_frequency(1.0);
    let read = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract().map_err(|_| {
            wrong_type("of: the names of quantities are needed, as in {\"accel(roof)\": 5.0}")
        })?;
        let part = quantity(system, "of", &name)?;
        if part.size == MotionQuantity::Damping {
            return Err(domain(format_args!(
                "of: `{name}`: an equivalent damping ratio has no upper bound; leave it out"
            )));
        }
        let place = format!("of[{name:?}]");
        let value = one(&place, &value)?;
        let over = value / measure.convert(part.dimension(), 1.0, reference);
        if !(0.0 < value && value.is_finite()) {
            return Err(domain(format_args!(
                "{place} is {value:?}: the value that divides a quantity must be above 0 and finite"
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

/// Finds the friction that minimises the largest quotient of a quantity and its value.
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
    let values = all.iter().zip(&found.largest);
    let values: Vec<(MovingPart, f64, f64)> = values
        .map(|(valued, largest)| (valued.part.clone(), valued.value, *largest))
        .collect();
    let lines = table.lines_with(&found.optimum, None, Further::Weighted(&values));
    let answer = answer(py, &table, &found.optimum)?;
    let ([once, ..], [decisive]) = (&answer, &parts);
    once.set_item("decisive", &decisive.name)?;
    once.set_item("quotient", found.ratio)?;
    Ok((answer, quotients(py, &values, &lines)?))
}

/// Returns the answer about each quantity of several: the name, the unit and the numbers.
fn quotients<'py>(
    py: Python<'py>,
    values: &[(MovingPart, f64, f64)],
    lines: &[OptimumLine],
) -> PyResult<Vec<QuotientAnswer<'py>>> {
    let each = (1..).zip(values).map(|(row, (part, ..))| {
        let (numbers, mut unit) = (PyDict::new(py), "");
        let of_row = |line: &&OptimumLine| line.list == Some(WEIGHTED) && line.row == Some(row);
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
