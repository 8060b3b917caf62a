//! Prints the time of one steady state. `scripts/orbit-times` runs this program.
//!
//! r is random, and β is random between the limits, so that the contact stops. The time at a point is the shortest of
//! five runs. The program prints the median and the 90th percentile of these times over the points.

use frictiongen::study::SystemAt;
use frictiongen::{FrictionSystem, System};
use fuzzing::Random;
use std::hint::black_box;
use std::time::Instant;

const POINTS: usize = 400;

/// The scenes: one mass, and a damped chain of five masses with and without stiction.
const SCENES: [(&str, &str); 4] = [
    (
        "one mass",
        "struct One { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a }",
    ),
    (
        "one mass, base",
        "struct Base { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - base,
        excitation: base, damping: modal(0.02) }",
    ),
    (
        "five masses",
        "struct Five { masses: { a: 1, b: 1, c: 1, d: 1, e: 1 },
        springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 },
        contact: a - wall, excitation: a, damping: modal(0.05) }",
    ),
    (
        "five masses, mu = 1.2",
        "struct Sticky { masses: { a: 1, b: 1, c: 1, d: 1, e: 1 },
        springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 },
        contact: c - wall, excitation: a, damping: modal(0.05), stiction: 1.2 }",
    ),
];

/// Returns the time of one steady state, in µs.
fn once(at: &SystemAt<'_>, beta: f64) -> f64 {
    let start = Instant::now();
    let _ = black_box(at.orbit(black_box(beta)));
    start.elapsed().as_secs_f64() * 1e6
}

fn main() {
    println!("| scene | median, µs | nine of ten, µs | without a steady state |");
    println!("|---|---|---|---|");
    for (name, text) in SCENES {
        let system: System = text.parse().expect("a scene");
        let mut random = Random(1);
        let (mut times, mut none) = (Vec::new(), 0);
        while times.len() < POINTS {
            let r = 0.2 + 2.0 * random.unit();
            let at = FrictionSystem::at(&system, r).expect("in the domain");
            let (low, high) = (at.continuous_limit(), at.sliding_limit());
            let beta = low + (high - low) * random.unit();
            if !(low < high) {
                continue;
            }
            none += usize::from(at.orbit(beta).is_err());
            times.push((0..5).map(|_| once(&at, beta)).fold(f64::MAX, f64::min));
        }
        times.sort_by(f64::total_cmp);
        let (median, most) = (times[POINTS / 2], times[POINTS * 9 / 10]);
        println!("| {name} | {median:.1} | {most:.1} | {none} of {POINTS} |");
    }
}
