//! `frictiongen transmissibility`: finds driving frequency, transmissibility and phase in recordings.

use super::read;
use crate::args::TransmissibilityArguments;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::measure::Measured;
use frictiongen::measure::columns::TransmissibilityTable;
use frictiongen::study::columns::Column;
use std::io::Write;

/// Runs `frictiongen transmissibility`.
pub fn run(arguments: &TransmissibilityArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = &arguments.recordings;
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&files.scene), &arguments.format, false)?;
    let system = read::scene(&files.scene)?;
    let measured = files.measured(&system)?;
    let summary = Summary::of(&system, true, Measure::groups(&system));
    let report = TransmissibilityReport { system, measured };
    destination.write(out, |out| {
        output::write(&report, &summary, destination.form, out)
    })
}

struct TransmissibilityReport {
    system: System,
    measured: Vec<Measured>,
}

impl ResultTable for TransmissibilityReport {
    type Row = Measured;

    fn len(&self) -> usize {
        self.measured.len()
    }

    fn each(&self, visit: Visitor<'_, Measured>) -> Result<(), Failure> {
        self.measured.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, Measured>> {
        TransmissibilityTable::of(&self.system, &self.measured).columns()
    }
}
