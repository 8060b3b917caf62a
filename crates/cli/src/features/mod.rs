//! `frictiongen features`: lists the features of a scene's response, such as resonances, thresholds and peaks. The
//! command computes them directly, without a frequency sweep.

#[cfg(feature = "pictures")]
pub mod draw;
pub mod report;

use crate::args::{FeaturesArguments, FrequencyArguments, FrictionArguments};
use crate::asked::{self, MovingPart};
use crate::destination::Destination;
#[cfg(feature = "pictures")]
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::friction::Frictions;
use crate::joined;
use crate::measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::study::columns::FeaturesAsked;
use frictiongen::{Of, System};
use frictiongen_codegen::{Description, SizeLimits};
use report::FeaturesReport;
use std::io::Write;

/// Largest number of frictions in one call of `frictiongen features`.
const MOST_FRICTIONS: usize = 16;

/// Runs `frictiongen features`.
pub fn run(arguments: &FeaturesArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let destination = Destination::of(
        arguments.output.as_deref(),
        arguments.file.path(),
        &arguments.format,
        true,
    )?;
    let given = FrictionArguments {
        beta: arguments.beta.clone(),
        friction: arguments.friction.clone(),
    };
    let asked = given.beta.is_some() || given.friction.is_some();
    let frictions = asked.then(|| Frictions::parse(&given, None)).transpose()?;
    if frictions
        .as_ref()
        .is_some_and(|all| MOST_FRICTIONS < all.len())
    {
        return Err(Failure::new(format_args!(
            "at most {MOST_FRICTIONS} frictions are possible, because each has its own list"
        )));
    }
    let (description, is_joined) = described(arguments)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let frequency = FrequencyArguments {
        r: arguments.r.clone(),
        hz: arguments.hz.clone(),
        omega: arguments.omega.clone(),
    };
    let measure = measure::constant(&arguments.load, &system)?;
    let band = if frequency.r.is_none() && frequency.hz.is_none() && frequency.omega.is_none() {
        Band::about_resonances(&system, measure.load().is_some())
    } else {
        Band::parse(&frequency, &system)?
    };
    let band = band.under(&measure);
    if band.widest.is_some() {
        return Err(Failure::new(
            "a band is a:b, without a step, because all its features are listed",
        ));
    }
    let mut parts = match is_joined {
        true => {
            let masses = asked::masses(&system, "--of", &arguments.of)?;
            masses.into_iter().map(MovingPart::from).collect()
        }
        false => asked::parts(&system, &arguments.of)?,
    };
    asked::without_rates(&parts)?;
    if !is_joined && arguments.of.is_empty() && !system.modal().on_moving_base {
        // A mass that rubs on a fixed support has the same motion as the contact. The output therefore lists this
        // motion only once.
        let rubbing = system.modal().rubbing().map(Of::Mass);
        parts.retain(|part| Some(part.of) != rubbing);
    }
    let frictions = frictions
        .map(|frictions| frictions.under(&measure))
        .transpose()?;
    let frictions: Vec<f64> = frictions
        .iter()
        .flat_map(Frictions::all)
        .map(|friction| friction.beta)
        .collect();
    let summary = Summary::of(&system, band.is_physical(), measure);
    let asked = FeaturesAsked {
        range: [band.from, band.to],
        frictions: &frictions,
        peaks: true,
    };
    let table = report::table(&system, &band, measure, &parts);
    let lines = match is_joined {
        true => table.joined_rows(asked.range),
        false => {
            let features = system.features(measure.load()).map_err(Failure::new)?;
            table.rows(&features, asked)
        }
    };
    let lines = lines.map_err(Failure::new)?;
    let report = FeaturesReport {
        system: &system,
        band,
        measure,
        lines,
    };
    destination.write(out, |out| match destination.form {
        #[cfg(feature = "pictures")]
        OutputFormat::Svg | OutputFormat::Png => {
            draw::draw(&report, &parts, &frictions, destination.form, out)
        }
        form => output::write(&report, &summary, form, out),
    })
}

/// Reads the scene description. Returns true with it if the solver for several contacts computes its features. Fails
/// for options that need the features of a single contact.
fn described(arguments: &FeaturesArguments) -> Result<(Description, bool), Failure> {
    let description = arguments.file.any(&SizeLimits::RUN_TIME)?;
    let is_joined = description.scene.is_joined();
    if is_joined {
        joined::refused(&[
            (arguments.beta.is_some(), "--beta"),
            (arguments.friction.is_some(), "--friction"),
        ])?;
    } else {
        arguments.file.check_constant(&description)?;
    }
    Ok((description, is_joined))
}
