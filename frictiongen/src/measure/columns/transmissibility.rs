//! Table of the displacement transmissibilities of masses (amplitude of a mass divided by the amplitude of the base).

use super::drive_amplitude;
use crate::measure::Measured;
use crate::study::System;
use crate::study::columns::{Column, Columns, Head, Measure, PhysicalQuantity, TableRow};

/// The table of measured displacement transmissibilities. It has one row for each recording.
#[derive(Clone, Debug)]
pub struct TransmissibilityTable<'a> {
    system: &'a System,
    /// Indices of the recorded masses in the scene description, in ascending order.
    masses: Vec<usize>,
}

impl TableRow for Measured {}

impl<'a> TransmissibilityTable<'a> {
    /// Creates the table. It contains every mass that occurs in at least one of the recordings.
    #[must_use]
    pub fn of(system: &'a System, measured: &[Measured]) -> Self {
        let each = measured.iter().flat_map(|measured| &measured.masses);
        let mut masses: Vec<usize> = each.map(|(mass, _)| *mass).collect();
        masses.sort_unstable();
        masses.dedup();
        Self { system, masses }
    }

    /// Returns the columns of the table, with their names and units.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, Measured>> {
        let mut columns = Columns::new(&Measure::si(self.system));
        let head = Head::of("frequency", PhysicalQuantity::Hertz);
        columns.number(head, |row: &Measured| Some(row.hertz));
        let head = Head::of("steady_from", PhysicalQuantity::Time).titled(&["steady", "from (s)"]);
        columns.number(head, |row| Some(row.steady.0));
        drive_amplitude(&mut columns, self.system, |row| Some(row.drive_amplitude()));
        for mass in self.masses.iter().copied() {
            let named = self.system.scene().masses.get(mass);
            columns.begin_part(named.map_or("", |mass| mass.name.as_str()));
            columns.number("transmissibility", move |row| {
                Some(row.transmissibility(mass)?.amplitude())
            });
            let head = Head::of("lag", PhysicalQuantity::Angle).titled(&["lag (deg)"]);
            columns.number(head, move |row| Some(row.transmissibility(mass)?.lag()));
            columns.number("deviation", move |row| {
                Some(row.transmissibility(mass)?.deviation)
            });
            let head = Head::new("third_harmonic").titled(&["third harmonic"]);
            columns.number(head, move |row| Some(row.harmonic(mass, 3)?.norm()));
        }
        columns.done()
    }
}
