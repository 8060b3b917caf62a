//! Reads Python's arguments for frequency, in ratios r, in Hz or in rad/s.

use super::ACROSS;
use super::measure::Measure;
use super::numbers::{GivenNumbers, ends, numbers, one, points};
use crate::columns::NamedArrays;
use crate::errors::domain;
use frictiongen::System;
use frictiongen::study::columns::{self, FrequencyUnit as Unit, Setting};
use pyo3::prelude::*;

/// The Python arguments `r`, `hz` and `omega`, of which the caller gives one.
pub type FrequencyKeywords<'py> = (
    Option<Bound<'py, PyAny>>,
    Option<Bound<'py, PyAny>>,
    Option<Bound<'py, PyAny>>,
);

/// Returns the name of the Python argument for frequencies in this unit.
fn argument(unit: Unit) -> &'static str {
    match unit {
        Unit::Ratio | Unit::RatioUnderLoad => "r",
        Unit::Hertz => "hz",
        Unit::AngularFrequency => "omega",
    }
}

fn chosen<'a, 'py>(
    (r, hz, omega): &'a FrequencyKeywords<'py>,
) -> PyResult<(&'a Bound<'py, PyAny>, Unit)> {
    match (r, hz, omega) {
        (Some(r), None, None) => Ok((r, Unit::Ratio)),
        (None, Some(hz), None) => Ok((hz, Unit::Hertz)),
        (None, None, Some(omega)) => Ok((omega, Unit::AngularFrequency)),
        _ => Err(domain("the frequency: give one of r, hz and omega")),
    }
}

/// Returns true if the conversion of `given` to another unit, `computed`, neither overflowed nor underflowed to 0.
pub fn survives(given: f64, computed: f64) -> bool {
    computed.is_finite() == given.is_finite() && (computed == 0.0) == (given == 0.0)
}

/// Frequencies that the caller gave, in the caller's order.
#[derive(Clone)]
pub struct FrequencyValues {
    given: GivenNumbers,
    unit: Unit,
    /// The frequencies as frequency ratios r.
    pub r: Vec<f64>,
}

impl FrequencyValues {
    /// Reads the frequencies from Python. If `in_time` is true, every frequency must be above 0 and finite.
    pub fn of(system: &System, arguments: &FrequencyKeywords<'_>, in_time: bool) -> PyResult<Self> {
        let (given, unit) = chosen(arguments)?;
        let given = points(argument(unit), given, ACROSS)?;
        Self::checked(system, (given, unit), in_time)
    }

    /// Reads the frequencies of a curve of a scene with several contacts: points, or a range `(from, to)`.
    pub fn spread(system: &System, arguments: &FrequencyKeywords<'_>) -> PyResult<Self> {
        let (given, unit) = chosen(arguments)?;
        if ends(argument(unit), given)?.is_none() {
            return Self::of(system, arguments, true);
        }
        let (from, to) = FrequencyRange::given(arguments)?;
        let given = GivenNumbers {
            values: columns::spread(from, to),
            is_one: false,
        };
        Self::checked(system, (given, unit), true)
    }

    fn checked(
        system: &System,
        (given, unit): (GivenNumbers, Unit),
        in_time: bool,
    ) -> PyResult<Self> {
        let mut r = Vec::with_capacity(given.values.len());
        for (index, value) in given.values.iter().enumerate() {
            let place = || given.place(argument(unit), index);
            let usable = if in_time {
                0.0 < *value && value.is_finite()
            } else {
                0.0 <= *value
            };
            if !usable {
                let needed = if in_time {
                    "above 0 and finite"
                } else {
                    "a number, 0 or above"
                };
                return Err(domain(format_args!(
                    "{} is {value:?}: a frequency must be {needed}",
                    place()
                )));
            }
            let ratio = unit.given(system, *value).r;
            if !survives(*value, ratio) {
                return Err(domain(format_args!(
                    "{} is {value:?}: its frequency ratio is too small or too large to compute with",
                    place()
                )));
            }
            r.push(ratio);
        }
        Ok(Self { given, unit, r })
    }

    /// Returns the only frequency. Fails if the caller gave several frequencies.
    pub fn only(&self, system: &System) -> PyResult<columns::Frequency> {
        match (self.given.is_one, self.given.values.as_slice()) {
            (true, [given]) => Ok(self.unit.given(system, *given)),
            _ => Err(domain(format_args!(
                "{}: one number is needed here, not an array",
                argument(self.unit)
            ))),
        }
    }

