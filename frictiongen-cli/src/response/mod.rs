//! `frictiongen response`: regime and motion over frequency and friction.

mod point;
mod report;

use crate::args::ResponseArguments;
use crate::asked;
use crate::failure::Failure;
use crate::grid::Quantity;
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen_codegen::Limits;
use report::ResponseReport;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &ResponseArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let (r, beta) = asked::grids(&arguments.r, Quantity::FrequencyRatio, &arguments.beta)?;
    let orders = match asked::harmonics(arguments.harmonics.as_deref())? {
        Some(highest) => (1..=highest).step_by(2).collect(),
        None => Vec::new(),
    };
    let description = arguments.file.description(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let masses = asked::masses(&system, &arguments.mass)?;
    let summary = Summary::of(&system);
    let report = ResponseReport {
        system,
        r,
        beta,
        masses,
        orders,
    };
    output::print(&report, &summary, &arguments.format, out)
}
