//! Compares states for β > β*_lim with μ > 1, which motion from rest reaches, with `reference/several_states.json`.
//! Another program made the reference.

use frictiongen::System;
use serde_json::Value;

/// Tolerance. It allows for the error of the reference, which follows the motion for up to 900 cycles without Newton's
/// method.
const TOLERANCE: f64 = 1e-5;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn every_state_from_rest() {
    let text = include_str!("../../../reference/several_states.json");
    let scenes: Value = serde_json::from_str(text).expect("JSON");
    let (mut stuck, mut sliding, mut compared) = (0, 0, 0);
    let mut failures = Vec::new();
    for scene in scenes["above"].as_array().expect("scenes") {
        let text = scene["description"].as_str().expect("text");
        let system: System = text.parse().expect("a scene");
        for expected in scene["points"].as_array().expect("points") {
            let (r, beta) = (number(&expected["r"]), number(&expected["beta"]));
            let what = format!("{text}r = {r}, β = {beta}, {}", expected["state"]);
            let orbit = match system.at(r).expect("in the domain").orbit(beta) {
                Ok(orbit) => orbit,
                Err(error) => {
                    failures.push(format!("{what}: {error}"));
                    continue;
                }
            };
            let sticks = 1.0 - orbit.stuck_fraction() < 1e-12 && orbit.reversals() == 0;
            if expected["state"] == "stuck" {
                stuck += 1;
                if !sticks {
                    failures.push(format!("{what}: slides, stops {}", orbit.stops()));
                }
                continue;
            }
            sliding += 1;
            if sticks || orbit.stops() as u64 != expected["stops"].as_u64().expect("a count") {
                failures.push(format!("{what}: {sticks}, stops {}", orbit.stops()));
                continue;
            }
            let mut close = |found: f64, expected: f64, scale: f64| {
                compared += 1;
                if !((found - expected).abs() <= TOLERANCE * scale) {
                    failures.push(format!("{what}: {found} instead of {expected}"));
                }
            };
            close(
                orbit.stuck_fraction(),
                number(&expected["stuck_fraction"]),
                1.0,
            );
            let amplitudes = expected["amplitude"].as_array().expect("amplitudes");
            for (mass, expected) in amplitudes.iter().enumerate() {
                let expected = number(expected);
                let found = orbit.mass_at(mass).expect("a mass").amplitude();
                close(found, expected, expected);
            }
        }
    }
    assert!(
        failures.is_empty(),
        "{} fail:\n{}",
        failures.len(),
        failures.join("\n")
    );
    println!("{stuck} stuck, {sliding} sliding, {compared} values compared, none skipped");
    assert_eq!((stuck, sliding), (58, 57));
}
