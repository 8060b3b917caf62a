//! Friction arguments: ratios β, or forces.

use super::UP;
use super::frequency::survives;
use super::measure::{self, Measure};
use super::numbers::{Given, ends, points};
use crate::columns::{Columns, cell};
use crate::errors::domain;
use frictiongen::study::LoadScale;
use frictiongen::study::columns::Friction;
use pyo3::prelude::*;

/// The arguments `beta` and `friction`.
pub type FrictionArguments<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// Frictions in the order given.
pub struct Frictions {
    given: Given,
    argument: &'static str,
    /// Friction ratios β.
    pub beta: Vec<f64>,
    /// Friction forces in N, if the load is known.
    force: Option<Vec<f64>>,
    scale: Option<LoadScale>,
}

impl Frictions {
    /// Reads the frictions under a load.
    pub fn of((beta, friction): &FrictionArguments<'_>, measure: &Measure) -> PyResult<Self> {
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
        let values = || given.values.iter();
        let convert = |scale: LoadScale, of: fn(&LoadScale, f64) -> f64| -> Vec<f64> {
            values().map(|value| of(&scale, *value)).collect()
        };
        let (beta, force): (Vec<f64>, Option<Vec<f64>>) = match scale {
            None => (given.values.clone(), None),
            Some(scale) if argument == "friction" => (
                convert(scale, LoadScale::friction_ratio),
                Some(given.values.clone()),
            ),
            Some(scale) => (
                given.values.clone(),
                Some(convert(scale, LoadScale::friction)),
            ),
        };
        let computed = if argument == "friction" {
            Some(&beta)
        } else {
            force.as_ref()
        };
        for (index, (value, computed)) in values().zip(computed.into_iter().flatten()).enumerate() {
            if !survives(*value, *computed) {
                let why = "with this load it is too small or too large to compute with";
                return Err(refused(index, *value, why));
            }
        }
        Ok(Self {
            given,
            argument,
            beta,
            force,
            scale,
        })
    }

    /// Reads frictions as one number or a list. A band is refused, because each friction costs a whole curve.
    pub fn listed(arguments: &FrictionArguments<'_>, measure: &Measure) -> PyResult<Self> {
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

    /// Returns the only friction ratio, with its force if the load is known and the ratio again if not.
    pub fn only(&self) -> PyResult<(f64, f64)> {
        match (self.given.is_one, self.beta.as_slice()) {
            (true, [beta]) => {
                let force = self.force.as_ref().and_then(|force| force.first());
                Ok((*beta, force.copied().unwrap_or(*beta)))
            }
            _ => Err(domain(format_args!(
                "{}: one number is needed here, not an array",
                self.argument
            ))),
        }
    }

    /// Returns the frictions in the order given.
    pub fn all(&self) -> Vec<Friction> {
        let given = self.given.values.iter();
        let friction = |given: &f64| match self.scale {
            Some(scale) if self.argument == "friction" => Friction::of_force(*given, scale),
            scale => Friction::of_ratio(*given, scale),
        };
        given.map(friction).collect()
    }

    /// Returns the shape of an answer over the frictions.
    pub fn shape(&self) -> Vec<usize> {
        self.given.shape()
    }

    /// Adds the columns of the frictions.
    pub fn put(&self, columns: &mut Columns<'_>) -> PyResult<()> {
        self.put_places(columns, &(0..self.beta.len()).collect::<Vec<_>>())
    }

    /// Adds the columns of the frictions at some indices.
    pub fn put_places(&self, columns: &mut Columns<'_>, places: &[usize]) -> PyResult<()> {
        let of = |values: &[f64]| {
            places
                .iter()
                .map(|place| cell(values.get(*place).copied()))
                .collect()
        };
        if let Some(force) = &self.force {
            columns.numbers("friction_N", of(force))?;
        }
        columns.numbers("beta", of(&self.beta))
    }
}
