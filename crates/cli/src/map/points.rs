//! Writes the points and the boundaries of a map.

use crate::failure::Failure;
use crate::grids::Grids;
use crate::layout::Layout;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{BoundaryRow, Column, MapRow, MapTable};
use frictiongen::study::map::{Boundary, Map};

/// A map of the regimes, with the options for the output.
pub struct MapReport<'m> {
    /// Grids, units, and the contact and masses whose motions the map contains.
    pub grids: Grids,
    /// The map that the command has computed.
    pub map: &'m Map,
}

/// The boundaries between the regions of a map, and the map itself.
pub struct BoundaryReport<'m> {
    /// The map to which the boundaries belong.
    pub map: &'m MapReport<'m>,
    /// The boundaries, in the order of their frequencies. The boundaries at one frequency are in ascending order of
    /// friction.
    pub boundaries: Vec<Boundary>,
}

impl MapReport<'_> {
    fn table(&self) -> MapTable<'_> {
        let setting = self.grids.setting();
        MapTable { setting }
    }
}

impl<'m> ResultTable for MapReport<'m> {
    type Row = MapRow<'m>;

    fn len(&self) -> usize {
        self.map.columns.len().saturating_mul(self.map.beta.len())
    }

    fn each(&self, visit: Visitor<'_, MapRow<'m>>) -> Result<(), Failure> {
        let frequencies = self.grids.frequencies.all(&self.grids.system);
        let frictions = self.grids.frictions.all();
        let mut rows = MapTable::rows(self.grids.measure, self.map, frequencies, frictions);
        rows.try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, MapRow<'m>>> {
        self.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lists
    }
}

impl ResultTable for BoundaryReport<'_> {
    type Row = BoundaryRow;

    fn len(&self) -> usize {
        self.boundaries.len()
    }

    fn each(&self, visit: Visitor<'_, BoundaryRow>) -> Result<(), Failure> {
        let grids = &self.map.grids;
        let frequencies = grids.frequencies.all(&grids.system);
        let mut rows = self.map.table().boundaries(&self.boundaries, frequencies);
        rows.try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, BoundaryRow>> {
        self.map.table().boundary_columns()
    }
}
