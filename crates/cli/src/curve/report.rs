//! Table of curves, with one line for each point. A curve consists of continuous pieces, and each line contains the
//! number of its piece.

#[cfg(feature = "pictures")]
use crate::args::LogAxes;
use crate::asked::MovingPart;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::friction::Frictions;
use crate::layout::Layout;
use crate::measure::Measure;
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::study::columns::{Column, CurveRow, CurveTable, FrictionSetting, Setting};
use frictiongen::study::curve::{Curve, CurveRequest};

/// Curves over frequency, with the options for the output.
pub struct CurveReport {
    /// The system that the results describe.
    pub system: System,
    /// Range of frequencies of the results.
    pub band: Band,
    /// Frictions of the results.
    pub frictions: Frictions,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
    /// The contact and masses whose motions the output contains.
    pub parts: Vec<MovingPart>,
    /// True if the output contains velocities and accelerations of every motion.
    pub rates: bool,
    /// The request from which the library computed the curves.
    pub request: CurveRequest,
    /// The curves, one for each friction and initial state.
    pub curves: Vec<(FrictionSetting, Curve)>,
    /// The axes of a picture that are logarithmic.
    #[cfg(feature = "pictures")]
    pub log: LogAxes,
    /// True if the user has requested curves with an initial state other than rest.
    pub swept: bool,
}

impl CurveReport {
    fn table(&self) -> CurveTable<'_> {
        CurveTable {
            setting: Setting {
                system: &self.system,
                measure: self.measure,
                frequency: self.band.unit(),
                frequencies: &[],
                frictions: self.frictions.given(),
                forces: self.frictions.are_forces(),
                parts: &self.parts,
            },
            starts: self.swept,
            rates: self.rates,
            orders: &self.request.harmonics,
        }
    }
}

impl ResultTable for CurveReport {
    type Row = CurveRow;

    fn len(&self) -> usize {
        let pieces = |curve: &'_ Curve| -> usize {
            let pieces = curve.pieces.iter();
            pieces.map(|piece| piece.points.len()).sum()
        };
        self.curves.iter().map(|(_, curve)| pieces(curve)).sum()
    }

    fn each(&self, visit: Visitor<'_, CurveRow>) -> Result<(), Failure> {
        let table = self.table();
        for (friction, curve) in &self.curves {
            table
                .rows(*friction, curve)
                .iter()
                .try_for_each(&mut *visit)?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, CurveRow>> {
        self.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lists
    }
}
