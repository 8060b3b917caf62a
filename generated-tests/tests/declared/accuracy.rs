//! Every answer of a table within its accuracy.
//!
//! What is compared with is the exact system in double precision, which answers to some roundings of r; where a limit
//! vanishes, that is more than its accuracy.  So far an answer may be off besides: by what the exact one moves by for
//! 16 roundings of r, and for the rounding of a large sum, which shows beside zeros of V.

use super::random;
use super::scenes::scenes;
use frictiongen::System;
use frictiongen::study::table::{FRICTION_SHARES, TableError};
use frictiongen_kernel::Float;
use fuzzing::Random;
use std::f64::consts::PI;

const RANGE: std::ops::Range<f64> = 0.2..2.5;
/// Closer to a resonance a rounding of its place is more than an amplitude's accuracy.
const BESIDE: f64 = 1e-13;
/// Roundings of r.
const ROUNDINGS: f64 = 16.0;

/// The worst of a run.
#[derive(Default)]
struct Tally {
    points: usize,
    compared: usize,
    /// Scenes whose β*_lim has no form of its own.
    by_sums: usize,
    /// Points beside a zero, where the exact answer is too uncertain.
    skipped: usize,
    /// Largest errors over the accuracy: β_lim, β*_lim, amplitude, phase.
    worst: [f64; 4],
    failures: Vec<String>,
    /// Scenes of which no table could be had.
    unmet: Vec<String>,
}

/// How many random points a scene is looked at.
pub fn points(default: usize) -> usize {
    let asked = std::env::var("POINTS").ok();
    asked
        .and_then(|points| points.parse().ok())
        .unwrap_or(default)
}

fn check<S: Float>(name: &str, text: &str, accuracy: f64, points: usize, tally: &mut Tally) {
    let exact: System<f64> = text.parse().expect("a scene");
    let system: System<S> = text.parse().expect("a scene");
    let compiled = match system.compile(RANGE, accuracy) {
        Ok(compiled) => compiled,
        Err(TableError::NotMet { reached, at, .. }) => {
            tally
                .unmet
                .push(format!("{name} at {accuracy:e}: r = {at}, {reached:?}"));
            return;
        }
        Err(error) => panic!("{name}: {error}\n{text}"),
    };
    tally.by_sums += usize::from(compiled.tables().sliding.is_none());
    let mut random = Random(name.len() as u64 * 7919 + points as u64);
    let mut ratios: Vec<f64> = (0..points)
        .map(|_| random.between(RANGE.start, RANGE.end))
        .collect();
    // Ends, zeros, kinks, resonances and their neighbours.
    let places = compiled
        .tables()
        .pieces
        .iter()
        .map(|piece| piece.from.to_f64());
    let resonances = system.resonances().iter().flat_map(|r| {
        let r = r.to_f64();
        [1.0, 3.0, 5.0, 7.0, 9.0].map(|order| r / order)
    });
    for place in places.chain(resonances).chain([RANGE.start, RANGE.end]) {
        let epsilon = S::EPSILON;
        for beside in [
            0.0, epsilon, -epsilon, 1e-9, -1e-9, 1e-6, -1e-6, 1e-4, -1e-4,
        ] {
            ratios.push(place * (1.0 + beside));
        }
    }
    for r in ratios {
        let own = S::constant(r);
        let r = own.to_f64();
        let Ok(at) = compiled.at(own) else { continue };
        // So close to a zero the roundings of its place are more than 10⁻⁴ of the distance.
        let near = |sigma: &f64| {
            let order = 2.0 * (0.5 * (sigma / r - 1.0)).round() + 1.0;
            (r * order / sigma - 1.0).abs()
        };
        if exact
            .resonances()
            .iter()
            .any(|sigma| (1e-15..1e-12).contains(&near(sigma)))
        {
            tally.skipped += 1;
            continue;
        }
        let reference = exact.at(r).expect("in the domain");
        tally.points += 1;
        let moved = exact
            .at(r * (1.0 + ROUNDINGS * f64::EPSILON))
            .expect("in the domain");
        let limits = reference.limits();
        let answers = [
            (
                at.continuous_limit().to_f64(),
                limits.continuous,
                moved.continuous_limit(),
            ),
            (
                at.sliding_limit().to_f64(),
                limits.sliding,
                moved.sliding_limit(),
            ),
        ];
        for (which, (answer, expected, moved)) in answers.into_iter().enumerate() {
            if !expected.is_finite() || expected == 0.0 {
                continue;
            }
            tally.compared += 1;
            let noise = (moved - expected).abs() + sum_rounding(&exact, r) * expected;
            let error = ((answer - expected).abs() - noise).max(0.0) / expected / accuracy;
            tally.worst[which] = tally.worst[which].max(error);
            if !(error <= 1.0) {
                let which = ["beta_lim", "beta*_lim"][which];
                tally.failures.push(format!(
                    "{name}, {accuracy:e}, {which} at r = {r:?}: {answer:e} for {expected:e}"
                ));
            }
        }
        let share = FRICTION_SHARES[random.below(FRICTION_SHARES.len())];
        let limit = limits.continuous.min(limits.sliding);
        let beta = S::constant(share * limit);
        // A point within rounding of a zero of a limit has no motion to compare.
        let beside = |place: f64| (r / place - 1.0).abs() < BESIDE.max(S::EPSILON);
        let known = (moved.continuous_limit() / limits.continuous - 1.0).abs() < 0.1;
        if !(limit > 1e-9 && known)
            || exact
                .resonances()
                .iter()
                .any(|resonance| beside(*resonance))
        {
            continue;
        }
        let Ok(motion) = at.motion(beta) else {
            tally.failures.push(format!("{name}, {accuracy:e}, no motion at r = {r:?}, {share} of the limits {limits:?}, answers {:?}", at.limits()));
            continue;
        };
        let contact = motion.contact();
        let Ok(reference) = reference.motion(beta.to_f64()) else {
            continue;
        };
        let nearby = moved.motion(beta.to_f64());
        let reference = reference.contact();
        let (amplitude, phase) = (reference.amplitude(), reference.phase());
        let (amplitude_moved, phase_moved) = match &nearby {
            Ok(moved) => (moved.contact().amplitude(), moved.contact().phase()),
            Err(_) => (amplitude, phase),
        };
        let rounding =
            sum_rounding(&exact, r) / (1.0 - share * share) + S::EPSILON * 16.0 / (1.0 - share);
        let noise = (amplitude_moved - amplitude).abs() + rounding * amplitude;
        let error = ((contact.amplitude().to_f64() - amplitude).abs() - noise).max(0.0)
            / amplitude
            / accuracy;
        let turn = |angle: f64| (angle - (angle / (2.0 * PI)).round() * 2.0 * PI).abs();
        let noise = turn(phase_moved - phase) + rounding;
        let turned = (turn(contact.phase().to_f64() - phase) - noise).max(0.0) / accuracy;
        tally.compared += 2;
        for (which, error) in [(2, error), (3, turned)] {
            tally.worst[which] = tally.worst[which].max(error);
            if !(error <= 1.0) {
                let which = ["amplitude", "phase"][which - 2];
                tally.failures.push(format!(
                    "{name}, {accuracy:e}, {which} at r = {r:?}, {share} of the limit: {error}"
                ));
            }
        }
    }
}

