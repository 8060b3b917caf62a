//! Writes steady states of a scene with several contacts. The table has one line for each contact and each mass.

use super::Question;
use crate::failure::Failure;
use crate::layout::Layout;
use crate::orbit::{at_point, does_not_settle, other_state};
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, JoinedRow};

/// Steady states of a scene with several contacts, with the options for the output.
pub struct JoinedReport<'q> {
    /// Frequencies, frictions, units and masses that the user has requested.
    pub(super) question: &'q Question<'q>,
    /// True if the user requests every steady state at each frequency and friction.
    pub states: bool,
}

impl ResultTable for JoinedReport<'_> {
    type Row = JoinedRow;

    fn len(&self) -> usize {
        let frequencies = self.question.frequencies.len();
        frequencies.saturating_mul(self.question.frictions.len())
    }

    fn each(&self, visit: Visitor<'_, JoinedRow>) -> Result<(), Failure> {
        let (question, table) = (self.question, self.question.table());
        let frequencies: Vec<_> = question.frequencies.all(question.system).collect();
        let frictions: Vec<_> = question.frictions.all().collect();
        if !self.states {
            return table.rows(&frequencies, &frictions, |rows| {
                rows.iter().try_for_each(&mut *visit)
            });
        }
        for frequency in frequencies {
            for friction in &frictions {
                let states = table.states(frequency, *friction).map_err(Failure::new)?;
                states.iter().try_for_each(&mut *visit)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, JoinedRow>> {
        self.question.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn has_motions(&self, row: &JoinedRow) -> bool {
        row.is_known()
    }

    fn note(&self, row: &JoinedRow) -> Option<String> {
        let mut said = vec![does_not_settle(row.cycles_followed()?)];
        if row.kind().is_some() {
            said.push(other_state(row.regime).to_owned());
        }
        Some(at_point((row.frequency.r, row.friction.beta), &said))
    }
}
