//! Compares the best common friction of random frames of two to four contacts with a map of steady states, which uses
//! none of the optimiser's code.
//!
//! ```sh
//! cargo test --release -p generated-tests --test study answers::contacts -- --ignored --nocapture
//! ```

use frictiongen::study::System;
use frictiongen::study::optimum::{FrequencyBand, Optimum, OptimumEnd, OptimumRequest};
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::units::Load;
use frictiongen::{Of, Regime};
use fuzzing::Random;
use std::time::Instant;

/// Largest accepted ratio, minus 1, of the optimum's amplitude to the best amplitude of the map.
const ABOVE: f64 = 0.01;
/// Largest accepted ratio, minus 1, of a refined scan at the optimum's friction to the optimum's amplitude.
const HIGHER: f64 = 0.002;

/// A random frame of several contacts.
struct Frame {
    text: String,
    system: System,
    mass: usize,
    band: [f64; 2],
}

/// Returns a random frame of one to three masses, reproducible from its number. Most contacts are elastic.
fn frame(index: usize, contacts: usize) -> Frame {
    let mut random = Random((index * 7919 + 104_729 * contacts) as u64);
    for _ in 0..8 {
        random.bits();
    }
    let count = 1 + random.below(3).max(contacts.saturating_sub(3));
    let masses = (0..count).map(|mass| format!("m{mass}: {:.4}", random.log_uniform(1.0, 10.0)));
    let masses: Vec<String> = masses.collect();
    let node = |mass: usize| {
        if mass == 0 {
            "base".to_owned()
        } else {
            format!("m{}", mass - 1)
        }
    };
    let springs = (0..count).map(|mass| {
        format!(
            "{} - m{mass}: {:.2}",
            node(mass),
            random.log_uniform(1e3, 1e4)
        )
    });
    let springs: Vec<String> = springs.collect();
    let mut sides: Vec<String> = (0..count)
        .flat_map(|mass| {
            [
                format!("{} - m{mass}", node(mass)),
                format!("m{mass} - wall"),
            ]
        })
        .collect();
    let mut all = Vec::new();
    for contact in 0..contacts.min(sides.len()) {
        let side = sides.remove(random.below(sides.len()));
        let stiffness = match contact > 0 || random.once_in(2) {
            true => format!("stiffness: {:.1}, ", random.log_uniform(1e3, 2e4)),
            false => String::new(),
        };
        let stiction = match random.once_in(4) {
            true => "stiction: 1.3, ",
            false => "",
        };
        let share = random.log_uniform(0.3, 2.0);
        all.push(format!(
            "c{contact}: {side} {{ {stiffness}{stiction}share: {share:.3} }}"
        ));
    }
    let excitation = match random.once_in(2) {
        true => "base".to_owned(),
        false => format!("m{}", random.below(count)),
    };
    let text = format!(
        "struct Frame {{ masses: {{ {} }}, springs: {{ {} }}, contacts: {{ {} }}, excitation: {excitation},
         damping: modal({:.4}) }}",
        masses.join(", "),
        springs.join(", "),
        all.join(", "),
        random.log_uniform(0.005, 0.05)
    );
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{text}: {error}"));
    let resonances = system.resonances();
    let band = [0.4 * resonances[0], 1.5 * resonances[count - 1]];
    let mass = random.below(count);
    Frame {
        text,
        system,
        mass,
        band,
    }
}

impl Frame {
    fn optimum(&self) -> Optimum {
        let request = OptimumRequest {
            of: Of::Mass(self.mass),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Ratio(self.band[0], self.band[1]),
            load: None,
        };
        let found = self.system.optimum(&request);
        found.unwrap_or_else(|error| panic!("{}: {error}", self.text))
    }

