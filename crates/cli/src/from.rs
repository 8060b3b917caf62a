//! The option `--from`: the initial state of a motion.

use crate::args::FromArguments;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::measure::Measure;
use frictiongen::System;
use frictiongen::study::{InitialState, units::LoadScale};

/// The text of an initial state in which every mass is at 0 without velocity.
pub const REST: &str = "rest";

/// Displacements and velocities of all masses, as non-dimensional groups.
pub type StateGroups = (Vec<f64>, Vec<f64>);

/// Returns the text of the initial state, if the user gives one. Fails if a frequency is then 0 or infinite, because a
/// motion has no cycle at these frequencies.
pub fn given<'a>(
    arguments: &'a FromArguments,
    frequencies: &Frequencies,
) -> Result<Option<&'a str>, Failure> {
    let from = arguments.from.as_deref();
    let has_cycles = |given: &f64| 0.0 < *given && given.is_finite();
    if from.is_none() || frequencies.given().iter().all(has_cycles) {
        return Ok(from);
    }
    Err(Failure::new(format_args!(
        "--from: a motion needs a frequency above 0 and below infinity; leave 0 and inf out of {}",
        frequencies.quantity.option()
    )))
}

/// Returns the system with the initial state of its steady states, if the user gives one.
pub fn started(text: Option<&str>, system: System, measure: &Measure) -> Result<System, Failure> {
    let state = match text.map(str::trim) {
        None => return Ok(system),
        Some(REST) => InitialState::rest(system.scene().masses.len()),
        Some(text) => {
            let groups = state(
                text,
                &system,
                measure.scale(),
                system.angular_frequency(1.0),
            )?;
            match measure.scale() {
                Some(_) => InitialState::at_ratio(groups, 1.0, measure.fall()),
                None => InitialState::groups(groups),
            }
        }
    };
    Ok(system.starting_from(state))
}

/// Parses an initial state, and returns non-dimensional groups. If a load is given, the text is in m and m/s. `omega`
/// is the angular frequency ω of the excitation in rad/s.
pub fn state(
    text: &str,
    system: &System,
    scale: Option<LoadScale>,
    omega: f64,
) -> Result<StateGroups, Failure> {
    let refuse = |why: &str| Failure::new(format_args!("--from `{text}`: {why}"));
    let halves: Vec<&str> = text.split(';').collect();
    let [displacements, velocities] = *halves else {
        return Err(refuse(
            "write rest, or x1,...;v1,...: the displacements of all masses, a semicolon, their velocities",
        ));
    };
    let masses = system.scene().masses.len();
    let numbers = |list: &str, what: &str, ratio: &dyn Fn(f64) -> f64| {
        let values: Vec<&str> = list.split(',').map(str::trim).collect();
        if values.len() != masses {
            return Err(refuse(&format!(
                "the number of {what} is {}, but the number of masses is {masses}",
                values.len()
            )));
        }
        let one = |value: &&str| {
            let number: Option<f64> = value.parse().ok();
            let number = number.filter(|number| number.is_finite());
            let number = number.ok_or_else(|| match value.is_empty() {
                true => refuse("a number is missing"),
                false => refuse(&format!("`{value}` is not a finite number")),
            })?;
            let group = ratio(number);
            match group.is_finite() {
                true => Ok(group),
                false => Err(refuse(&format!("with this load `{value}` is too large"))),
            }
        };
        values
            .iter()
            .map(one)
            .collect::<Result<Vec<f64>, Failure>>()
    };
    let displacement = |x| scale.map_or(x, |scale| scale.displacement_ratio(x));
    let velocity = |v| scale.map_or(v, |scale| scale.velocity_ratio(v, omega));
    Ok((
        numbers(displacements, "displacements", &displacement)?,
        numbers(velocities, "velocities", &velocity)?,
    ))
}
