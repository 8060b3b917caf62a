//! Reads the references, and pairs each with its system.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::{NoOrbit, System};
use serde_json::Value;

pub fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub fn count(value: &Value) -> usize {
    value.as_u64().expect("a count") as usize
}

fn references() -> Vec<Value> {
    serde_json::from_str(include_str!("../../../../reference/orbits_more.json")).expect("JSON")
}

/// A reference state, with its system and its r and β.
pub struct Point {
    pub expected: Value,
    pub system: System,
    pub r: f64,
    pub beta: f64,
    pub what: String,
}

impl Point {
    fn of(expected: Value) -> Self {
        let text = expected["description"].as_str().expect("text");
        let (r, beta) = (number(&expected["r"]), number(&expected["beta"]));
        Self {
            system: text.parse().expect("a scene"),
            r,
            beta,
            what: format!("{text}, r = {r}, β = {beta}"),
            expected,
        }
    }

    pub fn orbit(&self) -> Result<SystemOrbit<'_>, NoOrbit> {
        self.system
            .at(self.r)
            .expect("in the domain")
            .orbit(self.beta)
    }

    pub fn kind(&self) -> &str {
        self.expected["kind"].as_str().expect("a kind")
    }

    pub fn mu(&self) -> f64 {
        number(&self.expected["mu"])
    }
}

pub fn points(wanted: impl Fn(&Point) -> bool) -> Vec<Point> {
    let points: Vec<Point> = references().into_iter().map(Point::of).collect();
    let found: Vec<Point> = points.into_iter().filter(wanted).collect();
    assert!(!found.is_empty());
    found
}
