//! `frictiongen map`: computes the regime of the contact over frequency and friction.

#[cfg(feature = "pictures")]
mod draw;
mod points;

use crate::args::{MapArguments, ShadeArgument};
use crate::asked;
use crate::destination::Destination;
#[cfg(feature = "pictures")]
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::grids::Grids;
use crate::interrupt;
use crate::joined;
use crate::measure;
use crate::output;
use crate::progress::Progress;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::map::MapRequest;
use frictiongen_codegen::SizeLimits;
use points::{BoundaryReport, MapReport};
use std::io::Write;
use std::sync::Mutex;

/// Largest number of significant digits that the user may request for a boundary.
const MOST_DIGITS: u32 = 12;

/// Runs `frictiongen map`.
pub fn run(arguments: &MapArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let destination = Destination::of(
        arguments.output.as_deref(),
        arguments.point.file.path(),
        &arguments.format,
        true,
    )?;
    let digits = arguments
        .boundaries
        .as_deref()
        .map(|text| asked::whole("--boundaries", text, 1..=MOST_DIGITS))
        .transpose()?;
    let frequencies = Frequencies::parse(&arguments.point.frequency, false)?;
    let from = from::given(&arguments.start, &frequencies)?;
    let frictions = Frictions::of_map(&arguments.point.friction, &frequencies)?;
    let description = arguments.point.file.any(&SizeLimits::RUN_TIME)?;
    if description.scene.has_joined_states() {
        joined::refused(&[
            (digits.is_some(), "--boundaries"),
            (arguments.shade == ShadeArgument::Stuck, "--shade stuck"),
        ])?;
        let asked = joined::Asked::of(&arguments.point, frequencies, frictions, &arguments.of)
            .starting_from(from);
        return destination.write(out, |out| match destination.form {
            #[cfg(feature = "pictures")]
            form @ (OutputFormat::Svg | OutputFormat::Png) => {
                let picture = joined::Picture::Map(arguments.shade);
                asked.draw(description.scene, picture, form, out)
            }
            form => asked.write(description.scene, false, form, out),
        });
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    frequencies.check(&system)?;
    let parts = asked::parts(&system, &arguments.of)?;
    asked::without_rates(&parts)?;
    let measure = measure::of(&arguments.point.load, &system)?;
    let system = from::started(from, system, &measure)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    let request = MapRequest {
        r: frequencies
            .all(&system)
            .map(|frequency| frequency.r)
            .collect(),
        beta: frictions.all().map(|friction| friction.beta).collect(),
        of: parts.iter().map(|part| part.of).collect(),
    };
    interrupt::watch();
    let progress = Mutex::new(Progress::silent(request.r.len(), "frequencies"));
    let map = system.map_under(&request, measure.fall(), |done| {
        if let Ok(mut progress) = progress.lock() {
            progress.reach(done);
        }
        !interrupt::pressed()
    });
    drop(progress);
    let map = map.map_err(Failure::new)?;
    let (done, asked) = (map.columns.len(), request.r.len());
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let boundaries = digits.map(|digits| system.boundaries(&map, digits));
    let report = MapReport {
        grids: Grids {
            system,
            frequencies,
            frictions,
            measure,
            parts,
        },
        map: &map,
    };
    destination.write(out, |out| match (destination.form, boundaries) {
        #[cfg(feature = "pictures")]
        (form @ (OutputFormat::Svg | OutputFormat::Png), boundaries) => {
            let boundaries = boundaries.unwrap_or_default();
            draw::draw(&report, &boundaries, arguments.shade, form, out)
        }
        (form, Some(boundaries)) => {
            let report = BoundaryReport {
                map: &report,
                boundaries,
            };
            output::write(&report, &summary, form, out)
        }
        (form, None) => output::write(&report, &summary, form, out),
    })?;
    if done < asked {
        return Err(Failure::new(format_args!(
            "stopped: {done} of {asked} frequencies are done and written"
        )));
    }
    Ok(())
}
