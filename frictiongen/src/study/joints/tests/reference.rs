//! Compares events, states and steady states with the file `joints.json`. A separate program wrote this file, by
//! matrix exponentials and bisection. The program shares no code with this project.

use super::super::{Motion, Series};
use super::{Chain, Joint, Wave, modal, stiffness};
use frictiongen_kernel::joints::{first_negative, value};
use frictiongen_model::scene::Node;
use serde_json::Value;
use std::f64::consts::TAU;

pub fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

pub fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

fn node(value: &Value) -> Node {
    match value.as_str().expect("a name") {
        "wall" => Node::Wall,
        "base" => Node::Base,
        mass => Node::Mass(mass[1..].parse::<usize>().expect("an index") - 1),
    }
}

fn links(value: &Value) -> Vec<(Node, Node, f64)> {
    let links = list(value).iter();
    links
        .map(|link| (node(&link[0]), node(&link[1]), number(&link[2])))
        .collect()
}

pub fn read() -> Value {
    serde_json::from_str(include_str!("joints.json")).expect("JSON")
}

/// Returns the chain of an entry of the reference file, at one frequency.
pub fn chain(value: &Value, omega: f64) -> Chain {
    let masses = numbers(&value["masses"]);
    let springs = links(&value["springs"]);
    let contacts = list(&value["contacts"]).iter().map(|contact| Joint {
        ends: (node(&contact["between"][0]), node(&contact["between"][1])),
        level: Wave::constant(number(&contact["force"])),
        stiction: number(&contact["stiction"]),
        stiffness: contact["stiffness"].as_f64(),
        speed: 0.0,
    });
    let damping = if value["rayleigh"].is_array() {
        let factor = number(&value["rayleigh"][1]);
        let k = stiffness(masses.len(), &springs);
        k.into_iter()
            .map(|row| row.into_iter().map(|k| factor * k).collect())
            .collect()
    } else {
        modal(&masses, &springs, &numbers(&value["zeta"]))
    };
    let wave = Wave::harmonic(number(&value["load"]), omega);
    let mut chain = Chain {
        masses,
        springs,
        dashpots: if value["dampers"].is_array() {
            links(&value["dampers"])
        } else {
            vec![]
        },
        damping,
        contacts: contacts.collect(),
        ..Chain::default()
    };
    match node(&value["excitation"]) {
        Node::Mass(mass) => chain.loads.push((mass, wave)),
        _ => chain.base = wave,
    }
    chain
}

/// Finds the largest |x| of each mass in a stretch (time interval of a power series). Stores the number in `amplitudes`
/// if it exceeds the amplitude so far.
fn largest(amplitudes: &mut [f64], series: &Series, end: f64) {
    for (mass, amplitude) in amplitudes.iter_mut().enumerate() {
        let (x, v) = (series.displacement_terms(mass), series.velocity_terms(mass));
        let sign = if v[0] > 0.0 { 1.0 } else { -1.0 };
        let turn = first_negative(&v.map(|term| sign * term), 0);
        for at in [Some(0.0), Some(end), turn].into_iter().flatten() {
            *amplitude = amplitude.max(value(&x, at.min(end)).abs());
        }
    }
}

/// Returns the amplitudes of the masses and the stuck fractions of the contacts over one cycle of the load. The motion
/// starts from rest, and first runs for `cycles` cycles.
fn steady(chain: &Chain, omega: f64, cycles: usize) -> (Vec<f64>, Vec<f64>) {
    let mut motion = Motion::from_rest(chain).expect("a chain");
    let period = TAU / omega;
    for cycle in 0..cycles {
        motion
            .run((cycle + 1) as f64 * period, &mut |_, _, _| {})
            .expect("a motion");
    }
    let mut amplitudes = vec![0.0; chain.masses.len()];
    let mut stuck = vec![0.0; chain.contacts.len()];
    let end = (cycles + 1) as f64 * period;
    let watch = &mut |series: &Series, fraction: f64, state: &super::super::State| {
        largest(&mut amplitudes, series, fraction);
        for (share, phase) in stuck.iter_mut().zip(&state.phases) {
            if *phase == 0 {
                *share += fraction * series.length / period;
            }
        }
    };
    motion.run(end, watch).expect("a motion");
    (amplitudes, stuck)
}

