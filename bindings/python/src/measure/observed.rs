//! Collects observations (measured motions at one frequency), from recordings or from amplitudes and phases.

use super::recording::NativeRecording;
use super::transmissibility::measured;
use crate::asked::{LoadKeywords, Optional, numbers};
use crate::errors::{domain, wrong_type};
use frictiongen::measure::columns::MotionKnown as Known;
use frictiongen::measure::{Datum, Observation, Using};
use frictiongen::study::scene::Excitation;
use frictiongen::study::units::Load;
use frictiongen::{Complex, Of, System};
use pyo3::prelude::*;

/// A motion that the caller gave: mass, order of the harmonic, amplitude, phase, and the standard deviations of
/// amplitude and phase.
type Told<'py> = (
    String,
    u32,
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
    Optional<'py>,
);

/// Observations that the caller gave: frequencies, load, standard deviation of the load, and motions.
type Points<'py> = (
    Bound<'py, PyAny>,
    LoadKeywords<'py>,
    Bound<'py, PyAny>,
    Vec<Told<'py>>,
);

/// Observations of steady motions, with the quantities that are known for each observation.
#[derive(Default)]
pub struct Observed {
    /// The observations in the type of the library.
    pub all: Vec<Observation>,
    /// Quantities that are known for each observation.
    pub known: Vec<Known>,
}

/// Reads one number for each frequency, or one number for all frequencies. Every number must satisfy the condition
/// `sound`. `needed` describes this condition in the error message.
fn row(
    argument: &str,
    given: &Bound<'_, PyAny>,
    count: usize,
    sound: impl Fn(f64) -> bool,
    needed: &str,
) -> PyResult<Vec<f64>> {
    let given = numbers(argument, given)?;
    for (index, value) in given.values.iter().enumerate() {
        if !(value.is_finite() && sound(*value)) {
            return Err(domain(format_args!(
                "{} is {value:?}: {needed} is needed",
                given.place(argument, index)
            )));
        }
    }
    match (given.is_one, given.values.as_slice()) {
        (true, [value]) => Ok(vec![*value; count]),
        (_, values) if values.len() != count => Err(domain(format_args!(
            "{argument}: {count} numbers are needed, one for each frequency, but these are {}",
            values.len()
        ))),
        _ => Ok(given.values),
    }
}

const ABOVE: &str = "a finite number above 0";

/// Reads the amplitude of the load from Python: one number for each frequency, or one number for all frequencies.
fn loads(system: &System, load: &LoadKeywords<'_>, count: usize) -> PyResult<Vec<Load>> {
    let above = |value| 0.0 < value;
    match (load, system.scene().excitation) {
        ((None, Some(base)), Excitation::Base) => {
            let all = row("base", base, count, above, ABOVE)?;
            Ok(all.into_iter().map(Load::Base).collect())
        }
        ((Some(force), None), Excitation::Force(_)) => {
            let all = row("force", force, count, above, ABOVE)?;
            Ok(all.into_iter().map(Load::Force).collect())
        }
        (_, Excitation::Base) => Err(domain(
            "the base moves: give base, the amplitude that was measured, in m",
        )),
        _ => Err(domain(
            "a force drives the scene: give force, the amplitude that was measured, in N",
        )),
    }
}

/// Measured motion of a mass. Amplitude and phase have a value at each frequency.
struct ObservedMotion {
    mass: usize,
    harmonic: u32,
    amplitude: Option<Vec<f64>>,
    phase: Option<Vec<f64>>,
    deviation: Vec<f64>,
}

impl ObservedMotion {
    fn of(system: &System, told: Told<'_>, count: usize) -> PyResult<Self> {
        let (name, harmonic, amplitude, phase, deviation, of_phase) = told;
        let mass = match system.motion_named(&name) {
            Ok(Of::Mass(mass)) => mass,
            Ok(_) => {
                return Err(domain("a measured motion must be that of a mass"));
            }
            Err(error) => return Err(domain(error)),
        };
        let above = |value| 0.0 < value;
        let called = |what: &str| format!("{what}[{name:?}]");
        let amplitude = amplitude
            .map(|given| row(&called("amplitude_m"), &given, count, above, ABOVE))
            .transpose()?;
        let phase = phase
            .map(|given| {
                row(
                    &called("phase_deg"),
                    &given,
                    count,
                    |_| true,
                    "a finite number",
                )
            })
            .transpose()?;
        let (argument, given) = match &amplitude {
            Some(_) => ("deviation_m", deviation),
            None => ("phase_deviation_deg", of_phase),
        };
        let Some(given) = given else {
            return Err(domain(format_args!(
                "{argument}: the standard deviation of {} is missing; give it, because the interval needs it",
                called(if amplitude.is_some() {
                    "amplitude_m"
                } else {
                    "phase_deg"
                })
            )));
        };
        Ok(Self {
            mass,
            harmonic,
            amplitude,
            phase,
            deviation: row(&called(argument), &given, count, above, ABOVE)?,
        })
    }

