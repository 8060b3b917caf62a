//! Computes the motion under any load over time: from rest, from a given state, or from the end of an earlier run.

use crate::asked::{MovingPart, check_size, numbers, whole};
use crate::columns::NamedArrays;
use crate::errors::{domain, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::answer::Contact;
use frictiongen::measure::columns::{DrivenSample, DrivenTable};
use frictiongen::study::{
    SystemInput,
    joined::JoinedContactNow,
    stepper::{SystemStepSaved, SystemStepper},
};
use frictiongen::{Of, Stepping, System};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Number of steps after which the program checks if the user has pressed Ctrl-C.
const PORTION: usize = 4096;

/// The end of a run of the stepper. It contains all data from which another run can continue.
#[pyclass(frozen, module = "frictiongen._native", name = "StepState")]
pub struct NativeStepState {
    saved: SystemStepSaved,
    dt: f64,
    system: Py<NativeSystem>,
}

/// State from which a run starts.
pub enum RunStart {
    /// Every mass starts at rest.
    Rest,
    /// The run starts with these displacements and velocities of all masses.
    Moving(Vec<f64>, Vec<f64>),
    /// The run starts at the end of another run.
    After(Py<NativeStepState>),
}

impl RunStart {
    /// Reads the initial state from Python: the end of another run, or displacements and velocities of all masses.
    /// Without the argument, every mass starts at rest.
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

/// Options of a run of the stepper over time.
pub struct Course {
    /// Time between two samples of the run, in s.
    pub dt: f64,
    /// Number of samples of the run.
    pub samples: usize,
    /// The contact and masses whose motion the run returns.
    pub parts: Vec<MovingPart>,
    /// State from which the run starts: rest, a given state, or the end of another run.
    pub start: RunStart,
    /// Ratio μ of static to kinetic friction. `None` means the ratio in the scene description.
    pub stiction: Option<f64>,
    /// Largest number of events (stops, break-aways and reversals) that the stepper follows in one step. The value 0
    /// means no limit. `None` means the limit of the run that this run continues, or no limit for a new run.
    pub budget: Option<u8>,
}

/// Reads an event budget, which is the largest number of stops, break-aways and reversals that the stepper follows in
/// one step.
pub fn event_budget(given: &Bound<'_, PyAny>) -> PyResult<u8> {
    let events = whole("budget", given, 0..=u8::MAX.into())?;
    // The conversion cannot fail, because `whole` has checked the range.
    Ok(u8::try_from(events).unwrap_or(u8::MAX))
}

/// Returns a stepper in the initial state of a run, and a flag. The flag is true if the run continues an earlier run.
/// In this case the first sample is at the end of the first step. Otherwise the first sample is at the start of the
/// first step.
fn ready<'s>(
    py: Python<'_>,
    system: &'s Bound<'_, NativeSystem>,
    course: &Course,
) -> PyResult<(SystemStepper<'s>, bool)> {
    let dt = course.dt;
    let of_dt = |error| domain(format_args!("dt = {dt:?}: {error}"));
    let of_system: &System = &system.get().system;
    let (mut stepper, goes_on) = match &course.start {
        RunStart::Rest => (of_system.stepper(dt).map_err(of_dt)?, false),
        RunStart::Moving(displacements, velocities) => {
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
        RunStart::After(state) => {
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
    if let Some(events) = course.budget {
        stepper.set_event_budget(events);
    }
    Ok((stepper, goes_on))
}

/// Returns the motion at the present instant of a stepper.
fn sample(table: &DrivenTable<'_>, stepper: &SystemStepper<'_>, events: usize) -> DrivenSample {
    let masses = stepper.all_masses().into_iter();
    let masses: Vec<_> = masses
        .map(|mass| [mass.displacement(), mass.velocity()])
        .collect();
    let (base, contact) = (stepper.base(), stepper.contact());
    let now = JoinedContactNow {
        displacement: contact.displacement(),
        velocity: contact.velocity(),
        force: contact.force(),
        slip: f64::NAN,
        energy: f64::NAN,
        is_sticking: contact.contact() == Contact::Stuck,
    };
    let sign = match table.system.contact_is_reversed() {
        true => -1.0,
        false => 1.0,
    };
    let base = [base.displacement(), base.velocity()];
    table.sample(
        (stepper.time(), events),
        (base, &masses),
        vec![now.signed(sign)],
    )
}

/// Runs the stepper. Returns the motion at every sample, the work of the forces, and the end of the run.
pub fn follow<'py, 'r>(
    system: &Bound<'py, NativeSystem>,
    course: Course,
    input: &(dyn Fn(usize) -> SystemInput<'r> + Sync),
) -> PyResult<Bound<'py, PyDict>> {
    let py = system.py();
    let (samples, parts) = (course.samples, &course.parts);
    check_size(samples, 4 + 2 * parts.len())?;
    let of_system = &system.get().system;
    let names = [of_system.name_of_motion(Of::Contact)];
    let table = DrivenTable {
        system: of_system,
        parts,
        names: &names,
        has_slips: false,
    };
    let (mut stepper, goes_on) = ready(py, system, &course)?;
    let (rows, stepper) = without_lock(py, |stop| {
        let mut rows = Vec::new();
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
            rows.push(sample(&table, &stepper, events as usize));
        }
        Ok::<_, PyErr>((rows, stepper))
    })??;

    let mut arrays = NamedArrays::new(py, &[samples]);
    arrays.table(&table.columns(), &rows)?;
    let work = Stepping::work(&stepper);
    arrays.other(
        "work",
        (work.load, work.friction, work.damping, work.stored),
    )?;
    arrays.other("exceeded", stepper.exceeded())?;
    let end = NativeStepState {
        saved: stepper.save(),
        dt: course.dt,
        system: system.clone().unbind(),
    };
    arrays.other("end", end)?;
    Ok(arrays.done())
}
