//! The steady states of `reference/orbits.json`, waited for by simulation.
use frictiongen::System;
use frictiongen::kernel::simulation::{Contact, Event};
use std::f64::consts::{PI, TAU};
use serde_json::Value;

#[test]
fn waited_for() {
    let scenes: Vec<Value> = serde_json::from_str(include_str!("../../reference/orbits.json")).expect("JSON");
    for scene in &scenes {
        let system: System = scene["description"].as_str().expect("text").parse().expect("a scene");
        let names: Vec<String> = system.scene().masses.iter().map(|m| m.name.clone()).collect();
        for orbit in scene["orbits"].as_array().expect("orbits") {
            let (r, beta) = (orbit["r"].as_f64().unwrap(), orbit["beta"].as_f64().unwrap());
            let mut run = system.simulation(r, beta).unwrap();
            let cycles = 2 * orbit["cycles"].as_u64().unwrap();
            let mut count = 0;
            while run.run().cycles() < cycles { run.advance(TAU - run.run().phase() + 1e-12); count += 1; assert!(count < 100000); }
            let (mut stops, mut stuck) = (0, 0.0);
            let mut left = TAU;
            let mut most = vec![0.0_f64; names.len()];
            while left > 1e-9 {
                let segment = run.advance(left.min(1e-2));
                left -= segment.length;
                if segment.event == Some(Event::Stop) { stops += 1; }
                if segment.contact == Contact::Stuck { stuck += segment.length; }
                for (most, name) in most.iter_mut().zip(&names) { *most = most.max(run.displacement(name).unwrap().abs()); }
            }
            let want: Vec<f64> = orbit["amplitude"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
            let worst = most.iter().zip(&want).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
            println!("n {} r {r} beta {beta}: stops {stops} {} stuck {:.10} {:.10} diff {:.1e} amp {worst:.1e} events/cycle {:.1}", names.len(), orbit["stops"], stuck / TAU, orbit["stuck_fraction"].as_f64().unwrap(), stuck / TAU - orbit["stuck_fraction"].as_f64().unwrap(), count as f64 / cycles as f64);
        }
    }
    let _ = PI;
}
