//! `frictiongen identify`: finds the friction force from recordings.

use super::lines::Lines;
use super::{decay, read};
use crate::args::{Also, By, IdentifyArguments};
use crate::asked;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::{Identified, IdentifyRequest, Observation, Unknown, Using};
use frictiongen::study::scene::Excitation;
use frictiongen::study::units::{hertz, polar};
use frictiongen::study::words;
use std::io::Write;

/// Runs the command.
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
            output::print(&lines, &summary, destination.form, out)
        });
    }
    let harmonics = asked::harmonics(arguments.harmonics.as_deref())?.unwrap_or(1);
    let masses = asked::masses(&system, &arguments.mass)?;
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
            crate::destination::Form::Svg | crate::destination::Form::Png
        ) {
            return super::draw::residuals(&system, &observations, &found, destination.form, out);
        }
        let lines = lines(&system, &observations, &found);
        output::print(&lines, &summary, destination.form, out)
    })
}

/// Parses a range of friction forces, a:b.
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

fn lines(system: &System, observations: &[Observation], found: &Identified) -> Lines {
    let mut lines = Lines::default();
    lines.said.push(("verdict", found.verdict.to_string()));
    let open = found.undetermined();
    if !open.is_empty() {
        let names: Vec<String> = open.iter().map(|unknown| unknown.symbol(system)).collect();
        lines.said.push((
            "not determined",
            format!(
                "{}: the response does not change with it here; the other results are valid for any value of it",
                names.join(", ")
            ),
        ));
    }
    lines.word("friction force is", found.verdict.word());
    if 1 < found.levels.len() {
        for (index, level) in found.levels.iter().enumerate() {
            lines.estimate(format!("friction force {}", index + 1), *level, 1.0, "N");
        }
    } else {
        lines.estimate("friction force", found.friction, 1.0, "N");
    }
    for (unknown, estimate) in &found.unknowns {
        match unknown {
            Unknown::Frequencies => {
                for (mode, omega) in system.natural_frequencies().into_iter().enumerate() {
                    let name = format!("natural frequency {}", mode + 1);
                    lines.estimate(name, *estimate, hertz(omega), "Hz");
                }
            }
            _ => lines.estimate(unknown.symbol(system), *estimate, 1.0, ""),
        }
    }
    lines.number("condition", found.condition, "");
    if let Some(misfit) = found.misfit {
        lines.number("misfit (1 is noise)", misfit, "");
    }
    let names = &system.scene().masses;
    for (index, (seen, point)) in observations.iter().zip(&found.explained).enumerate() {
        lines.number(
            format!("recording {}: frequency", index + 1),
            seen.hertz,
            "Hz",
        );
        let (what, unit) = match system.scene().excitation {
            Excitation::Base => ("base amplitude", "m"),
            Excitation::Force(_) => ("force amplitude", "N"),
        };
        let (frictiongen::study::Load::Base(size) | frictiongen::study::Load::Force(size)) =
            seen.load;
        lines.number(format!("  {what}"), size, unit);
        lines.number("  r", point.r, "");
        lines.number("  beta", point.beta, "");
        lines.word("  regime", words::regime(point.regime));
        for (datum, (model, residual)) in seen
            .motions
            .iter()
            .zip(point.model.iter().zip(found.residuals(observations, index)))
        {
            let name = names.get(datum.mass).map_or("", |mass| mass.name.as_str());
            let name = match datum.harmonic {
                1 => name.to_owned(),
                order => format!("{name} X_{order}"),
            };
            let (measured, computed) = (polar(datum.value), polar(*model));
            lines.number(format!("  {name}: amplitude measured"), measured.0, "");
            lines.number(format!("  {name}: amplitude computed"), computed.0, "");
            lines.number(
                format!("  {name}: lag measured"),
                measured.1.to_degrees(),
                "deg",
            );
            lines.number(
                format!("  {name}: lag computed"),
                computed.1.to_degrees(),
                "deg",
            );
            lines.number(
                format!("  {name}: residual over deviation"),
                residual.norm() / datum.deviation,
                "",
            );
        }
    }
    lines
}
