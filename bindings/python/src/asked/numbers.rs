//! Reads numbers from Python: one number, or a one-dimensional row of numbers.

use crate::errors::{domain, wrong_type};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyTuple};
use std::ops::RangeInclusive;

/// Numbers that the caller gave as one Python argument.
#[derive(Clone)]
pub struct GivenNumbers {
    /// The given values, in their order.
    pub values: Vec<f64>,
    /// True if the caller gave a single number instead of a row.
    pub is_one: bool,
}

impl GivenNumbers {
    /// Returns the shape of a Python array with one element for each of these numbers.
    pub fn shape(&self) -> Vec<usize> {
        if self.is_one {
            Vec::new()
        } else {
            vec![self.values.len()]
        }
    }

    /// Returns the name, for an error message, of the number at this index of an argument.
    pub fn place(&self, argument: &str, index: usize) -> String {
        if self.is_one {
            argument.to_owned()
        } else {
            format!("{argument}[{index}]")
        }
    }
}

/// Returns the name of an object's Python type, for a message.
fn type_name(object: &Bound<'_, PyAny>) -> String {
    let name = object.get_type().name();
    name.map_or_else(|_| "object".to_owned(), |name| name.to_string())
}

/// Reads a number or a row of numbers from Python. Accepts every object that numpy converts to numbers, except texts,
/// truth values and complex numbers.
pub fn numbers(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<GivenNumbers> {
    let py = given.py();
    let needed = || {
        wrong_type(format_args!(
            "{argument}: a number or an array of numbers is needed, not {}",
            type_name(given)
        ))
    };
    let numpy = py.import("numpy")?;
    let array = numpy
        .call_method1("asanyarray", (given,))
        .map_err(|_| needed())?;
    if array.is_instance(&numpy.getattr("ma")?.getattr("MaskedArray")?)? {
        return Err(wrong_type(format_args!(
            "{argument}: the array has a mask; remove the masked values with .compressed()"
        )));
    }
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "i" | "u" | "f") {
        return Err(needed());
    }
    let shape: Vec<usize> = array.getattr("shape")?.extract()?;
    if shape.len() > 1 {
        let shape: Vec<String> = shape.iter().map(usize::to_string).collect();
        return Err(domain(format_args!(
            "{argument}: one number or a row of numbers is needed, but this has the shape ({})",
            shape.join(", ")
        )));
    }
    let flat = numpy.call_method1("ravel", (array,))?;
    let flat = numpy.call_method1("ascontiguousarray", (flat, "float64"))?;
    let flat: PyReadonlyArray1<'_, f64> = flat.extract()?;
    Ok(GivenNumbers {
        values: flat.as_slice()?.to_vec(),
        is_one: shape.is_empty(),
    })
}

/// Reads the bounds of a range from a Python tuple. Returns `None` for a list or an array, because a list or an array
/// contains points.
pub fn ends(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<Option<(f64, f64)>> {
    if !given.is_instance_of::<PyTuple>() {
        return Ok(None);
    }
    match *numbers(argument, given)?.values.as_slice() {
        [from, to] => Ok(Some((from, to))),
        ref values => Err(domain(format_args!(
            "{argument}: a tuple is a band of two numbers (from, to), but this one has {}; for points, give a list or an array",
            values.len()
        ))),
    }
}

/// Reads one number, a row of points, or a range `(from, to)` from Python. A range becomes `count` evenly spaced
/// points.
pub fn points(argument: &str, given: &Bound<'_, PyAny>, count: u32) -> PyResult<GivenNumbers> {
    let Some((from, to)) = ends(argument, given)? else {
        return numbers(argument, given);
    };
    if !(0.0 <= from && from < to && to.is_finite()) {
        return Err(domain(format_args!(
            "{argument} is ({from:?}, {to:?}): a band must begin at 0 or above and end above its start; for points, give a list or an array"
        )));
    }
    let steps = count.max(2) - 1;
    let share = |index: u32| f64::from(index) / f64::from(steps);
    let inner = (0..steps).map(|index| from + (to - from) * share(index));
    Ok(GivenNumbers {
        values: inner.chain([to]).collect(),
        is_one: false,
    })
}

/// Reads one number from Python. Fails if the argument is a row of numbers.
pub fn one(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<f64> {
    let given = numbers(argument, given)?;
    match (given.is_one, given.values.as_slice()) {
        (true, [value]) => Ok(*value),
        (_, values) => Err(domain(format_args!(
            "{argument}: one number is needed, but these are {}",
            values.len()
        ))),
    }
}

/// Reads one whole number from a Python argument.
pub fn whole(
    argument: &str,
    given: &Bound<'_, PyAny>,
    range: RangeInclusive<u32>,
) -> PyResult<u32> {
    let (least, most) = range.clone().into_inner();
    if given.is_instance_of::<PyBool>() {
        return Err(wrong_type(format_args!(
            "{argument}: a whole number is needed, not bool"
        )));
    }
    let index = given.call_method0("__index__");
    let index = index.map_err(|_| {
        wrong_type(format_args!(
            "{argument}: a whole number is needed, not {}",
            type_name(given)
        ))
    })?;
    let value: Option<u32> = index.extract().ok();
    value.filter(|value| range.contains(value)).ok_or_else(|| {
        domain(format_args!(
            "{argument} is {index}: a whole number from {least} to {most} is needed"
        ))
    })
}
