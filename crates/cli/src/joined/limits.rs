//! Writes the limits of several contacts.

use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::measure::Measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::columns::{Column, JoinedLimitsRow, JoinedTable, Setting};
use frictiongen::study::joined::JoinedError;
use std::io::Write;

/// Writes the limits of continuous motion and of sliding over frequency.
pub fn write(
    system: &System,
    (frequencies, measure): (Frequencies, Measure),
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let joined = system.joined().map_err(Failure::new)?;
    if !system.scene().has_linear_states() {
        return Err(Failure::new(JoinedError::NotLinear));
    }
    let setting = Setting {
        frequencies: frequencies.given(),
        ..Setting::new(system, measure, frequencies.unit())
    };
    let report = LimitsReport {
        table: JoinedTable {
            setting,
            joined: &joined,
            orders: None,
        },
        frequencies: &frequencies,
    };
    let summary = Summary::of(system, frequencies.are_physical(), measure);
    output::write(&report, &summary, form, out)
}

struct LimitsReport<'s> {
    table: JoinedTable<'s>,
    frequencies: &'s Frequencies,
}

impl ResultTable for LimitsReport<'_> {
    type Row = JoinedLimitsRow;

    fn len(&self) -> usize {
        self.frequencies.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedLimitsRow>) -> Result<(), Failure> {
        for frequency in self.frequencies.all(self.table.setting.system) {
            visit(&self.table.limits(frequency).map_err(Failure::new)?)?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, JoinedLimitsRow>> {
        self.table.limits_columns()
    }
}
