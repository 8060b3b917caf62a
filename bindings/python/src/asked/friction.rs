//! Reads Python's arguments for friction, in ratios β or in newtons.

use super::UP;
use super::frequency::survives;
use super::measure::{self, Measure};
use super::numbers::{GivenNumbers, ends, points};
use crate::columns::NamedArrays;
use crate::errors::domain;
use frictiongen::study::columns::{ColumnAxis, FrictionSetting, Setting};
use pyo3::prelude::*;

/// The Python arguments `beta` and `friction`, of which the caller gives one.
pub type FrictionKeywords<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// Frictions that the caller gave, in the caller's order.
#[derive(Clone)]
pub struct FrictionValues {
    given: GivenNumbers,
    argument: &'static str,
    /// The frictions as friction ratios β.
    pub beta: Vec<f64>,
    all: Vec<FrictionSetting>,
}

impl FrictionValues {
    /// Reads the frictions from Python. The load in `measure` converts friction forces in N to friction ratios β.
    pub fn of((beta, friction): &FrictionKeywords<'_>, measure: &Measure) -> PyResult<Self> {
        let (argument, given) = match (beta, friction) {
            (Some(beta), None) => ("beta", points("beta", beta, UP)?),
            (None, Some(friction)) => ("friction", points("friction", friction, UP)?),
            _ => return Err(domain("the friction: give one of beta and friction")),
        };
        let refused = |index: usize, value: f64, why: &str| {
            let place = given.place(argument, index);
            domain(format_args!("{place} is {value:?}: {why}"))
        };
        for (index, value) in given.values.iter().enumerate() {
            if !(0.0 <= *value && value.is_finite()) {
                return Err(refused(
                    index,
                    *value,
                    "friction must be a finite number, 0 or above",
                ));
            }
        }
        let scale = measure.scale();
        if scale.is_none() && argument == "friction" {
            return Err(domain(format_args!(
                "friction is a force and needs the amplitude of the load: give {}",
                measure::argument(measure)
            )));
        }
        if measure.fall() != 0 && argument == "beta" {
            return Err(domain(
                "beta: the amplitude of this load depends on frequency, so that one friction ratio is another force at each frequency; give friction in N",
            ));
        }
        let friction = |given: &f64| match scale {
            Some(scale) if argument == "friction" => FrictionSetting::of_force(*given, scale),
            scale => FrictionSetting::of_ratio(*given, scale),
        };
        let all: Vec<FrictionSetting> = given.values.iter().map(friction).collect();
        for (index, (value, friction)) in given.values.iter().zip(&all).enumerate() {
            if !(survives(*value, friction.beta) && survives(*value, friction.force())) {
                let why = "with this load it is too small or too large to compute with";
                return Err(refused(index, *value, why));
            }
        }
        Ok(Self {
            given,
            argument,
            beta: all.iter().map(|friction| friction.beta).collect(),
            all,
        })
    }

    /// Reads one friction or a list of frictions from Python. Fails for a range `(from, to)`, because each friction
    /// takes the work of a whole curve.
    pub fn listed(arguments: &FrictionKeywords<'_>, measure: &Measure) -> PyResult<Self> {
        let (beta, friction) = arguments;
        for (argument, given) in [("beta", beta), ("friction", friction)] {
            if let Some(given) = given
                && ends(argument, given)?.is_some()
            {
                return Err(domain(format_args!(
                    "{argument}: a tuple is a band (from, to); here a number or a list of frictions is needed"
                )));
            }
        }
        Self::of(arguments, measure)
    }

    /// Returns the only friction. Fails if the caller gave several frictions.
    pub fn only(&self) -> PyResult<FrictionSetting> {
        match (self.given.is_one, self.all.as_slice()) {
            (true, [friction]) => Ok(*friction),
            _ => Err(domain(format_args!(
                "{}: one number is needed here, not an array",
                self.argument
            ))),
        }
    }

    /// Returns all frictions, in the caller's order.
    pub fn all(&self) -> Vec<FrictionSetting> {
        self.all.clone()
    }

    /// Returns the shape of a Python array that has one element for each friction.
    pub fn shape(&self) -> Vec<usize> {
        self.given.shape()
    }

    /// Adds the columns that depend on the friction alone. The columns have one row for each friction.
    pub fn put(&self, arrays: &mut NamedArrays<'_>, setting: &Setting<'_>) -> PyResult<()> {
        arrays.along(ColumnAxis::Friction, &setting.friction_columns(), &self.all)
    }
}
