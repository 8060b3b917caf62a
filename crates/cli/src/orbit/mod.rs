//! `frictiongen orbit`: computes the steady state over frequency and friction, in every regime.

mod report;

use crate::args::OrbitArguments;
use crate::asked;
#[cfg(feature = "pictures")]
use crate::asked::without_rates;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::grids::Grids;
use crate::joined;
use crate::measure;
use crate::output;
use crate::summary::Summary;
#[cfg(feature = "pictures")]
use crate::time;
use frictiongen::System;
use frictiongen_codegen::SizeLimits;
use report::OrbitReport;
pub use report::{at_point, does_not_settle, other_state};
use std::io::Write;

/// Runs `frictiongen orbit`.
pub fn run(arguments: &OrbitArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let destination = Destination::of(
        arguments.output.as_deref(),
        arguments.point.file.path(),
        &arguments.format,
        true,
    )?;
    let form = destination.form;
    let draws = form.is_picture();
    if draws && (arguments.states || arguments.harmonics.is_some()) {
        return Err(Failure::new(
            "a picture of `orbit` shows one period of one steady state; leave --states and --harmonics out, or write .csv",
        ));
    }
    let frequencies = Frequencies::parse(&arguments.point.frequency, true)?;
    let frictions = Frictions::parse(&arguments.point.friction, Some(&frequencies))?;
    let orders = match asked::harmonics(arguments.harmonics.as_deref())? {
        Some(highest) => (0..=highest).collect(),
        None => Vec::new(),
    };
    let description = arguments.point.file.any(&SizeLimits::RUN_TIME)?;
    if description.scene.has_joined_states() {
        let asked = joined::Asked::of(&arguments.point, frequencies, frictions, &arguments.of)
            .starting_from(arguments.start.from.as_deref())
            .with_harmonics(orders);
        return destination.write(out, |out| {
            #[cfg(feature = "pictures")]
            if draws {
                let period = joined::OfTime {
                    asked: time::asked::TimeRequest::PERIOD,
                    from: None,
                    until: None,
                    inputs: &[],
                    events: false,
                };
                return asked.time(description.scene, &period, form, out);
            }
            asked.write(description.scene, arguments.states, form, out)
        });
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let parts = asked::contact_and(&system, &arguments.of)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.point.load, &system)?;
    let system = from::started(arguments.start.from.as_deref(), system, &measure)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    #[cfg(feature = "pictures")]
    if draws {
        without_rates(&parts)?;
        let grids = (&frequencies, &frictions);
        let draw =
            |out: &mut dyn Write| time::draw_period((&system, measure), grids, parts, (form, out));
        return destination.write(out, draw);
    }
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let report = OrbitReport {
        grids: Grids {
            system,
            frequencies,
            frictions,
            measure,
            parts,
        },
        orders,
        states: arguments.states,
    };
    destination.write(out, |out| output::write(&report, &summary, form, out))
}
