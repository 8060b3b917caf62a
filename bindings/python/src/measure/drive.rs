//! Computes the motion of a scene under a recorded input: base motion or forces.

use super::recording::NativeRecording;
use crate::asked::{
    FrictionValues, MOST_POINTS, Measure, Optional, check_size, names, numbers, one, whole,
};
use crate::columns::NamedArrays;
use crate::errors::{domain, measurement, wrong_type};
use crate::system::NativeSystem;
use crate::work::without_lock;
use frictiongen::System;
use frictiongen::measure::columns::{
    DrivenTable, PeakQuantities, PeakRow, driven_parts, peak_columns,
};
use frictiongen::measure::{Drive, Inputs, Recording, Signal, SignalInputs};
use frictiongen::study::joined::{Joined, JoinedError, JoinedStepper};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// The Python arguments `friction`, `of`, `after` and `start`.
type DriveKeywords<'py> = (Optional<'py>, Optional<'py>, Optional<'py>, Optional<'py>);

/// A recording from Python, or the texts of inputs with the end of the motion and its number of sample intervals.
#[derive(FromPyObject)]
pub enum DrivenBy<'py> {
    /// A recording of the inputs.
    Recorded(PyRef<'py, NativeRecording>),
    /// The Python arguments `input`, `until` and `samples`.
    Inputs(Vec<String>, Optional<'py>, Optional<'py>),
}

/// Displacements in m and velocities in m/s of all masses.
type State = (Vec<f64>, Vec<f64>);

/// Displacements in m and velocities in m/s of all masses.
type GivenState<'s> = (&'s [f64], &'s [f64]);

/// A question about the motion of a scene under a recorded input.
struct DriveQuestion {
    system: Arc<System>,
    source: Source,
    /// Kinetic friction forces in N, or `None` for the recorded friction.
    frictions: Vec<Option<f64>>,
    names: Vec<String>,
    start: Option<State>,
}

/// The inputs that drive the scene.
enum Source {
    /// A recording with its name, followed by this time in s.
    Recorded(Recording, Option<String>, f64),
    /// Inputs in closed form, with the end of the motion in s and its number of sample intervals.
    Signals(Vec<Signal>, (f64, usize)),
}

/// Inputs, and a stepper of the scene at their first sample.
type Begun<'i, 's> = (Box<dyn Drive + 'i>, JoinedStepper<'s>);

impl Source {
    fn of(
        driver: DrivenBy<'_>,
        system: &System,
        after: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let after = after.map(|given| one("after", given)).transpose()?;
        match driver {
            DrivenBy::Recorded(recording) => {
                let after = after.unwrap_or(0.0);
                let samples = after * recording.recording.rate();
                if !(0.0 <= after && samples < MOST_POINTS as f64) {
                    return Err(domain(format_args!(
                        "after is {after:?}: a time in s, 0 or above, of less than {MOST_POINTS} samples is needed"
                    )));
                }
                let (recording, source) = (recording.recording.clone(), recording.source.clone());
                Ok(Self::Recorded(recording, source, after))
            }
            DrivenBy::Inputs(texts, until, samples) => {
                let (Some(until), None) = (until, after) else {
                    return Err(domain(
                        "inputs need until=, the end of the motion in s, in place of after=",
                    ));
                };
                let samples = samples.map(|given| whole("samples", &given, 1..=MOST_POINTS as u32));
                let samples = samples.transpose()?.unwrap_or(1000) as usize;
                Ok(Self::Signals(
                    signals(system, &texts)?,
                    (one("until", &until)?, samples),
                ))
            }
        }
    }

    /// Begins the motion at one friction force in N, or under the recorded friction.
    fn begin<'i, 's>(
        &'i self,
        py: Python<'_>,
        joined: &Joined<'s>,
        (system, start, friction): (&System, Option<GivenState<'_>>, Option<f64>),
    ) -> PyResult<Begun<'i, 's>> {
        match self {
            Self::Recorded(recording, source, after) => {
                let inputs = Inputs::of(recording, system, friction);
                let inputs = inputs.and_then(|inputs| inputs.followed_by(*after));
                let inputs = inputs.map_err(|error| measurement(py, source.as_deref(), &error))?;
                let step = inputs.joined_stepper(joined, start).map_err(domain)?;
                Ok((Box::new(inputs), step))
            }
            Self::Signals(signals, extent) => {
                let friction = friction.ok_or_else(|| domain("inputs need friction="))?;
                let inputs = SignalInputs::new(signals, *extent, friction).map_err(domain)?;
                let step = inputs.stepper(joined, start).map_err(domain)?;
                Ok((Box::new(inputs), step))
            }
        }
    }
}

/// Parses inputs in closed form.
pub fn signals(system: &System, texts: &[String]) -> PyResult<Vec<Signal>> {
    let parse = |text: &String| Signal::parse(text, system);
    let signals = texts.iter().map(parse).collect::<Result<_, _>>();
    signals.map_err(|error| domain(format_args!("inputs: {error}")))
}

impl DriveQuestion {
    fn of(
        system: &NativeSystem,
        driver: DrivenBy<'_>,
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
        Ok(Self {
            start: start
                .as_ref()
                .map(|given| state(given, &system))
                .transpose()?,
            source: Source::of(driver, &system, after.as_ref())?,
            names: names("of", of.as_ref())?,
            system,
            frictions,
        })
    }

    /// Begins the motion at one friction force in N, or under the recorded friction.
    fn begin<'s>(
        &self,
        py: Python<'_>,
        joined: &Joined<'s>,
        friction: Option<f64>,
    ) -> PyResult<Begun<'_, 's>> {
        let question = (&*self.system, self.start(), friction);
        self.source.begin(py, joined, question)
    }

    fn start(&self) -> Option<GivenState<'_>> {
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
    driver: DrivenBy<'py>,
    keywords: DriveKeywords<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let question = DriveQuestion::of(system, driver, &keywords)?;
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
    let (inputs, step) = question.begin(py, &joined, friction)?;
    check_size(inputs.samples(), columns.len())?;
    let motion = without_lock(py, |stop| {
        table.motion(&joined, (&*inputs, step), &|| stop.goes_on())
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
    driver: DrivenBy<'py>,
    keywords: DriveKeywords<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let question = DriveQuestion::of(system, driver, &keywords)?;
    let joined = question.system.joined().map_err(domain)?;
    let names = joined.contact_names();
    let asked = (names.as_slice(), question.names.as_slice());
    let quantities = PeakQuantities::named(&question.system, "of", asked).map_err(domain)?;
    let mut rows: Vec<PeakRow> = Vec::new();
    for friction in question.frictions.iter().copied() {
        let (inputs, mut step) = question.begin(py, &joined, friction)?;
        quantities
            .follow(&mut step)
            .map_err(|error: JoinedError| domain(error))?;
        let found = without_lock(py, |stop| {
            quantities.rows(&joined, (&*inputs, step), friction, &|| stop.goes_on())
        })?;
        rows.extend(found.map_err(domain)?);
    }
    let mut arrays = NamedArrays::new(py, &[rows.len()]);
    arrays.table(&peak_columns(&question.system, &rows), &rows)?;
    Ok(arrays.done())
}
