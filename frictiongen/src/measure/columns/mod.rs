//! Tables of measurements, with rows and columns as in [`study::columns`](crate::study::columns), and single values
//! with keys. All values are in SI units.

mod driven;
mod lines;
mod once;
mod peaks;
mod residuals;
mod spectrum;
mod transmissibility;

pub use driven::{DrivenSample, DrivenTable, driven_parts};
pub use lines::{QuantityLine, decay_lines, fit_lines, identify_lines, line_columns, motion_lines};
pub use once::{Keyed, SingleValue, decay_values, fit_values, identify_values, motion_values};
pub use peaks::{PeakQuantities, PeakRow, peak_columns};
pub use residuals::{
    ExtremeRow, FittedRow, MotionKnown, ResidualRow, extreme_columns, extremes, fitted,
    fitted_columns, residual_columns, residuals,
};
pub use spectrum::{SpectrumRow, spectrum_columns, spectrum_rows};
pub use transmissibility::TransmissibilityTable;

use crate::study::System;
use crate::study::columns::{Columns, Head, Measure, PhysicalQuantity, TableRow};
use crate::study::scene::Excitation;

/// Returns the name of the excitation in the table, and its physical quantity: displacement or force.
fn drive(system: &System) -> (&'static str, PhysicalQuantity) {
    match system.scene().excitation {
        Excitation::Base => ("base", PhysicalQuantity::Length),
        Excitation::Force(_) => ("force", PhysicalQuantity::Force),
    }
}

/// Adds the column with the amplitude of the excitation, in m or N.
fn drive_amplitude<'a, R: TableRow + 'a>(
    columns: &mut Columns<'a, R>,
    system: &System,
    read: impl Fn(&R) -> Option<f64> + 'a,
) {
    let (name, dimension) = drive(system);
    let title = Measure::si(system).title(dimension);
    let name = format!("{name}.amplitude");
    let (short, _) = drive(system);
    columns.number(Head::of(name, dimension).titled(&[short, title]), read);
}
