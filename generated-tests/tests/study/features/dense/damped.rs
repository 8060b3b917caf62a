//! Tests the regimes and the crossings of damped chains, which the features find by sampling. They may miss no range
//! that is longer than one of their steps.

use super::dense;
use crate::features::scenes::{random, shown};
use frictiongen::study::{System, features::Certainty};
use frictiongen::{LimitsAt, Of, Regime};
use fuzzing::Random;

/// Number of samples of the test for each step of the search.
const CLOSER: usize = 8;
const DENSE: usize = CLOSER * Certainty::STEPS as usize;
/// Relative distance below which two frequencies count as one.
const NEAR: f64 = 1e-9;

fn range(system: &System) -> [f64; 2] {
    let largest = *system.resonances().last().unwrap();
    [0.15 * largest, 2.0 * largest]
}

#[test]
fn regimes_of_damped_chains() {
    let mut random_numbers = Random(26);
    let (mut stretches, mut short, mut missed) = (0, 0, 0);
    for _ in 0..16 {
        let system = random(&mut random_numbers, 5, true);
        let range = range(&system);
        let beta = random_numbers.log_uniform(0.05, 1.5);
        let features = system.features(None).unwrap();
        let (ranges, certainty) = features.regimes(beta, range).unwrap();
        let steps = Certainty::STEPS;
        assert_eq!(certainty, Certainty::Sampled { steps });
        let mut found = ranges.iter();
        let mut own = found.next().unwrap();
        // The loop counts consecutive samples in one regime, and samples whose regime differs from that of the list.
        let (mut last, mut row, mut wrong) = (None, 0, 0);
        for r in dense(range, DENSE) {
            let limits = system.at(r).unwrap().limits();
            let regime = if beta < limits.continuous.min(limits.sliding) {
                Regime::Continuous
            } else if beta < limits.sliding {
                Regime::StickSlip
            } else {
                Regime::Stuck
            };
            while own.to < r {
                own = found.next().unwrap();
            }
            if last != Some(regime) {
                stretches += 1;
                short += usize::from(last.is_some() && row < CLOSER);
                (last, row) = (Some(regime), 0);
            }
            row += 1;
            let beside = [own.from, own.to]
                .into_iter()
                .any(|end| (end / r - 1.0).abs() < NEAR);
            wrong = if beside || own.regime == regime {
                0
            } else {
                missed += 1;
                wrong + 1
            };
            assert!(
                wrong <= CLOSER,
                "{r}, β = {beta}: {regime:?} in {own:?}, {}",
                shown(&system)
            );
        }
    }
    println!(
        "{stretches} stretches, {short} of them shorter than a step; {missed} samples in another regime than listed"
    );
    assert!(stretches > 60, "{stretches}");
    assert_eq!(missed, 0);
}

#[test]
fn crossings_of_damped_chains() {
    let mut random_numbers = Random(27);
    let (mut crossed, mut missed) = (0, 0);
    for _ in 0..8 {
        let system = random(&mut random_numbers, 4, true);
        let range = range(&system);
        let betas = [0.02, 0.1].map(|beta| beta * random_numbers.log_uniform(0.5, 2.0));
        let features = system.features(None).unwrap();
        let mass = random_numbers.below(system.scene().masses.len());
        let found = features.crossings(Of::Mass(mass), betas, range).unwrap();
        let amplitude = |r: f64, beta: f64| -> Option<f64> {
            let motion = system.at(r).ok()?.motion(beta).ok()?;
            Some(motion.mass_at(mass)?.amplitude())
        };
        let gain = |r: f64| {
            let [less, more] = betas.map(|beta| amplitude(r, beta));
            let (less, more) = (less?, more?);
            // A difference within rounding counts as 0, because its sign is random.
            let gain = more - less;
            (1e-11 * less < gain.abs()).then_some(gain)
        };
        let mut last: Option<(f64, f64)> = None;
        for r in dense(range, DENSE / 4) {
            let now = gain(r).map(|gain| (r, gain));
            if let (Some((before, was)), Some((_, is))) = (last, now)
                && was * is < 0.0
            {
                crossed += 1;
                let within = |place: f64| before <= place && place <= r;
                missed += usize::from(!found.iter().any(|crossing| within(crossing.r)));
            }
            last = now;
        }
    }
    println!("{crossed} crossings, {missed} missed");
    assert!(crossed > 10, "{crossed}");
    assert_eq!(missed, 0);
}
