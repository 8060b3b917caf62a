//! `frictiongen sensitivity`: computes derivatives of a response and of β_lim and β*_lim. The output has one line for
//! each parameter.

use crate::args::SensitivityArguments;
use crate::asked;
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::grids::Grids;
use crate::joined;
use crate::measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::study::StudyError;
use frictiongen::study::columns::{Column, SensitivityRow, SensitivityTable};
use frictiongen::{Of, System};
use frictiongen_codegen::SizeLimits;
use std::io::Write;

/// Runs `frictiongen sensitivity`.
pub fn run(arguments: &SensitivityArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let frequencies = Frequencies::parse(&arguments.point.frequency, true)?;
    let frictions = Frictions::parse(&arguments.point.friction, Some(&frequencies))?;
    let description = arguments.point.file.any(&SizeLimits::RUN_TIME)?;
    if description.scene.has_joined_states() {
        let asked = joined::Asked::of(&arguments.point, frequencies, frictions, &[]);
        let form = arguments.format.checked()?;
        return asked.write_sensitivities(description.scene, &arguments.of, form, out);
    }
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    let part = asked::part(&system, &arguments.of)?;
    asked::without_rates(std::slice::from_ref(&part))?;
    if part.of.is_force() {
        return Err(Failure::new(StudyError::ForceHasNoDerivative));
    }
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.point.load, &system)?;
    let frequencies = frequencies.under(&measure);
    let frictions = frictions.under(&measure)?;
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let form = arguments.format.checked()?;
    let report = SensitivityReport {
        of: part.of,
        grids: Grids {
            system,
            frequencies,
            frictions,
            measure,
            parts: vec![part],
        },
        with_answers: matches!(form, OutputFormat::Table(_)),
    };
    output::write(&report, &summary, form, out)
}

struct SensitivityReport {
    of: Of,
    grids: Grids,
    /// True if the output has a line with the results themselves before the lines with their derivatives.
    with_answers: bool,
}

impl SensitivityReport {
    fn table(&self) -> SensitivityTable<'_> {
        let setting = self.grids.setting();
        SensitivityTable { setting }
    }
}

impl ResultTable for SensitivityReport {
    type Row = SensitivityRow;

    fn len(&self) -> usize {
        self.grids.len()
    }

    fn each(&self, visit: Visitor<'_, SensitivityRow>) -> Result<(), Failure> {
        let (table, grids) = (self.table(), &self.grids);
        for frequency in grids.frequencies.all(&grids.system) {
            for friction in grids.frictions.all() {
                let point = table.setting.point(frequency, friction);
                let known = grids.system.response_sensitivities(point, self.of);
                let rows = table.rows(frequency, friction, known);
                let rows = rows.map_err(Failure::new)?;
                each_row(&rows, self.with_answers, visit)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, SensitivityRow>> {
        self.table().columns()
    }
}

/// Visits the rows of an operating point, which has one frequency and one friction. If `with_answers` is true, a row
/// with the results themselves comes before the rows with derivatives.
pub fn each_row<D: Clone>(
    rows: &[SensitivityRow<D>],
    with_answers: bool,
    visit: Visitor<'_, SensitivityRow<D>>,
) -> Result<(), Failure> {
    let first = rows.first().filter(|_| with_answers);
    if let Some(answers) = first.and_then(SensitivityRow::itself) {
        visit(&answers)?;
    }
    rows.iter().try_for_each(visit)
}
