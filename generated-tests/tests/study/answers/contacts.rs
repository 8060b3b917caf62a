//! Compares the best common friction of random frames of one to four contacts with scans of steady states, which use
//! none of the optimiser's code. The steady states of a single contact also come from the solver for several contacts.
//!
//! ```sh
//! RAYON_NUM_THREADS=1 cargo test --release -p generated-tests --test study answers::contacts -- --ignored --nocapture
//! FRAMES=0..100 RAYON_NUM_THREADS=1 cargo test --release -p generated-tests --test study hundreds -- --ignored --nocapture
//! ```

use frictiongen::study::System;
use frictiongen::study::optimum::{
    FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumOptions, OptimumRequest,
    QuantityValue, Tuning,
};
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::units::Load;
use frictiongen::{Of, Regime};
use fuzzing::Random;

/// Largest accepted ratio, minus 1, of the optimum's amplitude to the best amplitude of the scan.
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
        // A contact alone with another share belongs to the solver for several contacts.
        let share = match contacts {
            1 => 1.0,
            _ => random.log_uniform(0.3, 2.0),
        };
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
        random.log_uniform(0.005, 0.03)
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
    /// sampled ever closer. Ends with the first amplitude above `enough`. The grid begins at the frequency `first`, and
    /// stores there the frequency with the largest amplitude.
    fn largest(&self, beta: f64, cells: u32, (enough, first): (f64, &mut f64)) -> f64 {
        let [from, to] = self.band;
        let place = |cell: u32| from * (to / from).powf(f64::from(cell) / f64::from(cells));
        let mut order: Vec<u32> = (0..8).flat_map(|from| (from..=cells).step_by(8)).collect();
        order.insert(
            0,
            (0..=cells)
                .min_by_key(|cell| ((place(*cell) / *first).ln().abs() * 1e9) as u64)
                .expect("a cell"),
        );
        let mut values = vec![0.0; cells as usize + 1];
        for cell in order {
            values[cell as usize] = self.amplitude(place(cell), beta);
            if enough < values[cell as usize] {
                *first = place(cell);
                return values[cell as usize];
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
                if best < value {
                    (best, *first) = (value, finer[at]);
                }
                (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(8)]);
            }
            if enough < best {
                break;
            }
        }
        best
    }

    /// Returns common frictions from a small part of the limit of the stuck state to beyond its largest value.
    fn frictions(&self, count: u32, cells: u32) -> impl Iterator<Item = f64> {
        let limits = (0..=cells).map(|cell| {
            let r = self.band[0]
                * (self.band[1] / self.band[0]).powf(f64::from(cell) / f64::from(cells));
            let joined = self.system.joined().expect("a solver");
            let stuck = joined.at(r).expect("r").stuck();
            stuck.map_or(0.0, |stuck| stuck.limit())
        });
        let mut limits: Vec<f64> = limits.filter(|limit| 0.0 < *limit).collect();
        limits.sort_by(f64::total_cmp);
        let (middle, most) = (limits[limits.len() / 2], limits[limits.len() - 1]);
        let [low, high] = [0.03 * middle, 1.1 * most];
        (0..count)
            .map(move |place| low * (high / low).powf(f64::from(place) / f64::from(count - 1)))
    }
}

/// Result for one frame.
struct Outcome {
    seconds: f64,
    /// Smallest amplitude of the scan over the amplitude of the optimum, minus 1, if the scan is better by more than
    /// [`ABOVE`], and otherwise infinite.
    better: f64,
    /// Refined scan at the friction of the optimum over the amplitude of the optimum, minus 1.
    higher: f64,
    end: OptimumEnd,
}

/// Compares a frame with a scan over friction. The scan ends a friction as soon as its amplitude shows that the friction
/// is not better than the optimum by more than [`ABOVE`].
fn check(frame: &Frame, frictions: u32, cells: u32) -> Outcome {
    let start = super::processor_seconds();
    let found = frame.optimum();
    let seconds = super::processor_seconds() - start;
    let mut first = found.peaks.first().map_or(1.0, |peak| peak.r);
    // At the friction from which a contact with μ > 1 sticks, rounding decides whether it does.
    let beta = found.beta * (1.0 + 1e-9);
    let there = frame.largest(beta, 4 * cells, (f64::INFINITY, &mut first));
    let enough = found.amplitude / (1.0 + ABOVE);
    let better = frame.frictions(frictions, cells).filter_map(|beta| {
        let largest = frame.largest(beta, cells, (enough, &mut first));
        // A better friction counts only if a closer scan confirms it.
        let closer = |first| frame.largest(beta, 4 * cells, (enough, first));
        let largest = if largest < enough {
            closer(&mut first)
        } else {
            largest
        };
        (largest < enough).then_some(largest / found.amplitude - 1.0)
    });
    let better = better.fold(f64::INFINITY, f64::min);
    let higher = match found.amplitude {
        0.0 => there,
        amplitude => there / amplitude - 1.0,
    };
    println!(
        "{seconds:.2} s, {} evaluations, β = {}, {}, {:?}, {:?}; scan {better:.1e}, at the optimum {higher:.1e}; {}",
        found.evaluations, found.beta, found.amplitude, found.kind, found.end, frame.text
    );
    Outcome {
        seconds,
        better,
        higher,
        end: found.end,
    }
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

/// Checks a dashpot that varies beside two contacts. The result is the optimum of the scene with the best value, and no
/// scanned value and no other scene is better.
#[test]
#[ignore = "tens of optima: minutes"]
fn a_dashpot_varies_too() {
    let system = |dashpot: f64| -> System {
        let text = format!(
            "struct Pair {{ masses: {{ m: 1.0, n: 2.0 }}, springs: {{ base - m: 100.0, m - n: 150.0 }}, excitation: base,
             contacts: {{ pads: m - wall {{ stiffness: 20 }}, brace: base - n {{ stiffness: 50 }} }},
             dampers: {{ m - n: {dashpot:?} }}, damping: modal(0.02) }}"
        );
        text.parse().expect("a valid scene")
    };
    let described = system(0.3);
    let request = OptimumRequest {
        of: Of::Mass(0),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Hertz(0.8, 4.0),
        load: Some(Load::Base(0.01)),
    };
    let of = described.tunable_named("c n - m").expect("a dashpot");
    let (from, to) = (0.1, 2.0);
    let options = OptimumOptions {
        vary: &[Tuning { of, from, to }],
        ..OptimumOptions::default()
    };
    let found = described
        .optimum_with(&request, &options)
        .expect("an optimum");
    let alone = |dashpot: f64| system(dashpot).optimum(&request).expect("an optimum");
    let same = alone(found.tuned[0].value);
    println!("{:?}: {} N, {}", found.tuned, found.beta, found.amplitude);
    assert!((same.amplitude / found.amplitude - 1.0).abs() < 1e-6);
    assert_eq!(found.scan.len(), 17);
    let scanned = found.scan.iter().map(|point| point.amplitude);
    for other in scanned.chain([0.3, 0.7].map(|dashpot| alone(dashpot).amplitude)) {
        assert!(found.amplitude <= other * (1.0 + 1e-6), "{other}");
    }
}

