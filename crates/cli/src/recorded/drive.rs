//! `frictiongen drive`: computes the motion of a scene under a recorded input.

use super::driven::DrivenReport;
use super::peaks::PeaksReport;
use super::read;
use super::spectrum::ResponseSpectrumReport;
use crate::args::{DriveArguments, RecordingArguments};
use crate::asked::{self, MovingPart, number_that, without_rates};
use crate::destination::Destination;
use crate::failure::Failure;
use crate::grid::{self, GridQuantity};
use crate::joined::refused;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::measure::columns::DrivenTable;
use frictiongen::{Of, System};
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
    let recording = files.inputs()?;
    let inputs = |friction| read::drive(files, &recording, &system, (friction, after));
    if arguments.peaks {
        let mut peaks = PeaksReport::new(&system, &names, &arguments.of)?;
        for friction in frictions {
            peaks.add(&joined, &inputs(friction)?, friction)?;
        }
        return destination.write(out, |out| output::write(&peaks, &summary, form, out));
    }
    let parts = motions(&system, &names, &arguments.of)?;
    without_rates(&parts)?;
    let table = DrivenTable {
        system: &system,
        parts: &parts,
        names: &names,
        has_slips: true,
    };
    let friction = frictions.first().copied().flatten();
    let driven = DrivenReport::of(&joined, &inputs(friction)?, table)?;
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            return super::draw::driven(&driven, form, out);
        }
        output::write(&driven, &summary, form, out)
    })
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

/// Returns the motions that the option `--of` names. Without names, returns all contacts and all masses, which are
/// relative to the base if the base moves.
fn motions(
    system: &System,
    contacts: &[String],
    names: &[String],
) -> Result<Vec<MovingPart>, Failure> {
    let contact = |name: &String| MovingPart {
        name: name.clone(),
        ..MovingPart::contact(system)
    };
    if names.is_empty() {
        // Under a recorded acceleration the base drifts by metres. This drift would hide all relative motion.
        let masses = asked::masses(system, "--of", names)?.into_iter();
        let masses = masses.map(|mass| MovingPart::from(mass).from_base(system));
        return Ok(contacts.iter().map(contact).chain(masses).collect());
    }
    let mut found: Vec<MovingPart> = Vec::new();
    for name in names {
        if found.iter().any(|part| part.name == *name) {
            return Err(Failure::new(format_args!(
                "--of `{name}`: it is given twice"
            )));
        }
        found.push(match contacts.iter().find(|contact| *contact == name) {
            Some(name) => contact(name),
            None => named(system, contacts, name)?,
        });
    }
    Ok(found)
}

/// Returns the mass, or the combination of masses and base, with this name.
pub fn named(system: &System, contacts: &[String], name: &str) -> Result<MovingPart, Failure> {
    let known = || contacts.join(", ");
    let part = MovingPart::named(system, name).map_err(|error| {
        Failure::new(format_args!("--of: {error}; the contacts are {}", known()))
    })?;
    if part.of == Of::Contact && 1 < contacts.len() {
        return Err(Failure::new(format_args!(
            "--of `{name}`: the scene has several contacts; name one of them: {}",
            known()
        )));
    }
    Ok(part)
}
