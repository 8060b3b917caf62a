//! Tests of steady states of random scenes, with periods of any length. A third of the scenes have no support.

use super::super::{Joint, JointError, Motion, State, Wave};
use super::steady_state_from;
use super::{Chain, Random, random_chain};
use std::f64::consts::TAU;

/// Advances the motion from the state `start` by a number of cycles, and returns the state after each cycle.
fn states(chain: &Chain, start: &State, omega: f64, cycles: usize) -> Vec<State> {
    let mut motion = Motion::from_rest(chain).expect("a chain");
    motion.restart(start.clone());
    let states = (0..cycles).map(|_| {
        motion
            .run(TAU / omega, &mut |_, _, _| {})
            .expect("a motion");
        motion.restart(motion.state().clone());
        motion.state().clone()
    });
    states.collect()
}

/// Returns the largest difference between the displacements of two states.
fn away(a: &State, b: &State) -> f64 {
    let differences = a.x.iter().zip(&b.x).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

/// A random scene in which elastic contacts share the nodes of other contacts. A rigid contact then often holds the two
/// sides of an elastic contact together while the force of the elastic contact is at its limit.
fn crowded(random: &mut Random) -> (Chain, f64) {
    let (mut chain, omega) = random_chain(random);
    let beside: Vec<Joint> = chain
        .contacts
        .iter()
        .map(|contact| Joint {
            ends: contact.ends,
            level: Wave::constant(random.between(0.5, 6.0)),
            stiction: if random.unit() < 0.5 { 1.0 } else { 1.2 },
            stiffness: Some(random.between(500.0, 5000.0)),
            speed: 0.0,
        })
        .collect();
    chain.contacts.extend(beside);
    (chain, omega)
}

/// Checks that a motion that the search calls unsettled does not repeat after 600 cycles, within 1e-6 of its size.
fn never_repeats(chain: &Chain, omega: f64, index: usize) {
    let rest = Motion::from_rest(chain).expect("a chain").state().clone();
    let states = states(chain, &rest, omega, 600);
    let last = &states[599];
    let size = last.x.iter().fold(1e-12_f64, |m, x| m.max(x.abs()));
    for period in 1..=8 {
        let back = away(last, &states[599 - period]);
        assert!(
            back > 1e-6 * size,
            "scene {index} repeats after {period} cycles"
        );
    }
}

/// Checks steady states of random scenes. Returns the number of scenes in which the search finds no steady state, and
/// the number of scenes with a period of several cycles.
fn settle(count: usize, scene: impl Fn(&mut Random) -> (Chain, f64)) -> (usize, usize) {
    let mut random = Random::new(99);
    let (mut open, mut several, mut compared) = (0, 0, 0);
    for index in 0..count {
        let (chain, omega) = scene(&mut random);
        let rest = Motion::from_rest(&chain).expect("a chain");
        let steady = match steady_state_from(rest, omega) {
            Ok(steady) => steady,
            Err(error) => {
                assert_eq!(error, JointError::NotSteady, "scene {index}");
                never_repeats(&chain, omega, index);
                open += 1;
                continue;
            }
        };
        let size = steady
            .cycle
            .amplitudes
            .iter()
            .fold(1e-12_f64, |m, x| m.max(*x));
        let period = states(&chain, &steady.state, omega, steady.period);
        let back = away(&period[steady.period - 1], &steady.state);
        assert!(
            back < 1e-10 * size,
            "scene {index}: {back:.1e} of {size:.1e}"
        );
        // The motion must not repeat after fewer cycles than the period.
        for state in period.iter().take(steady.period - 1) {
            assert!(away(state, &steady.state) > 1e-6 * size, "scene {index}");
        }
        several += usize::from(steady.period > 1);
        // If the motion from rest settles within 150 cycles, it must reach one of the states of this period.
        let rate = steady.multipliers.first().map_or(0.0, |m| m.norm());
        if rate.powf(150.0 / steady.period as f64) < 1e-9 && steady.neutral == 0 {
            let rest = Motion::from_rest(&chain).expect("a chain").state().clone();
            let settled = states(&chain, &rest, omega, 200);
            let last = &settled[199];
            let nearest = period.iter().map(|state| away(state, last));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(
                nearest < 1e-6 * size,
                "scene {index}: {nearest:.1e} of {size:.1e}"
            );
            compared += 1;
        }
    }
    println!(
        "{count} scenes: {open} not settled, {several} of several cycles, {compared} compared with motions"
    );
    assert!(compared > count / 4, "{compared}");
    (open, several)
}

#[test]
fn random_scenes_settle() {
    let (open, _) = settle(12, random_chain);
    assert_eq!(open, 0);
    let (open, _) = settle(12, crowded);
    assert!(open <= 1, "{open}");
}

/// Repeats `random_scenes_settle` with more scenes. Some scenes have periods of several cycles.
#[test]
#[ignore = "half a minute"]
fn random_scenes_settle_long() {
    let (open, several) = settle(300, random_chain);
    assert!(open <= 3 && several >= 3, "{open} {several}");
    let (open, _) = settle(300, crowded);
    assert!(open <= 3, "{open}");
}