    /// Returns the amplitude at one frequency and one common friction. Contacts that never slide have no mean force.
    fn amplitude(&self, r: f64, beta: f64) -> f64 {
        let joined = self.system.joined().expect("a solver");
        let at = joined.at(r).expect("r");
        let name = &self.system.scene().masses[self.mass].name;
        match at.orbit(beta) {
            Ok(orbit) if orbit.regime() == Regime::Stuck => at
                .stuck()
                .expect("a stuck state")
                .mass(name)
                .expect("a mass")
                .norm(),
            Ok(orbit) => orbit.amplitude(name).expect("a mass"),
            Err(_) => {
                let mut run = at.simulation(beta).expect("a motion");
                let cycles = |count: f64| count * std::f64::consts::TAU;
                run.advance(cycles(256.0)).expect("a motion");
                let sampled = (0..64 * 200).map(|_| {
                    run.advance(cycles(1.0 / 200.0)).expect("a motion");
                    run.mass(name).expect("a mass").0.abs()
                });
                sampled.fold(0.0, f64::max)
            }
        }
    }

    /// Returns the largest amplitude over the band at one common friction: on a geometric grid, whose local maxima are
    /// sampled ever closer. Ends with the first amplitude above `enough`.
    fn largest(&self, beta: f64, cells: u32, enough: f64) -> f64 {
        let [from, to] = self.band;
        let place = |cell: u32| from * (to / from).powf(f64::from(cell) / f64::from(cells));
        let mut values = vec![0.0; cells as usize + 1];
        for offset in 0..8 {
            for cell in (offset..=cells).step_by(8) {
                values[cell as usize] = self.amplitude(place(cell), beta);
                if enough < values[cell as usize] {
                    return values[cell as usize];
                }
            }
        }
        let most = values.iter().copied().fold(0.0, f64::max);
        let mut best = most;
        for cell in 0..=cells {
            let (before, after) = (cell.saturating_sub(1), (cell + 1).min(cells));
            let [left, own, right] = [before, cell, after].map(|cell| values[cell as usize]);
            if own < left || own < right || own < 0.9 * most {
                continue;
            }
            let (mut a, mut b) = (place(before), place(after));
            for _ in 0..4 {
                let finer: Vec<f64> = (0..=8).map(|i| a + (b - a) * f64::from(i) / 8.0).collect();
                let found = finer.iter().map(|r| self.amplitude(*r, beta));
                let (at, value) = found
                    .enumerate()
                    .max_by(|(_, x), (_, y)| x.total_cmp(y))
                    .expect("samples");
                best = best.max(value);
                (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(8)]);
            }
        }
        best
    }

    /// Returns the smallest of the largest amplitudes at a list of common frictions.
    fn least(&self, betas: impl Iterator<Item = f64>, cells: u32) -> f64 {
        betas.fold(f64::INFINITY, |best, beta| {
            best.min(self.largest(beta, cells, best))
        })
    }
}

/// Compares a frame with a map. Returns the time of the search in seconds, the ratio of the optimum to the map, minus 1,
/// that of a refined scan to the optimum, and the end of the search.
fn check(frame: &Frame, frictions: u32, cells: u32) -> (f64, [f64; 2], OptimumEnd) {
    let start = Instant::now();
    let found = frame.optimum();
    let seconds = start.elapsed().as_secs_f64();
    let there = frame.largest(found.beta, 4 * cells, f64::INFINITY);
    let limits = (0..=40).map(|cell| {
        let r = frame.band[0] * (frame.band[1] / frame.band[0]).powf(f64::from(cell) / 40.0);
        let joined = frame.system.joined().expect("a solver");
        let stuck = joined.at(r).expect("r").stuck();
        stuck.map_or(0.0, |stuck| stuck.limit())
    });
    let mut limits: Vec<f64> = limits.filter(|limit| 0.0 < *limit).collect();
    limits.sort_by(f64::total_cmp);
    let (middle, most) = (limits[limits.len() / 2], limits[limits.len() - 1]);
    let [low, high] = [0.03 * middle, 1.1 * most];
    let betas = (0..frictions)
        .map(|place| low * (high / low).powf(f64::from(place) / f64::from(frictions - 1)));
    let least = frame.least(betas, cells);
    let ratios = [found.amplitude / least - 1.0, there / found.amplitude - 1.0];
    println!(
        "{seconds:.2} s, {} evaluations, β = {}, {}, {:?}, {:?}; map {:.1e}, scan {:.1e}; {}",
        found.evaluations,
        found.beta,
        found.amplitude,
        found.kind,
        found.end,
        ratios[0],
        ratios[1],
        frame.text
    );
    (seconds, ratios, found.end)
}

