//! `frictiongen transmissibility`: finds driving frequency, transmissibility and phase in recordings.

use super::read;
use crate::args::TransmissibilityArguments;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::number::{Cell, Exact as _};
use crate::output::{self, Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use frictiongen::measure::Measured;
use frictiongen::study::scene::Excitation;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &TransmissibilityArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let files = &arguments.recordings;
    let output = arguments.output.as_deref();
    let destination = Destination::of(output, Some(&files.scene), &arguments.format, false)?;
    let system = read::scene(&files.scene)?;
    let measured = files.measured(&system)?;
    let mut masses: Vec<usize> = measured
        .iter()
        .flat_map(|measured| measured.masses.iter().map(|(mass, _)| *mass))
        .collect();
    masses.sort_unstable();
    masses.dedup();
    let summary = Summary::of(&system, true, Measure::groups(&system));
    let report = TransmissibilityReport {
        system,
        measured,
        masses,
    };
    destination.write(out, |out| {
        output::print(&report, &summary, destination.form, out)
    })
}

struct TransmissibilityReport {
    system: System,
    measured: Vec<Measured>,
    masses: Vec<usize>,
}

impl TransmissibilityReport {
    fn name(&self, mass: usize) -> &str {
        self.system
            .scene()
            .masses
            .get(mass)
            .map_or("", |mass| mass.name.as_str())
    }

    fn drive(&self) -> (&'static str, &'static str) {
        match self.system.scene().excitation {
            Excitation::Base => ("base", "m"),
            Excitation::Force(_) => ("force", "N"),
        }
    }
}

impl Report for TransmissibilityReport {
    type Point = Measured;

    fn len(&self) -> usize {
        self.measured.len()
    }

    fn each(&self, visit: Visitor<'_, Measured>) -> Result<(), Failure> {
        self.measured.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column> {
        let (drive, unit) = self.drive();
        let mut columns = vec![
            Column::computed(&["frequency", "(Hz)"]),
            Column::computed(&["steady", "from (s)"]),
            Column::computed(&[drive, &format!("({unit})")]),
        ];
        for mass in &self.masses {
            let name = self.name(*mass);
            columns.extend([
                Column::computed(&[name, "transmissibility"]),
                Column::computed(&[name, "lag (deg)"]),
                Column::computed(&[name, "deviation"]),
                Column::computed(&[name, "third harmonic"]),
            ]);
        }
        columns
    }

    fn rows<'a>(&'a self, point: &'a Measured) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(point)]
    }

    fn names(&self) -> Vec<String> {
        let (drive, unit) = self.drive();
        let mut names = vec![
            "frequency_Hz".to_owned(),
            "steady_from_s".to_owned(),
            format!("{drive}.amplitude_{unit}"),
        ];
        let parts = ["transmissibility", "lag_deg", "deviation", "third_harmonic"];
        for mass in &self.masses {
            names.extend(parts.map(|part| format!("{}.{part}", self.name(*mass))));
        }
        names
    }

    fn record<'a>(&'a self, point: &'a Measured) -> Vec<Cell<'a>> {
        let mut cells: Vec<Cell<'a>> = vec![
            point.hertz.into(),
            point.steady.0.into(),
            point.drive_amplitude().into(),
        ];
        for mass in &self.masses {
            let found = point.transmissibility(*mass);
            let third = point.harmonic(*mass, 3).map(|value| value.norm());
            cells.extend([
                found.map(|found| found.amplitude()).into(),
                found.map(|found| found.lag().to_degrees()).into(),
                found.map(|found| found.deviation).into(),
                third.into(),
            ]);
        }
        cells
    }

    fn json(&self, point: &Measured) -> serde_json::Value {
        self.names()
            .into_iter()
            .zip(self.record(point))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}
