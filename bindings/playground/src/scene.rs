//! Answers questions about the description: its system, or messages about its faults.

use crate::numbers::numbers;
use crate::question::{Question, read};
use frictiongen::System;
use frictiongen::study::scene::{Excitation, Node, Scene};
use frictiongen_plot::{Label, Sketch, Spring, desk};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// Returns the numbers and the sketch of the described system, or the messages about faults of the description.
pub fn answer(question: &Question) -> Value {
    match read(&question.text) {
        Ok(system) => chain(&system, &question.text),
        Err(faults) => {
            let faults = faults.iter().map(|fault| {
                json!({ "line": fault.line, "column": fault.column, "message": fault.message })
            });
            json!({ "faults": faults.collect::<Vec<_>>() })
        }
    }
}

fn chain(system: &System, text: &str) -> Value {
    let scene = system.scene();
    let node = |node: Node| scene.node_name(node).to_owned();
    let masses = scene.masses.iter();
    let springs = scene.springs.iter();
    let dampers = scene.joints.dampers.iter();
    let contacts = scene.named_contacts().into_iter();
    let resonances: Vec<f64> = system.resonances().to_vec();
    let (from, to) = band(&resonances);
    json!({
        "name": scene.name,
        "joined": scene.is_joined(),
        "masses": masses.map(|mass| json!({ "name": mass.name, "value": mass.value })).collect::<Vec<_>>(),
        "springs": springs.map(|spring| json!([node(spring.from), node(spring.to)])).collect::<Vec<_>>(),
        "dampers": dampers.map(|damper| json!([node(damper.from), node(damper.to)])).collect::<Vec<_>>(),
        "contacts": contacts.map(|contact| json!({
            "name": contact.name,
            "between": [node(contact.sides.from), node(contact.sides.to)],
        })).collect::<Vec<_>>(),
        "excitation": match scene.excitation {
            Excitation::Base => "base".to_owned(),
            Excitation::Force(mass) => node(Node::Mass(mass)),
        },
        "resonances": resonances,
        // Frequency in Hz at the frequency ratio r = 1.
        "hertz": system.modal().reference.to_f64() / TAU,
        "from": from,
        "to": to,
        "numbers": numbers(text, scene),
        "sketch": sketch(scene).svg(),
    })
}

/// Returns a range of frequency ratios that contains the resonances of the chain.
fn band(resonances: &[f64]) -> (f64, f64) {
    let moving = || resonances.iter().copied().filter(|r| 0.0 < *r);
    let least = moving().fold(f64::INFINITY, f64::min);
    let most = moving().fold(0.0, f64::max);
    if 0.0 < most {
        (0.2 * least, 1.4 * most)
    } else {
        (0.1, 3.0)
    }
}

/// Returns the sketch of a scene with the values of its masses and springs.
fn sketch(scene: &Scene) -> Sketch {
    let plain = desk::sketch(scene, true);
    let values = scene.masses.iter();
    let values = values.map(|mass| Label::verbatim(&format!("{} kg", mass.value)));
    let mut sketch = Sketch {
        values: values.collect(),
        ..plain
    };
    for (drawn, spring) in sketch.springs.iter_mut().zip(&scene.springs) {
        drawn.label = Label::verbatim(&format!("{} N/m", spring.stiffness));
    }
    if sketch.dashpots.is_empty() {
        let end = |node: Node| match node {
            Node::Mass(index) => frictiongen_plot::End::Mass(index),
            Node::Base => frictiongen_plot::End::Base,
            Node::Wall => frictiongen_plot::End::Wall,
        };
        let dampers = scene.joints.dampers.iter().map(|damper| Spring {
            between: (end(damper.from), end(damper.to)),
            label: Label::verbatim(&format!("{} N·s/m", damper.coefficient)),
        });
        sketch.dashpots = dampers.collect();
    }
    sketch
}
