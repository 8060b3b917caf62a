//! `frictiongen drive`: computes the motion of a scene under a recorded input.

use super::driven::DrivenReport;
use super::joined;
use super::read;
use super::spectrum::ResponseSpectrumReport;
use crate::args::DriveArguments;
use crate::asked::{number_that, parts, without_rates};
use crate::destination::Destination;
#[cfg(feature = "pictures")]
use crate::failure::Failure;
use crate::joined::refused;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use std::io::Write;

/// Runs `frictiongen drive`.
pub fn run(arguments: &DriveArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = &arguments.recordings;
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&files.scene), &arguments.format, true)?;
    let form = destination.form;
    let friction = arguments.friction.as_deref().map(|text| {
        let needed = "a force in N that is not negative";
        number_that("--friction", text, |force| 0.0 <= force, needed)
    });
    let friction = friction.transpose()?;
    let system = read::any_scene(&files.scene)?;
    if system.scene().is_joined() {
        refused(&[(arguments.spectrum.is_some(), "--spectrum")])?;
    }
    if let Some(text) = &arguments.spectrum {
        let needed = "a damping ratio from 0 to below 1";
        let zeta = number_that(
            "--spectrum",
            text,
            |zeta| (0.0..1.0).contains(&zeta),
            needed,
        )?;
        let spectrum = ResponseSpectrumReport::of(&system, files, zeta)?;
        let summary = Summary::of(&system, true, Measure::groups(&system));
        return destination.write(out, |out| {
            #[cfg(feature = "pictures")]
            if form.is_picture() {
                return super::draw::spectrum(&system, &spectrum, form, out);
            }
            output::write(&spectrum, &summary, form, out)
        });
    }
    if system.scene().is_joined() {
        let driven = joined::DriveRequest::of(&system, &arguments.of, friction)?;
        return destination.write(out, |out| driven.write(files, form, out));
    }
    let mut parts = parts(&system, &arguments.of)?;
    without_rates(&parts)?;
    if arguments.of.is_empty() {
        // Under a recorded acceleration the base drifts by metres. This drift would hide all relative motion.
        let all = parts.into_iter().map(|part| part.from_base(&system));
        parts = all.collect();
    }
    let recording = files.inputs()?;
    let inputs = read::drive(files, &recording, &system, friction)?;
    let driven = DrivenReport::of(&system, &inputs, parts)?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            return super::draw::driven(&system, &driven, form, out);
        }
        output::write(&&driven, &summary, form, out)
    })
}
