//! Compares steady states with the reference file, with formulas and with motions in time. Further tests check the
//! response of the chain while no contact slides, and damping matrices.

use super::super::Steady;
use super::super::{Motion, stuck_response};
use super::reference::{chain, list, number, numbers, read};
use super::steady_from_rest;
use super::steady_state_from;
use super::{Chain, Random, Wave, random_chain, rigid};
use frictiongen_kernel::joints;
use frictiongen_model::scene::Node::{Base, Mass, Wall};
use serde_json::Value;
use std::f64::consts::TAU;

/// Returns the largest difference of a steady state from the reference file. Differences of amplitudes are divided by
/// the largest amplitude, and those of stuck fractions by 10.
fn differs(steady: &Steady, expected: &Value) -> f64 {
    let amplitudes = numbers(&expected["amplitude"]);
    let largest = amplitudes.iter().fold(0.0_f64, |m, x| m.max(*x));
    let amplitudes = steady.cycle.amplitudes.iter().zip(&amplitudes);
    let amplitudes = amplitudes.map(|(got, expected)| (got - expected).abs() / largest);
    let stuck = numbers(&expected["stuck_fraction"]);
    let stuck = steady.cycle.contacts.iter().zip(stuck);
    let stuck = stuck.map(|(got, expected)| (got.stuck_fraction - expected).abs() / 10.0);
    amplitudes.chain(stuck).fold(0.0, f64::max)
}

/// Returns the steady state that the motion from rest reaches, with what it leaves in contacts that never slide. The
/// reference has the same.
fn from_rest(chain: &Chain, omega: f64) -> Steady {
    let motion = Motion::from_rest(chain).expect("a chain");
    steady_state_from(motion, omega).expect("a steady state")
}

#[test]
fn steady_states_are_those_of_the_reference() {
    let all = read();
    let mut worst = 0.0_f64;
    for (index, scene) in list(&all["scenes"]).iter().enumerate() {
        let omega = number(&scene["omega"]);
        let expected = &scene["steady"];
        let cycles = number(&expected["cycles_to_settle"]);
        let steady = from_rest(&chain(scene, omega), omega);
        let differs = differs(&steady, expected);
        println!(
            "scene {index}: {differs:.1e} after {cycles} cycles, marginal {:?}, residual {:.1e}, |multiplier| {:.3}",
            steady.marginal,
            steady.residual,
            steady.multipliers[0].norm()
        );
        // The reference is accurate to 1e-9 only if its motion settles within 200 cycles.
        if cycles < 200.0 {
            assert!(differs < 1e-9, "scene {index}: {differs:.1e}");
            worst = worst.max(differs);
        }
        let stops = steady.cycle.contacts.iter().map(|c| Value::from(c.stops));
        let stops: Vec<Value> = stops.collect();
        assert_eq!(&stops, list(&expected["stops"]), "scene {index}");
        assert_eq!(steady.period, 1);
    }
    let scene = &all["jenkins_chain"];
    for expected in list(&scene["steady"]) {
        let omega = number(&expected["omega"]);
        let steady = from_rest(&chain(scene, omega), omega);
        let differs = differs(&steady, expected);
        println!("ω = {omega}: {differs:.1e}, marginal {:?}", steady.marginal);
        assert!(differs < 1e-9, "ω = {omega}: {differs:.1e}");
        worst = worst.max(differs);
    }
    println!("{worst:.1e}");
}

/// Checks that an elastic contact with two stops in a cycle dissipates the energy 4F(X − F/k). X is the amplitude of
/// the mass, F the friction force and k the stiffness of the contact.
#[test]
fn energy_of_a_cycle_is_the_area_of_the_loop() {
    let all = read();
    let mut seen = 0;
    for scene in list(&all["scenes"]) {
        if list(&scene["masses"]).len() > 1 {
            continue;
        }
        let omega = number(&scene["omega"]);
        let steady = steady_from_rest(&chain(scene, omega), omega).expect("a steady state");
        let contact = &scene["contacts"][0];
        let (force, stiffness) = (number(&contact["force"]), number(&contact["stiffness"]));
        let slip = steady.cycle.amplitudes[0] - force / stiffness;
        let got = &steady.cycle.contacts[0];
        assert!(
            (got.energy - 4.0 * force * slip).abs() < 1e-12 * got.energy,
            "{got:?}"
        );
        assert!((got.slip - 4.0 * slip).abs() < 1e-12 * got.slip, "{got:?}");
        assert!((got.force - force).abs() < 1e-14 * force, "{got:?}");
        seen += 1;
    }
    assert!(seen >= 3);
}

