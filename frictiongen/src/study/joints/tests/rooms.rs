//! Compares motions with stops, moving surfaces and constant forces with the file `rooms.json`. A separate program made
//! this file by matrix exponentials and bisection.

use crate::study::joints::{Chain, EndStop, Joint, Motion, Wave};
use frictiongen_kernel::joints::STUCK;
use frictiongen_model::scene::{Impact, Node, StopLaw};
use serde_json::Value;

/// Largest difference of displacements and velocities after up to eight cycles. The reference states 4e-10.
const CLOSE: f64 = 1e-9;

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().into_iter().flatten();
    numbers.map(|number| number.as_f64().unwrap()).collect()
}

fn node(value: &Value) -> Node {
    match value.as_str().unwrap() {
        "wall" => Node::Wall,
        "base" => Node::Base,
        mass => Node::Mass(mass[1..].parse::<usize>().unwrap() - 1),
    }
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

fn chain(room: &Value) -> Chain {
    let between = |value: &Value| (node(&value["between"][0]), node(&value["between"][1]));
    let link = |value: &Value| (node(&value[0]), node(&value[1]), value[2].as_f64().unwrap());
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or(0.0);
    let contacts = list(&room["contacts"]).map(|contact| Joint {
        ends: between(contact),
        level: Wave::constant(number(contact, "force")),
        stiction: number(contact, "stiction"),
        stiffness: contact["stiffness"].as_f64(),
        speed: number(contact, "speed"),
    });
    let stops = list(&room["stops"]).map(|stop| EndStop {
        ends: between(stop),
        law: StopLaw {
            gap: number(stop, "gap"),
            impact: Impact::Spring {
                stiffness: number(stop, "stiffness"),
                damping: number(stop, "damping"),
            },
        },
    });
    let constant = numbers(&room["constant"]);
    let load = Wave::harmonic(number(room, "force"), number(room, "omega"));
    Chain {
        masses: numbers(&room["masses"]),
        springs: list(&room["springs"]).map(link).collect(),
        dashpots: list(&room["dampers"]).map(link).collect(),
        contacts: contacts.collect(),
        stops: stops.collect(),
        constant: constant.into_iter().enumerate().collect(),
        loads: match node(&room["excitation"]) {
            Node::Mass(mass) => vec![(mass, load)],
            _ => Vec::new(),
        },
        ..Chain::default()
    }
}

#[test]
fn stops_belts_and_constant_forces() {
    let rooms: Value = serde_json::from_str(include_str!("rooms.json")).unwrap();
    for (index, room) in list(&rooms).enumerate() {
        let (x, v) = (numbers(&room["x0"]), numbers(&room["v0"]));
        let mut motion = Motion::from(&chain(room), &x, &v).unwrap();
        let cycle = std::f64::consts::TAU / room["omega"].as_f64().unwrap();
        for at in list(&room["at"]) {
            let cycles = at["cycles"].as_f64().unwrap();
            motion.run(cycles * cycle, &mut |_, _, _| {}).unwrap();
            let state = motion.state();
            for (found, known) in [(&state.x, &at["x"]), (&state.v, &at["v"])] {
                for (found, known) in found.iter().zip(numbers(known)) {
                    let error = (found - known).abs();
                    assert!(error < CLOSE, "room {index}, cycle {cycles}: {error:e}");
                }
            }
            let contacts = list(&at["stuck"]).chain(list(&at["shut"]));
            for (j, known) in contacts.enumerate() {
                let is_shut = state.phase(j) == STUCK;
                assert_eq!(Some(is_shut), known.as_bool(), "room {index}, contact {j}");
            }
        }
    }
}
