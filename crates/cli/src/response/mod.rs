//! `frictiongen response`: computes regime and motion over frequency and friction.

mod report;

use crate::args::ResponseArguments;
use crate::asked;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::grids::Grids;
use crate::joined;
use crate::measure;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen_codegen::SizeLimits;
use report::ResponseReport;
use std::io::Write;

/// Runs `frictiongen response`.
pub fn run(arguments: &ResponseArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let frequencies = Frequencies::parse(&arguments.point.frequency, false)?;
    let from = from::given(&arguments.start, &frequencies)?;
    let frictions = Frictions::parse(&arguments.point.friction, Some(&frequencies))?;
    let orders = match asked::harmonics(arguments.harmonics.as_deref())? {
        Some(highest) => (1..=highest).step_by(2).collect(),
        None => Vec::new(),
    };
    let description = arguments.point.file.any(&SizeLimits::RUN_TIME)?;
    if description.scene.has_joined_states() {
        let asked = joined::Asked::of(&arguments.point, frequencies, frictions, &arguments.of)
            .starting_from(from)
            .with_harmonics(orders);
        return asked.write(description.scene, false, arguments.format.checked()?, out);
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let parts = asked::contact_and(&system, &arguments.of)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.point.load, &system)?;
    let system = from::started(from, system, &measure)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let report = ResponseReport {
        grids: Grids {
            system,
            frequencies,
            frictions,
            measure,
            parts,
        },
        orders,
    };
    output::write(&report, &summary, arguments.format.checked()?, out)
}
