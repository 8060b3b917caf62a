//! `frictiongen identify`: finds the friction force from recordings.

use super::lines::ResultLines;
use super::{decay, read};
use crate::args::{Also, By, IdentifyArguments};
use crate::asked;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::columns::identify_lines;
use frictiongen::measure::{Identified, IdentifyRequest, Observation, Unknown, Using};
use frictiongen::study::sensitivity::Quantity;
use std::io::Write;

/// Runs `frictiongen identify`.
pub fn run(arguments: &IdentifyArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = &arguments.recordings;
    let output = arguments.output.as_deref();
    let destination = Destination::of(
        output,
        Some(&files.scene),
        &arguments.format,
        !arguments.decay,
    )?;
    let system = read::scene(&files.scene)?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    if arguments.decay {
        let lines = decay::lines(arguments, &system)?;
        return destination.write(out, |out| {
            output::write(&lines, &summary, destination.form, out)
        });
    }
    if arguments.also.contains(&Also::Stiffness) && system.scene().stiffness.is_none() {
        return Err(Failure::new(format_args!(
            "--also stiffness: the contact of {} is rigid; add `stiffness` to the description, with a first guess in N/m",
            files.scene.display()
        )));
    }
    let harmonics = asked::harmonics(arguments.harmonics.as_deref())?.unwrap_or(1);
    let masses = asked::masses(&system, "--mass", &arguments.mass)?;
    let mut observations: Vec<Observation> = files
        .measured(&system)?
        .iter()
        .map(|measured| Observation::of(measured, &system, harmonics))
        .collect();
    for seen in &mut observations {
        seen.motions
            .retain(|datum| masses.iter().any(|mass| mass.index == datum.mass));
    }
    let request = IdentifyRequest {
        using: match arguments.by {
            By::Both => Using::Complex,
            By::Amplitude => Using::Amplitude,
            By::Phase => Using::Phase,
        },
        unknowns: arguments
            .also
            .iter()
            .map(|also| match also {
                Also::Damping => Unknown::Damping,
                Also::Frequency => Unknown::Frequencies,
                Also::Stiction => Unknown::Stiction,
                Also::Stiffness => Unknown::Quantity(Quantity::ContactStiffness),
            })
            .collect(),
        range: arguments.between.as_deref().map(between).transpose()?,
    };
    let found = system
        .identify(&observations, &request)
        .map_err(Failure::new)?;
    destination.write(out, |out| {
        #[cfg(feature = "pictures")]
        if matches!(
            destination.form,
            crate::destination::OutputFormat::Svg | crate::destination::OutputFormat::Png
        ) {
            return super::draw::residuals(&system, &observations, &found, destination.form, out);
        }
        let lines = lines(&system, &observations, &found);
        output::write(&lines, &summary, destination.form, out)
    })
}

/// Parses a range of friction forces `a:b`, in N.
fn between(text: &str) -> Result<(f64, f64), Failure> {
    let ends = text
        .split_once(':')
        .and_then(|(from, to)| Some((from.trim().parse().ok()?, to.trim().parse().ok()?)));
    ends.ok_or_else(|| {
        Failure::new(format_args!(
            "--between `{text}`: two forces in N are needed, a:b"
        ))
    })
}

fn lines<'a>(
    system: &'a System,
    observations: &[Observation],
    found: &Identified,
) -> ResultLines<'a> {
    let mut said = vec![("verdict", found.verdict.to_string())];
    let open = found.undetermined();
    if !open.is_empty() {
        let names: Vec<String> = open.iter().map(|unknown| unknown.symbol(system)).collect();
        said.push((
            "not determined",
            format!(
                "{}: the response does not change with it here; the other results are valid for any value of it",
                names.join(", ")
            ),
        ));
    }
    ResultLines {
        system,
        lines: identify_lines(system, observations, found),
        said,
        keys: vec![("verdict_key", found.verdict.key())],
    }
}
