//! `frictiongen fit`: fits a scene's parameters to a sweep without friction.

use super::lines::ResultLines;
use super::read;
use crate::args::FitArguments;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::columns::fit_lines;
use frictiongen::measure::{SweepFit, SweepPoint};
use std::io::Write;

/// Runs `frictiongen fit`.
pub fn run(arguments: &FitArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&arguments.scene), &arguments.format, false)?;
    let system = read::scene(&arguments.scene)?;
    let text = read::text(&arguments.sweep)?;
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
