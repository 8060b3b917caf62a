//! Tests of the energy balance: the work of loads and base equals the increase of the stored energy plus the energy
//! that damping, dashpots and contacts dissipate.

use super::super::{JointError, Motion, Series, State};
use super::{Chain, Random, random_chain};
use frictiongen_model::scene::Node;
use std::f64::consts::TAU;

/// Returns points and weights of Gaussian integration with ten points on [0, 1], computed by Newton's method.
pub fn gauss() -> Vec<(f64, f64)> {
    let n = 10;
    let nodes = (1..=n).map(|i| {
        let mut x = (std::f64::consts::PI * (f64::from(i) - 0.25) / (f64::from(n) + 0.5)).cos();
        let mut slope = 0.0;
        for _ in 0..10 {
            let (mut p, mut before) = (x, 1.0);
            for k in 2..=n {
                let k = f64::from(k);
                (p, before) = (((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k, p);
            }
            slope = f64::from(n) * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    });
    nodes.collect()
}

/// Returns the kinetic energy of the masses plus the elastic energy of springs and elastic contacts.
fn energy(chain: &Chain, motion: &Motion, forces: &[f64]) -> f64 {
    let (x, v) = (&motion.state().x, &motion.state().v);
    let base = chain.base.amplitude * (chain.base.omega * motion.time()).cos();
    let place = |node| match node {
        Node::Mass(i) => x[i],
        Node::Wall => 0.0,
        Node::Base => base,
    };
    let kinetic: f64 = chain
        .masses
        .iter()
        .zip(v)
        .map(|(m, v)| m * v * v / 2.0)
        .sum();
    let springs = chain.springs.iter();
    let springs: f64 = springs
        .map(|&(a, b, k)| k * (place(a) - place(b)).powi(2) / 2.0)
        .sum();
    let contacts = chain.contacts.iter().zip(forces);
    let contacts = contacts.filter_map(|(c, f)| c.stiffness.map(|k| f * f / k / 2.0));
    kinetic + springs + contacts.sum::<f64>()
}

/// Returns the power of the loads and the dissipated power at an instant of a stretch (time interval of a power
/// series).
fn powers(chain: &Chain, motion: &super::super::Model, series: &Series, at: f64) -> (f64, f64) {
    let (x, v) = series.motion(motion, at);
    let (y, dy) = series.base(at);
    let time = series.start + at * series.length;
    let quantity = |node, masses: &[f64], base| match node {
        Node::Mass(i) => masses[i],
        Node::Wall => 0.0,
        Node::Base => base,
    };
    let mut input = motion.load_power(time, &v);
    for &(a, b, k) in &chain.springs {
        let pull = k * (quantity(a, &x, y) - quantity(b, &x, y));
        for (node, sign) in [(a, 1.0), (b, -1.0)] {
            if node == Node::Base {
                input += sign * pull * dy;
            }
        }
    }
    let mut lost = 0.0;
    for &(a, b, c) in &chain.dashpots {
        lost += c * (quantity(a, &v, dy) - quantity(b, &v, dy)).powi(2);
    }
    for (row, v_row) in chain.damping.iter().zip(&v) {
        lost += v_row * row.iter().zip(&v).map(|(c, v)| c * v).sum::<f64>();
    }
    (input, lost)
}

/// Returns the error of the energy balance of one scene over some cycles, and the number of events. The error is
/// divided by the energy at the start plus the absolute work of load and base. The absolute work counts energy put in
/// and energy taken out as positive.
fn balance(chain: &Chain, omega: f64, cycles: f64) -> Result<(f64, usize), JointError> {
    let mut motion = Motion::from_rest(chain)?;
    let model = motion.model().clone();
    let nodes = gauss();
    let start = energy(chain, &motion, &vec![0.0; chain.contacts.len()]);
    let (mut put, mut lost, mut moved) = (0.0, 0.0, 0.0);
    let mut forces = vec![0.0; chain.contacts.len()];
    let watch = &mut |series: &Series, end: f64, state: &State| {
        for &(node, weight) in &nodes {
            let at = node * end;
            let weight = weight * end * series.length;
            let (input, loss) = powers(chain, &model, series, at);
            put += weight * input;
            moved += weight * input.abs();
            lost += weight * loss;
            for (j, contact) in model.contacts.iter().enumerate() {
                let speed = frictiongen_kernel::joints::value(
                    &series.speed_terms(contact.plus, contact.minus),
                    at,
                );
                // Only a sliding contact dissipates energy.
                if state.phases[j] != 0 {
                    let power = series.force(j, at) * speed;
                    assert!(power > -1e-9, "{power}");
                    lost += weight * power;
                }
            }
        }
        for (j, force) in forces.iter_mut().enumerate() {
            *force = series.force(j, end);
        }
    };
    let mut events = 0;
    for cycle in 1..=20 {
        let until = f64::from(cycle) / 20.0 * cycles * TAU / omega;
        events += motion.run(until, watch)?.len();
    }
    let end = energy(chain, &motion, &forces);
    Ok(((put - lost - (end - start)).abs() / (start + moved), events))
}

/// Checks the energy balance of random scenes of 1 to 6 masses, a third of them without a support. Returns the number
/// of events.
fn random_scenes(count: usize) -> usize {
    let mut random = Random::new(7);
    let (mut worst, mut events) = (0.0_f64, 0);
    for index in 0..count {
        let (mut chain, omega) = random_chain(&mut random);
        for contact in &mut chain.contacts {
            // At break-away, the force of an elastic contact with μ > 1 drops suddenly, and its spring loses energy.
            // `balance` does not count this loss.
            if contact.stiffness.is_some() {
                contact.stiction = 1.0;
            }
        }
        let (miss, seen) = match balance(&chain, omega, 8.0) {
            Ok(balance) => balance,
            Err(error) => panic!("scene {index}: {error} {chain:?}"),
        };
        assert!(miss < 1e-11, "scene {index}: {miss:.1e} {chain:?}");
        worst = worst.max(miss);
        events += seen;
    }
    println!("{count} scenes, {events} events: {worst:.1e}");
    events
}

#[test]
fn random_scenes_keep_their_energy() {
    assert!(random_scenes(40) > 1000);
}

/// Repeats `random_scenes_keep_their_energy` with more random scenes.
#[test]
#[ignore = "minutes"]
fn random_scenes_keep_their_energy_long() {
    assert!(random_scenes(10_000) > 200_000);
}

/// Checks that a chain of 64 masses with sixteen contacts, rigid and elastic, runs without an error, also with μ > 1.
#[test]
fn the_largest_chain_runs() {
    let mut random = Random::new(9);
    let masses: Vec<f64> = (0..64).map(|_| random.between(0.5, 2.0)).collect();
    let node = |i: usize| {
        if i == 0 {
            Node::Base
        } else {
            Node::Mass(i - 1)
        }
    };
    let springs = (0..64).map(|i| (node(i), Node::Mass(i), random.between(2e3, 5e3)));
    let springs: Vec<_> = springs.collect();
    let contacts = (0..16).map(|i| super::Joint {
        ends: (
            Node::Mass(4 * i),
            if i % 3 == 0 {
                Node::Wall
            } else {
                Node::Mass(4 * i - 1)
            },
        ),
        level: super::Wave::constant(random.between(0.5, 4.0)),
        stiction: random.between(1.0, 1.5),
        stiffness: (i % 2 == 0).then_some(5e3),
        speed: 0.0,
    });
    let chain = Chain {
        contacts: contacts.collect(),
        damping: super::stiffness(64, &springs)
            .into_iter()
            .map(|row| row.into_iter().map(|k| 1e-4 * k).collect())
            .collect(),
        masses,
        springs,
        base: super::Wave::harmonic(0.02, 12.0),
        ..Chain::default()
    };
    let mut motion = Motion::from_rest(&chain).expect("a chain");
    let events = motion
        .run(2.0 * TAU / 12.0, &mut |_, _, _| {})
        .expect("a motion");
    println!("{} events", events.len());
    assert!(events.len() > 50, "{}", events.len());
}
