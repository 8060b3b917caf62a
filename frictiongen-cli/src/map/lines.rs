//! Writes the boundaries of a map.

use super::points::MapReport;
use crate::failure::Failure;
use crate::frequency::Frequency;
use crate::number::{Cell, Exact as _};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::study::{Boundary, words};
use serde_json::Value as Json;
use std::borrow::Cow;

/// The boundaries between the regions of a map, with the map itself.
pub struct BoundaryReport<'a> {
    /// The map.
    pub map: &'a MapReport,
    /// The boundaries, in the order of the frequencies, with ascending friction.
    pub boundaries: Vec<Boundary>,
}

/// A boundary with the names of the regions on its two sides.
pub struct Point {
    frequency: Frequency,
    beta: f64,
    width: f64,
    below: Cow<'static, str>,
    above: Cow<'static, str>,
}

impl Report for BoundaryReport<'_> {
    type Point = Point;

    fn len(&self) -> usize {
        self.boundaries.len()
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for (frequency, boundary) in self.map.placed(&self.boundaries, |boundary| boundary.r) {
            visit(&Point {
                frequency,
                beta: boundary.beta,
                width: boundary.width,
                below: words::region(boundary.below),
                above: words::region(boundary.above),
            })?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let mut columns = self.map.frequencies.columns();
        if self.map.measure.scale().is_some() {
            columns.push(Column::computed(&["friction", "(N)"]));
        }
        columns.extend([
            Column::computed(&["beta"]),
            Column::computed(&["width"]),
            Column::words(&["below"], ["sliding reversals"]),
            Column::words(&["above"], ["sliding reversals"]),
        ]);
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(point)]
    }

    fn names(&self) -> Vec<String> {
        let groups = [self.map.frequencies.names(), self.map.frictions.names()].concat();
        let all = groups.into_iter().chain(["width", "below", "above"]);
        all.map(str::to_owned).collect()
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut values = point.frequency.values();
        let force = self
            .map
            .measure
            .scale()
            .map(|scale| scale.friction(point.beta));
        values.extend(force.map(Cell::from));
        values.extend([point.beta, point.width].map(Cell::from));
        values.extend([Cell::from(&*point.below), Cell::from(&*point.above)]);
        values
    }

    fn json(&self, point: &Point) -> Json {
        let names = self.names().into_iter();
        let values = self.record(point).into_iter().map(|value| value.json());
        Json::Object(names.zip(values).collect())
    }
}
