//! Compares motions in time with `reference/runs.json`: every segment, and the state after the last segment. The
//! reference comes from an integrator that shares no code with this project.

use super::independent::number;
use frictiongen::System;
use frictiongen::kernel::simulation::{Contact, Event};
use serde_json::Value;
use std::collections::BTreeMap;

/// Tolerance of the comparison. Both sides know the time of an event to about 1e-15 divided by the slope of the
/// function at the event. Each event inherits the error of the previous event. The tolerance is twenty times the
/// resulting error.
const TOLERANCE: f64 = 1e-10;

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(number).collect()
}

/// Collects the largest error of each kind of value, divided by the scale of that kind.
fn compare(expected: &Value, worst: &mut BTreeMap<&'static str, (f64, String)>) -> (usize, usize) {
    let text = expected["description"].as_str().expect("text");
    let (r, beta) = (number(&expected["r"]), number(&expected["beta"]));
    let system: System = text.parse().expect("a scene");
    let what = format!("{text}, r = {r}, β = {beta}");
    let masses = system.scene().masses.len();
    let mut run = if expected["start"].is_null() {
        system.simulation(r, beta)
    } else {
        let start = numbers(&expected["start"]);
        let (x, v) = start.split_at(masses);
        system.simulation_from(r, beta, (x, v))
    }
    .expect("in the domain");
    let mut note = |kind, error: f64| {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let worst = worst.entry(kind).or_insert((0.0, String::new()));
        if worst.0 <= error {
            *worst = (error, what.clone());
        }
    };
    let segments = expected["segments"].as_array().expect("segments");
    let (mut values, mut between) = (0, 0);
    for (index, segment) in segments.iter().enumerate() {
        let contact = match segment[0].as_i64().expect("a direction") {
            0 => Contact::Stuck,
            1 => Contact::Forward,
            _ => Contact::Backward,
        };
        let event = match segment[2].as_str().expect("an event") {
            "stop" => Event::Stop,
            "slip" => Event::Slip,
            _ => Event::Reversal,
        };
        assert_eq!(run.run().contact(), contact, "{what}: segment {index}");
        let mut length = 0.0;
        // The simulation returns a segment longer than a cycle in several pieces.
        let found = loop {
            let piece = run.next().expect("it never ends");
            assert_eq!(piece.contact, contact, "{what}: segment {index}");
            length += piece.length;
            if piece.event.is_some() {
                break piece.event;
            }
            assert!(length < 300.0, "{what}: segment {index} does not end");
        };
        assert_eq!(found, Some(event), "{what}: segment {index}");
        note("length", (length - number(&segment[1])).abs());
        between += usize::from(segment[3].as_bool().expect("a flag"));
        values += 1;
    }
    let (x, v) = (numbers(&expected["x"]), numbers(&expected["v"]));
    let largest = |values: &[f64]| {
        values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    // With a single mass the run ends in a stop, where the velocity is zero and has no scale of its own.
    let size = largest(&x).max(largest(&v));
    for (index, mass) in system.scene().masses.iter().enumerate() {
        let found = run.mass(&mass.name).expect("a mass");
        note(
            "displacement",
            (found.displacement() - x[index]).abs() / size,
        );
        note("velocity", (found.velocity() - v[index]).abs() / size);
        values += 2;
    }
    let friction = number(&expected["friction"]);
    note(
        "friction",
        (run.run().friction() - friction).abs() / (number(&expected["mu"]) * beta),
    );
    (values + 1, between)
}

#[test]
fn every_segment() {
    let runs: Vec<Value> =
        serde_json::from_str(include_str!("../../../reference/runs.json")).expect("JSON");
    let mut worst = BTreeMap::new();
    let (mut values, mut between) = (0, 0);
    for run in &runs {
        let (compared, rule) = compare(run, &mut worst);
        values += compared;
        between += rule;
    }
    println!(
        "{} runs, {values} values, {between} stops under forces between β and μβ, none skipped",
        runs.len()
    );
    for (kind, (error, place)) in &worst {
        println!("{kind}: {error:.1e} at {place}");
    }
    assert_eq!((runs.len(), values, between), (66, 1382, 69));
    for (kind, (error, place)) in &worst {
        assert!(*error <= TOLERANCE, "{kind}: {error:e} at {place}");
    }
}