/// Checks that a mass with one contact has the same optimum in both spellings. With 1.11 N the largest amplitude is
/// 0.114162 m if the contact has no mean force.
#[test]
fn one_contact_in_two_spellings() {
    let found = [
        "contact: m - wall, stiffness: 10",
        "contacts: { c: m - wall { stiffness: 10 } }",
    ];
    let found = found.map(|contact| {
        let text = format!(
            "struct Block {{ masses: {{ m: 1 }}, springs: {{ base - m: 1 }}, {contact}, excitation: m,
             damping: modal(0.02) }}"
        );
        let system: System = text.parse().expect("a valid scene");
        let (mass, band) = (0, [0.9, 1.5]);
        Frame { text, system, mass, band }.optimum()
    });
    let [one, other] = &found;
    assert!(
        (one.beta / other.beta - 1.0).abs() < 1e-4,
        "{} {}",
        one.beta,
        other.beta
    );
    assert!((one.amplitude / other.amplitude - 1.0).abs() < 1e-6);
    assert!((one.beta - 1.11).abs() < 0.01 && one.amplitude < 0.114_162);
    assert_eq!((one.kind, one.end), (other.kind, other.end));
}

/// Checks that the best friction of three contacts does not depend on the upper end of the band. Another program finds a
/// largest amplitude of 49.53 mm at 788 N.
#[test]
fn one_optimum_in_two_bands() {
    let text = "struct O { masses: { f1: 163.3, f2: 238.3, f3: 135.7 },
        springs: { base - f1: 82928, f1 - f2: 59739, f2 - f3: 74983 },
        contacts: { c0: base - f1 { stiffness: 93857 }, c1: f1 - f2 { stiffness: 39361, share: 0.743 },
            c2: f2 - f3 { stiffness: 80280, share: 0.808 } },
        excitation: base, damping: modal(0.02), damping_from: base }";
    let system: System = text.parse().expect("a valid scene");
    let load = Load::Base(0.01);
    let scale = system.load_scale(load).expect("a base motion");
    for (from, to) in [(0.86, 5.0), (0.87, 4.0)] {
        let found = system.optimum(&OptimumRequest {
            of: Of::Mass(2),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Hertz(from, to),
            load: Some(load),
        });
        let found = found.expect("an optimum");
        let (force, height) = (
            scale.friction(found.beta),
            scale.displacement(found.amplitude),
        );
        println!("{from}:{to} {force} N, {height} m, {:?}", found.end);
        assert_eq!(found.end, OptimumEnd::Converged);
        assert!(
            (height / 0.04953 - 1.0).abs() < 1e-3,
            "{force} N: {height} m"
        );
        assert!((700.0..800.0).contains(&force), "{force} N");
    }
}

/// Checks one frame of two contacts.
#[test]
#[ignore = "half a minute"]
fn a_frame_of_two_contacts() {
    let text = "struct Block { masses: { block: 1.0 }, springs: { base - block: 1.0 }, excitation: block,
        contacts: { brace: base - block { stiffness: 2.0 }, pads: block - wall { share: 0.2, stiffness: 1.0 } },
        damping: modal(0.05) }";
    let frame = Frame {
        text: text.to_owned(),
        system: text.parse().expect("a valid scene"),
        mass: 0,
        band: [0.8, 2.2],
    };
    let (_, [above, higher], _) = check(&frame, 12, 40);
    assert!(above < ABOVE && higher < HIGHER, "{above} {higher}");
}

/// Checks 40 frames of two to four contacts against maps of 60 frictions.
#[test]
#[ignore = "40 maps: an hour"]
fn forty_frames() {
    let (mut wrong, mut slowest) = (Vec::new(), 0.0_f64);
    for index in 0..40 {
        let frame = frame(index, 2 + index % 3);
        let (seconds, [above, higher], end) = check(&frame, 60, 120);
        slowest = slowest.max(seconds);
        if ABOVE < above || HIGHER < higher {
            wrong.push((index, end, above, higher));
        }
    }
    println!("{} wrong: {wrong:?}; slowest {slowest:.1} s", wrong.len());
    let converged = wrong
        .iter()
        .filter(|(_, end, ..)| *end == OptimumEnd::Converged);
    assert_eq!(converged.count(), 0, "{wrong:?}");
}
