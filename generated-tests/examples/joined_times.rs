//! Prints times of steady states with several contacts. `scripts/trade joints` runs this program.
//!
//! * `joined_times growth [RUNS]` prints a CSV table of times for several numbers of masses and of contacts. On standard
//!   error it prints how the time grows with each of these numbers. All masses and springs are equal, and the first
//!   storeys have elastic contacts.
//! * `joined_times curve FILE FROM TO COUNT BETA [RUNS]` prints the time of a curve of steady states from rest. For each
//!   frequency it prints the displacement of the last mass at a maximum of the load, and the amplitude of this mass
//!   about its mean place.

use frictiongen::System;
use std::hint::black_box;
use std::time::Instant;

const MASSES: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
const CONTACTS: [usize; 4] = [1, 2, 4, 8];

/// Returns the description of a chain with equal masses and springs, and with an elastic contact beside each of the
/// first springs. A chain with fewer masses than contacts has several contacts at each mass.
fn description(masses: usize, contacts: usize) -> String {
    let node = |index: usize| match index {
        0 => "base".to_owned(),
        _ => format!("m{index}"),
    };
    let list = |parts: Vec<String>| parts.join(", ");
    let values = (1..=masses).map(|mass| format!("m{mass}: 1"));
    let springs = (1..=masses).map(|mass| format!("{} - {}: 1", node(mass - 1), node(mass)));
    let contacts = (0..contacts).map(|contact| {
        let mass = 1 + contact % masses;
        // Equal contacts would slide at the same instants.
        let share = 1.0 - 0.07 * contact as f64;
        let ends = format!("{} - {}", node(mass - 1), node(mass));
        format!("c{contact}: {ends} {{ stiffness: 0.5, share: {share:.2} }}")
    });
    let [values, springs, contacts] =
        [values.collect(), springs.collect(), contacts.collect()].map(list);
    format!(
        "struct Chain {{ masses: {{ {values} }}, springs: {{ {springs} }}, contacts: {{ {contacts} }},
        damping: modal(0.05), excitation: base }}"
    )
}

/// Returns the median of the times of a call, in ms, and its last result.
fn median<T>(runs: usize, mut call: impl FnMut() -> T) -> (f64, T) {
    let mut times = Vec::new();
    let mut last = None;
    for _ in 0..runs.max(1) {
        let start = Instant::now();
        last = Some(black_box(call()));
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], last.expect("a run"))
}

/// Returns the exponent b of the power law y = a xᵇ that fits the points best.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let logs = || points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let count = points.len() as f64;
    let (x, y) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let (over, under) = logs().fold((0.0, 0.0), |(over, under), (a, b)| {
        (over + (a - x) * (b - y), under + (a - x) * (a - x))
    });
    over / under
}

fn growth(runs: usize) {
    let mut table = Vec::new();
    for masses in MASSES {
        let mut row = Vec::new();
        for contacts in CONTACTS {
            let system: System = description(masses, contacts).parse().expect("a scene");
            let joined = system.joined().expect("answers");
            let at = joined.at(0.35).expect("a frequency");
            let beta = 0.4 * at.stuck().expect("a stuck state").limit();
            let (time, orbit) = median(runs, || at.orbit(beta));
            orbit.expect("a steady state");
            row.push(time);
        }
        table.push(row);
    }
    println!("masses,contacts,ms");
    for (masses, row) in MASSES.iter().zip(&table) {
        for (contacts, time) in CONTACTS.iter().zip(row) {
            println!("{masses},{contacts},{time:.2}");
        }
    }
    let along_masses: Vec<(f64, f64)> = MASSES
        .iter()
        .zip(&table)
        .filter(|(masses, _)| **masses >= 8)
        .map(|(masses, row)| (*masses as f64, row[1]))
        .collect();
    let along_contacts: Vec<(f64, f64)> = CONTACTS
        .iter()
        .zip(&table[3])
        .map(|(contacts, time)| (*contacts as f64, *time))
        .collect();
    eprintln!(
        "The time grows with the power {:.2} of the number of masses (8 to 64 masses, two contacts), and with the power {:.2} of the number of contacts (eight masses).",
        exponent(&along_masses),
        exponent(&along_contacts)
    );
}

fn curve(arguments: &[String]) {
    let [file, from, to, count, beta, rest @ ..] = arguments else {
        panic!("joined_times curve FILE FROM TO COUNT BETA [RUNS]");
    };
    let number = |text: &String| -> f64 { text.parse().expect("a number") };
    let (from, to, beta) = (number(from), number(to), number(beta));
    let count: usize = count.parse().expect("a count");
    let runs: usize = rest.first().map_or(1, |runs| runs.parse().expect("runs"));
    let text = std::fs::read_to_string(file).expect("a description");
    let system: System = text.parse().expect("a scene");
    let place = |index: usize| from + (to - from) * index as f64 / (count - 1) as f64;
    let (time, found) = median(runs, || {
        let joined = system.joined().expect("answers");
        let last = |index| {
            let at = joined.at(place(index)).expect("a frequency");
            let orbit = at.orbit(beta).ok()?;
            let place = orbit.state().0.last().copied()?;
            Some((place, orbit.centred_amplitudes().last().copied()?))
        };
        (0..count).map(last).collect::<Vec<Option<(f64, f64)>>>()
    });
    println!("{time:.3} {}", found.iter().flatten().count());
    for found in found {
        let numbers = found.map(|(place, amplitude)| format!("{place:?} {amplitude:?}"));
        println!("{}", numbers.unwrap_or("none none".to_owned()));
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.split_first() {
        Some((word, rest)) if word == "growth" => {
            growth(rest.first().map_or(5, |runs| runs.parse().expect("runs")));
        }
        Some((word, rest)) if word == "curve" => curve(rest),
        _ => panic!("joined_times growth|curve …"),
    }
}
