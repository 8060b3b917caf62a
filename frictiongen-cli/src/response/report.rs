//! Writes responses: a table line for each moving part, and a CSV line and a JSON object for each point.

use super::point::{Movement, Point, Question};
use crate::asked::{CONTACT, Mass};
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::harmonics;
use crate::measure::{Dimension, Measure};
use crate::number::{Cell, Exact as _};
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::System;
use serde_json::Value as Json;

/// The responses with everything needed to write them.
pub struct ResponseReport {
    /// The system.
    pub system: System,
    /// The frequencies.
    pub frequencies: Frequencies,
    /// The frictions.
    pub frictions: Frictions,
    /// The units of the answers.
    pub measure: Measure,
    /// The masses to write.
    pub masses: Vec<Mass>,
    /// The orders of the harmonics.
    pub orders: Vec<u32>,
}

impl ResponseReport {
    /// Returns the names of the moving parts.
    fn parts(&self) -> impl Iterator<Item = &str> {
        let masses = self.masses.iter().map(|mass| mass.name.as_str());
        std::iter::once(CONTACT).chain(masses)
    }

    /// Returns the moving parts with their movements.
    fn movements<'a>(&'a self, point: &'a Point) -> impl Iterator<Item = (&'a str, &'a Movement)> {
        self.parts()
            .zip(std::iter::once(&point.contact).chain(&point.masses))
    }

    /// Returns amplitudes, phases and estimate of a movement, then amplitude and phase of each harmonic.
    fn values<'a>(&self, movement: &Movement) -> Vec<Cell<'a>> {
        let mut values = self.first(movement).to_vec();
        let mut harmonics = movement.harmonics.iter();
        for _ in &self.orders {
            let harmonic = harmonics.next();
            values.extend(harmonic.map_or([Cell::Missing, Cell::Missing], |harmonic| {
                harmonics::values(*harmonic, &self.measure)
            }));
        }
        values
    }

    /// Returns the amplitudes, phases and estimate of a movement.
    fn first(&self, movement: &Movement) -> [Cell<'static>; 5] {
        let measure = &self.measure;
        let swing = movement.swing;
        [
            swing.map(|swing| measure.length(swing.amplitude)).into(),
            movement.centred.map(|size| measure.length(size)).into(),
            swing
                .and_then(|swing| swing.phase)
                .map(|phase| measure.angle(phase))
                .into(),
            movement
                .fundamental_phase
                .map(|phase| measure.angle(phase))
                .into(),
            movement
                .monoharmonic
                .map(|size| measure.length(size))
                .into(),
        ]
    }

    /// Returns the names of the columns of [`first`](Self::first).
    fn first_names(&self) -> [String; 5] {
        [
            self.measure.name("amplitude", Dimension::Length),
            self.measure.name("centred", Dimension::Length),
            self.measure.name("phase", Dimension::Angle),
            self.measure.name("fundamental_phase", Dimension::Angle),
            self.measure
                .name("amplitude_monoharmonic", Dimension::Length),
        ]
    }

    fn object(&self, movement: &Movement) -> serde_json::Map<String, Json> {
        let values = self.first(movement).map(|value| value.json());
        let mut fields: serde_json::Map<String, Json> =
            self.first_names().into_iter().zip(values).collect();
        if !self.orders.is_empty() {
            let harmonics = match movement.harmonics.is_empty() {
                true => Json::Null,
                false => harmonics::json(&self.orders, &movement.harmonics, &self.measure),
            };
            fields.insert("harmonics".to_owned(), harmonics);
        }
        fields
    }

    /// Returns the values that a point has once.
    fn once<'a>(&self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut values: Vec<Cell<'a>> = point.frequency.values();
        values.extend(point.friction.values());
        values.extend([
            point.regime.into(),
            point.margin.into(),
            point.answer.into(),
            point
                .offset
                .map(|offset| self.measure.length(offset))
                .into(),
        ]);
        values
    }

    /// Returns the columns that only CSV and JSON have.
    fn flags(point: &Point) -> [Cell<'static>; 2] {
        [point.marginal.into(), point.from_rest.into()]
    }

    /// Returns the names of the columns that a point has once.
    fn once_names(&self) -> Vec<String> {
        let groups = [self.frequencies.names(), self.frictions.names()];
        let first = [groups.concat(), vec!["regime", "margin", "answer"]].concat();
        let mut names: Vec<String> = first.into_iter().map(str::to_owned).collect();
        names.push(self.measure.name("offset", Dimension::Length));
        names.extend(["marginal", "from_rest"].map(str::to_owned));
        names
    }
}

impl Report for ResponseReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.frequencies.len().saturating_mul(self.frictions.len())
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        let question = Question {
            masses: &self.masses,
            orders: &self.orders,
            turn_contact: self.measure.turns_contact(),
        };
        for frequency in self.frequencies.iter(&self.system) {
            let at = self.system.at(frequency.r).map_err(Failure::new)?;
            question.answers(&at, frequency, &self.frictions, visit)?;
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column> {
        let (unit, angle) = (
            self.measure.title(Dimension::Length),
            self.measure.title(Dimension::Angle),
        );
        let mut columns = self.frequencies.columns();
        columns.extend(self.frictions.columns());
        columns.extend([
            Column::words(&["regime"], ["continuous"]),
            Column::computed(&["margin"]),
            Column::words(&["answer"], ["orbit: marginal"]),
            Column::computed(&["offset", unit]),
            Column::words(&["motion"], self.parts()),
            Column::computed(&["amplitude", unit]),
            Column::computed(&["centred", unit]),
            Column::computed(&["phase", angle]),
            Column::computed(&["fundamental", angle]),
            Column::computed(&["monoharmonic", unit]),
        ]);
        columns.extend(harmonics::columns(&self.orders, &self.measure));
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        let first = self.once(point);
        let movements = self.movements(point);
        let mut rows: Vec<Vec<Cell<'a>>> = movements
            .filter(|(_, movement)| movement.swing.is_some())
            .map(|(name, movement)| {
                let mut row = vec![Cell::Missing; first.len()];
                row.push(name.into());
                row.extend(self.values(movement));
                row
            })
            .collect();
        match rows.first_mut() {
            Some(row) => row
                .iter_mut()
                .zip(first)
                .for_each(|(cell, value)| *cell = value),
            None => rows.push(first),
        }
        rows
    }

    fn names(&self) -> Vec<String> {
        let mut names = self.once_names();
        for part in self.parts() {
            let first = self.first_names().into_iter();
            names.extend(first.map(|name| format!("{part}.{name}")));
            names.extend(harmonics::names(part, &self.orders, &self.measure));
        }
        names
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Cell<'a>> {
        let mut record = self.once(point);
        record.extend(Self::flags(point));
        for (_, movement) in self.movements(point) {
            record.extend(self.values(movement));
        }
        record
    }

    fn json(&self, point: &Point) -> Json {
        let masses = self.masses.iter().zip(&point.masses);
        let masses = masses.map(|(mass, movement)| {
            let mut fields = self.object(movement);
            fields.insert("name".to_owned(), Json::from(mass.name.as_str()));
            Json::Object(fields)
        });
        let once = self.once(point).into_iter().chain(Self::flags(point));
        let once = once.map(|value| value.json());
        let names = self.once_names().into_iter();
        let mut fields: serde_json::Map<String, Json> = names.zip(once).collect();
        let contact = Json::Object(self.object(&point.contact));
        fields.insert(CONTACT.to_owned(), contact);
        fields.insert("masses".to_owned(), masses.collect());
        Json::Object(fields)
    }
}