    /// Returns all frequencies, in the caller's order.
    pub fn all(&self, system: &System) -> Vec<columns::Frequency> {
        let given = self.given.values.iter();
        given.map(|given| self.unit.given(system, *given)).collect()
    }

    /// Returns the unit in which the answer gives the frequencies.
    pub fn unit(&self, measure: &Measure) -> Unit {
        self.unit.under(measure)
    }

    /// Returns the shape of a Python array that has one element for each frequency.
    pub fn shape(&self) -> Vec<usize> {
        self.given.shape()
    }

    /// Adds the columns that state the frequencies. The columns have one row for each frequency.
    pub fn put(&self, columns: &mut NamedArrays<'_>, setting: &Setting<'_>) -> PyResult<()> {
        columns.table(&setting.frequency_columns(), &self.all(setting.system))
    }
}

/// A frequency range that the caller gave.
pub struct FrequencyRange {
    /// Lowest frequency ratio r of the range.
    pub from: f64,
    /// Highest frequency ratio r of the range.
    pub to: f64,
    unit: Unit,
}

impl FrequencyRange {
    /// Reads the bounds of a frequency range from Python. Without bounds, returns the default range around the
    /// resonances.
    pub fn of_or_usual(
        system: &System,
        arguments: &FrequencyKeywords<'_>,
        measure: &Measure,
    ) -> PyResult<Self> {
        if !matches!(arguments, (None, None, None)) {
            return Self::of(system, arguments);
        }
        let [from, to] = system.about_resonances();
        let unit = match measure.load() {
            Some(_) => Unit::Hertz,
            None => Unit::Ratio,
        };
        Ok(Self { from, to, unit })
    }

    /// Returns the unit in which the answer gives the frequencies of this range.
    pub fn unit(&self, measure: &Measure) -> Unit {
        self.unit.under(measure)
    }

    /// Reads the bounds of a frequency range from Python, in the given unit.
    fn given(arguments: &FrequencyKeywords<'_>) -> PyResult<(f64, f64)> {
        let (given, unit) = chosen(arguments)?;
        let argument = argument(unit);
        let Some((from, to)) = ends(argument, given)? else {
            // For a text, this call returns the error for texts. Otherwise the error for ranges follows.
            numbers(argument, given)?;
            return Err(domain(format_args!(
                "{argument}: a band is needed, a tuple (from, to); lists and arrays are points, for `limits`, `response` and `map`"
            )));
        };
        if !(0.0 < from && from < to && to.is_finite()) {
            return Err(domain(format_args!(
                "{argument} is ({from:?}, {to:?}): a band must begin above 0 and end above its start"
            )));
        }
        Ok((from, to))
    }

    /// Reads the bounds of a frequency range from Python.
    pub fn of(system: &System, arguments: &FrequencyKeywords<'_>) -> PyResult<Self> {
        let (from, to) = Self::given(arguments)?;
        let (_, unit) = chosen(arguments)?;
        let argument = argument(unit);
        let [first, last] = [from, to].map(|value| unit.given(system, value).r);
        if !(0.0 < first && first < last && last.is_finite()) {
            return Err(domain(format_args!(
                "{argument} is ({from:?}, {to:?}): its frequency ratios are too small or too large to compute with"
            )));
        }
        Ok(Self {
            from: first,
            to: last,
            unit,
        })
    }

    /// Reads a difference of two frequencies from Python, in the unit of the range. Returns the difference as a
    /// difference of frequency ratios r.
    pub fn step(&self, system: &System, given: &Bound<'_, PyAny>) -> PyResult<f64> {
        let given = one("step", given)?;
        let step = self.unit.given(system, given).r;
        if !(0.0 < step && step.is_finite()) {
            return Err(domain(format_args!(
                "step is {given:?}: it must be above 0 and finite"
            )));
        }
        // An answer must not have more points than this limit. The command has the same limit.
        if super::MOST_POINTS as f64 <= (self.to - self.from) / step {
            return Err(domain(format_args!(
                "step is {given:?}: it gives more than {} points",
                super::MOST_POINTS
            )));
        }
        Ok(step)
    }
}
