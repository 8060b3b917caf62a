//! Table of responses. The printed table has one line for each moving contact or mass. CSV has one line for each point,
//! and JSON one object.

use crate::failure::Failure;
use crate::grids::Grids;
use crate::layout::Layout;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, ResponseRow, ResponseTable};

/// The responses, with the settings for their output.
pub struct ResponseReport {
    /// Grids, units, and the contact and masses whose motions the output contains.
    pub grids: Grids,
    /// Orders n of the harmonics in the output.
    pub orders: Vec<u32>,
}

impl ResponseReport {
    fn table(&self) -> ResponseTable<'_> {
        ResponseTable {
            setting: self.grids.setting(),
            orders: &self.orders,
            stuck: false,
        }
    }
}

impl ResultTable for ResponseReport {
    type Row = ResponseRow;

    fn len(&self) -> usize {
        self.grids.len()
    }

    fn each(&self, visit: Visitor<'_, ResponseRow>) -> Result<(), Failure> {
        let (table, grids) = (self.table(), &self.grids);
        for frequency in grids.frequencies.all(&grids.system) {
            let rows = table.rows(frequency, grids.frictions.all());
            for row in rows.map_err(Failure::new)? {
                visit(&row)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, ResponseRow>> {
        self.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }
}
