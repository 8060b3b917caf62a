//! Rows and columns of the table with the largest values of a motion.

use crate::study::System;
use crate::study::columns::{
    Column, Columns, Head, Measure, MovingPart, PhysicalQuantity, TableRow,
};
use crate::study::joined::Peak;

/// Row of the table: the largest absolute value of one quantity.
#[derive(Clone, Debug)]
pub struct PeakRow {
    /// Kinetic friction force in N, if the user gave it.
    pub friction: Option<f64>,
    /// The contact, the mass or the combination, with the quantity of its motion.
    pub part: MovingPart,
    /// The largest value and the value at the end, in SI units.
    pub peak: Peak,
}

impl TableRow for PeakRow {}

/// Returns the columns of the table of peaks.
#[must_use]
pub fn peak_columns<'a>(system: &System, rows: &[PeakRow]) -> Vec<Column<'a, PeakRow>> {
    let measure = Measure::si(system);
    let names = rows.iter().map(|row| row.part.name.as_str());
    let widest = names.max_by_key(|name| name.chars().count());
    let mut columns = Columns::new(&measure);
    if rows.iter().any(|row| row.friction.is_some()) {
        let head = Head::of("friction", PhysicalQuantity::Force);
        columns.converted(head, |row: &PeakRow| row.friction);
    }
    columns.word("quantity", widest.unwrap_or_default(), |row| {
        Some(&row.part.name)
    });
    columns.converted("peak", |row| Some(row.peak.value));
    let head = Head::of("time", PhysicalQuantity::Time);
    columns.converted(head, |row| Some(row.peak.time));
    columns.converted("end", |row| Some(row.peak.last));
    columns.word("unit", "m/s2", move |row| {
        Some(measure.unit(row.part.dimension()))
    });
    columns.done()
}
