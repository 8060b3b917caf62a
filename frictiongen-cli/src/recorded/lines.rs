//! Results as lines: a quantity, its value with an interval, and its unit.

use crate::failure::Failure;
use crate::number::{Cell, Exact as _};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::measure::Estimate;
use serde_json::Value as Json;

/// A quantity with its value, interval and unit.
pub struct Line {
    name: String,
    value: Cell<'static>,
    interval: Option<(f64, f64)>,
    unit: &'static str,
}

/// Quantities, and texts that come once.
#[derive(Default)]
pub struct Lines {
    lines: Vec<Line>,
    /// Titles and texts before the quantities.
    pub said: Vec<(&'static str, String)>,
}

impl Lines {
    /// Adds a number.
    pub fn number(&mut self, name: impl Into<String>, value: f64, unit: &'static str) {
        self.add(name.into(), value.into(), None, unit);
    }

    /// Adds a word.
    pub fn word(&mut self, name: impl Into<String>, word: &'static str) {
        self.add(name.into(), word.into(), None, "");
    }

    /// Adds a number with its interval, both multiplied by `scale`.
    pub fn estimate(
        &mut self,
        name: impl Into<String>,
        found: Estimate,
        scale: f64,
        unit: &'static str,
    ) {
        let interval = (found.from * scale, found.to * scale);
        self.add(
            name.into(),
            (found.value * scale).into(),
            Some(interval),
            unit,
        );
    }

    fn add(
        &mut self,
        name: String,
        value: Cell<'static>,
        interval: Option<(f64, f64)>,
        unit: &'static str,
    ) {
        self.lines.push(Line {
            name,
            value,
            interval,
            unit,
        });
    }
}

fn cells(line: &Line) -> Vec<Cell<'_>> {
    vec![
        line.name.as_str().into(),
        line.value.clone(),
        line.interval.map(|interval| interval.0).into(),
        line.interval.map(|interval| interval.1).into(),
        line.unit.into(),
    ]
}

impl Report for Lines {
    type Point = Line;

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn each(&self, visit: Visitor<'_, Line>) -> Result<(), Failure> {
        self.lines.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column> {
        vec![
            Column::words(
                &["quantity"],
                self.lines.iter().map(|line| line.name.as_str()),
            ),
            Column::computed(&["value"]),
            Column::computed(&["from", "(95 %)"]),
            Column::computed(&["to", "(95 %)"]),
            Column::words(&["unit"], ["rad/s"]),
        ]
    }

    fn rows<'a>(&'a self, line: &'a Line) -> Vec<Vec<Cell<'a>>> {
        vec![cells(line)]
    }

    fn names(&self) -> Vec<String> {
        ["quantity", "value", "from", "to", "unit"]
            .map(str::to_owned)
            .to_vec()
    }

    fn record<'a>(&'a self, line: &'a Line) -> Vec<Cell<'a>> {
        cells(line)
    }

    fn head(&self) -> Vec<(String, Json)> {
        self.said
            .iter()
            .map(|(title, text)| ((*title).to_owned(), Json::from(text.as_str())))
            .collect()
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        self.said.clone()
    }

    fn json(&self, line: &Line) -> Json {
        self.names()
            .into_iter()
            .zip(cells(line))
            .map(|(name, value)| (name, value.json()))
            .collect()
    }
}
