//! Tables that compare measured values with computed values.

use super::drive_amplitude;
use crate::Complex;
use crate::measure::{Datum, Explained, FreeDecay, Identified, Observation, SweepFit, SweepPoint};
use crate::study::columns::{Column, Columns, Head, Measure, PhysicalQuantity, TableRow};
use crate::study::units::polar;
use crate::study::{System, words};

/// The quantities of a motion that a measurement contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKnown {
    /// The measurement contains the amplitude and the phase of the motion.
    Both,
    /// The measurement contains only the amplitude of the motion.
    Amplitude,
    /// The measurement contains only the phase of the motion.
    Phase,
}

/// Row of the table: a measured motion of one observation, and the motion that the scene computes.
#[derive(Clone, Copy, Debug)]
pub struct ResidualRow<'o> {
    recording: usize,
    seen: &'o Observation,
    point: &'o Explained,
    datum: &'o Datum,
    mass: &'o str,
    model: Complex<f64>,
    residual: Complex<f64>,
    known: MotionKnown,
}

/// Row of the table: one point of a sweep, and its residual (measured minus computed amplitude).
#[derive(Clone, Copy, Debug)]
pub struct FittedRow<'o> {
    point: &'o SweepPoint,
    mass: &'o str,
    residual: f64,
}

/// Row of the table: one extreme of a free vibration.
#[derive(Clone, Copy, Debug)]
pub struct ExtremeRow {
    time: f64,
    displacement: f64,
}

impl TableRow for ResidualRow<'_> {}

impl TableRow for FittedRow<'_> {}

impl TableRow for ExtremeRow {}

impl ResidualRow<'_> {
    /// Returns the residual of the measured quantity (complex value, amplitude or phase), divided by the standard
    /// deviation of that quantity.
    fn over_deviation(&self) -> f64 {
        let apart = match self.known {
            MotionKnown::Amplitude => (self.datum.value.norm() - self.model.norm()).abs(),
            MotionKnown::Phase => polar(self.datum.value * self.model.conj()).1.abs(),
            MotionKnown::Both => self.residual.norm(),
        };
        apart / self.datum.deviation
    }

    /// Returns the real or imaginary part `residual` of a residual, divided by the standard deviation of the motion.
    /// Returns `None` unless both the amplitude and the phase were measured.
    fn whole(&self, residual: f64) -> Option<f64> {
        (self.known == MotionKnown::Both).then(|| residual / self.datum.deviation)
    }
}

fn name(system: &System, mass: usize) -> &str {
    let mass = system.scene().masses.get(mass);
    mass.map_or("", |mass| mass.name.as_str())
}

/// Returns one table row for each motion of each observation. `known` has one entry for each observation: the
/// quantities that were measured.
#[must_use]
pub fn residuals<'o>(
    system: &'o System,
    observations: &'o [Observation],
    known: &[MotionKnown],
    found: &'o Identified,
) -> Vec<ResidualRow<'o>> {
    let mut rows = Vec::new();
    let each = observations.iter().zip(known).zip(&found.explained);
    for (index, ((seen, known), point)) in each.enumerate() {
        let residuals = found.residuals(observations, index);
        let motions = seen.motions.iter().zip(&point.model).zip(residuals);
        rows.extend(motions.map(|((datum, model), residual)| ResidualRow {
            recording: index + 1,
            seen,
            point,
            datum,
            mass: name(system, datum.mass),
            model: *model,
            residual,
            known: *known,
        }));
    }
    rows
}

/// Returns the columns of the table whose rows [`residuals`] returns.
#[must_use]
pub fn residual_columns<'o>(system: &System) -> Vec<Column<'o, ResidualRow<'o>>> {
    use PhysicalQuantity::Angle;
    let mut columns = Columns::new(&Measure::si(system));
    columns.count("recording", |row: &ResidualRow<'_>| Some(row.recording));
    let head = Head::of("frequency", PhysicalQuantity::Hertz);
    columns.number(head, |row| Some(row.seen.hertz));
    drive_amplitude(&mut columns, system, |row| {
        let size = row.seen.load.amplitude();
        Some(size)
    });
    columns.number("r", |row| Some(row.point.r));
    columns.number("beta", |row| Some(row.point.beta));
    columns.word("regime", "", |row| Some(words::regime(row.point.regime)));
    columns.word("of", "", |row| Some(row.mass));
    columns.count("harmonic", |row| Some(row.datum.harmonic as usize));
    columns.number("amplitude_measured", |row| {
        (row.known != MotionKnown::Phase).then(|| polar(row.datum.value).0)
    });
    columns.number("amplitude_computed", |row| Some(polar(row.model).0));
    columns.number(Head::of("lag_measured", Angle), |row| {
        (row.known != MotionKnown::Amplitude).then(|| polar(row.datum.value).1)
    });
    columns.number(Head::of("lag_computed", Angle), |row| {
        Some(polar(row.model).1)
    });
    columns.number("residual_over_deviation", |row| Some(row.over_deviation()));
    columns.number("residual_real", |row| row.whole(row.residual.re));
    columns.number("residual_imaginary", |row| row.whole(row.residual.im));
    columns.done()
}

/// Returns one table row for each point of a sweep, with the residual of the fit.
#[must_use]
pub fn fitted<'o>(
    system: &'o System,
    points: &'o [SweepPoint],
    found: &SweepFit,
) -> Vec<FittedRow<'o>> {
    let rows = points.iter().zip(&found.residuals);
    let rows = rows.map(|(point, residual)| FittedRow {
        point,
        mass: name(system, point.mass),
        residual: *residual,
    });
    rows.collect()
}

/// Returns the columns of the table whose rows [`fitted`] returns.
#[must_use]
pub fn fitted_columns<'o>(system: &System) -> Vec<Column<'o, FittedRow<'o>>> {
    let mut columns = Columns::new(&Measure::si(system));
    let head = Head::of("frequency", PhysicalQuantity::Hertz);
    columns.number(head, |row: &FittedRow<'_>| Some(row.point.hertz));
    columns.word("of", "", |row| Some(row.mass));
    columns.number("transmissibility", |row| Some(row.point.amplitude));
    columns.number("deviation", |row| row.point.deviation);
    columns.number("residual", |row| Some(row.residual));
    columns.done()
}

/// Returns one table row for each extreme of a free vibration.
#[must_use]
pub fn extremes(found: &FreeDecay) -> Vec<ExtremeRow> {
    let all = found.extremes.iter();
    let rows = all.map(|(time, displacement)| ExtremeRow {
        time: *time,
        displacement: *displacement,
    });
    rows.collect()
}

/// Returns the columns of the table whose rows [`extremes`] returns.
#[must_use]
pub fn extreme_columns<'o>(system: &System) -> Vec<Column<'o, ExtremeRow>> {
    let mut columns = Columns::new(&Measure::si(system));
    let head = Head::of("time", PhysicalQuantity::Time);
    columns.number(head, |row: &ExtremeRow| Some(row.time));
    let head = Head::of("displacement", PhysicalQuantity::Length);
    columns.number(head, |row| Some(row.displacement));
    columns.done()
}