    fn known(&self) -> Known {
        match (&self.amplitude, &self.phase) {
            (Some(_), None) => Known::Amplitude,
            (None, _) => Known::Phase,
            _ => Known::Both,
        }
    }

    /// Returns the measured motion at one frequency, divided by the load `load`. The value 1 replaces an unknown
    /// amplitude, and 0 replaces an unknown phase.
    fn datum(&self, place: usize, load: f64) -> Datum {
        let at = |values: &Vec<f64>| values.get(place).copied().unwrap_or(f64::NAN);
        let phase = self.phase.as_ref().map_or(0.0, at).to_radians();
        let (size, deviation) = match &self.amplitude {
            Some(amplitude) => (at(amplitude) / load, at(&self.deviation) / load),
            None => (1.0, at(&self.deviation).to_radians()),
        };
        Datum {
            mass: self.mass,
            harmonic: self.harmonic,
            value: Complex::from_polar(size, -phase),
            deviation,
        }
    }
}

impl Observed {
    /// Reads recordings and measured motions from Python, in the caller's order. A recording contributes its odd
    /// harmonics up to the order `harmonics`.
    pub fn of(
        py: Python<'_>,
        system: &System,
        items: Vec<Bound<'_, PyAny>>,
        harmonics: u32,
    ) -> PyResult<Self> {
        let mut observed = Self::default();
        let recordings: Vec<Py<NativeRecording>> = items
            .iter()
            .filter_map(|item| Some(item.cast::<NativeRecording>().ok()?.clone().unbind()))
            .collect();
        let mut measured = measured(py, system, &recordings)?.into_iter();
        for item in items {
            if item.is_instance_of::<NativeRecording>() {
                if let Some(measured) = measured.next() {
                    observed
                        .all
                        .push(Observation::of(&measured, system, harmonics));
                    observed.known.push(Known::Both);
                }
                continue;
            }
            let points = item
                .extract::<Points<'_>>()
                .map_err(|_| wrong_type("recordings and observations are needed"))?;
            observed.tell(system, points)?;
        }
        Ok(observed)
    }

    fn tell(
        &mut self,
        system: &System,
        (hertz, load, load_deviation, motions): Points<'_>,
    ) -> PyResult<()> {
        let count = numbers("hz", &hertz)?.values.len();
        let hertz = row("hz", &hertz, count, |value| 0.0 < value, ABOVE)?;
        let loads = loads(system, &load, count)?;
        let needed = "a finite number, 0 or above,";
        let load_deviation = row(
            "load_deviation",
            &load_deviation,
            count,
            |value| 0.0 <= value,
            needed,
        )?;
        let motions = motions.into_iter();
        let motions = motions.map(|told| ObservedMotion::of(system, told, count));
        let motions = motions.collect::<PyResult<Vec<_>>>()?;
        let Some(known) = motions.first().map(ObservedMotion::known) else {
            return Err(domain("amplitude_m or phase_deg: no motion is given"));
        };
        if motions.iter().any(|motion| motion.known() != known) {
            return Err(domain(
                "amplitude_m and phase_deg: give the same quantities for each mass, or make two observations",
            ));
        }
        let points = hertz.into_iter().zip(loads).zip(load_deviation);
        for (place, ((hertz, load), load_deviation)) in points.enumerate() {
            let size = load.amplitude();
            self.known.push(known);
            self.all.push(Observation {
                hertz,
                load,
                load_deviation,
                motions: motions
                    .iter()
                    .map(|motion| motion.datum(place, size))
                    .collect(),
            });
        }
        Ok(())
    }

    /// Returns the quantities of a motion that the fit compares: amplitude, phase, or both. `by` names these
    /// quantities. The default is every quantity that all measured motions have.
    pub fn using(&self, by: Option<&str>) -> PyResult<Using> {
        let none = |without: Known| self.known.iter().all(|known| *known != without);
        let (amplitudes, phases) = (none(Known::Phase), none(Known::Amplitude));
        let phase = if amplitudes {
            Using::Phase
        } else {
            Using::PhaseAlone
        };
        let missing = |what: &str, by: &str| {
            domain(format_args!("by is {by:?}, but some motion has no {what}"))
        };
        match by {
            None if amplitudes && phases => Ok(Using::Complex),
            None if amplitudes => Ok(Using::Amplitude),
            None if phases => Ok(phase),
            None => Err(domain(
                "some motions have no amplitude and others have no phase: no quantity can be compared for all of them",
            )),
            Some("both") if amplitudes && phases => Ok(Using::Complex),
            Some("amplitude") if amplitudes => Ok(Using::Amplitude),
            Some("phase") if phases => Ok(phase),
            Some(by @ ("both" | "amplitude")) if !amplitudes => Err(missing("amplitude", by)),
            Some(by @ ("both" | "phase")) => Err(missing("phase", by)),
            Some(by) => Err(domain(format_args!(
                "by is {by:?}: both, amplitude or phase is needed"
            ))),
        }
    }
}
