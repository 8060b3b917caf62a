//! Compares steady states with the motion from rest, cycle after cycle. All contacts of the chains are elastic with μ
//! = 1. For such chains, the search may return a steady state before the motion has settled.

use super::super::{Motion, State};
use super::steady_from_rest;
use super::steady_state_from;
use super::{Chain, Random, random_chain};
use std::f64::consts::TAU;

/// Largest number of cycles of the load for which the tests follow the motion from rest.
const CYCLES: usize = 4000;

/// Returns the largest difference of motion and the largest difference of contact forces between the states a and b.
/// The difference of motion is that of displacements, or that of velocities divided by ω. Contact forces are divided
/// by their friction force.
fn away(chain: &Chain, omega: f64, (a, b): (&State, &State)) -> (f64, f64) {
    let most = |a: &[f64], b: &[f64]| {
        let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, f64::max)
    };
    let contacts = chain.contacts.iter().enumerate();
    let forces = contacts.map(|(j, contact)| {
        let differs = a.forces[j] - b.forces[j];
        (differs / contact.level.constant).abs()
    });
    let motion = most(&a.x, &b.x).max(most(&a.v, &b.v) / omega);
    (motion, forces.fold(0.0, f64::max))
}

/// Follows the motion from rest until it repeats, and returns the last state. Returns `None` if the motion does not
/// repeat.
fn settled(chain: &Chain, omega: f64) -> Option<State> {
    let mut motion = Motion::from_rest(chain).expect("a chain");
    let mut quiet = 0;
    for _ in 0..CYCLES {
        let before = motion.state().clone();
        motion.restart(before.clone());
        motion
            .run(TAU / omega, &mut |_, _, _| {})
            .expect("a motion");
        let size = motion
            .state()
            .x
            .iter()
            .fold(1e-12_f64, |m, x| m.max(x.abs()));
        let (moved, forces) = away(chain, omega, (motion.state(), &before));
        let repeats = moved < 1e-13 * size && forces < 1e-12;
        quiet = if repeats { quiet + 1 } else { 0 };
        if quiet == 20 {
            return Some(motion.state().clone());
        }
    }
    None
}

/// Checks that the steady state without a given start repeats with the opposite sign after half a cycle, the forces of
/// contacts that never slide included. If all contacts slide, it is `expected`, the state that the motion from rest
/// reaches.
fn centred(chain: &Chain, omega: f64, expected: Option<&State>) {
    let steady = steady_from_rest(chain, omega).expect("a steady state");
    let size = steady
        .cycle
        .amplitudes
        .iter()
        .fold(0.0_f64, |m, x| m.max(*x));
    let mut motion = Motion::from_rest(chain).expect("a chain");
    motion.restart(steady.state.clone());
    motion
        .run(0.5 * TAU / omega, &mut |_, _, _| {})
        .expect("a motion");
    let mut opposite = motion.state().clone();
    let numbers = opposite.x.iter_mut().chain(&mut opposite.v);
    for number in numbers.chain(&mut opposite.forces) {
        *number = -*number;
    }
    let (moved, forces) = away(chain, omega, (&opposite, &steady.state));
    // Newton's method ends at a residual of some 1e-13 of the size of the motion.
    assert!(
        moved < 1e-11 * size && forces < 1e-10,
        "{moved:.1e} {forces:.1e}"
    );
    if let Some(expected) = expected {
        let (moved, forces) = away(chain, omega, (&steady.state, expected));
        assert!(
            moved < 1e-9 * size && forces < 1e-9,
            "{moved:.1e} {forces:.1e}"
        );
    }
}

/// Compares the steady states of random scenes with the motions from rest. Returns the largest difference, and the
/// number of scenes in which one contact never slides although another contact slides.
fn compare(count: usize) -> (f64, usize) {
    let mut random = Random::new(461);
    let (mut worst, mut mixed, mut compared) = (0.0_f64, 0, 0);
    while compared < count {
        let (mut chain, omega) = random_chain(&mut random);
        let held = chain.springs.len() == chain.masses.len();
        for contact in &mut chain.contacts {
            let stiffness = random.between(500.0, 20000.0);
            contact.stiffness = contact.stiffness.or(Some(stiffness));
            contact.stiction = 1.0;
        }
        if chain.contacts.is_empty() || !held {
            continue;
        }
        let Some(expected) = settled(&chain, omega) else {
            continue;
        };
        let rest = Motion::from_rest(&chain).expect("a chain");
        let steady = steady_state_from(rest, omega).expect("a steady state");
        assert_eq!(steady.period, 1);
        centred(
            &chain,
            omega,
            steady.marginal.is_empty().then_some(&expected),
        );
        let size = steady
            .cycle
            .amplitudes
            .iter()
            .fold(0.0_f64, |m, x| m.max(*x));
        let (motion, forces) = away(&chain, omega, (&steady.state, &expected));
        let differs = (motion / size).max(forces);
        // Successive cycles of the motion from rest differ by less than 1e-13. With a multiplier of 0.999, the distance
        // from the steady state is then 1e-10.
        assert!(differs < 1e-9, "scene {compared}: {differs:.1e}");
        worst = worst.max(differs);
        let marginal = steady.marginal.len();
        mixed += usize::from(marginal > 0 && marginal < chain.contacts.len());
        compared += 1;
    }
    println!("{count} scenes: {worst:.1e}, {mixed} with contacts of both kinds");
    (worst, mixed)
}

#[test]
fn steady_states_are_those_that_the_motion_from_rest_reaches() {
    let (_, mixed) = compare(12);
    assert!(mixed > 0);
}

/// Repeats `steady_states_are_those_that_the_motion_from_rest_reaches` with more random scenes.
#[test]
#[ignore = "half a minute"]
fn steady_states_are_those_that_the_motion_from_rest_reaches_long() {
    let (_, mixed) = compare(300);
    assert!(mixed > 20, "{mixed}");
}
