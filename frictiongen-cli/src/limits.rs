//! `frictiongen limits`: computes both limits over the frequency ratio.

use crate::args::LimitsArguments;
use crate::failure::Failure;
use crate::frequency::{Frequencies, Frequency};
use crate::measure;
use crate::number::{Cell, Exact as _};
use crate::output::{self, Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use frictiongen::study::LoadScale;
use frictiongen_codegen::Limits;
use std::io::Write;

/// Runs the command.
pub fn run(arguments: &LimitsArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let frequencies = Frequencies::parse(&arguments.frequency, false)?;
    let description = arguments.file.constant_level(&Limits::RUN_TIME)?;
    let system = System::try_from(description.scene).map_err(Failure::new)?;
    frequencies.check(&system)?;
    let measure = measure::of(&arguments.load, &system)?;
    let frequencies = frequencies.under(&measure);
    let summary = Summary::of(&system, frequencies.are_physical(), measure);
    let report = LimitsReport {
        system,
        frequencies,
        scale: measure.scale(),
    };
    output::print(&report, &summary, arguments.format.checked()?, out)
}

/// Names of the cells of the limits.
const LIMITS: [&str; 4] = [
    "continuous_limit",
    "continuous_limit_without_search",
    "continuous_limit_per_mode",
    "sliding_limit",
];

/// Headings of the limits, and their symbols as ratios.
const HEADINGS: [(&str, &str); 4] = [
    ("continuous limit", "beta_lim"),
    ("without search", "beta_lim"),
    ("per mode", "beta_lim"),
    ("sliding limit", "beta*_lim"),
];

struct LimitsReport {
    system: System,
    frequencies: Frequencies,
    scale: Option<LoadScale>,
}

/// The limits at one frequency.
struct Point {
    frequency: Frequency,
    /// The limits as ratios, in the order of [`LIMITS`].
    limits: [f64; 4],
}

impl LimitsReport {
    fn values(&self, point: &Point) -> Vec<Cell<'static>> {
        let mut values = point.frequency.values();
        if let Some(scale) = self.scale {
            values.extend(point.limits.map(|limit| Cell::from(scale.friction(limit))));
        }
        values.extend(point.limits.map(Cell::from));
        values
    }
}

impl Report for LimitsReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.frequencies.len()
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for frequency in self.frequencies.iter(&self.system) {
            let at = self.system.at(frequency.r).map_err(Failure::new)?;
            let limits = at.limits();
            visit(&Point {
                frequency,
                limits: [
                    limits.continuous,
                    at.continuous_limit_without_search(),
                    at.continuous_limit_per_mode(),
                    limits.sliding,
                ],
            })?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let mut columns = self.frequencies.columns();
        if self.scale.is_some() {
            columns.extend(HEADINGS.map(|(title, _)| Column::computed(&[title, "(N)"])));
        }
        columns.extend(HEADINGS.map(|(title, ratio)| Column::computed(&[title, ratio])));
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        vec![self.values(point)]
    }

    fn names(&self) -> Vec<String> {
        let frequency = self.frequencies.names().iter();
        let mut names: Vec<String> = frequency.map(|name| (*name).to_owned()).collect();
        if self.scale.is_some() {
            names.extend(LIMITS.map(|name| format!("{name}_N")));
        }
        names.extend(LIMITS.map(str::to_owned));
        names
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Cell<'a>> {
        self.values(point)
    }

    fn json(&self, point: &Point) -> serde_json::Value {
        let names = self.names().into_iter();
        names
            .zip(self.values(point))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}
