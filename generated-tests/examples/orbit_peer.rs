//! This library's part of `scripts/trade`: computes one steady state, its time, and its difference from the
//! same state in double-double.
//!
//! `orbit_peer FILE R BETA [RUNS]` prints the time in microseconds, the stops, the reversals, and two amplitudes: of
//! the contact's relative motion, and of the mass at the contact. It also prints both amplitudes in double-double.
//! The time is the median of the runs. A run starts from a parsed scene and includes frequency stage, steady state
//! and amplitudes.

use frictiongen::study::scene::Node;
use frictiongen::{NoOrbit, System};
use frictiongen_kernel::Plain;
use frictiongen_kernel::number::dd::Dd;
use std::hint::black_box;
use std::time::Instant;

/// The values of the printed columns.
struct Answer<S> {
    stops: usize,
    reversals: usize,
    contact: S,
    mass: S,
}

fn answer<S: Plain>(system: &System<S>, r: f64, beta: f64) -> Result<Answer<S>, NoOrbit> {
    let Node::Mass(mass) = system.scene().contact.from else {
        return Err(NoOrbit::Unsettled);
    };
    let at = system.at(S::constant(r)).map_err(NoOrbit::OutOfDomain)?;
    let orbit = at.orbit(S::constant(beta))?;
    let contact = orbit.contact().amplitude();
    let mass = orbit
        .mass_at(mass)
        .map_or(contact, |motion| motion.amplitude());
    Ok(Answer {
        stops: orbit.stops(),
        reversals: orbit.reversals(),
        contact,
        mass,
    })
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, r, beta, rest @ ..] = arguments.as_slice() else {
        panic!("orbit_peer FILE R BETA [RUNS]");
    };
    let text = std::fs::read_to_string(file).expect("a description");
    let (r, beta) = (r.parse().expect("r"), beta.parse().expect("β"));
    let runs: usize = rest.first().map_or(1, |runs| runs.parse().expect("runs"));
    let system: System = text.parse().expect("a scene");
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            let _ = black_box(answer(black_box(&system), r, beta));
            start.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let wide: System<Dd> = text.parse().expect("a scene");
    let found = answer(&system, r, beta).expect("a steady state");
    let exact = answer(&wide, r, beta).expect("a steady state");
    println!(
        "{:.3} {} {} {:?} {:?} {:?} {:?}",
        times[runs / 2],
        found.stops,
        found.reversals,
        found.contact,
        found.mass,
        exact.contact.to_f64(),
        exact.mass.to_f64()
    );
}
