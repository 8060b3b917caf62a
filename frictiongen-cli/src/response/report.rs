//! Writes responses: a table line for each part that moves, a CSV line and a JSON object for each
//! point.

use super::point::{Movement, Point, Question};
use crate::asked::{Mass, polar};
use crate::failure::Failure;
use crate::json::object;
use crate::number::Value;
use crate::output::{Report, Visitor};
use crate::summary::Summary;
use crate::table::Column;
use frictiongen::System;
use serde_json::Value as Json;

/// What is computed.
pub struct ResponseReport {
    /// Of which system.
    pub system: System,
    /// At which frequency ratios.
    pub r: Vec<f64>,
    /// At which friction ratios.
    pub beta: Vec<f64>,
    /// Of which masses.
    pub masses: Vec<Mass>,
    /// Which harmonics.
    pub orders: Vec<u32>,
}

/// What the contact is called; no mass can be.
const CONTACT: &str = "contact";

impl ResponseReport {
    /// The names of the parts that move.
    fn parts(&self) -> impl Iterator<Item = &str> {
        let masses = self.masses.iter().map(|mass| mass.name.as_str());
        std::iter::once(CONTACT).chain(masses)
    }

    /// The parts that move, with their movements.
    fn movements<'a>(&'a self, point: &'a Point) -> impl Iterator<Item = (&'a str, &'a Movement)> {
        self.parts()
            .zip(std::iter::once(&point.contact).chain(&point.masses))
    }

    /// Amplitude, phase, estimate; amplitude and phase of each harmonic.
    fn values<'a>(&self, movement: &Movement) -> Vec<Value<'a>> {
        let mut values = vec![
            movement.swing.map(|(amplitude, _)| amplitude).into(),
            movement.swing.map(|(_, phase)| phase).into(),
            movement.monoharmonic.into(),
        ];
        let mut harmonics = movement.harmonics.iter();
        for _ in &self.orders {
            let harmonic = harmonics.next().map(|harmonic| polar(*harmonic));
            values.push(harmonic.map(|(amplitude, _)| amplitude).into());
            values.push(harmonic.map(|(_, phase)| phase).into());
        }
        values
    }

    fn object(&self, movement: &Movement) -> serde_json::Map<String, Json> {
        let number = |value: Option<f64>| Value::from(value).json();
        let mut fields = object([
            ("amplitude", number(movement.swing.map(|(size, _)| size))),
            ("phase", number(movement.swing.map(|(_, phase)| phase))),
            ("amplitude_monoharmonic", number(movement.monoharmonic)),
        ]);
        if !self.orders.is_empty() {
            let orders = self.orders.iter().zip(&movement.harmonics);
            let harmonics = orders.map(|(order, harmonic)| {
                let (amplitude, phase) = polar(*harmonic);
                Json::Object(object([
                    ("n", Json::from(*order)),
                    ("re", number(Some(harmonic.re))),
                    ("im", number(Some(harmonic.im))),
                    ("amplitude", number(Some(amplitude))),
                    ("phase", number(Some(phase))),
                ]))
            });
            let harmonics = match movement.harmonics.is_empty() {
                true => Json::Null,
                false => harmonics.collect(),
            };
            fields.insert("harmonics".to_owned(), harmonics);
        }
        fields
    }
}

impl Report for ResponseReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.r.len().saturating_mul(self.beta.len())
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        let question = Question {
            masses: &self.masses,
            orders: &self.orders,
        };
        for &r in &self.r {
            let at = self.system.at(r).map_err(Failure::new)?;
            question.answers(&at, (r, &self.beta), visit)?;
        }
        Ok(())
    }

    fn columns(&self, summary: &Summary) -> Vec<Column> {
        let unit = summary.amplitude();
        let mut columns = vec![
            Column::given(&["r"], &self.r),
            Column::given(&["beta"], &self.beta),
            Column::words(&["regime"], ["continuous"]),
            Column::computed(&["margin"]),
            Column::words(&["answer"], ["orbit: marginal"]),
            Column::words(&["motion"], self.parts()),
            Column::computed(&["amplitude", unit]),
            Column::computed(&["phase", "(rad)"]),
            Column::computed(&["monoharmonic", unit]),
        ];
        for order in &self.orders {
            columns.push(Column::computed(&[&format!("|X_{order}|"), unit]));
            columns.push(Column::computed(&[&format!("lag X_{order}"), "(rad)"]));
        }
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Value<'a>>> {
        let first = [
            point.r.into(),
            point.beta.into(),
            point.regime.into(),
            point.margin.into(),
            point.answer.into(),
        ];
        let movements = self.movements(point);
        let mut rows: Vec<Vec<Value<'a>>> = movements
            .filter(|(_, movement)| movement.swing.is_some())
            .map(|(name, movement)| {
                let mut row = vec![Value::Missing; first.len()];
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
            None => rows.push(first.to_vec()),
        }
        rows
    }

    fn names(&self) -> Vec<String> {
        let mut names = ["r", "beta", "regime", "margin", "answer"]
            .map(str::to_owned)
            .to_vec();
        for part in self.parts() {
            for name in ["amplitude", "phase", "amplitude_monoharmonic"] {
                names.push(format!("{part}.{name}"));
            }
            for order in &self.orders {
                names.push(format!("{part}.X{order}.amplitude"));
                names.push(format!("{part}.X{order}.phase"));
            }
        }
        names
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Value<'a>> {
        let mut record = vec![
            point.r.into(),
            point.beta.into(),
            point.regime.into(),
            point.margin.into(),
            point.answer.into(),
        ];
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
        Json::Object(object([
            ("r", Value::from(point.r).json()),
            ("beta", Value::from(point.beta).json()),
            ("regime", Json::from(point.regime)),
            ("margin", Value::from(point.margin).json()),
            ("answer", Json::from(point.answer)),
            ("contact", Json::Object(self.object(&point.contact))),
            ("masses", masses.collect()),
        ]))
    }
}
