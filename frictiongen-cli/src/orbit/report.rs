//! Writes steady states: a table line for each moving part, and a CSV line and a JSON object for each point.

use super::point::{Movement, Point, Question, Steady, answer, states};
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

/// The steady states with everything needed to write them.
pub struct OrbitReport {
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
    /// True if the user asked for every steady state; false for the one from rest.
    pub states: bool,
}

/// Columns that a point has once, besides frequency and friction.
const ONCE: [&str; 7] = [
    "regime",
    "state",
    "symmetry",
    "period",
    "stops",
    "reversals",
    "stuck_fraction",
];

fn number(value: f64) -> Json {
    Cell::from(value).json()
}

fn pair((first, second): (f64, f64)) -> Json {
    Json::from(vec![number(first), number(second)])
}

impl OrbitReport {
    /// Returns the values that a point has once.
    fn once<'a>(&self, point: &'a Point) -> Vec<Cell<'a>> {
        let orbit = point.orbit.as_ref();
        let period = orbit.and_then(|orbit| orbit.period.as_ref());
        let symmetry = |symmetric| if symmetric { "symmetric" } else { "asymmetric" };
        let or_none = |value: Option<Cell<'static>>| value.unwrap_or(Cell::Missing);
        let mut values: Vec<Cell<'a>> = point.frequency.values();
        values.extend(point.friction.values());
        values.extend([
            point.regime.into(),
            point.state.into(),
            or_none(period.map(|period| symmetry(period.symmetric).into())),
            or_none(period.map(|period| period.cycles.into())),
            or_none(period.map(|period| period.stops.into())),
            or_none(period.map(|period| period.reversals.into())),
            orbit.map(|orbit| orbit.stuck_fraction).into(),
        ]);
        if self.frequencies.tell_hertz() {
            let longest = orbit.and_then(Steady::longest_stop);
            let seconds = longest.map(|angle| self.seconds(point, angle));
            values.push(seconds.into());
        }
        values.push(orbit.and_then(Steady::largest_multiplier).into());
        values.push(orbit.map(|orbit| self.measure.length(orbit.offset)).into());
        values
    }

    /// Returns the columns that only CSV and JSON have.
    fn flags(point: &Point) -> [Cell<'static>; 2] {
        let orbit = point.orbit.as_ref();
        [
            orbit.map(|orbit| orbit.marginal).into(),
            orbit.map(|orbit| orbit.from_rest).into(),
        ]
    }

    /// Converts an angle of the excitation to seconds.
    fn seconds(&self, point: &Point, angle: f64) -> f64 {
        angle / self.system.angular_frequency(point.frequency.r)
    }

    /// Returns the names of the moving parts.
    fn parts(&self) -> impl Iterator<Item = &str> {
        let masses = self.masses.iter().map(|mass| mass.name.as_str());
        std::iter::once(CONTACT).chain(masses)
    }

    /// Returns amplitudes and phases of a movement, then amplitude and phase of each harmonic.
    fn values<'a>(&self, movement: Option<&Movement>) -> Vec<Cell<'a>> {
        let Some(movement) = movement else {
            return vec![Cell::Missing; 4 + 2 * self.orders.len()];
        };
        let mut values = self.first(movement).to_vec();
        let harmonics = movement.harmonics.iter();
        values.extend(harmonics.flat_map(|harmonic| harmonics::values(*harmonic, &self.measure)));
        values
    }

    /// Returns the amplitudes and phases of a movement.
    fn first(&self, movement: &Movement) -> [Cell<'static>; 4] {
        let measure = &self.measure;
        [
            measure.length(movement.amplitude).into(),
            measure.length(movement.centred).into(),
            measure.angle(movement.phase).into(),
            movement
                .fundamental_phase
                .map(|phase| measure.angle(phase))
                .into(),
        ]
    }

    /// Returns the names of the columns of [`first`](Self::first).
    fn first_names(&self) -> [String; 4] {
        [
            self.measure.name("amplitude", Dimension::Length),
            self.measure.name("centred", Dimension::Length),
            self.measure.name("phase", Dimension::Angle),
            self.measure.name("fundamental_phase", Dimension::Angle),
        ]
    }

    /// Returns the names of the columns that a point has once.
    fn once_names(&self) -> Vec<String> {
        let names = [self.frequencies.names(), self.frictions.names(), &ONCE].concat();
        let mut names: Vec<String> = names.into_iter().map(str::to_owned).collect();
        if self.frequencies.tell_hertz() {
            names.push("longest_stop_s".to_owned());
        }
        names.push("largest_multiplier".to_owned());
        names.push(self.measure.name("offset", Dimension::Length));
        names.extend(["marginal", "from_rest"].map(str::to_owned));
        names
    }

    fn object(&self, movement: &Movement) -> serde_json::Map<String, Json> {
        let values = self.first(movement).map(|value| value.json());
        let mut fields: serde_json::Map<String, Json> =
            self.first_names().into_iter().zip(values).collect();
        if !self.orders.is_empty() {
            let harmonics = harmonics::json(&self.orders, &movement.harmonics, &self.measure);
            fields.insert("harmonics".to_owned(), harmonics);
        }
        fields
    }
}

