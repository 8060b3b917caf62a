//! Computes the motion of a scene under a recorded input: base motion or forces.

use super::recording::NativeRecording;
use crate::asked::{Optional, one, parts};
use crate::errors::{domain, measurement};
use crate::follow::{Course, RunStart, event_budget, follow};
use crate::step::Beginning;
use crate::system::NativeSystem;
use frictiongen::measure::Inputs;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Computes the motion under recorded base motion or recorded forces.
#[pyfunction]
pub fn drive<'py>(
    system: &Bound<'py, NativeSystem>,
    recording: &Bound<'py, NativeRecording>,
    friction: Optional<'py>,
    of: Optional<'py>,
    beginning: Beginning<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let py = system.py();
    let (start, stiction, budget) = beginning;
    let of_system = &system.get().system;
    let friction = friction.map(|given| one("friction", &given)).transpose()?;
    if let Some(force) = friction
        && !(0.0 <= force && force.is_finite())
    {
        return Err(domain(format_args!(
            "friction is {force:?}: friction must be a finite number, 0 or above"
        )));
    }
    let mut parts = parts(of_system, "of", of.as_ref())?;
    if of.is_none() {
        // Under a recorded acceleration the base drifts by metres. This drift would hide the relative motions, so all
        // motions are relative to the base.
        let all = parts.into_iter().map(|part| part.from_base(of_system));
        parts = all.collect();
    }
    let recording = recording.get();
    let inputs = Inputs::of(&recording.recording, of_system, friction);
    let inputs = inputs.map_err(|error| measurement(py, recording.source.as_deref(), &error))?;
    let course = Course {
        dt: inputs.dt(),
        samples: inputs.len(),
        parts,
        start: match start {
            None => {
                let (displacements, velocities) = inputs.initial_state(of_system);
                RunStart::Moving(displacements, velocities)
            }
            given => RunStart::of(given.as_ref())?,
        },
        stiction: stiction.map(|mu| one("stiction", &mu)).transpose()?,
        budget: budget.map(|events| event_budget(&events)).transpose()?,
    };
    follow(system, course, &|sample| inputs.at(sample))
}