/// Checks that a small deviation from the steady state decays as the largest Floquet multiplier predicts.
#[test]
fn changes_decay_with_the_multipliers() {
    let all = read();
    let scene = &list(&all["scenes"])[9];
    let omega = number(&scene["omega"]);
    let chain = chain(scene, omega);
    let steady = steady_from_rest(&chain, omega).expect("a steady state");
    let mut motion = Motion::from_rest(&chain).expect("a chain");
    let mut state = steady.state.clone();
    state.v[1] += 1e-6;
    let mut changes = Vec::new();
    for _ in 0..60 {
        motion.restart(state);
        motion
            .run(TAU / omega, &mut |_, _, _| {})
            .expect("a motion");
        state = motion.state().clone();
        let size = state
            .x
            .iter()
            .zip(&steady.state.x)
            .map(|(a, b)| (a - b).powi(2));
        changes.push(size.sum::<f64>().sqrt());
    }
    // The largest multiplier belongs to a complex pair, so that the decay differs from cycle to cycle. The test
    // therefore takes a mean over 30 cycles.
    let rate = (changes[59] / changes[29]).powf(1.0 / 30.0);
    let expected = steady.multipliers[0].norm();
    assert!(
        (rate - expected).abs() < 0.02 * expected,
        "{rate} {expected}"
    );
    assert!(steady.is_stable());
}

/// Compares the steady state under very large friction forces with the closed form of the chain while no contact
/// slides.
#[test]
fn the_stuck_chain_is_the_steady_state_with_large_levels() {
    let mut random = Random::new(77);
    let (mut seen, mut worst) = (0, 0.0_f64);
    while seen < 4 {
        let (mut chain, omega) = random_chain(&mut random);
        let held = chain.springs.first().is_some_and(|spring| spring.0 == Base);
        if chain.contacts.is_empty() || !held {
            continue;
        }
        for contact in &mut chain.contacts {
            contact.level.constant *= 1e3;
        }
        for (i, row) in chain.damping.iter_mut().enumerate() {
            row[i] += 30.0;
        }
        let stuck = stuck_response(&chain).expect("a response");
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let (mut forces, mut highest, mut lowest) =
            (vec![0.0_f64; 4], vec![-1e9_f64; 6], vec![1e9_f64; 6]);
        let cycles = (4.0 * omega).ceil();
        motion
            .run(cycles * TAU / omega, &mut |_, _, _| {})
            .expect("a motion");
        for part in 1..=720 {
            let until = (cycles + f64::from(part) / 720.0) * TAU / omega;
            motion
                .run(until, &mut |series, end, _| {
                    for (j, force) in forces.iter_mut().enumerate().take(chain.contacts.len()) {
                        *force = force.max(series.force(j, end).abs());
                    }
                })
                .expect("a motion");
            for (i, x) in motion.state().x.iter().enumerate() {
                highest[i] = highest[i].max(*x);
                lowest[i] = lowest[i].min(*x);
            }
        }
        let largest = stuck.amplitudes.iter().fold(1e-12_f64, |m, x| m.max(*x));
        for (i, amplitude) in stuck.amplitudes.iter().enumerate() {
            // The samples miss a maximum by at most the fraction (π/720)²/2, which is 1e-5.
            let miss = (0.5 * (highest[i] - lowest[i]) - amplitude).abs() / largest;
            assert!(miss < 2e-5, "{miss:.1e} {chain:?}");
            worst = worst.max(miss);
        }
        let most = stuck.forces.iter().fold(1e-12_f64, |m, x| m.max(*x));
        for (got, expected) in forces.iter().zip(&stuck.forces) {
            assert!(
                (got - expected).abs() < 2e-5 * most,
                "{forces:?} {:?} {chain:?}",
                stuck.forces
            );
        }
        seen += 1;
    }
    println!("{worst:.1e}");
}

