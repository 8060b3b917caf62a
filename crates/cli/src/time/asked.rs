//! Parses the options of a motion over time: its length and its initial state.

use super::course::RunSettings;
use crate::args::TimeArguments;
use crate::asked::whole;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::study::history::MOST_SAMPLES;
use frictiongen::study::units::LoadScale;

/// Upper bound on each of three numbers: cycles, skipped cycles, and samples in a cycle.
const MOST: u32 = MOST_SAMPLES as u32;

/// Length of the motion over time that the user requests, and the form of its output.
#[derive(Clone, Copy, Debug)]
pub struct TimeRequest {
    /// Number of cycles of the excitation in the output.
    pub cycles: u32,
    /// Number of cycles of the excitation before the first cycle of the output.
    pub skip: u32,
    /// Number of samples in a cycle of the excitation.
    pub samples: u32,
    /// True if the output is one period of the steady state. If false, the output is a run from the initial state.
    pub steady: bool,
    /// True if the output is the spectrum. If false, the output is samples or events.
    pub spectrum: bool,
}

impl TimeRequest {
    /// Request for one period of the steady state, with as many samples as a picture needs.
    #[cfg(feature = "pictures")]
    pub const PERIOD: Self = Self {
        cycles: 1,
        skip: 0,
        samples: 200,
        steady: true,
        spectrum: false,
    };

    /// Reads the options of `frictiongen time`.
    pub fn parse(arguments: &TimeArguments) -> Result<Self, Failure> {
        let number = |option, text: &Option<String>, least, default| match text {
            Some(text) => whole(option, text, least..=MOST),
            None => Ok(default),
        };
        let asked = Self {
            cycles: number("--cycles", &arguments.cycles, 1, 10)?,
            skip: number("--skip", &arguments.skip, 0, 0)?,
            samples: number(
                "--samples",
                &arguments.samples,
                2,
                if arguments.until.is_some() { 1000 } else { 200 },
            )?,
            steady: arguments.steady,
            spectrum: arguments.spectrum,
        };
        if asked.samples.is_multiple_of(2) {
            Ok(asked)
        } else {
            Err(Failure::new(format_args!(
                "--samples `{}`: an even number is needed",
                asked.samples
            )))
        }
    }
}

/// An initial state: displacements and velocities of all masses, as non-dimensional groups.
pub type InitialState = (Vec<f64>, Vec<f64>);

/// Parses the initial state in the option `--from`. Under a load, the state is in m and m/s.
pub fn start(
    text: &str,
    system: &System,
    course: &RunSettings<'_>,
) -> Result<InitialState, Failure> {
    state(text, system, course.measure.scale(), course.frequency.omega)
}

/// Parses an initial state, and returns non-dimensional groups. If a load is given, the text is in m and m/s. `omega`
/// is the angular frequency ω of the excitation in rad/s.
pub fn state(
    text: &str,
    system: &System,
    scale: Option<LoadScale>,
    omega: f64,
) -> Result<InitialState, Failure> {
    let refuse = |why: &str| Failure::new(format_args!("--from `{text}`: {why}"));
    let halves: Vec<&str> = text.split(';').collect();
    let [displacements, velocities] = *halves else {
        return Err(refuse(
            "write x1,...;v1,...: the displacements of all masses, a semicolon, their velocities",
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
