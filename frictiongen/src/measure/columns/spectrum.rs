//! Rows and columns of the table of a response spectrum.

use crate::measure::PeakResponse;
use crate::study::System;
use crate::study::columns::{Column, Columns, Head, Measure, PhysicalQuantity, TableRow};

/// Row of the table: the peak response of one oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectrumRow {
    /// Number, from 1, of the scene's mode that has the period of the oscillator. `None` if no mode has this period.
    pub mode: Option<usize>,
    /// Natural period of the oscillator, and its largest displacement relative to the base.
    pub peak: PeakResponse,
}

impl TableRow for SpectrumRow {}

/// Returns the columns of the table, with their names and units.
#[must_use]
pub fn spectrum_columns(system: &System) -> Vec<Column<'static, SpectrumRow>> {
    let mut columns = Columns::new(&Measure::si(system));
    columns.count("mode", |row: &SpectrumRow| row.mode);
    columns.converted(Head::of("period", PhysicalQuantity::Time), |row| {
        Some(row.peak.period)
    });
    columns.converted(Head::of("frequency", PhysicalQuantity::Hertz), |row| {
        Some(1.0 / row.peak.period)
    });
    columns.converted(Head::of("displacement", PhysicalQuantity::Length), |row| {
        Some(row.peak.displacement)
    });
    columns.converted(
        Head::of("pseudo_velocity", PhysicalQuantity::Velocity),
        |row| Some(row.peak.displacement * row.peak.omega()),
    );
    columns.converted(
        Head::of("pseudo_acceleration", PhysicalQuantity::Acceleration),
        |row| Some(row.peak.displacement * row.peak.omega() * row.peak.omega()),
    );
    columns.done()
}
