//! The motion under any load, sample by sample.

use crate::asked::{Optional, Part, check_size, numbers, one, parts};
use crate::columns::{Columns, Words, cell};
use crate::errors::domain;
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{StudyError, SystemInput, SystemStepper, words};
use frictiongen::{Of, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// How many steps are taken between two looks whether to go on.
const PORTION: usize = 4096;

/// `force`, `base` and `base_velocity`, one number for each sample.
type Acting<'py> = (Optional<'py>, Optional<'py>, Optional<'py>);

/// The load over time.
struct Recording {
    /// Of the excitation: forces, or displacements and velocities of the base.
    excitation: Excited,
    /// On further masses.
    more: Vec<(String, Vec<f64>)>,
    friction: Vec<f64>,
}

enum Excited {
    Force(Vec<f64>),
    Base(Vec<f64>, Vec<f64>),
}

/// One number for each sample, or one for all.
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
            "{argument}: {samples} numbers are needed, one for each sample, and these are {}",
            given.values.len()
        ))),
        _ => Ok(given.values),
    }
}

impl Recording {
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
                Ok(Of::Contact) => {
                    return Err(domain("on: a force acts on a mass, not on the contact"));
                }
                Err(error) => return Err(domain(format_args!("on: {error}"))),
            }
            let force = course(&format!("on[{name:?}]"), &force, Some(samples))?;
            more.push((name, force));
        }
        let friction = course("friction", friction, Some(samples))?;
        if let Some(value) = friction.iter().find(|value| **value < 0.0) {
            return Err(domain(format_args!(
                "friction is {value:?}: friction is a finite number, 0 or above"
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

/// What has come of the steps.
#[derive(Default)]
struct Followed {
    /// Displacements and velocities, one motion after the other.
    motions: Vec<[Vec<f64>; 2]>,
    force: Vec<f64>,
    state: Vec<Contact>,
    events: Vec<i64>,
    time: Vec<f64>,
}

impl Followed {
    fn note(&mut self, stepper: &SystemStepper<'_>, parts: &[Part], turned: bool, events: u32) {
        let signed = |value: f64| if turned { 0.0 - value } else { value };
        let contact = stepper.contact();
        for (part, [displacement, velocity]) in parts.iter().zip(&mut self.motions) {
            let (x, v) = match part.of {
                Of::Contact => (signed(contact.displacement()), signed(contact.velocity())),
                Of::Mass(index) => {
                    // By place: the method of this name takes names.
                    let mass = frictiongen::Stepping::mass(stepper, index);
                    (mass.displacement(), mass.velocity())
                }
            };
            displacement.push(cell(Some(x)));
            velocity.push(cell(Some(v)));
        }
        self.force.push(cell(Some(signed(contact.force()))));
        let state = contact.contact();
        self.state
            .push(if turned { state.reversed() } else { state });
        self.events.push(events.into());
        self.time.push(stepper.time());
    }
}

/// The motion under a load that is known sample by sample.
#[pyfunction]
pub fn step<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    dt: Bound<'py, PyAny>,
    acting: Acting<'py>,
    friction: Bound<'py, PyAny>,
    on: Option<Bound<'py, PyDict>>,
    of: Optional<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let system = &system.system;
    let dt = one("dt", &dt)?;
    let recording = Recording::of(system, &acting, &friction, on.as_ref())?;
    let parts = parts(system, "of", of.as_ref())?;
    let samples = recording.friction.len();
    check_size(samples, 4 + 2 * parts.len())?;
    let turned = system.contact_is_reversed();
    let (followed, work) = without_lock(py, |stop| {
        let mut stepper = system.stepper(dt)?;
        let mut followed = Followed {
            motions: vec![Default::default(); parts.len()],
            ..Followed::default()
        };
        for index in 0..samples {
            if index % PORTION == 0 && !stop.goes_on() {
                break;
            }
            let input = recording.at(index);
            let events = match index {
                0 => stepper.begin(input).map(|()| 0)?,
                _ => stepper.advance(input)?.events,
            };
            followed.note(&stepper, &parts, turned, events);
        }
        let work = stepper.work();
        Ok::<_, StudyError>((followed, work))
    })?
    .map_err(|error| domain(format_args!("dt = {dt:?}: {error}")))?;

    let mut columns = Columns::new(py, &[samples]);
    columns.numbers("time_s", followed.time)?;
    for (part, [displacement, velocity]) in parts.iter().zip(followed.motions) {
        columns.numbers(format!("{}.displacement_m", part.name), displacement)?;
        columns.numbers(format!("{}.velocity_m_s", part.name), velocity)?;
    }
    columns.numbers("contact.friction_N", followed.force)?;
    let states = followed
        .state
        .iter()
        .map(|contact| words::contact(*contact));
    columns.words("contact.state", states.collect::<Words>())?;
    columns.counts("events", followed.events)?;
    columns.other(
        "work",
        (work.load, work.friction, work.damping, work.stored),
    )?;
    Ok(columns.done())
}
