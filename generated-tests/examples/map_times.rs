//! Prints times of maps of a damped frame of five masses, with regimes at 200 × 200 points. Then prints the times for
//! several numbers of cores and of masses. `cargo run --release -p generated-tests --features tools --example
//! map_times`

use frictiongen::study::map::{Map, MapRequest};
use frictiongen::{Of, System};
use std::collections::BTreeMap;
use std::time::Instant;

fn chain(masses: usize) -> System {
    let names: Vec<String> = (1..=masses).map(|i| format!("m{i}")).collect();
    let all: Vec<String> = names.iter().map(|name| format!("{name}: 1")).collect();
    let below = std::iter::once("base".to_owned()).chain(names.iter().cloned());
    let springs: Vec<String> = below
        .zip(&names)
        .map(|(from, to)| format!("{from} - {to}: 1"))
        .collect();
    let text = format!(
        "struct Frame {{ masses: {{ {} }}, springs: {{ {} }}, contact: m1 - wall, excitation: base, damping: modal(0.02) }}",
        all.join(", "),
        springs.join(", ")
    );
    text.parse().expect("a scene")
}

fn timed(system: &System, request: &MapRequest) -> (Map, f64) {
    let start = Instant::now();
    let map = system.map(request, |_| true).expect("a map");
    (map, start.elapsed().as_secs_f64())
}

fn main() {
    let grid = |count: u32, last: f64| {
        (1..=count)
            .map(|i| last * f64::from(i) / f64::from(count))
            .collect()
    };
    let request = MapRequest {
        r: grid(200, 2.5),
        beta: grid(200, 1.5),
        of: vec![Of::Mass(4)],
    };
    let five = chain(5);
    let (map, seconds) = timed(&five, &request);
    println!("five damped masses, 200 × 200 points: {seconds:.2} s");
    let mut counts: BTreeMap<String, u32> = BTreeMap::new();
    for (_, _, point) in map.points() {
        let name = match point {
            Ok(point) if point.pattern.period == 0 => "stick-slip, not settled".to_owned(),
            Ok(point) if point.pattern.period > 1 => "stick-slip, subharmonic".to_owned(),
            Ok(point) => format!("{:?}", point.pattern.regime),
            Err(error) => error.to_string(),
        };
        *counts.entry(name).or_default() += 1;
    }
    for (name, count) in counts {
        println!("  {:5.1} %  {name}", 100.0 * f64::from(count) / 40_000.0);
    }
    let smaller = MapRequest {
        r: grid(80, 2.5),
        beta: grid(80, 1.5),
        of: vec![Of::Mass(0)],
    };
    println!("80 × 80 points:");
    for masses in [1, 2, 3, 5, 10] {
        let system = chain(masses);
        let one = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .build()
            .expect("a thread");
        let (_, alone) = one.install(|| timed(&system, &smaller));
        let (_, all) = timed(&system, &smaller);
        let cores = rayon::current_num_threads();
        println!(
            "  {masses:2} masses: {alone:.2} s on one core, {all:.2} s on {cores}, {:.2} times as fast",
            alone / all
        );
    }
}
