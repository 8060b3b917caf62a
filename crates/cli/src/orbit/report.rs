//! Table of steady states. The printed table has one line for each moving contact or mass. CSV has one line for each
//! point, and JSON one object.

use crate::failure::Failure;
use crate::grids::Grids;
use crate::layout::Layout;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, OrbitRow, OrbitTable};

/// Steady states over frequency and friction, with the options for the output.
pub struct OrbitReport {
    /// Grids, units, and the contact and masses whose motions the output contains.
    pub grids: Grids,
    /// Orders n of the harmonics in the output.
    pub orders: Vec<u32>,
    /// True if the output contains every steady state that the search finds. If false, the output contains only the
    /// steady state that motion from rest reaches.
    pub states: bool,
}

impl OrbitReport {
    fn table(&self) -> OrbitTable<'_> {
        OrbitTable {
            setting: self.grids.setting(),
            orders: &self.orders,
        }
    }
}

impl ResultTable for OrbitReport {
    type Row = OrbitRow;

    fn len(&self) -> usize {
        self.grids.len()
    }

    fn each(&self, visit: Visitor<'_, OrbitRow>) -> Result<(), Failure> {
        let (table, grids) = (self.table(), &self.grids);
        for frequency in grids.frequencies.all(&grids.system) {
            let at = grids.system.at(frequency.r).map_err(Failure::new)?;
            for friction in grids.frictions.all() {
                let mut rows = Vec::new();
                if self.states {
                    rows = table
                        .states(&at, frequency, friction)
                        .map_err(Failure::new)?;
                }
                // If the search finds no steady state, the table has a line with the reason.
                if rows.is_empty() {
                    let row = table.row(&at, frequency, friction);
                    rows.push(row.map_err(Failure::new)?);
                }
                rows.iter().try_for_each(&mut *visit)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, OrbitRow>> {
        self.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn has_motions(&self, row: &OrbitRow) -> bool {
        row.is_known()
    }
}
