//! `frictiongen time`: displacements, velocities, the friction force and events over time, and spectra.

mod asked;
mod events;
mod motion;
mod samples;
mod spectrum;

use crate::args::{FormatArguments, TimeArguments};
use crate::asked::parts;
use crate::failure::Failure;
use crate::file;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use asked::{Asked, start};
use events::EventsReport;
use frictiongen::System;
use frictiongen_codegen::Limits;
use motion::{Course, Motion};
use samples::SamplesReport;
use spectrum::SpectrumReport;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &TimeArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let format = format(arguments)?;
    let asked = Asked::parse(arguments)?;
    let frequencies = Frequencies::parse(&arguments.frequency, true)?;
    let frictions = Frictions::parse(&arguments.friction, &frequencies)?;
    let description = arguments.file.description(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let parts = parts(&system, &arguments.of)?;
    frequencies.check(&system)?;
    let measure = Measure::of(&arguments.load, &system)?;
    let frictions = frictions.under(&measure)?;
    let frequency = frequencies.only(&system)?;
    let friction = frictions.only()?;
    let summary = Summary::of(&system, &frequencies, measure);
    let course = Course {
        omega: system.angular_frequency(frequency.r),
        in_seconds: frequencies.are_physical() || measure.scale().is_some(),
        frequency: (frequencies.names(), frequency),
        friction: (frictions.names(), friction),
        measure,
        parts,
    };
    let from = arguments.from.as_deref();
    let from = from.map(|text| start(text, &system, &course)).transpose()?;
    let motion = Motion::of(&system, course, &asked, from)?;
    let write = |out: &mut dyn Write| {
        if arguments.events {
            output::print(&EventsReport { motion: &motion }, &summary, &format, out)
        } else if arguments.spectrum {
            let report = SpectrumReport::of(&motion);
            output::print(&report, &summary, &format, out)
        } else {
            output::print(&SamplesReport { motion: &motion }, &summary, &format, out)
        }
    };
    match &arguments.output {
        Some(path) => file::write_with(path, arguments.file.path(), write),
        None => write(out),
    }
}

/// The format asked for, or that of the file's ending; a file that cannot be written is refused before anything is
/// computed.
fn format(arguments: &TimeArguments) -> Result<FormatArguments, Failure> {
    let FormatArguments { json, csv } = arguments.format;
    let Some(path) = &arguments.output else {
        return Ok(FormatArguments { json, csv });
    };
    let refuse = |why: &str| {
        let shown = path.display();
        Err(Failure::new(format_args!("--output `{shown}`: {why}")))
    };
    let ending = path.extension().and_then(|ending| ending.to_str());
    let format = match ending {
        Some("csv") if json => return refuse("its name says CSV, and --json is given"),
        Some("json") if csv => return refuse("its name says JSON, and --csv is given"),
        Some("csv") => FormatArguments {
            json: false,
            csv: true,
        },
        Some("json") => FormatArguments {
            json: true,
            csv: false,
        },
        _ => return refuse("the name of a file ends in .csv or .json"),
    };
    file::check(path, arguments.file.path())?;
    Ok(format)
}