/// Checks the best shares under a bound on the relative motion, which the best friction without the bound exceeds.
#[test]
#[ignore = "searches of shares: a minute"]
fn shares_within_a_bound() {
    let text = "struct Pair { masses: { m: 1 }, springs: { base - m: 100 }, excitation: base, damping: modal(0.02),
        contacts: { pads: m - wall { stiffness: 20 }, brace: base - m { stiffness: 50 } } }";
    let system: System = text.parse().expect("a valid scene");
    let request = OptimumRequest {
        of: Of::Mass(0),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Hertz(1.5, 1.8),
        load: None,
    };
    let (of, size) = system.quantity_named("m-base").expect("a quantity");
    let vary = [Tuning {
        of: system.tunable_named("share brace").expect("a share"),
        from: 0.3,
        to: 3.0,
    }];
    let found = |value: f64| {
        let options = OptimumOptions {
            kept: &[QuantityValue { of, size, value }],
            vary: &vary,
            ..OptimumOptions::default()
        };
        system.optimum_with(&request, &options)
    };
    let free = found(f64::INFINITY).expect("an optimum");
    let drift = OptimumRequest {
        of,
        size,
        ..request.clone()
    };
    let least = system.optimum(&drift).expect("an optimum").amplitude;
    // The shares of the description satisfy this bound with another friction.
    let bound = 0.5 * (least + free.largest[0]);
    assert!(least < bound, "{least} {bound}");
    let kept = found(bound).expect("an optimum");
    println!(
        "{} {:?}, within {bound}: {} {:?}",
        free.amplitude, free.tuned, kept.amplitude, kept.tuned
    );
    assert!(kept.largest[0] <= bound && free.amplitude <= kept.amplitude);
    let error = found(1e-6).expect_err("no such friction");
    assert!(
        matches!(error, OptimumError::Unreachable { index: 0, .. }),
        "{error:?}"
    );
}

/// Checks random frames of one to four contacts. A search that its bound on work ends says so, and may be worse.
fn check_frames(numbers: &[usize], frictions: u32, cells: u32) {
    let (mut wrong, mut spent, mut slowest) = (Vec::new(), 0, 0.0_f64);
    for number in numbers {
        let outcome = check(&frame(number / 4, 1 + number % 4), frictions, cells);
        slowest = slowest.max(outcome.seconds);
        spent += usize::from(outcome.end != OptimumEnd::Converged);
        if outcome.better.is_finite() || HIGHER < outcome.higher {
            wrong.push((number, outcome.end, outcome.better, outcome.higher));
        }
    }
    println!(
        "{} frames, {spent} not converged, {} wrong: {wrong:?}; slowest {slowest:.1} s",
        numbers.len(),
        wrong.len()
    );
    assert!(slowest < 60.0, "{slowest} s");
    let mut wrong = wrong.iter();
    assert!(wrong.all(|(_, end, ..)| *end != OptimumEnd::Converged));
}

/// Checks a frame of one contact and a frame of three contacts against coarse scans.
#[test]
fn two_frames() {
    check_frames(&[8, 10], 8, 16);
}

/// Checks hundreds of frames. The variable `FRAMES`, such as `0..300`, selects them.
#[test]
#[ignore = "60 frictions for each of 100 frames: half an hour"]
fn hundreds_of_frames() {
    let numbers = std::env::var("FRAMES").unwrap_or_else(|_| "0..100".to_owned());
    let ends: Vec<usize> = numbers
        .split("..")
        .filter_map(|end| end.parse().ok())
        .collect();
    let [from, to] = ends[..] else {
        panic!("FRAMES={numbers}")
    };
    check_frames(&(from..to).collect::<Vec<_>>(), 60, 120);
}
