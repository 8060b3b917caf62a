//! `frictiongen curve`: computes responses over frequency in every regime.

#[cfg(feature = "pictures")]
mod draw;
mod report;

use crate::args::CurveArguments;
use crate::asked::{self, MovingPart};
use crate::destination::Destination;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::{Band, Frequencies};
use crate::friction::Frictions;
use crate::from;
use crate::interrupt;
use crate::joined;
use crate::measure;
use crate::output;
use crate::progress::Progress;
use crate::summary::Summary;
use frictiongen::study::columns::FrictionSetting;
use frictiongen::study::scene::{Excitation, Node, Scene};
use frictiongen::study::{
    curve::{Curve, CurveRequest, CurveStart},
    words,
};
use frictiongen::{Of, System};
use frictiongen_codegen::SizeLimits;
use report::CurveReport;
use std::io::Write;
use std::sync::Mutex;

/// Runs `frictiongen curve`.
pub fn run(arguments: &CurveArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let destination = Destination::of(
        arguments.output.as_deref(),
        arguments.point.file.path(),
        &arguments.format,
        true,
    )?;
    let orders = match asked::harmonics(arguments.harmonics.as_deref())? {
        Some(highest) => (1..=highest).collect(),
        None => Vec::new(),
    };
    if arguments.log.is_some() && !destination.form.is_picture() {
        return Err(Failure::new(
            "--log: only a picture has axes; write one by -o curve.svg, or leave --log out",
        ));
    }
    let frictions = Frictions::parse(&arguments.point.friction, None)?;
    let description = arguments.point.file.any(&SizeLimits::RUN_TIME)?;
    let (starts, state) = starts(&arguments.from)?;
    if description.scene.has_joined_states() {
        joined::refused(&[
            (!orders.is_empty(), "--harmonics"),
            (arguments.rates, "--rates"),
            (arguments.accuracy.is_some(), "--accuracy"),
            (starts.contains(&CurveStart::Up), "--from up"),
            (starts.contains(&CurveStart::Down), "--from down"),
        ])?;
        let frequencies = Frequencies::spread(&arguments.point.frequency)?;
        let asked = joined::Asked::of(&arguments.point, frequencies, frictions, &arguments.of)
            .starting_from(state);
        return destination.write(out, |out| match destination.form {
            #[cfg(feature = "pictures")]
            form @ (OutputFormat::Svg | OutputFormat::Png) => {
                let log = arguments.log.unwrap_or_default();
                let picture = joined::Picture::Curve(log.frequency(), log.amplitude());
                asked.draw(description.scene, picture, form, out)
            }
            form => asked.write(description.scene, false, form, out),
        });
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let band = Band::parse(&arguments.point.frequency, &system)?;
    let mut parts = asked::parts(&system, &arguments.of)?;
    if destination.form.is_picture() {
        one_row_of_contact(&mut parts, system.scene());
    }
    let measure = measure::of(&arguments.point.load, &system)?;
    let system = from::started(state, system, &measure)?;
    let band = band.under(&measure);
    let frictions = frictions.under(&measure)?;
    let of: Vec<_> = parts.iter().map(|part| part.of).collect();
    let mut request = CurveRequest {
        widest: band.widest,
        harmonics: orders,
        rates: arguments.rates || parts.iter().any(MovingPart::has_rate),
        turned: measure.turns_contact(),
        // The user gives the friction as a force. If the load's amplitude is proportional to r⁻ⁿ, the friction
        // ratio β is therefore proportional to rⁿ, with the same exponent n.
        rise: measure.fall(),
        fall: measure.fall(),
        ..CurveRequest::new(band.from, band.to, &of)
    };
    if let Some(text) = &arguments.accuracy {
        request.accuracy = asked::number("--accuracy", text)?;
    }
    let of_friction =
        |friction: FrictionSetting| starts.iter().map(move |start| (friction, *start));
    let asked: Vec<(FrictionSetting, CurveStart)> = frictions.all().flat_map(of_friction).collect();
    let pairs: Vec<(f64, CurveStart)> = asked
        .iter()
        .map(|(friction, start)| (friction.beta, *start))
        .collect();
    let found = followed(&system, &request, &pairs)?;
    let curves = asked.iter().map(|(friction, _)| *friction).zip(found);
    let curves = curves.filter_map(|(friction, curve)| Some((friction, curve?)));
    let curves: Vec<(FrictionSetting, Curve)> = curves.collect();
    let (done, all) = (curves.len(), asked.len());
    if done == 0 {
        return Err(stopped(done, all));
    }
    let swept = starts != [CurveStart::Rest];
    let summary = Summary::of(&system, band.is_physical(), measure);
    let report = CurveReport {
        system,
        band,
        frictions,
        measure,
        parts,
        rates: arguments.rates,
        request,
        curves,
        #[cfg(feature = "pictures")]
        log: arguments.log.unwrap_or_default(),
        swept,
    };
    destination.write(out, |out| match destination.form {
        #[cfg(feature = "pictures")]
        OutputFormat::Svg | OutputFormat::Png => draw::draw(&report, destination.form, out),
        form => output::write(&report, &summary, form, out),
    })?;
    if done < all {
        return Err(stopped(done, all));
    }
    Ok(())
}

/// Leaves out the contact of a mass with a support at rest if the mass is requested, too. Both have the same motion, so
/// that a picture would show two equal rows.
fn one_row_of_contact(parts: &mut Vec<MovingPart>, scene: &Scene) {
    let at_rest = |node| match node {
        Node::Mass(_) => false,
        Node::Base => scene.excitation != Excitation::Base,
        Node::Wall => true,
    };
    let mass = match (scene.contact.from, scene.contact.to) {
        (Node::Mass(mass), other) | (other, Node::Mass(mass)) if at_rest(other) => Of::Mass(mass),
        _ => return,
    };
    let shown = |of: Of| move |part: &MovingPart| part.of == of && !part.has_rate();
    let Some(row) = parts.iter().position(shown(mass)) else {
        return;
    };
    let Some(contact) = parts.iter().position(shown(Of::Contact)) else {
        return;
    };
    if let Some(part) = parts.get_mut(row) {
        part.name = format!("{} ({})", part.name, scene.contact_name);
    }
    parts.remove(contact);
}

/// Returns one curve for each pair of friction ratio and initial state. After Ctrl-C, the curves whose computation has
/// not begun are `None`.
fn followed(
    system: &System,
    request: &CurveRequest,
    pairs: &[(f64, CurveStart)],
) -> Result<Vec<Option<Curve>>, Failure> {
    interrupt::watch();
    let progress = Mutex::new(Progress::silent(pairs.len(), "curves"));
    let found = system.curves_while(request, pairs, |done| {
        if let Ok(mut progress) = progress.lock() {
            progress.reach(done);
        }
        !interrupt::pressed()
    });
    found.map_err(Failure::new)
}

fn stopped(done: usize, all: usize) -> Failure {
    Failure::new(format_args!(
        "stopped: {done} of {all} curves are done and written"
    ))
}

/// Returns the initial states of the curves, each once, in the order of the options. The second result is the state
/// that the curves which start at rest have instead of the default.
fn starts(asked: &[String]) -> Result<(Vec<CurveStart>, Option<&str>), Failure> {
    if let Some(state) = asked.iter().find(|text| text.contains(';')) {
        return match asked {
            [_] => Ok((vec![CurveStart::Rest], Some(state))),
            _ => Err(Failure::new(format_args!(
                "--from `{state}`: give a state alone, without another --from"
            ))),
        };
    }
    let mut starts = Vec::new();
    for word in asked.iter().flat_map(|text| text.split(',')).map(str::trim) {
        let all = [CurveStart::Rest, CurveStart::Up, CurveStart::Down];
        let start = all.into_iter().find(|start| words::start(*start) == word);
        let start = start.ok_or_else(|| {
            Failure::new(format_args!(
                "--from `{word}`: write rest, up, down, or x1,...;v1,...: the displacements of all masses, a semicolon, their velocities"
            ))
        })?;
        if starts.contains(&start) {
            return Err(Failure::new(format_args!(
                "--from: `{word}` is given twice"
            )));
        }
        starts.push(start);
    }
    if starts.is_empty() {
        return Ok((vec![CurveStart::Rest], None));
    }
    Ok((starts, Some(from::REST)))
}
