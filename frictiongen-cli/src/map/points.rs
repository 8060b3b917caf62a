//! Writes the points of a map.

use crate::asked::Part;
use crate::failure::Failure;
use crate::frequency::{Frequencies, Frequency};
use crate::friction::{Friction, Frictions};
use crate::measure::{Dimension, Measure};
use crate::number::{Cell, Exact as _};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::study::{Map, MapPoint, words};
use frictiongen::{Error, System};
use serde_json::Value as Json;
use std::borrow::Cow;

/// The map with everything needed to write it.
pub struct MapReport {
    /// The system.
    pub system: System,
    /// The frequencies.
    pub frequencies: Frequencies,
    /// The frictions.
    pub frictions: Frictions,
    /// The units of the answers.
    pub measure: Measure,
    /// The motions whose amplitudes are written.
    pub parts: Vec<Part>,
    /// The map.
    pub map: Map,
}

/// A point with the name of its region.
pub struct Point {
    frequency: Frequency,
    friction: Friction,
    region: Cow<'static, str>,
    found: Result<MapPoint, Error>,
}

impl MapReport {
    /// Pairs the entries of the map with their frequencies, in order. A map that was cancelled lacks some frequencies.
    pub fn placed<'a, T>(
        &'a self,
        found: &'a [T],
        r: impl Fn(&T) -> f64 + 'a,
    ) -> impl Iterator<Item = (Frequency, &'a T)> {
        let mut frequencies = self.frequencies.iter(&self.system).peekable();
        found.iter().filter_map(move |found| {
            while frequencies.next_if(|at| at.r != r(found)).is_some() {}
            Some((*frequencies.peek()?, found))
        })
    }

    fn once<'a>(&self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut values = point.frequency.values();
        values.extend(point.friction.values());
        let found = point.found.as_ref().ok();
        let pattern = found.map(|found| found.pattern);
        let count = |value: Option<usize>| value.map_or(Cell::Missing, Cell::Count);
        // A motion that does not repeat has no counts.
        let counted = pattern.filter(|pattern| 0 < pattern.period);
        values.extend([
            pattern.map_or(Cell::Missing, |pattern| {
                words::regime(pattern.regime).into()
            }),
            Cell::from(&*point.region),
            count(counted.map(|pattern| pattern.period as usize)),
            count(counted.map(|pattern| pattern.stops)),
            count(counted.map(|pattern| pattern.reversals)),
            found.map(|found| found.stuck_fraction).into(),
            found
                .map(|found| self.measure.length(self.sign() * found.offset))
                .into(),
            found.map(|found| found.marginal).into(),
            found.map(|found| found.from_rest).into(),
        ]);
        values
    }

    /// Returns the sign with which the scene's contact moves.
    fn sign(&self) -> f64 {
        if self.measure.turns_contact() {
            -1.0
        } else {
            1.0
        }
    }

    fn once_names(&self) -> Vec<String> {
        let counts = vec![
            "regime",
            "region",
            "period",
            "stops",
            "reversals",
            "stuck_fraction",
        ];
        let names = [
            self.frequencies.names().to_vec(),
            self.frictions.names().to_vec(),
            counts,
        ]
        .concat();
        let mut names: Vec<String> = names.into_iter().map(str::to_owned).collect();
        names.push(self.measure.name("offset", Dimension::Length));
        names.extend(["marginal", "from_rest"].map(str::to_owned));
        names
    }

    fn amplitudes(&self, point: &Point) -> Vec<Cell<'static>> {
        let found = point.found.as_ref().ok();
        let places = 0..self.parts.len();
        places
            .flat_map(|index| {
                let sizes = found.map(|found| [&found.amplitudes, &found.centred]);
                let size = |which: usize| sizes?.get(which)?.get(index).copied();
                [size(0), size(1)].map(|size| size.map(|size| self.measure.length(size)).into())
            })
            .collect()
    }

    fn amplitude_names(&self) -> impl Iterator<Item = String> {
        let parts = self.parts.iter();
        parts.flat_map(|part| {
            ["amplitude", "centred"].map(|what| {
                self.measure
                    .name(&format!("{}.{what}", part.name), Dimension::Length)
            })
        })
    }
}

impl Report for MapReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.map.columns.len().saturating_mul(self.map.beta.len())
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for (frequency, column) in self.placed(&self.map.columns, |column| column.r) {
            for (friction, found) in self.frictions.iter().zip(&column.points) {
                let pattern = found.as_ref().map(|found| found.pattern);
                let pattern = pattern.map_err(|error| *error);
                visit(&Point {
                    frequency,
                    friction,
                    region: words::region(pattern),
                    found: found.clone(),
                })?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let mut columns = self.frequencies.columns();
        columns.extend(self.frictions.columns());
        columns.extend([
            Column::words(&["regime"], ["continuous"]),
            Column::words(&["region"], ["sliding reversals"]),
            Column::counts(&["period"]),
            Column::counts(&["stops"]),
            Column::counts(&["reversals"]),
            Column::computed(&["stuck"]),
        ]);
        let unit = self.measure.title(Dimension::Length);
        columns.extend([
            Column::computed(&["offset", unit]),
            Column::words(&["marginal"], ["false"]),
            Column::words(&["from", "rest"], ["false"]),
        ]);
        let parts = self.parts.iter();
        columns.extend(parts.flat_map(|part| {
            ["amplitude", "centred"].map(|what| Column::computed(&[&part.name, what, unit]))
        }));
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(point)]
    }

    fn names(&self) -> Vec<String> {
        let once = self.once_names().into_iter();
        once.chain(self.amplitude_names()).collect()
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Cell<'a>> {
        self.once(point)
            .into_iter()
            .chain(self.amplitudes(point))
            .collect()
    }

    fn json(&self, point: &Point) -> Json {
        let names = self.names().into_iter();
        let values = self.record(point).into_iter().map(|value| value.json());
        Json::Object(names.zip(values).collect())
    }
}
