//! Writes the limits of several contacts.

use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::measure::Measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::columns::{Column, JoinedLimitsRow, JoinedTable, Setting};
use frictiongen::study::joined::Joined;
use std::io::Write;

/// Writes the limits of continuous motion and of sliding over frequency.
pub fn write(
    system: &System,
    (frequencies, measure): (Frequencies, Measure),
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let joined = system.joined().map_err(Failure::new)?;
    let summary = Summary::of(system, frequencies.are_physical(), measure);
    let report = LimitsReport {
        system,
        joined: &joined,
        frequencies,
        measure,
    };
    output::write(&report, &summary, form, out)
}

struct LimitsReport<'s> {
    system: &'s System,
    joined: &'s Joined<'s>,
    frequencies: Frequencies,
    measure: Measure,
}

impl LimitsReport<'_> {
    fn table(&self) -> JoinedTable<'_> {
        JoinedTable {
            setting: Setting {
                system: self.system,
                measure: self.measure,
                frequency: self.frequencies.unit(),
                frequencies: self.frequencies.given(),
                frictions: &[],
                forces: false,
                parts: &[],
            },
            joined: self.joined,
        }
    }
}

impl ResultTable for LimitsReport<'_> {
    type Row = JoinedLimitsRow;

    fn len(&self) -> usize {
        self.frequencies.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedLimitsRow>) -> Result<(), Failure> {
        let table = self.table();
        for frequency in self.frequencies.all(self.system) {
            visit(&table.limits(frequency).map_err(Failure::new)?)?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, JoinedLimitsRow>> {
        self.table().limits_columns()
    }
}
