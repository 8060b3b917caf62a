//! Writes derivatives of steady states of scenes with several contacts.

use super::Question;
use crate::failure::Failure;
use crate::output::{ResultTable, Visitor};
use crate::sensitivity::each_row;
use frictiongen::study::columns::{
    Column, JoinedPart, JoinedSensitivityRow, JoinedSensitivityTable,
};

/// Derivatives of a steady state, with the options for the output.
pub struct SensitivityReport<'q> {
    /// Frequencies, frictions and units that the user has requested.
    pub(super) question: &'q Question<'q>,
    /// The mass or contact whose derivatives the user requests.
    pub of: &'q JoinedPart,
    /// True if the output has a line with the number itself before the lines with its derivatives.
    pub with_answers: bool,
}

impl SensitivityReport<'_> {
    fn table(&self) -> JoinedSensitivityTable<'_> {
        JoinedSensitivityTable {
            setting: self.question.table().setting,
            joined: self.question.joined,
            of: self.of,
        }
    }
}

impl ResultTable for SensitivityReport<'_> {
    type Row = JoinedSensitivityRow;

    fn len(&self) -> usize {
        let frequencies = self.question.frequencies.len();
        frequencies.saturating_mul(self.question.frictions.len())
    }

    fn each(&self, visit: Visitor<'_, JoinedSensitivityRow>) -> Result<(), Failure> {
        let (question, table) = (self.question, self.table());
        for frequency in question.frequencies.all(question.system) {
            for friction in question.frictions.all() {
                let rows = table.rows(frequency, friction).map_err(Failure::new)?;
                each_row(&rows, self.with_answers, visit)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, JoinedSensitivityRow>> {
        self.table().columns()
    }
}
