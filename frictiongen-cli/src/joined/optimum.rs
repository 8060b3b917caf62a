//! Finds the best common friction of several contacts.

use super::refused;
use crate::args::OptimumArguments;
use crate::asked;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::layout::Layout;
use crate::measure;
use crate::number::computed;
use crate::output::{self, Table, Visitor};
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::columns::{
    Column, Frequency, Friction, JoinedRow, JoinedTable, Measure, Setting,
};
use frictiongen::study::joined::JoinedOptimum;
use frictiongen::study::scene::Scene;
use std::io::Write;

/// Finds the common friction with which the largest amplitude of a mass over a band is smallest. Writes the steady state
/// at the frequency of this amplitude.
pub fn optimum(
    arguments: &OptimumArguments,
    scene: Scene,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    refused(&[
        (arguments.vary.is_some(), "--vary"),
        (!arguments.keep.is_empty(), "--keep"),
        (1 < arguments.of.len(), "a second --of"),
    ])?;
    let system = System::try_from(scene).map_err(Failure::new)?;
    let joined = system.joined().map_err(Failure::new)?;
    let band = Band::parse(&arguments.frequency, &system)?;
    if band.widest.is_some() {
        return Err(Failure::new(
            "a band is a:b, without a step, because the search covers all its frequencies",
        ));
    }
    let measure = measure::constant(&arguments.load, &system)?;
    let band = band.under(&measure);
    let masses = asked::masses(&system, "--of", &arguments.of)?;
    let all: Vec<usize> = (0..system.scene().masses.len()).collect();
    let table = JoinedTable {
        setting: Setting {
            system: &system,
            measure,
            frequency: band.unit(),
            frequencies: &[],
            frictions: &[],
            forces: false,
            parts: &[],
        },
        joined: &joined,
        masses: &all,
    };
    // Without a spring, this fails unless the units are physical.
    table
        .at(Frequency::at(&system, band.from))
        .map_err(Failure::new)?;
    let name = masses.first().map_or("", |mass| mass.name.as_str());
    let found = joined.optimum(name, (band.from, band.to));
    let found = found.map_err(Failure::new)?;
    let friction = Friction::of_ratio(found.friction, measure.scale());
    let row = table.row(Frequency::at(&system, found.r), friction);
    let report = OptimumReport {
        table,
        row: row.map_err(Failure::new)?,
        found,
        measure,
        name,
    };
    let summary = Summary::of(&system, band.is_physical(), measure);
    output::write(&report, &summary, arguments.format.checked()?, out)
}

struct OptimumReport<'a> {
    table: JoinedTable<'a>,
    row: JoinedRow,
    found: JoinedOptimum,
    measure: Measure,
    name: &'a str,
}

impl Table for OptimumReport<'_> {
    type Row = JoinedRow;

    fn len(&self) -> usize {
        1
    }

    fn each(&self, visit: Visitor<'_, JoinedRow>) -> Result<(), Failure> {
        visit(&self.row)
    }

    fn columns(&self) -> Vec<Column<'_, JoinedRow>> {
        self.table.columns()
    }

    fn layout(&self) -> Layout {
        Layout::Joints
    }

    fn head(&self) -> Vec<(String, serde_json::Value)> {
        vec![
            ("of".to_owned(), self.name.into()),
            (
                "best_friction".to_owned(),
                self.measure.force(self.found.friction).into(),
            ),
            (
                "largest_amplitude".to_owned(),
                self.measure.length(self.found.amplitude).into(),
            ),
            ("steady_states".to_owned(), self.found.evaluations.into()),
        ]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        let (friction, amplitude) = (
            computed(self.measure.force(self.found.friction)),
            computed(self.measure.length(self.found.amplitude)),
        );
        let text = format!(
            "{friction}, with the largest amplitude {amplitude} of {} in the band; {} steady states",
            self.name, self.found.evaluations
        );
        vec![("best common friction", text)]
    }
}
