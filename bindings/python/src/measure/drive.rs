//! Computes the motion of a scene under a recorded input: base motion or forces.

use super::recording::NativeRecording;
use crate::asked::{
    FrictionValues, MOST_POINTS, Measure, Optional, check_size, names, numbers, one,
};
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::measure::columns::{
    DrivenTable, PeakQuantities, PeakRow, driven_parts, peak_columns,
};
use frictiongen::measure::{Inputs, Recording};
use frictiongen::study::joined::JoinedError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// The Python arguments `friction`, `of`, `after` and `start`.
type DriveKeywords<'py> = (Optional<'py>, Optional<'py>, Optional<'py>, Optional<'py>);

/// Displacements in m and velocities in m/s of all masses.
type State = (Vec<f64>, Vec<f64>);

/// A question about the motion of a scene under a recorded input.
struct DriveQuestion {
    system: Arc<System>,
    recording: Recording,
    source: Option<String>,
    /// Kinetic friction forces in N, or `None` for the recorded friction.
    frictions: Vec<Option<f64>>,
    names: Vec<String>,
    /// Time after the recording in s.
    after: f64,
    start: Option<State>,
}

impl DriveQuestion {
    fn of(
        system: &NativeSystem,
        recording: &NativeRecording,
        (friction, of, after, start): &DriveKeywords<'_>,
    ) -> PyResult<Self> {
        let system = Arc::clone(&system.system);
        let frictions = match friction {
            None => vec![None],
            Some(given) => {
                let given = (None, Some(given.clone()));
                let all = FrictionValues::listed(&given, &Measure::si(&system))?.all();
                all.iter().map(|friction| Some(friction.force())).collect()
            }
        };
        let after = after
            .as_ref()
            .map(|given| one("after", given))
            .transpose()?;
        let after = after.unwrap_or(0.0);
        let samples = after * recording.recording.rate();
        if !(0.0 <= after && samples < MOST_POINTS as f64) {
            return Err(domain(format_args!(
                "after is {after:?}: a time in s, 0 or above, of less than {MOST_POINTS} samples is needed"
            )));
        }
        Ok(Self {
            start: start
                .as_ref()
                .map(|given| state(given, &system))
                .transpose()?,
            recording: recording.recording.clone(),
            source: recording.source.clone(),
            names: names("of", of.as_ref())?,
            system,
            frictions,
            after,
        })
    }

    /// Returns the inputs of the scene, followed by the time after the recording.
    fn inputs(&self, py: Python<'_>, friction: Option<f64>) -> PyResult<Inputs<'_>> {
        let inputs = Inputs::of(&self.recording, &self.system, friction);
        let inputs = inputs.and_then(|inputs| inputs.followed_by(self.after));
        inputs.map_err(|error| measurement(py, self.source.as_deref(), &error))
    }

    fn start(&self) -> Option<(&[f64], &[f64])> {
        self.start
            .as_ref()
            .map(|(x, v)| (x.as_slice(), v.as_slice()))
    }
}

/// Reads displacements and velocities of all masses from Python.
fn state(given: &Bound<'_, PyAny>, system: &System) -> PyResult<State> {
    let rows: Result<(Bound<'_, PyAny>, Bound<'_, PyAny>), _> = given.extract();
    let (x, v) = rows
        .map_err(|_| wrong_type("start: displacements and velocities of all masses are needed"))?;
    let masses = system.scene().masses.len();
    let row = |given: &Bound<'_, PyAny>| {
        let values = numbers("start", given)?.values;
        if values.len() != masses || values.iter().any(|value| !value.is_finite()) {
            return Err(domain(format_args!(
                "start: {masses} finite numbers are needed, one for each mass, but these are {values:?}"
            )));
        }
        Ok(values)
    };
    Ok((row(&x)?, row(&v)?))
}

/// Computes the motion under recorded base motion or recorded forces.
#[pyfunction]
pub fn drive<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recording: &NativeRecording,
    keywords: DriveKeywords<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let question = DriveQuestion::of(system, recording, &keywords)?;
    let [friction] = *question.frictions else {
        return Err(domain(
            "friction: one number is needed here, not an array; peaks=True takes several",
        ));
    };
    let joined = question.system.joined().map_err(domain)?;
    let names = joined.contact_names();
    let asked = (names.as_slice(), question.names.as_slice());
    let parts = driven_parts(&question.system, "of", asked).map_err(domain)?;
    if let Some(part) = parts.iter().find(|part| part.has_rate()) {
        return Err(domain(format_args!(
            "of: `{}`: a motion in time has displacements and spring forces; peaks=True has the largest velocities and accelerations",
            part.name
        )));
    }
    let table = DrivenTable {
        system: &question.system,
        parts: &parts,
        names: &names,
        has_slips: true,
    };
    let columns = table.columns();
    let inputs = question.inputs(py, friction)?;
    check_size(inputs.len(), columns.len())?;
    let step = inputs
        .joined_stepper(&joined, question.start())
        .map_err(domain)?;
    let motion = without_lock(py, |stop| {
        table.motion(&joined, (&inputs, step), &|| stop.goes_on())
    })?;
    let motion = motion.map_err(domain)?;
    let mut arrays = NamedArrays::new(py, &[motion.samples.len()]);
    arrays.table(&columns, &motion.samples)?;
    let work = motion.work;
    arrays.other(
        "work",
        (work.load, work.friction, work.damping, work.stored),
    )?;
    arrays.other("exceeded", motion.exceeded)?;
    let energies = PyDict::new(py);
    for (name, energy) in motion.energies(&names) {
        energies.set_item(name, energy)?;
    }
    arrays.other("friction_energy", energies)?;
    Ok(arrays.done())
}

/// Computes the largest values of the motion under recorded base motion or recorded forces, at each friction force.
#[pyfunction]
pub fn drive_peaks<'py>(
    py: Python<'py>,
    system: &NativeSystem,
    recording: &NativeRecording,
    keywords: DriveKeywords<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let question = DriveQuestion::of(system, recording, &keywords)?;
    let joined = question.system.joined().map_err(domain)?;
    let names = joined.contact_names();
    let asked = (names.as_slice(), question.names.as_slice());
    let quantities = PeakQuantities::named(&question.system, "of", asked).map_err(domain)?;
    let mut rows: Vec<PeakRow> = Vec::new();
    for friction in question.frictions.iter().copied() {
        let inputs = question.inputs(py, friction)?;
        let mut step = inputs
            .joined_stepper(&joined, question.start())
            .map_err(domain)?;
        quantities
            .follow(&mut step)
            .map_err(|error: JoinedError| domain(error))?;
        let found = without_lock(py, |stop| {
            quantities.rows(&joined, (&inputs, step), friction, &|| stop.goes_on())
        })?;
        rows.extend(found.map_err(domain)?);
    }
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&peak_columns(&question.system, &rows), &rows)?;
    Ok(arrays.done())
}
