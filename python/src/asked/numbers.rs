//! Numbers from Python: one, or several in a row.

use crate::errors::{domain, wrong_type};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBool;
use std::ops::RangeInclusive;

/// Numbers, and whether it was one alone.
pub struct Given {
    /// The numbers.
    pub values: Vec<f64>,
    /// Whether one alone was given rather than a row of them.
    pub is_one: bool,
}

impl Given {
    /// The shape of what answers to it.
    pub fn shape(&self) -> Vec<usize> {
        if self.is_one {
            Vec::new()
        } else {
            vec![self.values.len()]
        }
    }

    /// What a number is called in a message.
    pub fn place(&self, argument: &str, index: usize) -> String {
        if self.is_one {
            argument.to_owned()
        } else {
            format!("{argument}[{index}]")
        }
    }
}

/// The type of an object, for a message.
fn type_name(object: &Bound<'_, PyAny>) -> String {
    let name = object.get_type().name();
    name.map_or_else(|_| "object".to_owned(), |name| name.to_string())
}

/// A number, or a row of numbers: whatever numpy reads as such, but no texts, no truth values and nothing complex.
pub fn numbers(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<Given> {
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
            "{argument}: an array with a mask; leave out what is masked, with .compressed()"
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
            "{argument}: one number or a row of numbers is needed, and this has the shape ({})",
            shape.join(", ")
        )));
    }
    let flat = numpy.call_method1("ravel", (array,))?;
    let flat = numpy.call_method1("ascontiguousarray", (flat, "float64"))?;
    let flat: PyReadonlyArray1<'_, f64> = flat.extract()?;
    Ok(Given {
        values: flat.as_slice()?.to_vec(),
        is_one: shape.is_empty(),
    })
}

/// One number.
pub fn one(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<f64> {
    let given = numbers(argument, given)?;
    match (given.is_one, given.values.as_slice()) {
        (true, [value]) => Ok(*value),
        (_, values) => Err(domain(format_args!(
            "{argument}: one number is needed, and these are {}",
            values.len()
        ))),
    }
}

/// One whole number.
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
