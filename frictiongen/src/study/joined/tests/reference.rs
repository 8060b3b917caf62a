//! Compares results with the scenes in `joints.json`. A separate program wrote that file by matrix exponentials and
//! bisection.

use super::system;
use crate::answer::Event;
use serde_json::Value;
use std::f64::consts::TAU;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

fn word(value: &Value) -> &str {
    value.as_str().expect("a name")
}

fn read() -> Value {
    serde_json::from_str(include_str!("../../joints/tests/joints.json")).expect("JSON")
}

/// Returns the description of a scene in the file. The friction force of each contact becomes its share.
fn text(scene: &Value) -> String {
    let masses = list(&scene["masses"]).iter().enumerate();
    let masses: Vec<_> = masses
        .map(|(index, mass)| format!("m{}: {mass}", index + 1))
        .collect();
    let links = |value: &Value| -> String {
        let links = list(value).iter();
        let links =
            links.map(|link| format!("{} - {}: {}", word(&link[0]), word(&link[1]), link[2]));
        links.collect::<Vec<_>>().join(", ")
    };
    let contacts = list(&scene["contacts"]).iter().enumerate();
    let contacts = contacts.map(|(index, contact)| {
        let stiffness = match contact["stiffness"].as_f64() {
            Some(stiffness) => format!("stiffness: {stiffness:?}, "),
            None => String::new(),
        };
        let between = &contact["between"];
        format!(
            "c{index}: {} - {} {{ {stiffness}stiction: {}, share: {} }}",
            word(&between[0]),
            word(&between[1]),
            contact["stiction"],
            contact["force"],
        )
    });
    let damping = match numbers(&scene["rayleigh"]).as_slice() {
        [mass, stiffness] => format!("rayleigh({mass:?}, {stiffness:?})"),
        _ => format!("modal{}", scene["zeta"]),
    };
    let dampers = match list(&scene["dampers"]) {
        [] => String::new(),
        _ => format!("dampers: {{ {} }},", links(&scene["dampers"])),
    };
    format!(
        "struct Scene {{ masses: {{ {} }}, springs: {{ {} }}, contacts: {{ {} }}, {dampers} damping: {damping},
        excitation: {} }}",
        masses.join(", "),
        links(&scene["springs"]),
        contacts.collect::<Vec<_>>().join(", "),
        word(&scene["excitation"])
    )
}

/// Returns the events of a scene in `joints.json`: time, contact and kind of event.
fn events(scene: &Value) -> Vec<(f64, usize, Event)> {
    let mut events = Vec::new();
    for event in list(&scene["events"]) {
        let phases = numbers(&event["before"]).into_iter();
        let phases = phases.zip(numbers(&event["after"])).enumerate();
        for (contact, (before, after)) in phases {
            let kind = if before == after {
                continue;
            } else if after == 0.0 {
                Event::Stop
            } else if before == 0.0 {
                Event::Slip
            } else {
                Event::Reversal
            };
            events.push((number(&event["t"]), contact, kind));
        }
    }
    events
}

#[test]
fn events_and_states() {
    let (mut count, mut instants, mut states) = (0, 0.0_f64, 0.0_f64);
    for (index, scene) in list(&read()["scenes"]).iter().enumerate() {
        let system = system(&text(scene));
        let omega = number(&scene["omega"]);
        let joined = system.joined().expect("an answer");
        let at = joined.under(omega, number(&scene["load"])).expect("a load");
        let mut run = at.simulation(1.0).expect("a motion");
        let mut found = Vec::new();
        for (cycle, expected) in list(&scene["after_cycles"]).iter().enumerate() {
            let end = (cycle + 1) as f64 * TAU / omega;
            found.extend(run.advance_to(end).expect("a motion"));
            let (x, v) = run.state();
            for (got, expected) in [(x, &expected["x"]), (v, &expected["v"])] {
                let expected = numbers(expected);
                let size = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                for (got, expected) in got.iter().zip(&expected) {
                    let miss = (got - expected).abs() / size;
                    assert!(
                        miss < 1e-10,
                        "scene {index}, cycle {cycle}: {got} {expected}"
                    );
                    states = states.max(miss);
                }
            }
        }
        let expected = events(scene);
        assert_eq!(found.len(), expected.len(), "scene {index}");
        for (got, (time, contact, kind)) in found.iter().zip(expected) {
            let miss = (got.tau - omega * time).abs() / TAU;
            assert!(miss < 1e-10, "scene {index}: {got:?} at {time}");
            assert_eq!((got.contact, got.event), (contact, kind), "scene {index}");
            assert_eq!(got.name, format!("c{contact}"));
            instants = instants.max(miss);
            count += 1;
        }
    }
    println!("{count} events: {instants:.1e} of the period; states {states:.1e}");
    assert!(count > 200);
}

#[test]
fn steady_states() {
    let all = read();
    let scenes = list(&all["scenes"]).iter();
    let mut asked: Vec<(Value, Value)> = scenes
        .map(|scene| (scene.clone(), scene["steady"].clone()))
        .collect();
    for steady in list(&all["jenkins_chain"]["steady"]) {
        let mut scene = all["jenkins_chain"].clone();
        scene["omega"] = steady["omega"].clone();
        asked.push((scene, steady.clone()));
    }
    let (mut compared, mut worst) = (0, 0.0_f64);
    for (index, (scene, expected)) in asked.iter().enumerate() {
        let system = system(&text(scene));
        let joined = system.joined().expect("an answer");
        let at = joined.under(number(&scene["omega"]), number(&scene["load"]));
        // The reference follows the motion from rest, with what it leaves in contacts that never slide.
        let rest = vec![0.0; joined.scene().masses.len()];
        let orbit = at.expect("a load").orbit_from(1.0, (&rest, &rest));
        let orbit = orbit.expect("a steady state");
        assert_eq!(orbit.period(), 1, "scene {index}");
        let stuck = numbers(&expected["stuck_fraction"]);
        // The reference is accurate to 1e-9 only if its motion settles within 200 cycles.
        if expected["cycles_to_settle"]
            .as_f64()
            .is_some_and(|cycles| cycles >= 200.0)
        {
            continue;
        }
        let amplitudes = numbers(&expected["amplitude"]);
        let size = amplitudes.iter().fold(0.0_f64, |most, x| most.max(*x));
        for (place, expected) in amplitudes.iter().enumerate() {
            let got = orbit.largest_displacements()[place];
            let miss = (got - expected).abs() / size;
            assert!(miss < 1e-9, "scene {index}: {got} {expected}");
            worst = worst.max(miss);
        }
        for (place, expected) in stuck.iter().enumerate() {
            let contact = orbit.contact(&format!("c{place}")).expect("a contact");
            let got = contact.stuck_fraction();
            assert!(
                (got - expected).abs() < 1e-8,
                "scene {index}: {got} {expected}"
            );
        }
        for (place, stops) in list(&expected["stops"]).iter().enumerate() {
            let contact = orbit.contact(&format!("c{place}")).expect("a contact");
            assert_eq!(Value::from(contact.stops()), *stops, "scene {index}");
        }
        compared += 1;
    }
    println!("{compared} steady states: {worst:.1e}");
    assert!(compared >= 18, "{compared}");
}
