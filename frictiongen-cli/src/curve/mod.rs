//! `frictiongen curve`: responses along frequency in every regime.

#[cfg(feature = "pictures")]
mod draw;
mod report;

use crate::args::CurveArguments;
use crate::asked;
use crate::destination::Destination;
#[cfg(feature = "pictures")]
use crate::destination::Form;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::friction::Frictions;
use crate::measure::Measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::CurveRequest;
use frictiongen_codegen::Limits;
use report::CurveReport;
use std::io::Write;

/// Runs the command.
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
    let frictions = Frictions::parse(&arguments.point.friction, None)?;
    let description = arguments.point.file.constant_level(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let band = Band::parse(&arguments.point.frequency, &system)?;
    let parts = asked::parts(&system, &arguments.of)?;
    let measure = Measure::of(&arguments.point.load, &system)?;
    let band = band.under(&measure);
    let frictions = frictions.under(&measure)?;
    let of: Vec<_> = parts.iter().map(|part| part.of).collect();
    let mut request = CurveRequest {
        widest: band.widest,
        harmonics: orders,
        rates: arguments.rates,
        turned: measure.turns_contact(),
        ..CurveRequest::new(band.from, band.to, &of)
    };
    if let Some(text) = &arguments.accuracy {
        request.accuracy = asked::number("--accuracy", text)?;
    }
    let curve = |friction: crate::friction::Friction| {
        Ok((
            friction,
            system
                .curve(&request, friction.beta)
                .map_err(Failure::new)?,
        ))
    };
    let curves = frictions
        .iter()
        .map(curve)
        .collect::<Result<Vec<_>, Failure>>()?;
    let summary = Summary::of(&system, band.is_physical(), measure);
    let report = CurveReport {
        system,
        band,
        frictions,
        measure,
        parts,
        request,
        curves,
    };
    destination.write(out, |out| match destination.form {
        #[cfg(feature = "pictures")]
        Form::Svg | Form::Png => draw::draw(&report, destination.form, out),
        form => output::print(&report, &summary, form, out),
    })
}