impl Report for OrbitReport {
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
            for friction in self.frictions.iter() {
                let asked = (frequency, friction);
                let points = match self.states {
                    true => states(&at, asked, &question),
                    false => answer(&at, asked, &question).map(|point| vec![point]),
                };
                for point in &points.map_err(Failure::new)? {
                    visit(point)?;
                }
            }
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
            Column::words(&["state"], ["unsettled"]),
            Column::words(&["symmetry"], ["asymmetric"]),
            Column::counts(&["period", "(cycles)"]),
            Column::counts(&["stops"]),
            Column::counts(&["reversals"]),
            Column::computed(&["stuck", "(of period)"]),
        ]);
        if self.frequencies.tell_hertz() {
            columns.push(Column::computed(&["longest", "stop (s)"]));
        }
        columns.extend([
            Column::computed(&["multiplier", "(largest)"]),
            Column::computed(&["offset", unit]),
            Column::words(&["motion"], self.parts()),
            Column::computed(&["amplitude", unit]),
            Column::computed(&["centred", unit]),
            Column::computed(&["phase", angle]),
            Column::computed(&["fundamental", angle]),
        ]);
        columns.extend(harmonics::columns(&self.orders, &self.measure));
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Cell<'a>>> {
        let first = self.once(point);
        let Some(orbit) = &point.orbit else {
            return vec![first];
        };
        let movements = self.parts().zip(&orbit.movements).enumerate();
        movements
            .map(|(index, (name, movement))| {
                let mut row = match index {
                    0 => first.clone(),
                    _ => vec![Cell::Missing; first.len()],
                };
                row.push(name.into());
                row.extend(self.values(Some(movement)));
                row
            })
            .collect()
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
        let orbit = point.orbit.as_ref();
        for (index, _) in self.parts().enumerate() {
            let movement = orbit.and_then(|orbit| orbit.movements.get(index));
            record.extend(self.values(movement));
        }
        record
    }

    fn json(&self, point: &Point) -> Json {
        let once = self.once(point).into_iter().chain(Self::flags(point));
        let fields = self.once_names().into_iter().zip(once);
        let fields = fields.map(|(name, value)| (name, value.json()));
        let mut fields: serde_json::Map<String, Json> = fields.collect();
        let Some(orbit) = &point.orbit else {
            return Json::Object(fields);
        };
        let multipliers = orbit.multipliers.iter();
        let multipliers = multipliers.map(|value| pair((value.re, value.im)));
        fields.insert("multipliers".to_owned(), multipliers.collect());
        let sticking = orbit.sticking.iter().map(|interval| pair(*interval));
        fields.insert("sticking_intervals".to_owned(), sticking.collect());
        if self.frequencies.tell_hertz() {
            let in_seconds = |angle| self.seconds(point, angle);
            let sticking = orbit.sticking.iter();
            let sticking =
                sticking.map(|(start, length)| pair((in_seconds(*start), in_seconds(*length))));
            fields.insert("sticking_intervals_s".to_owned(), sticking.collect());
        }
        let mut movements = orbit.movements.iter();
        if let Some(contact) = movements.next() {
            fields.insert(CONTACT.to_owned(), Json::Object(self.object(contact)));
        }
        let masses = self.masses.iter().zip(movements).map(|(mass, movement)| {
            let mut fields = self.object(movement);
            fields.insert("name".to_owned(), Json::from(mass.name.as_str()));
            Json::Object(fields)
        });
        fields.insert("masses".to_owned(), masses.collect());
        Json::Object(fields)
    }
}