#[test]
fn events_and_states_of_the_reference() {
    let (mut instants, mut states, mut count) = (0.0_f64, 0.0_f64, 0);
    for (index, scene) in list(&read()["scenes"]).iter().enumerate() {
        let omega = number(&scene["omega"]);
        let chain = chain(scene, omega);
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let period = TAU / omega;
        let mut events = Vec::new();
        let after = list(&scene["after_cycles"]);
        for (cycle, expected) in after.iter().enumerate() {
            let until = (cycle + 1) as f64 * period;
            events.extend(motion.run(until, &mut |_, _, _| {}).expect("a motion"));
            for (got, expected) in [
                (&motion.state().x, numbers(&expected["x"])),
                (&motion.state().v, numbers(&expected["v"])),
            ] {
                let scale = expected.iter().fold(0.0_f64, |m, x| x.abs().max(m));
                for (got, expected) in got.iter().zip(&expected) {
                    let miss = (got - expected).abs() / scale;
                    assert!(
                        miss < 1e-10,
                        "scene {index}, cycle {cycle}: {got} {expected}"
                    );
                    states = states.max(miss);
                }
            }
        }
        let expected = list(&scene["events"]);
        let phases = |value: &Value| -> Vec<i8> {
            list(value)
                .iter()
                .map(|v| v.as_i64().expect("a phase") as i8)
                .collect()
        };
        for (event, expected) in events.iter().zip(expected) {
            let miss = (event.time - number(&expected["t"])).abs() / period;
            assert!(miss < 1e-10, "scene {index}: {event:?} {expected}");
            assert_eq!(event.before, phases(&expected["before"]), "scene {index}");
            assert_eq!(event.after, phases(&expected["after"]), "scene {index}");
            instants = instants.max(miss);
            count += 1;
        }
        assert_eq!(events.len(), expected.len(), "scene {index}");
    }
    println!("{count} events: {instants:.1e} of the period; states {states:.1e}");
    assert!(count > 200);
}

#[test]
fn steady_states_of_two_elastic_contacts() {
    let all = read();
    let scene = &all["jenkins_chain"];
    let mut worst = 0.0_f64;
    for steady_state in list(&scene["steady"]) {
        let omega = number(&steady_state["omega"]);
        let cycles = steady_state["cycles"].as_u64().expect("a count") as usize;
        let (amplitudes, stuck) = steady(&chain(scene, omega), omega, cycles);
        let expected = numbers(&steady_state["amplitude"]);
        for (got, expected) in amplitudes.iter().zip(&expected) {
            let miss = (got - expected).abs() / expected;
            assert!(miss < 1e-9, "ω = {omega}: {got} {expected}");
            worst = worst.max(miss);
        }
        for (got, expected) in stuck.iter().zip(numbers(&steady_state["stuck_fraction"])) {
            assert!(
                (got - expected).abs() < 1e-8,
                "ω = {omega}: {got} {expected}"
            );
        }
    }
    println!("amplitudes {worst:.1e}");
}

#[test]
fn steady_states_that_settle_soon() {
    let mut worst = 0.0_f64;
    let all = read();
    for (index, scene) in list(&all["scenes"]).iter().enumerate() {
        let steady_state = &scene["steady"];
        let cycles = steady_state["cycles_to_settle"]
            .as_u64()
            .unwrap_or(u64::MAX);
        if cycles > 100 {
            continue;
        }
        let omega = number(&scene["omega"]);
        let (amplitudes, stuck) = steady(&chain(scene, omega), omega, cycles as usize);
        let expected = numbers(&steady_state["amplitude"]);
        let largest = expected.iter().fold(0.0_f64, |m, x| m.max(*x));
        for (got, expected) in amplitudes.iter().zip(&expected) {
            let miss = (got - expected).abs() / largest;
            assert!(miss < 1e-9, "scene {index}: {got} {expected}");
            worst = worst.max(miss);
        }
        for (got, expected) in stuck.iter().zip(numbers(&steady_state["stuck_fraction"])) {
            assert!(
                (got - expected).abs() < 1e-8,
                "scene {index}: {got} {expected}"
            );
        }
    }
    println!("amplitudes {worst:.1e}");
}
