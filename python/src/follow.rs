//! Follows a load step by step, from rest, from a state, or from the end of an earlier run.

use crate::asked::{Part, check_size, numbers};
use crate::columns::{Columns, Words, cell};
use crate::errors::{domain, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::{SystemInput, SystemStepSaved, SystemStepper, words};
use frictiongen::{Of, Stepping, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Number of steps between two checks for an interrupt.
const PORTION: usize = 4096;

/// The end of a run, with everything from which another run continues.
#[pyclass(frozen, module = "frictiongen._native", name = "StepState")]
pub struct NativeStepState {
    saved: SystemStepSaved,
    dt: f64,
    system: Py<NativeSystem>,
}

/// The start of a run.
pub enum Start {
    /// Rest.
    Rest,
    /// Displacements and velocities of all masses.
    Moving(Vec<f64>, Vec<f64>),
    /// The end of another run.
    After(Py<NativeStepState>),
}

impl Start {
    /// Reads the start: none, a state, or two rows of numbers.
    pub fn of(given: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let Some(given) = given else {
            return Ok(Self::Rest);
        };
        if let Ok(state) = given.cast::<NativeStepState>() {
            return Ok(Self::After(state.clone().unbind()));
        }
        let (displacements, velocities): (Bound<'_, PyAny>, Bound<'_, PyAny>) =
            given.extract().map_err(|_| {
                wrong_type("start: an answer of steps is needed, or displacements and velocities")
            })?;
        Ok(Self::Moving(
            numbers("start", &displacements)?.values,
            numbers("start", &velocities)?.values,
        ))
    }
}

/// Options of a run.
pub struct Course {
    /// Time between two samples, s.
    pub dt: f64,
    /// Number of samples.
    pub samples: usize,
    /// Parts whose motion is returned.
    pub parts: Vec<Part>,
    /// Start of the run.
    pub start: Start,
    /// Ratio μ from the start on, if it differs from the description's.
    pub stiction: Option<f64>,
}

/// Result of the steps.
#[derive(Default)]
struct Followed {
    /// Displacements and velocities, one pair for each part.
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
                    let mass = stepper.mass_at(index);
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

/// Returns a stepper at the start of the run. The flag tells whether the first sample is the end of a step instead of
/// the start.
fn ready<'s>(
    py: Python<'_>,
    system: &'s Bound<'_, NativeSystem>,
    course: &Course,
) -> PyResult<(SystemStepper<'s>, bool)> {
    let dt = course.dt;
    let of_dt = |error| domain(format_args!("dt = {dt:?}: {error}"));
    let of_system: &System = &system.get().system;
    let (mut stepper, goes_on) = match &course.start {
        Start::Rest => (of_system.stepper(dt).map_err(of_dt)?, false),
        Start::Moving(displacements, velocities) => {
            let masses = of_system.scene().masses.len();
            for row in [displacements, velocities] {
                if row.len() != masses || row.iter().any(|value| !value.is_finite()) {
                    return Err(domain(format_args!(
                        "start: {masses} finite numbers are needed, one for each mass, but these are {row:?}"
                    )));
                }
            }
            let state = (displacements.as_slice(), velocities.as_slice());
            (of_system.stepper_from(dt, state).map_err(of_dt)?, false)
        }
        Start::After(state) => {
            let state = state.get();
            if !state.system.bind(py).is(system) {
                return Err(domain("start: these steps are of another system"));
            }
            if state.dt != dt {
                return Err(domain(format_args!(
                    "dt = {dt:?}: the steps to continue are {:?} s long",
                    state.dt
                )));
            }
            let mut stepper = of_system.stepper(dt).map_err(of_dt)?;
            stepper.restore(&state.saved).map_err(domain)?;
            (stepper, true)
        }
    };
    if let Some(mu) = course.stiction {
        stepper.set_stiction(mu).map_err(|_| {
            domain(format_args!(
                "stiction is {mu:?}: static over kinetic friction must be 1 or above, and finite"
            ))
        })?;
    }
    Ok((stepper, goes_on))
}

/// Returns the motion at every sample, the work, and the end of the run.
pub fn follow<'py, 'r>(
    system: &Bound<'py, NativeSystem>,
    course: Course,
    input: &(dyn Fn(usize) -> SystemInput<'r> + Sync),
) -> PyResult<Bound<'py, PyDict>> {
    let py = system.py();
    let (samples, parts) = (course.samples, &course.parts);
    check_size(samples, 4 + 2 * parts.len())?;
    let turned = system.get().system.contact_is_reversed();
    let (mut stepper, goes_on) = ready(py, system, &course)?;
    let (followed, stepper) = without_lock(py, |stop| {
        let mut followed = Followed {
            motions: vec![Default::default(); parts.len()],
            ..Followed::default()
        };
        for index in 0..samples {
            if index % PORTION == 0 && !stop.goes_on() {
                break;
            }
            let stepped = if index == 0 && !goes_on {
                stepper.begin(input(index)).map(|()| 0)
            } else {
                stepper.advance(input(index)).map(|stepped| stepped.events)
            };
            let events =
                stepped.map_err(|error| domain(format_args!("sample {index}: {error}")))?;
            followed.note(&stepper, parts, turned, events);
        }
        Ok::<_, PyErr>((followed, stepper))
    })??;

    let mut columns = Columns::new(py, &[samples]);
    columns.numbers("time_s", followed.time)?;
    for (part, [displacement, velocity]) in parts.iter().zip(followed.motions) {
        columns.numbers(format!("{}.displacement_m", part.name), displacement)?;
        columns.numbers(format!("{}.velocity_m_s", part.name), velocity)?;
    }
    columns.numbers("contact.friction_N", followed.force)?;
    let states = followed.state.iter();
    let states = states.map(|contact| words::contact(*contact));
    columns.words("contact.state", states.collect::<Words>())?;
    columns.counts("events", followed.events)?;
    let work = Stepping::work(&stepper);
    columns.other(
        "work",
        (work.load, work.friction, work.damping, work.stored),
    )?;
    columns.other("exceeded", stepper.exceeded())?;
    let end = NativeStepState {
        saved: stepper.save(),
        dt: course.dt,
        system: system.clone().unbind(),
    };
    columns.other("end", end)?;
    Ok(columns.done())
}