/// Roundings of V and H over V and H: the sums over modes cancel beside zeros.
fn sum_rounding(system: &System<f64>, r: f64) -> f64 {
    let modal = system.modal();
    let direct = if modal.on_moving_base { 1.0 } else { 0.0 };
    let (mut v, mut v_size, mut h, mut h_size) = ([-direct, 0.0], direct, [0.0, 0.0], 0.0);
    let modes = modal.resonances.iter().zip(&modal.damping_ratios);
    for ((sigma, zeta), (load, contact)) in modes.zip(modal.loads.iter().zip(&modal.contacts)) {
        let (sigma, zeta) = (sigma.to_f64(), zeta.to_f64());
        let (load, contact) = (load.to_f64(), contact.to_f64());
        let (re, im) = ((sigma - r) * (sigma + r), 2.0 * zeta * sigma * r);
        let size = re.hypot(im);
        if size == 0.0 || contact == 0.0 {
            continue;
        }
        let inverse = [re / size / size, -im / size / size];
        for k in 0..2 {
            v[k] += load * contact * inverse[k];
            h[k] += contact * contact * inverse[k];
        }
        v_size += (load * contact).abs() / size;
        h_size += contact * contact / size;
    }
    let worse = (v_size / v[0].hypot(v[1])).max(h_size / h[0].hypot(h[1]));
    4.0 * f64::EPSILON * worse
}

fn told(what: &str, tally: &Tally) {
    let [limit, sliding, amplitude, phase] = tally.worst;
    println!(
        "{what}: {} points, {} skipped, {} answers compared; largest errors over the accuracy: limit {limit:.3}, sliding {sliding:.3}, amplitude {amplitude:.3}, phase {phase:.3}; {} without a table",
        tally.points,
        tally.skipped,
        tally.compared,
        tally.unmet.len(),
    );
    for unmet in &tally.unmet {
        println!("  no table: {unmet}");
    }
    for failure in tally.failures.iter().take(20) {
        println!("  {failure}");
    }
}

