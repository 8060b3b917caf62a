//! Rows and columns of the table of a response spectrum.

use crate::measure::{MeasureError, PeakResponse, Recording, periods, response_spectrum};
use crate::study::System;
use crate::study::columns::{Column, Columns, Head, Measure, PhysicalQuantity, TableRow};
use crate::study::units::hertz;

/// Row of the table: the peak response of one oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectrumRow {
    /// Number, from 1, of the scene's mode that has the period of the oscillator. `None` if no mode has this period.
    pub mode: Option<usize>,
    /// Natural period of the oscillator, and its largest displacement relative to the base.
    pub peak: PeakResponse,
}

impl TableRow for SpectrumRow {}

/// Computes the response spectrum of the recorded base motion, for oscillators with the damping ratio ζ: first at the
/// natural periods of the scene, and then over the whole range of periods.
///
/// # Errors
/// Same errors as [`response_spectrum`].
pub fn spectrum_rows(
    system: &System,
    recording: &Recording,
    zeta: f64,
) -> Result<Vec<SpectrumRow>, MeasureError> {
    let frequencies = system.natural_frequencies().into_iter();
    let own: Vec<f64> = frequencies.map(|omega| 1.0 / hertz(omega)).collect();
    let modes = response_spectrum(recording, zeta, &own)?.into_iter();
    let modes = modes.enumerate().map(|(index, peak)| SpectrumRow {
        mode: Some(index + 1),
        peak,
    });
    let others = response_spectrum(recording, zeta, &periods(recording))?.into_iter();
    let others = others.map(|peak| SpectrumRow { mode: None, peak });
    Ok(modes.chain(others).collect())
}

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
