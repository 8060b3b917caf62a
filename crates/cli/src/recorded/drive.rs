//! `frictiongen drive`: computes the motion of a scene under a recorded input.

use super::driven::DrivenReport;
use super::peaks::PeaksReport;
use super::spectrum::ResponseSpectrumReport;
use super::{read, signals};
use crate::args::{DriveArguments, RecordingArguments};
use crate::asked::{number_that, whole, without_rates};
use crate::destination::Destination;
use crate::failure::Failure;
use crate::grid::{self, GridQuantity};
use crate::joined::refused;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::columns::{DrivenTable, PeakQuantities, driven_parts};
use frictiongen::measure::{Drive, Recording, Signal};
use frictiongen::study::history::MOST_SAMPLES;
use frictiongen::study::joined::{Joined, JoinedStepper};
use std::io::Write;

/// Runs `frictiongen drive`.
pub fn run(arguments: &DriveArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = &arguments.recordings;
    let output = arguments.output.as_deref();
    let pictures = !arguments.peaks;
    let destination = Destination::of(output, Some(&files.scene), &arguments.format, pictures)?;
    let form = destination.form;
    let frictions = frictions(arguments)?;
    let after = arguments.after.as_deref().map(|text| {
        let needed = "a time in s that is not negative";
        number_that("--after", text, |seconds| 0.0 <= seconds, needed)
    });
    let after = after.transpose()?.unwrap_or(0.0);
    let system = read::any_scene(&files.scene)?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    if let Some(text) = &arguments.spectrum {
        let spectrum = spectrum(&system, files, text)?;
        return destination.write(out, |out| {
            #[cfg(feature = "pictures")]
            if form.is_picture() {
                return super::draw::spectrum(&system, &spectrum, form, out);
            }
            output::write(&spectrum, &summary, form, out)
        });
    }
    let joined = system.joined().map_err(Failure::new)?;
    let names = joined.contact_names();
    let source = Source::of(arguments, &system, after)?;
    let asked = (names.as_slice(), arguments.of.as_slice());
    if arguments.peaks {
        let quantities = PeakQuantities::named(&system, "--of", asked).map_err(Failure::new)?;
        let mut rows = Vec::new();
        for friction in frictions {
            let (inputs, mut step) = source.begin(files, &joined, (&system, friction))?;
            quantities.follow(&mut step).map_err(Failure::new)?;
            let found = quantities.rows(&joined, (&*inputs, step), friction, &|| true);
            rows.extend(found.map_err(Failure::new)?);
        }
        let system = &system;
        let peaks = PeaksReport { system, rows };
        return destination.write(out, |out| output::write(&peaks, &summary, form, out));
    }
    let parts = driven_parts(&system, "--of", asked).map_err(Failure::new)?;
    without_rates(&parts)?;
    let table = DrivenTable {
        system: &system,
        parts: &parts,
        names: &names,
        has_slips: true,
    };
    let friction = frictions.first().copied().flatten();
    let (inputs, step) = source.begin(files, &joined, (&system, friction))?;
    let motion = table.motion(&joined, (&*inputs, step), &|| true);
    let motion = motion.map_err(Failure::new)?;
    let driven = DrivenReport { table, motion };
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            return super::draw::driven(&driven, form, out);
        }
        output::write(&driven, &summary, form, out)
    })
}

/// The inputs that drive the scene.
enum Source {
    /// A recording, followed by this time in s.
    Recorded(Recording, f64),
    /// Inputs in closed form, with the end of the motion in s and its number of sample intervals.
    Signals(Vec<Signal>, (f64, usize)),
}

/// Inputs, and a stepper of the scene at their first sample.
type Begun<'i, 's> = (Box<dyn Drive + 'i>, JoinedStepper<'s>);

impl Source {
    fn of(arguments: &DriveArguments, system: &System, after: f64) -> Result<Self, Failure> {
        let Some(until) = &arguments.until else {
            return Ok(Self::Recorded(arguments.recordings.inputs()?, after));
        };
        let until = number_that("--until", until, |time| 0.0 < time, "a time in s above 0")?;
        let samples = arguments.samples.as_deref().unwrap_or("1000");
        let samples = whole("--samples", samples, 1..=MOST_SAMPLES as u32)?;
        let signals = signals::parsed(system, &arguments.input)?;
        Ok(Self::Signals(signals, (until, samples as usize)))
    }

    /// Begins the motion at one friction force in N, or under the recorded friction.
    fn begin<'i, 's>(
        &'i self,
        files: &RecordingArguments,
        joined: &Joined<'s>,
        (system, friction): (&System, Option<f64>),
    ) -> Result<Begun<'i, 's>, Failure> {
        match self {
            Self::Recorded(recording, after) => {
                let inputs = read::drive(files, recording, system, (friction, *after))?;
                let step = inputs.joined_stepper(joined, None);
                Ok((Box::new(inputs), step.map_err(Failure::new)?))
            }
            Self::Signals(signals, extent) => {
                let inputs = signals::inputs(signals, *extent, friction.unwrap_or(0.0))?;
                let step = inputs.stepper(joined, None);
                Ok((Box::new(inputs), step.map_err(Failure::new)?))
            }
        }
    }
}

/// Returns the friction forces of the option `--friction`, or `None` for the friction of the recording. Only `--peaks`
/// permits several forces.
fn frictions(arguments: &DriveArguments) -> Result<Vec<Option<f64>>, Failure> {
    let Some(text) = &arguments.friction else {
        return Ok(vec![None]);
    };
    if arguments.peaks {
        let grid = grid::parse(text, GridQuantity::FrictionForce).map_err(Failure::new)?;
        return Ok(grid.into_iter().map(Some).collect());
    }
    let needed = "a force in N that is not negative";
    let friction = number_that("--friction", text, |force| 0.0 <= force, needed)?;
    Ok(vec![Some(friction)])
}

/// Computes the response spectrum of the recorded base motion for a damping ratio.
fn spectrum<'s>(
    system: &'s System,
    files: &RecordingArguments,
    text: &str,
) -> Result<ResponseSpectrumReport<'s>, Failure> {
    if system.scene().is_joined() {
        refused(&[(true, "--spectrum")])?;
    }
    let needed = "a damping ratio from 0 to below 1";
    let sound = |zeta| (0.0..1.0).contains(&zeta);
    let zeta = number_that("--spectrum", text, sound, needed)?;
    ResponseSpectrumReport::of(system, files, zeta)
}