/// Checks that no contact slides if the friction just exceeds the limit of the stuck response. If the friction is just
/// below the limit, the contact that the response names must slide.
#[test]
fn the_limit_names_the_contact_that_goes_first() {
    let make = |factor: f64| Chain {
        masses: vec![1.3, 2.0, 0.8],
        springs: vec![
            (Base, Mass(0), 900.0),
            (Mass(0), Mass(1), 1500.0),
            (Mass(1), Mass(2), 700.0),
        ],
        dashpots: vec![
            (Mass(0), Base, 20.0),
            (Mass(1), Base, 30.0),
            (Mass(1), Mass(2), 25.0),
        ],
        contacts: vec![
            rigid((Mass(0), Wall), factor, 1.2),
            super::Joint {
                stiffness: Some(800.0),
                speed: 0.0,
                ..rigid((Mass(2), Mass(1)), 0.5 * factor, 1.0)
            },
        ],
        loads: vec![(2, Wave::harmonic(7.0, 19.0))],
        ..Chain::default()
    };
    let stuck = stuck_response(&make(1.0)).expect("a response");
    let (limit, first) = stuck.limit.expect("a limit");
    for (share, slides) in [(1.001, false), (0.999, true)] {
        let mut motion = Motion::from_rest(&make(limit * share)).expect("a chain");
        // The motion from rest overshoots. The test therefore first lets it settle with much larger friction forces,
        // and continues from the settled state.
        let mut far = Motion::from_rest(&make(1e6)).expect("a chain");
        far.run(80.0 * TAU / 19.0, &mut |_, _, _| {})
            .expect("a motion");
        motion.restart(far.state().clone());
        let events = motion
            .run(3.0 * TAU / 19.0, &mut |_, _, _| {})
            .expect("a motion");
        assert_eq!(!events.is_empty(), slides, "{share}: {events:?}");
        if let Some(event) = events.first() {
            assert_ne!(event.after[first], 0, "{event:?}");
        }
    }
}

/// Checks random scenes in which only the contacts dissipate energy. The energies of the contacts must equal the work
/// of the load.
#[test]
fn energies_of_contacts_are_what_the_load_puts_in() {
    let mut random = Random::new(123);
    let mut seen = 0;
    for _ in 0..8 {
        let (mut chain, omega) = random_chain(&mut random);
        // Without modal damping, only the contacts dissipate energy.
        chain.damping.clear();
        chain.dashpots.clear();
        chain.base = Wave::default();
        chain.loads = vec![(0, Wave::harmonic(20.0, omega))];
        for contact in &mut chain.contacts {
            contact.stiction = 1.0;
        }
        let Ok(steady) = steady_from_rest(&chain, omega) else {
            continue;
        };
        let mut motion = Motion::from_rest(&chain).expect("a chain");
        let mut work = 0.0;
        motion.restart(steady.state.clone());
        for _ in 0..steady.period {
            motion.restart(motion.state().clone());
            motion
                .run(TAU / omega, &mut |series, end, _| {
                    for (node, weight) in super::energy::gauss() {
                        let speed = joints::value(&series.velocity_terms(0), node * end);
                        let load =
                            20.0 * (omega * (series.start + node * end * series.length)).cos();
                        work += weight * end * series.length * load * speed;
                    }
                })
                .expect("a motion");
        }
        let taken: f64 = steady.cycle.contacts.iter().map(|c| c.energy).sum();
        let size = 20.0 * steady.cycle.amplitudes[0];
        assert!(
            (work - taken).abs() < 1e-10 * size,
            "{work} {taken} {chain:?}"
        );
        seen += usize::from(taken > 1e-6 * size);
    }
    println!("{seen} scenes");
    assert!(seen >= 3, "{seen}");
}

/// Compares damping matrices with those from a separate eigensolver in the tests.
#[test]
fn damping_matrices_are_those_of_another_eigensolver() {
    let mut random = Random::new(31);
    for _ in 0..50 {
        let (mut chain, _) = random_chain(&mut random);
        let n = chain.masses.len();
        let zeta: Vec<f64> = (0..n).map(|_| random.between(0.0, 0.1)).collect();
        let expected = super::modal(&chain.masses, &chain.springs, &zeta);
        chain.damp_modes(&zeta).expect("ratios");
        let size = expected
            .iter()
            .flatten()
            .fold(1e-9_f64, |m, c| m.max(c.abs()));
        for (got, expected) in chain
            .damping
            .iter()
            .flatten()
            .zip(expected.iter().flatten())
        {
            assert!((got - expected).abs() < 1e-12 * size, "{got} {expected}");
        }
        chain.damp_by_rayleigh(0.3, 2e-3).expect("factors");
        let k = super::stiffness(n, &chain.springs);
        for (i, row) in chain.damping.iter().enumerate() {
            for (j, got) in row.iter().enumerate() {
                let mass = if i == j { 0.3 * chain.masses[i] } else { 0.0 };
                assert!((got - (2e-3 * k[i][j] + mass)).abs() < 1e-12, "{got}");
            }
        }
        assert!(chain.damp_modes(&[0.1; 9]).is_err());
    }
}