fn chains<S: Float>(budgets: &[f64], default: usize) {
    let count = points(default);
    // ACCURACY chooses one of the budgets.
    let only = std::env::var("ACCURACY")
        .ok()
        .and_then(|only| only.parse::<f64>().ok());
    let budgets = budgets
        .iter()
        .filter(|accuracy| only.is_none_or(|only| only == **accuracy));
    let scalar = if S::EPSILON > 1e-10 { "f32" } else { "f64" };
    for accuracy in budgets {
        let mut tally = Tally::default();
        for (name, text) in scenes(scalar) {
            check::<S>(&name, &text, *accuracy, count, &mut tally);
        }
        told(&format!("44 chains, {scalar}, {accuracy:e}"), &tally);
        assert!(tally.compared >= 44 * 4 * count / 2);
        assert_eq!(tally.by_sums, 0);
        assert!(
            tally.failures.is_empty(),
            "{} answers are off",
            tally.failures.len()
        );
        // 1e-12 asks of some undamped scenes more than double precision has beside zeros.
        assert!(*accuracy < 1e-11 || tally.unmet.is_empty());
    }
}

fn random_scenes(budgets: &[f64], count: usize, default: usize) {
    for accuracy in budgets {
        let mut random = Random(20_211_122);
        let mut tally = Tally::default();
        for number in 0..count {
            let text = random::scene(&mut random);
            check::<f64>(
                &format!("scene {number}"),
                &text,
                *accuracy,
                points(default),
                &mut tally,
            );
        }
        told(&format!("{count} random scenes, {accuracy:e}"), &tally);
        println!("{} scenes with sums for β*_lim", tally.by_sums);
        assert!(tally.by_sums * 10 <= count, "{}", tally.by_sums);
        assert!(
            tally.failures.is_empty(),
            "{} answers are off",
            tally.failures.len()
        );
        // Where a mode hardly touches the contact, undamped, a sub-harmonic is 10⁻⁹ of r wide, and rounding r moves a
        // limit by 10⁻⁶ of itself.
        let most = if *accuracy < 1e-5 {
            count / 6
        } else {
            count / 50
        };
        assert!(
            tally.unmet.len() <= most,
            "{} without a table",
            tally.unmet.len()
        );
    }
}

#[test]
fn of_chains() {
    chains::<f64>(&[1e-2, 1e-4, 1e-6, 1e-9], 100);
}

#[test]
fn of_chains_in_single_precision() {
    chains::<f32>(&[1e-2, 1e-3, 1e-4, 1e-5], 100);
}

#[test]
fn of_random_scenes() {
    random_scenes(&[1e-3, 1e-6], 10, 200);
}

#[test]
#[ignore = "a million points a scene: POINTS=1000000, hours; a hundred thousand, ten minutes"]
fn of_chains_whole() {
    chains::<f64>(&[1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12], 100_000);
    chains::<f32>(&[1e-2, 1e-3, 1e-4, 1e-5], 100_000);
}

#[test]
#[ignore = "a hundred scenes"]
fn of_random_scenes_whole() {
    random_scenes(&[1e-2, 1e-3, 1e-4, 1e-6, 1e-9], 100, 100_000);
}

/// A mode that the contact drives and the load does not: a pole of H alone, at which β*_lim vanishes.
#[test]
fn of_a_mode_that_the_load_does_not_drive() {
    for damping in ["none", "modal(0.03)"] {
        let text = format!(
            "struct Symmetric {{ masses: {{ a: 1, c: 2, b: 1 }},
            springs: {{ base - a: 1, a - c: 1, c - b: 1, wall - b: 1 }},
            contact: a - wall, excitation: c, damping: {damping} }}"
        );
        let mut tally = Tally::default();
        check::<f64>("Symmetric", &text, 1e-4, 2000, &mut tally);
        told(&format!("a symmetric chain, {damping}"), &tally);
        assert_eq!((tally.by_sums, tally.unmet.len()), (0, 0));
        assert!(tally.failures.is_empty());
    }
}

/// Of several modes one may be undamped: β_lim vanishes at its sub-harmonics, whatever damps the others.
#[test]
fn of_one_undamped_mode_among_damped_ones() {
    let text = "struct Mixed { masses: { a: 1, b: 2, c: 1 },
        springs: { base - a: 1, a - b: 1, b - c: 2 },
        contact: c - wall, excitation: a, damping: modal[0.02, 0, 0.05] }";
    for accuracy in [1e-2, 1e-4, 1e-6] {
        let mut tally = Tally::default();
        check::<f64>("Mixed", text, accuracy, 2000, &mut tally);
        told(&format!("one undamped mode of three, {accuracy:e}"), &tally);
        assert!(tally.unmet.is_empty() && tally.failures.is_empty());
    }
}
