//! Computes the motion under a load that is given at every sample.

use crate::asked::{Optional, numbers, one, parts};
use crate::errors::domain;
use crate::follow::{Course, RunStart, event_budget, follow};
use crate::system::NativeSystem;
use frictiongen::study::SystemInput;
use frictiongen::study::scene::Excitation;
use frictiongen::{Given, Of, OutOfDomain, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The Python arguments `force`, `base` and `base_velocity`. Each contains one number for each sample.
type Acting<'py> = (Optional<'py>, Optional<'py>, Optional<'py>);

/// The initial state, the ratio μ of static to kinetic friction, and the event budget (the largest number of stops,
/// break-aways and reversals that the stepper follows in one step).
type Beginning<'py> = (Optional<'py>, Optional<'py>, Optional<'py>);

/// A load over time, with one number for each sample.
struct LoadRecord {
    /// The excitation: forces in N, or displacements and velocities of the base.
    excitation: Excited,
    /// Forces on further masses, N, by the name of the mass.
    more: Vec<(String, Vec<f64>)>,
    friction: Vec<f64>,
}

enum Excited {
    Force(Vec<f64>),
    Base(Vec<f64>, Vec<f64>),
}

/// Reads a load or a friction over time from Python: one number for each sample, or one number for all samples.
fn course(argument: &str, given: &Bound<'_, PyAny>, samples: Option<usize>) -> PyResult<Vec<f64>> {
    let given = numbers(argument, given)?;
    if let Some(place) = given.values.iter().position(|value| !value.is_finite()) {
        let (name, value) = (given.place(argument, place), given.values.get(place));
        return Err(domain(format_args!(
            "{name} is {:?}: it must be finite",
            value.copied().unwrap_or(f64::NAN)
        )));
    }
    match (samples, given.is_one, given.values.first()) {
        (Some(samples), true, Some(value)) => Ok(vec![*value; samples]),
        (None, true, _) => Err(domain(format_args!(
            "{argument}: a row of numbers is needed, one for each sample"
        ))),
        (Some(samples), ..) if samples != given.values.len() => Err(domain(format_args!(
            "{argument}: {samples} numbers are needed, one for each sample, but these are {}",
            given.values.len()
        ))),
        _ => Ok(given.values),
    }
}

impl LoadRecord {
    fn of(
        system: &System,
        acting: &Acting<'_>,
        friction: &Bound<'_, PyAny>,
        on: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let excitation = match (acting, system.scene().excitation) {
            ((Some(force), None, None), Excitation::Force(_)) => {
                Excited::Force(course("force", force, None)?)
            }
            ((None, Some(base), Some(velocity)), Excitation::Base) => {
                let base = course("base", base, None)?;
                let velocity = course("base_velocity", velocity, Some(base.len()))?;
                Excited::Base(base, velocity)
            }
            (_, Excitation::Base) => {
                return Err(domain(
                    "the base moves: give base, its displacements in m, and base_velocity, in m/s",
                ));
            }
            _ => {
                return Err(domain(
                    "a force drives the scene: give force, in N, one for each sample",
                ));
            }
        };
        let samples = match &excitation {
            Excited::Force(force) => force.len(),
            Excited::Base(base, _) => base.len(),
        };
        let mut more = Vec::new();
        for (name, force) in on.into_iter().flatten() {
            let name = match name.extract::<String>() {
                Ok(name) => name,
                Err(_) => {
                    return Err(crate::errors::wrong_type(
                        "on: the names of masses are needed",
                    ));
                }
            };
            match system.motion_named(&name) {
                Ok(Of::Mass(_)) => {}
                Ok(_) => {
                    return Err(domain("on: a force acts on a mass"));
                }
                Err(error) => return Err(domain(format_args!("on: {error}"))),
            }
            let force = course(&format!("on[{name:?}]"), &force, Some(samples))?;
            more.push((name, force));
        }
        let friction = course("friction", friction, Some(samples))?;
        if let Some(value) = friction.iter().find(|value| **value < 0.0) {
            return Err(domain(format_args!(
                "friction is {value:?}: friction must be a finite number, 0 or above"
            )));
        }
        Ok(Self {
            excitation,
            more,
            friction,
        })
    }

    fn at(&self, index: usize) -> SystemInput<'_> {
        let of = |values: &[f64]| values.get(index).copied().unwrap_or(0.0);
        let input = match &self.excitation {
            Excited::Force(force) => SystemInput::force(of(force)),
            Excited::Base(base, velocity) => SystemInput::base(of(base), of(velocity)),
        };
        let more = self.more.iter();
        let input = more.fold(input, |input, (name, force)| input.on(name, of(force)));
        input.friction(of(&self.friction))
    }
}

/// Computes the motion under a load that is given at every sample.
#[pyfunction]
pub fn step<'py>(
    system: &Bound<'py, NativeSystem>,
    dt: Bound<'py, PyAny>,
    acting: Acting<'py>,
    friction: (Bound<'py, PyAny>, Option<Bound<'py, PyDict>>),
    of: Optional<'py>,
    beginning: Beginning<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let (friction, on) = friction;
    let (start, stiction, budget) = beginning;
    let of_system = &system.get().system;
    let dt = one("dt", &dt)?;
    if !(0.0 < dt && dt.is_finite()) {
        // Without this check, the message about a missing load would come first.
        let error = OutOfDomain::Step(Given::of(dt));
        return Err(domain(format_args!("dt = {dt:?}: {error}")));
    }
    let recording = LoadRecord::of(of_system, &acting, &friction, on.as_ref())?;
    let course = Course {
        dt,
        samples: recording.friction.len(),
        parts: parts(of_system, "of", of.as_ref())?,
        start: RunStart::of(start.as_ref())?,
        stiction: stiction.map(|mu| one("stiction", &mu)).transpose()?,
        budget: budget.map(|events| event_budget(&events)).transpose()?,
    };
    follow(system, course, &|index| recording.at(index))
}
