//! Stops: closed forms of impact oscillators, a bouncing mass, and the products of Floquet multipliers.

use super::steady_from_rest;
use crate::study::joints::{Chain, EndStop, Joint, Motion, Wave};
use frictiongen_kernel::joints::STUCK;
use frictiongen_model::scene::{Impact, Node, StopLaw};
use std::f64::consts::TAU;

const FLOOR: (Node, Node) = (Node::Wall, Node::Mass(0));
const CEILING: (Node, Node) = (Node::Mass(0), Node::Wall);

fn stop(ends: (Node, Node), gap: f64, impact: Impact) -> EndStop {
    EndStop {
        ends,
        law: StopLaw { gap, impact },
    }
}

#[test]
fn a_bouncing_mass_comes_to_rest_in_finite_time() {
    for restitution in [0.0, 0.3, 0.8, 0.95] {
        let chain = Chain {
            masses: vec![2.0],
            stops: vec![stop(FLOOR, 0.0, Impact::Restitution(restitution))],
            constant: vec![(0, -2.0)],
            ..Chain::default()
        };
        let mut motion = Motion::from(&chain, &[1.0], &[0.0]).unwrap();
        let fall = 2.0_f64.sqrt();
        let end = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
        let events = motion.run(end + 0.1, &mut |_, _, _| {}).unwrap();
        let last = events.last().unwrap();
        assert!((last.time - end).abs() < 1e-12, "{} {end}", last.time);
        assert_eq!(last.after[0], STUCK);
        assert!(motion.state().x[0].abs() < 1e-14);
        assert_eq!(motion.state().v[0], 0.0);
        assert!((motion.forces()[0] + 2.0).abs() < 1e-14);
    }
}

/// The motion of an undamped mass that collides once in each period, with x = a cos t + b sin t + C cos(ωt + φ) from an
/// impact on: x(0) = x(T) = g and ẋ(0) = −e ẋ(T) determine a, b and φ.
#[test]
fn an_impact_oscillator_has_its_closed_form() {
    for (omega, gap, restitution) in [(0.8, 1.0, 0.7), (1.3, 0.4, 0.5), (2.3, 0.05, 0.7)] {
        let chain = Chain {
            masses: vec![1.0],
            springs: vec![(Node::Wall, Node::Mass(0), 1.0)],
            stops: vec![stop(CEILING, gap, Impact::Restitution(restitution))],
            loads: vec![(0, Wave::harmonic(1.0, omega))],
            ..Chain::default()
        };
        let steady = steady_from_rest(&chain, omega).unwrap();
        assert_eq!(steady.cycle.contacts[0].stops, steady.period, "{omega}");
        let period = TAU / omega;
        let (sin, cos) = period.sin_cos();
        let size = 1.0 / (1.0 - omega * omega);
        let factor = ((1.0 - cos) * (1.0 + restitution * cos) / sin - restitution * sin)
            / (omega * (1.0 + restitution));
        // (g − a)² + (a·factor)² = C²
        let (two, one, zero) = (1.0 + factor * factor, -2.0 * gap, gap * gap - size * size);
        let root = (one * one - 4.0 * two * zero).sqrt();
        let state = (steady.state.x[0], steady.state.v[0]);
        let errors = [1.0, -1.0].map(|sign| {
            let a = (-one + sign * root) / (2.0 * two);
            let b = a * (1.0 - cos) / sin;
            let phase = (a * factor / size).atan2((gap - a) / size);
            let time = (-phase / omega).rem_euclid(period);
            let x = a * time.cos() + b * time.sin() + size;
            let v = -a * time.sin() + b * time.cos();
            (x - state.0).abs().max((v - state.1).abs())
        });
        let error = errors[0].min(errors[1]);
        assert!(error < 1e-12, "{omega}: {error:e}");
        // The impact multiplies areas in the plane of displacement and velocity by e².
        let product: f64 = steady
            .multipliers
            .iter()
            .take(2)
            .map(|m| m.norm())
            .product();
        let known = restitution.powi(2 * i32::try_from(steady.period).unwrap());
        assert!(
            (product - known).abs() < 1e-10,
            "{omega}: {product} {known}"
        );
    }
}

#[test]
fn the_multipliers_of_a_stop_with_a_dashpot() {
    let (dashpot, omega) = (0.3, 0.9);
    let chain = Chain {
        masses: vec![1.0],
        springs: vec![(Node::Wall, Node::Mass(0), 1.0)],
        dashpots: vec![(Node::Wall, Node::Mass(0), 0.1)],
        stops: vec![stop(
            CEILING,
            0.5,
            Impact::Spring {
                stiffness: 40.0,
                damping: dashpot,
            },
        )],
        constant: vec![(0, 0.2)],
        loads: vec![(0, Wave::harmonic(1.0, omega))],
        ..Chain::default()
    };
    let steady = steady_from_rest(&chain, omega).unwrap();
    let own = &steady.cycle.contacts[0];
    assert!(own.stops > 0 && own.energy > 0.0);
    let length = steady.period as f64 * TAU / omega;
    // Liouville: the product is exp(−∫ c dt) with the coefficient of all dashpots that act.
    let known = (-length * (0.1 + dashpot * own.stuck_fraction)).exp();
    let product: f64 = steady
        .multipliers
        .iter()
        .take(2)
        .map(|m| m.norm())
        .product();
    assert!((product - known).abs() < 1e-10, "{product} {known}");
}

#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    // Undamped, F = 1, μ = 2, speed V: the block slips from 2F/k back to where it meets the belt again.
    let (speed, level, stiction) = (0.3, 1.0, 2.0);
    let chain = Chain {
        masses: vec![1.0],
        springs: vec![(Node::Wall, Node::Mass(0), 1.0)],
        contacts: vec![Joint {
            ends: CEILING,
            level: Wave::constant(level),
            stiction,
            stiffness: None,
            speed,
        }],
        ..Chain::default()
    };
    let mut motion = Motion::from(&chain, &[1.5], &[speed]).unwrap();
    let events = motion.run(100.0, &mut |_, _, _| {}).unwrap();
    let slips = events.iter().filter(|event| event.before[0] == STUCK);
    let times: Vec<f64> = slips.map(|event| event.time).collect();
    // The slip starts at x = μF, ẋ = V and ends where ẋ = V again, which is at the mirror image about x = F.
    let drop = (stiction - 1.0) * level;
    let angle = TAU - 2.0 * (drop).atan2(speed);
    let period = angle + 2.0 * drop / speed;
    assert!(times.len() > 5);
    for pair in times.windows(2) {
        assert!(
            (pair[1] - pair[0] - period).abs() < 1e-11,
            "{pair:?} {period}"
        );
    }
}
