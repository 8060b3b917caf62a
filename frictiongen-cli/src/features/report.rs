//! Writes features, one per line.

use super::lines::Line;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::measure::{Dimension, Measure};
use crate::number::{Cell, Exact as _, computed};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::System;
use frictiongen::study::{OperatingPoint, Parameter, Sensed};
use serde_json::Value as Json;

/// The features with everything needed to write them.
pub struct FeaturesReport<'s> {
    /// The system.
    pub system: &'s System,
    /// The range of frequencies.
    pub band: Band,
    /// The units of the answers.
    pub measure: Measure,
    /// The features.
    pub lines: Vec<Line>,
}

impl FeaturesReport<'_> {
    fn point(&self) -> OperatingPoint {
        match self.measure.load() {
            Some(load) => OperatingPoint::Physical {
                hertz: 1.0,
                friction: 1.0,
                load,
            },
            None => OperatingPoint::Groups { r: 1.0, beta: 1.0 },
        }
    }

    /// Returns the symbol of a parameter.
    pub fn symbol(&self, parameter: Parameter) -> String {
        parameter.symbol(self.system.scene(), &self.point())
    }

    /// Returns the parameter to which a line's first number is most sensitive: the number's name, the parameter, and
    /// the change in per cent for one per cent of the parameter.
    pub fn strongest(line: &Line) -> Option<(&'static str, Parameter, f64)> {
        let (name, sensed) = line.sensed.first()?;
        let (parameter, relative) = sensed.strongest()?;
        Some((name, parameter, relative))
    }

    fn cells<'a>(&self, line: &'a Line) -> Vec<Cell<'a>> {
        let mut values: Vec<Cell<'a>> = vec![
            line.feature.into(),
            line.of.as_str().into(),
            line.detail.as_str().into(),
        ];
        for place in [line.r, line.to] {
            if self.band.tells_hertz() {
                values.push(place.map(|r| self.system.hertz(r)).into());
            }
            values.push(place.into());
        }
        values.push(line.friction.into());
        values.push(line.amplitude.into());
        values.push(line.ground.name().into());
        values
    }

    fn derivatives(&self, sensed: &Sensed) -> Json {
        let each = sensed.slopes.iter().map(|slope| {
            let fields = [
                ("parameter", Json::from(self.symbol(slope.parameter))),
                ("value", Cell::from(slope.value).json()),
                ("derivative", Cell::from(slope.derivative).json()),
            ];
            fields
                .into_iter()
                .map(|(name, value)| (name.to_owned(), value))
                .collect::<Json>()
        });
        each.collect()
    }

    fn titles(&self) -> Vec<[String; 2]> {
        let mut titles = Vec::new();
        for (hertz, ratio) in [("at", "r"), ("to", "to r")] {
            if self.band.tells_hertz() {
                titles.push([hertz.to_owned(), "(Hz)".to_owned()]);
            }
            titles.push([ratio.to_owned(), String::new()]);
        }
        let force = if self.measure.scale().is_some() {
            "(N)"
        } else {
            "beta"
        }
        .to_owned();
        titles.push(["friction".to_owned(), force]);
        titles.push([
            "amplitude".to_owned(),
            self.measure.title(Dimension::Length).to_owned(),
        ]);
        titles
    }
}

impl Report for FeaturesReport<'_> {
    type Point = Line;

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn each(&self, visit: Visitor<'_, Line>) -> Result<(), Failure> {
        self.lines.iter().try_for_each(visit)
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        let [from, to] = [self.band.from, self.band.to];
        let ends = [from, to].map(computed);
        let mut text = format!("r from {} to {}", ends[0], ends[1]);
        if self.band.tells_hertz() {
            let hertz = [from, to].map(|r| computed(self.system.hertz(r)));
            text.push_str(&format!(", {} to {} Hz", hertz[0], hertz[1]));
        }
        let mut lines = vec![("range", text)];
        if self.system.modal().is_damped() {
            lines.push((
                "with damping",
                "there are no antiresonances, invariant points or inversions; two frictions can have the same \
                 amplitude at a frequency"
                    .to_owned(),
            ));
        }
        lines
    }

    fn columns(&self) -> Vec<Column> {
        let words =
            |title: &str, of: fn(&Line) -> &str| Column::words(&[title], self.lines.iter().map(of));
        let mut columns = vec![
            words("feature", |line| line.feature),
            words("of", |line| &line.of),
            words("what", |line| &line.detail),
        ];
        for [first, second] in self.titles() {
            columns.push(Column::computed(&[&first, &second]));
        }
        columns.push(words("found", |line| line.ground.name()));
        let named = |line: &Line| {
            Self::strongest(line).map_or(String::new(), |(_, parameter, _)| self.symbol(parameter))
        };
        let symbols: Vec<String> = self.lines.iter().map(named).collect();
        columns.push(Column::computed(&["% for", "1 % of"]));
        columns.push(Column::words(&[""], symbols.iter().map(String::as_str)));
        columns
    }

    fn rows<'a>(&'a self, line: &'a Line) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(line)]
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = ["feature", "of", "detail"].map(str::to_owned).to_vec();
        for (hertz, ratio) in [("frequency_Hz", "r"), ("to_frequency_Hz", "to_r")] {
            if self.band.tells_hertz() {
                names.push(hertz.to_owned());
            }
            names.push(ratio.to_owned());
        }
        names.push(
            if self.measure.scale().is_some() {
                "friction_N"
            } else {
                "beta"
            }
            .to_owned(),
        );
        names.push(self.measure.name("amplitude", Dimension::Length));
        names.push("found".to_owned());
        names.push("per_cent_for_one".to_owned());
        names.push("parameter".to_owned());
        names
    }

    fn record<'a>(&'a self, line: &'a Line) -> Vec<Cell<'a>> {
        let mut values = self.cells(line);
        match Self::strongest(line) {
            Some((_, parameter, relative)) => {
                values.push(relative.into());
                values.push(self.symbol(parameter).into());
            }
            None => values.extend([Cell::Missing, Cell::Missing]),
        }
        values
    }

    fn json(&self, line: &Line) -> Json {
        let names = self.names().into_iter();
        let cells = names.zip(self.cells(line));
        let mut object: serde_json::Map<String, Json> =
            cells.map(|(name, value)| (name, value.json())).collect();
        let derivatives = line
            .sensed
            .iter()
            .map(|(name, sensed)| ((*name).to_owned(), self.derivatives(sensed)));
        object.insert("derivatives".to_owned(), derivatives.collect());
        Json::Object(object)
    }
}
