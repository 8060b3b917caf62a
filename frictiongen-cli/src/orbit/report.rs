//! Writes steady states: a table line for each part that moves, a CSV line and a JSON object for
//! each point.

use super::point::{Movement, Point, answer};
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
pub struct OrbitReport {
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

/// What a point says once.
const ONCE: [&str; 10] = [
    "r",
    "beta",
    "regime",
    "state",
    "symmetry",
    "period",
    "stops",
    "reversals",
    "stuck_fraction",
    "largest_multiplier",
];

fn number(value: f64) -> Json {
    Value::from(value).json()
}

fn pair((first, second): (f64, f64)) -> Json {
    Json::from(vec![number(first), number(second)])
}

fn once(point: &Point) -> [Value<'_>; 10] {
    let orbit = point.orbit.as_ref();
    let period = orbit.and_then(|orbit| orbit.period.as_ref());
    let symmetry = |symmetric| if symmetric { "symmetric" } else { "asymmetric" };
    let or_none = |value: Option<Value<'static>>| value.unwrap_or(Value::Missing);
    [
        point.r.into(),
        point.beta.into(),
        point.regime.into(),
        point.state.into(),
        or_none(period.map(|period| symmetry(period.symmetric).into())),
        or_none(period.map(|period| period.cycles.into())),
        or_none(period.map(|period| period.stops.into())),
        or_none(period.map(|period| period.reversals.into())),
        orbit.map(|orbit| orbit.stuck_fraction).into(),
        orbit
            .and_then(super::point::Steady::largest_multiplier)
            .into(),
    ]
}

impl OrbitReport {
    /// The names of the parts that move.
    fn parts(&self) -> impl Iterator<Item = &str> {
        let masses = self.masses.iter().map(|mass| mass.name.as_str());
        std::iter::once(CONTACT).chain(masses)
    }

    /// Amplitude and phase; the same of each harmonic.
    fn values<'a>(&self, movement: Option<&Movement>) -> Vec<Value<'a>> {
        let Some(movement) = movement else {
            return vec![Value::Missing; 2 + 2 * self.orders.len()];
        };
        let mut values = vec![movement.amplitude.into(), movement.phase.into()];
        for harmonic in &movement.harmonics {
            let (amplitude, phase) = polar(*harmonic);
            values.extend([Value::from(amplitude), Value::from(phase)]);
        }
        values
    }

    fn object(&self, movement: &Movement) -> serde_json::Map<String, Json> {
        let mut fields = object([
            ("amplitude", number(movement.amplitude)),
            ("phase", number(movement.phase)),
        ]);
        if !self.orders.is_empty() {
            let orders = self.orders.iter().zip(&movement.harmonics);
            let harmonics = orders.map(|(order, harmonic)| {
                let (amplitude, phase) = polar(*harmonic);
                Json::Object(object([
                    ("n", Json::from(*order)),
                    ("re", number(harmonic.re)),
                    ("im", number(harmonic.im)),
                    ("amplitude", number(amplitude)),
                    ("phase", number(phase)),
                ]))
            });
            fields.insert("harmonics".to_owned(), harmonics.collect());
        }
        fields
    }
}

impl Report for OrbitReport {
    type Point = Point;

    fn len(&self) -> usize {
        self.r.len().saturating_mul(self.beta.len())
    }

    fn each(&self, visit: Visitor<'_, Point>) -> Result<(), Failure> {
        for &r in &self.r {
            let at = self.system.at(r).map_err(Failure::new)?;
            for &beta in &self.beta {
                let point = answer(&at, (r, beta), &self.masses, &self.orders);
                visit(&point.map_err(Failure::new)?)?;
            }
        }
        Ok(())
    }

    fn columns(&self, summary: &Summary) -> Vec<Column> {
        let unit = summary.amplitude();
        let mut columns = vec![
            Column::given(&["r"], &self.r),
            Column::given(&["beta"], &self.beta),
            Column::words(&["regime"], ["continuous"]),
            Column::words(&["state"], ["unsettled"]),
            Column::words(&["symmetry"], ["asymmetric"]),
            Column::counts(&["period", "(cycles)"]),
            Column::counts(&["stops"]),
            Column::counts(&["reversals"]),
            Column::computed(&["stuck", "(of period)"]),
            Column::computed(&["multiplier", "(largest)"]),
            Column::words(&["motion"], self.parts()),
            Column::computed(&["amplitude", unit]),
            Column::computed(&["phase", "(rad)"]),
        ];
        for order in &self.orders {
            columns.push(Column::computed(&[&format!("|X_{order}|"), unit]));
            columns.push(Column::computed(&[&format!("lag X_{order}"), "(rad)"]));
        }
        columns
    }

    fn rows<'a>(&'a self, point: &'a Point) -> Vec<Vec<Value<'a>>> {
        let first = once(point);
        let Some(orbit) = &point.orbit else {
            return vec![first.to_vec()];
        };
        let movements = self.parts().zip(&orbit.movements).enumerate();
        movements
            .map(|(index, (name, movement))| {
                let mut row = match index {
                    0 => first.to_vec(),
                    _ => vec![Value::Missing; first.len()],
                };
                row.push(name.into());
                row.extend(self.values(Some(movement)));
                row
            })
            .collect()
    }

    fn names(&self) -> Vec<String> {
        let mut names = ONCE.map(str::to_owned).to_vec();
        for part in self.parts() {
            names.push(format!("{part}.amplitude"));
            names.push(format!("{part}.phase"));
            for order in &self.orders {
                names.push(format!("{part}.X{order}.amplitude"));
                names.push(format!("{part}.X{order}.phase"));
            }
        }
        names
    }

    fn record<'a>(&'a self, point: &'a Point) -> Vec<Value<'a>> {
        let mut record = once(point).to_vec();
        let orbit = point.orbit.as_ref();
        for (index, _) in self.parts().enumerate() {
            let movement = orbit.and_then(|orbit| orbit.movements.get(index));
            record.extend(self.values(movement));
        }
        record
    }

    fn json(&self, point: &Point) -> Json {
        let fields = ONCE.into_iter().zip(once(point));
        let fields = fields.map(|(name, value)| (name.to_owned(), value.json()));
        let mut fields: serde_json::Map<String, Json> = fields.collect();
        let Some(orbit) = &point.orbit else {
            return Json::Object(fields);
        };
        let multipliers = orbit.multipliers.iter();
        let multipliers = multipliers.map(|value| pair((value.re, value.im)));
        fields.insert("multipliers".to_owned(), multipliers.collect());
        let sticking = orbit.sticking.iter().map(|interval| pair(*interval));
        fields.insert("sticking_intervals".to_owned(), sticking.collect());
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
