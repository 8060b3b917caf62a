//! Tests natural frequencies that are far apart, against references with 40 digits.

use frictiongen::study::System;
use frictiongen_kernel::Float;
use serde_json::Value;

/// Tolerance relative to each frequency, including frequencies many decades below the largest one.
const TOLERANCE: f64 = 1e-14;

pub fn references() -> Vec<Value> {
    serde_json::from_str(include_str!("../../../reference/extremes.json")).expect("JSON")
}

pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        value => value.as_f64().expect("a number"),
    }
}

pub fn list(value: &Value) -> &[Value] {
    value.as_array().map(Vec::as_slice).expect("a list")
}

fn worst<S: Float>() -> (f64, String) {
    let mut worst = (0.0, String::new());
    let mut compared = 0;
    for scene in references() {
        let text = scene["description"].as_str().expect("a description");
        let system: System<S> = text.parse().expect("a valid scene");
        let wanted = list(&scene["natural_frequency_ratios"]);
        assert_eq!(wanted.len(), system.resonances().len());
        for (got, want) in system.resonances().iter().zip(wanted) {
            let error = (got.to_f64() / number(want) - 1.0).abs();
            compared += 1;
            if !(error <= worst.0) {
                worst = (error, format!("{}: {got:?} for {want}", scene["name"]));
            }
        }
    }
    println!("{compared} compared, none skipped");
    assert_eq!(compared, 63);
    worst
}

#[test]
fn of_twelve_decades() {
    let (error, place) = worst::<f64>();
    println!("natural frequencies, f64: {error:.2e} {place}");
    assert!(error <= TOLERANCE, "{error:e} at {place}");
    // The constant is rounded once, so its error is at most half a unit of the last place.
    let (error, place) = worst::<f32>();
    println!("natural frequencies, f32: {error:.2e} {place}");
    assert!(
        error <= 0.5 * f64::from(f32::EPSILON) * 1.0001,
        "{error:e} at {place}"
    );
}
