//! `frictiongen limits`: computes β_lim and β*_lim over the frequency ratio.

use crate::args::LimitsArguments;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::joined;
use crate::measure::{self, Measure};
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::columns::{Column, LimitsAsked, LimitsRow, LimitsTable, Setting};
use frictiongen_codegen::SizeLimits;
use std::io::Write;

/// Runs `frictiongen limits`.
pub fn run(arguments: &LimitsArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let frequencies = Frequencies::parse(&arguments.frequency, false)?;
    let description = arguments.file.any(&SizeLimits::RUN_TIME)?;
    arguments.file.check_constant(&description)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.load, &system)?;
    let frequencies = frequencies.under(&measure);
    if system.scene().is_joined() {
        let form = arguments.format.checked()?;
        return joined::limits(&system, (frequencies, measure), form, out);
    }
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let report = LimitsReport {
        system,
        frequencies,
        measure,
    };
    output::write(&report, &summary, arguments.format.checked()?, out)
}

struct LimitsReport {
    system: System,
    frequencies: Frequencies,
    measure: Measure,
}

impl LimitsReport {
    fn table(&self) -> LimitsTable<'_> {
        LimitsTable {
            setting: Setting {
                frequencies: self.frequencies.given(),
                ..Setting::new(&self.system, self.measure, self.frequencies.unit())
            },
            asked: LimitsAsked::All,
        }
    }
}

impl ResultTable for LimitsReport {
    type Row = LimitsRow;

    fn len(&self) -> usize {
        self.frequencies.len()
    }

    fn each(&self, visit: Visitor<'_, LimitsRow>) -> Result<(), Failure> {
        let table = self.table();
        for frequency in self.frequencies.all(&self.system) {
            visit(&table.row(frequency).map_err(Failure::new)?)?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, LimitsRow>> {
        self.table().columns()
    }
}
