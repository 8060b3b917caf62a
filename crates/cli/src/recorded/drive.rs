//! `frictiongen drive`: computes the motion of a scene under a recorded input.

use super::driven::DrivenReport;
use super::read;
use super::spectrum::ResponseSpectrumReport;
use crate::args::DriveArguments;
use crate::asked::{self, MovingPart, number_that, without_rates};
use crate::destination::Destination;
use crate::failure::Failure;
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
    let destination = Destination::of(output, Some(&files.scene), &arguments.format, true)?;
    let form = destination.form;
    let friction = arguments.friction.as_deref().map(|text| {
        let needed = "a force in N that is not negative";
        number_that("--friction", text, |force| 0.0 <= force, needed)
    });
    let friction = friction.transpose()?;
    let after = arguments.after.as_deref().map(|text| {
        let needed = "a time in s that is not negative";
        number_that("--after", text, |seconds| 0.0 <= seconds, needed)
    });
    let after = after.transpose()?.unwrap_or(0.0);
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
    let joined = system.joined().map_err(Failure::new)?;
    let names = joined.contact_names();
    let parts = motions(&system, &names, &arguments.of)?;
    without_rates(&parts)?;
    let recording = files.inputs()?;
    let inputs = read::drive(files, &recording, &system, (friction, after))?;
    let table = DrivenTable {
        system: &system,
        parts: &parts,
        names: &names,
        has_slips: true,
    };
    let driven = DrivenReport::of(&joined, &inputs, table)?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            return super::draw::driven(&driven, form, out);
        }
        output::write(&driven, &summary, form, out)
    })
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
fn named(system: &System, contacts: &[String], name: &str) -> Result<MovingPart, Failure> {
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
