//! Reads the load for the Python function `periodic`: samples over one period, or harmonics.

use super::numbers::{GivenNumbers, numbers, one, whole};
use crate::errors::{domain, wrong_type};
use frictiongen::System;
use frictiongen::measure::{Dimension, Unit};
use frictiongen::study::periodic::{BaseTable, Harmonic, PeriodicError, PeriodicLoad};
use frictiongen::study::scene::{Excitation, StepInput};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Largest order of a harmonic of a load.
const MOST_ORDER: u32 = 1000;

/// Reads the load over one period from Python. Returns a system for this load, and the load. If `hold` is true, the
/// system keeps each force constant until the next sample.
pub fn load(
    system: &System,
    given: &Bound<'_, PyAny>,
    period: &Bound<'_, PyAny>,
    hold: bool,
) -> PyResult<(System, PeriodicLoad)> {
    let period = one("period", period)?;
    if !(0.0 < period && period.is_finite()) {
        return Err(domain(format_args!(
            "period is {period:?}: it must be above 0 and finite"
        )));
    }
    let moves = system.scene().excitation == Excitation::Base;
    if let Ok(harmonics) = given.cast::<PyDict>() {
        if hold {
            return Err(domain(
                "hold: harmonics are continuous; give the samples of one period, or leave hold out",
            ));
        }
        let load = PeriodicLoad::harmonics(period, &self::harmonics(harmonics)?);
        return Ok((system.clone(), load.map_err(refused)?));
    }
    if hold && moves {
        return Err(domain(
            "hold: a motion of the base cannot be held between samples; leave hold out",
        ));
    }
    let (samples, unit) = samples(given)?;
    // Without a unit, a sample is a force in N, or a displacement of the base in m.
    let dimension = unit.as_ref().map(Unit::dimension);
    let quantity = match dimension {
        None if moves => Some(BaseTable::Displacement),
        None | Some(Dimension::Force) => None,
        Some(Dimension::Displacement) => Some(BaseTable::Displacement),
        Some(Dimension::Velocity) => Some(BaseTable::Velocity),
        Some(Dimension::Acceleration) => Some(BaseTable::Acceleration),
        Some(Dimension::Time) => return Err(domain("load: the unit of the load is a time")),
    };
    if quantity.is_some() != moves {
        return Err(refused(if moves {
            PeriodicError::BaseMoves
        } else {
            PeriodicError::BaseAtRest
        }));
    }
    let scale = unit.as_ref().map_or(1.0, Unit::scale);
    let samples: Vec<f64> = samples.iter().map(|value| value * scale).collect();
    // The samples include both ends of the period. The last sample repeats the load of the first sample.
    let step = period / samples.len().saturating_sub(1).max(1) as f64;
    let load = match quantity {
        None => PeriodicLoad::forces(step, &samples),
        Some(quantity) => PeriodicLoad::base(step, &samples, quantity),
    };
    let load = load.map_err(refused)?;
    if hold {
        return Ok((held(system)?, load));
    }
    Ok((system.clone(), load))
}

/// Returns the exception for a load that is not valid.
fn refused(error: PeriodicError) -> PyErr {
    domain(format_args!("load: {error}"))
}

/// Returns a copy of the system whose input keeps each force constant between two samples.
fn held(system: &System) -> PyResult<System> {
    let mut scene = system.scene().clone();
    scene.stepping.input = StepInput::Hold;
    System::try_from(scene).map_err(|error| domain(format_args!("hold: {error}")))
}

/// Reads the samples of a load from Python. If the argument is a tuple, it contains the samples and their unit.
fn samples(given: &Bound<'_, PyAny>) -> PyResult<(Vec<f64>, Option<Unit>)> {
    let mut unit = None;
    let mut samples = given.clone();
    if let Ok(pair) = given.cast::<PyTuple>()
        && pair.len() == 2
        && let Ok(text) = pair.get_item(1)?.extract::<String>()
    {
        let known = text.parse::<Unit>();
        unit = Some(known.map_err(|error| domain(format_args!("load: {error}")))?);
        samples = pair.get_item(0)?;
    }
    let given = numbers("load", &samples)?;
    if given.is_one {
        return Err(domain(
            "load: the samples of one period are needed, or harmonics {order: amplitude}",
        ));
    }
    finite("load", &given)?;
    Ok((given.values, unit))
}

/// Reads the harmonics of a load from Python. The value of each order is an amplitude, or an amplitude and a lag in
/// degrees.
fn harmonics(given: &Bound<'_, PyDict>) -> PyResult<Vec<Harmonic>> {
    let harmonic = |(order, given): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let order = whole("load: the order", &order, 0..=MOST_ORDER)?;
        let place = format!("load[{order}]");
        let given = numbers(&place, &given)?;
        finite(&place, &given)?;
        let (amplitude, degrees) = match *given.values.as_slice() {
            [amplitude] => (amplitude, 0.0),
            [amplitude, degrees] => (amplitude, degrees),
            _ => {
                return Err(wrong_type(format_args!(
                    "{place}: an amplitude is needed, or a tuple (amplitude, lag in degrees)"
                )));
            }
        };
        Ok(Harmonic {
            order,
            amplitude,
            lag: degrees.to_radians(),
        })
    };
    given.iter().map(harmonic).collect()
}

/// Fails if one of the numbers is not finite.
fn finite(argument: &str, given: &GivenNumbers) -> PyResult<()> {
    let mut values = given.values.iter().enumerate();
    match values.find(|(_, value)| !value.is_finite()) {
        Some((index, value)) => Err(domain(format_args!(
            "{} is {value:?}: it must be finite",
            given.place(argument, index)
        ))),
        None => Ok(()),
    }
}
