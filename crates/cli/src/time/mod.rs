//! `frictiongen time`: computes displacements, velocities, the friction force and events over time, and spectra.

pub mod asked;
mod course;
#[cfg(feature = "pictures")]
mod draw;
mod motion;
mod samples;
mod spectrum;

use crate::args::{LoadArguments, TimeArguments};
#[cfg(feature = "pictures")]
use crate::asked::MovingPart;
use crate::asked::{number_that, parts, without_rates};
use crate::destination::{Destination, OutputFormat};
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::joined;
use crate::measure::{self, Measure};
use crate::output;
use crate::summary::Summary;
use asked::TimeRequest;
use course::RunSettings;
use frictiongen::System;
use frictiongen::study::columns::{Frequency, FrequencyUnit};
use frictiongen::study::units::LoadError;
use frictiongen_codegen::SizeLimits;
use motion::RunMotion;
use samples::{EventsReport, SamplesReport};
use spectrum::{SpectrumReport, spectra};
use std::io::Write;

/// Draws one period of a steady state of a scene with a single contact.
#[cfg(feature = "pictures")]
pub fn draw_period(
    (system, measure): (&System, Measure),
    (frequencies, frictions): (&Frequencies, &Frictions),
    parts: Vec<MovingPart>,
    (form, out): (OutputFormat, &mut dyn Write),
) -> Result<(), Failure> {
    let course = RunSettings {
        system,
        unit: frequencies.unit(),
        frequency: frequencies.only(system)?,
        friction: frictions.only()?,
        measure,
        parts,
        in_seconds: frequencies.are_physical() || measure.scale().is_some(),
    };
    let motion = RunMotion::of(course, &TimeRequest::PERIOD, None)?;
    draw::draw(system, &motion, false, form, out)
}

/// Runs `frictiongen time`.
pub fn run(arguments: &TimeArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let destination = Destination::of(
        arguments.output.as_deref(),
        arguments.point.file.path(),
        &arguments.format,
        !arguments.events,
    )?;
    let asked = TimeRequest::parse(arguments)?;
    if let Some(until) = &arguments.until {
        return free(arguments, (until, &asked), &destination, out);
    }
    refuse_zero(&arguments.point.load)?;
    let form = destination.form;
    let frequencies = Frequencies::parse(&arguments.point.frequency, true)?;
    let frictions = Frictions::parse(&arguments.point.friction, Some(&frequencies))?;
    let file = &arguments.point.file;
    let description = file.any(&SizeLimits::RUN_TIME)?;
    let from = arguments.from.as_deref();
    let run_from = from.filter(|text| !arguments.steady && text.trim() != from::REST);
    let scene = &description.scene;
    if scene.is_joined() || arguments.steady && scene.has_joined_states() {
        joined::refused(&[(arguments.spectrum, "--spectrum")])?;
        let point = joined::Asked::of(&arguments.point, frequencies, frictions, &arguments.of);
        let point = point.starting_from(from.filter(|_| arguments.steady));
        let of_time = joined::OfTime {
            asked,
            from: run_from,
            until: None,
            inputs: &[],
            events: arguments.events,
        };
        return destination.write(out, |out| {
            point.time(description.scene, &of_time, form, out)
        });
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let parts = parts(&system, &arguments.of)?;
    without_rates(&parts)?;
    frequencies.check(&system)?;
    let measure = measure::constant(&arguments.point.load, &system)?;
    if system.scene().has_length() && measure.load().is_none() {
        return Err(Failure::new(format_args!(
            "{}: the scene has lengths, speeds or constant forces, so that the load is needed; give it by {}",
            file.name(),
            measure::option(&measure)
        )));
    }
    let system = from::started(from.filter(|_| arguments.steady), system, &measure)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    let frequency = frequencies.only(&system)?;
    let friction = frictions.only()?;
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let course = RunSettings {
        system: &system,
        unit: frequencies.unit(),
        frequency,
        friction,
        measure,
        parts,
        in_seconds: frequencies.are_physical() || measure.scale().is_some(),
    };
    let (scale, omega) = (measure.scale(), frequency.omega);
    let run_from = run_from.map(|text| from::state(text, &system, scale, omega));
    let motion = RunMotion::of(course, &asked, run_from.transpose()?)?;
    destination.write(out, |out| write(&motion, arguments, (form, &summary), out))
}

/// Fails for a load of amplitude 0, and names the option for a motion without a load.
fn refuse_zero(load: &LoadArguments) -> Result<(), Failure> {
    let given = [
        ("--force", &load.force),
        ("--base", &load.base),
        ("--unbalance", &load.unbalance),
    ];
    for (option, text) in given {
        let Some(text) = text.as_ref().filter(|text| text.trim().parse() == Ok(0.0)) else {
            continue;
        };
        let error = LoadError::Amplitude;
        return Err(Failure::new(format_args!(
            "{option} `{text}`: {error}; for a motion without a load, give --from and --until in place of the load and its frequency"
        )));
    }
    Ok(())
}

/// Writes a motion over time: its samples, its events, its spectrum or a picture.
fn write(
    motion: &RunMotion<'_>,
    arguments: &TimeArguments,
    (form, summary): (OutputFormat, &Summary),
    out: &mut dyn Write,
) -> Result<(), Failure> {
    #[cfg(feature = "pictures")]
    if form.is_picture() {
        let system = motion.course.system;
        return draw::draw(system, motion, arguments.spectrum, form, out);
    }
    if arguments.events {
        output::write(&EventsReport { motion }, summary, form, out)
    } else if arguments.spectrum {
        let report = SpectrumReport {
            motion,
            spectra: &spectra(motion),
        };
        output::write(&report, summary, form, out)
    } else {
        output::write(&SamplesReport { motion }, summary, form, out)
    }
}

/// Writes the motion without a harmonic load: the free vibration from the state --from, or the motion under --input.
fn free(
    arguments: &TimeArguments,
    (until, asked): (&str, &TimeRequest),
    destination: &Destination,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let form = destination.form;
    let until = number_that("--until", until, |time| 0.0 < time, "a time in s above 0")?;
    if arguments.from.is_none() && arguments.input.is_empty() {
        return Err(Failure::new(
            "--until needs the state --from of a free vibration, or an input over time, --input",
        ));
    }
    let frictions = Frictions::parse(&arguments.point.friction, None)?;
    let system = arguments.point.file.maybe_unloaded()?;
    let measure = Measure::si(&system);
    let frictions = frictions.under(&measure)?;
    let friction = frictions.only()?;
    let from = arguments.from.as_deref();
    if system.scene().is_joined() || !arguments.input.is_empty() {
        let of_time = joined::OfTime {
            asked: *asked,
            from,
            until: Some(until),
            inputs: &arguments.input,
            events: arguments.events,
        };
        return destination.write(out, |out| {
            joined::free(&system, &of_time, (&arguments.of, frictions), (form, out))
        });
    }
    let parts = parts(&system, &arguments.of)?;
    without_rates(&parts)?;
    let mut frequency = Frequency::at(&system, 1.0);
    // The history has times in s in place of phases.
    frequency.omega = 1.0;
    let summary = Summary::of(&system, true, measure);
    let course = RunSettings {
        system: &system,
        unit: FrequencyUnit::Hertz,
        frequency,
        friction,
        measure,
        parts,
        in_seconds: true,
    };
    let from = from::state(from.unwrap_or_default(), &system, measure.scale(), 1.0)?;
    let motion = RunMotion::free(course, (from, until), asked.samples)?;
    destination.write(out, |out| write(&motion, arguments, (form, &summary), out))
}
