//! `frictiongen fit`: fits a scene's parameters to a sweep without friction, or to a recording of the whole motion.

use super::lines::ResultLines;
use super::read;
use crate::args::FitArguments;
use crate::asked::number_that;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::columns::{fit_lines, motion_lines};
use frictiongen::measure::{CsvRequest, Recording, SweepFit, SweepPoint};
use std::io::Write;

/// Ratio of the residuals to the recorded motion above which the command warns that the scene description does not
/// explain the recording.
const UNEXPLAINED: f64 = 0.1;

/// Runs `frictiongen fit`.
pub fn run(arguments: &FitArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&arguments.scene), &arguments.format, false)?;
    let system = read::scene(&arguments.scene)?;
    let text = read::text(&arguments.sweep)?;
    if arguments.friction.is_some() || !arguments.vary.is_empty() {
        let lines = motion(arguments, &system, &text)?;
        let summary = Summary::of(&system, true, Measure::groups(&system));
        return destination.write(out, |out| {
            output::write(&lines, &summary, destination.form, out)
        });
    }
    let points =
        SweepPoint::read(&text, &system).map_err(|error| read::told(&arguments.sweep, &error))?;
    let found = system.fit_sweep(&points, arguments.damping);
    let found = found.map_err(|error| read::told(&arguments.sweep, &error))?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    let lines = lines(&system, &found, points.len());
    destination.write(out, |out| {
        output::write(&lines, &summary, destination.form, out)
    })
}

fn lines<'a>(system: &'a System, found: &SweepFit, points: usize) -> ResultLines<'a> {
    let mut said = Vec::new();
    if !found.is_explained() {
        let note = "the description does not explain the sweep: residuals exceed the deviations; check the chain, the damping and that friction was off";
        said.push(("verdict", note.to_owned()));
    }
    ResultLines {
        system,
        lines: fit_lines(system, found, points),
        said,
        keys: Vec::new(),
    }
}

/// Fits the friction force and numbers of the scene description to a recording of the whole motion.
fn motion<'a>(
    arguments: &FitArguments,
    system: &'a System,
    text: &str,
) -> Result<ResultLines<'a>, Failure> {
    let friction = arguments.friction.as_deref().map(|text| {
        let needed = "a force in N above 0, which is the first guess";
        number_that("--friction", text, |force| 0.0 < force, needed)
    });
    let vary = arguments.vary.iter().map(|name| {
        let tunable = system.tunable_named(name);
        tunable.map_err(|error| Failure::new(format_args!("--vary `{name}`: {error}")))
    });
    let vary = vary.collect::<Result<Vec<_>, _>>()?;
    let friction = friction.transpose()?;
    let recording = Recording::inputs_from_csv(text, &CsvRequest::default());
    let found = recording.and_then(|recording| system.fit_motion(&recording, friction, &vary));
    let found = found.map_err(|error| read::told(&arguments.sweep, &error))?;
    let derivatives = match found.differences {
        0 => "exact".to_owned(),
        count => format!(
            "exact, except for {count} by differences, because the motion grazes an event there"
        ),
    };
    let mut said = vec![("derivatives", derivatives)];
    if UNEXPLAINED < found.scatter {
        said.insert(
            0,
            (
                "verdict",
                format!(
                    "the description does not explain the recording: the residuals are {:.0} % of the motion; check the chain, the units and the first guess",
                    100.0 * found.scatter
                ),
            ),
        );
    }
    Ok(ResultLines {
        system,
        lines: motion_lines(system, &found),
        said,
        keys: Vec::new(),
    })
}
