//! Table of the largest values of the motion under a recorded input.

use crate::failure::Failure;
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::measure::columns::{PeakRow, peak_columns};
use frictiongen::study::columns::Column;

/// Largest values of the motion of a scene under a recorded input.
pub struct PeaksReport<'s> {
    pub system: &'s System,
    pub rows: Vec<PeakRow>,
}

impl ResultTable for PeaksReport<'_> {
    type Row = PeakRow;

    fn len(&self) -> usize {
        self.rows.len()
    }

    fn each(&self, visit: Visitor<'_, PeakRow>) -> Result<(), Failure> {
        self.rows.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, PeakRow>> {
        peak_columns(self.system, &self.rows)
    }
}
