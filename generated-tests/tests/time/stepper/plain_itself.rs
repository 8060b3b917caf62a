//! Compares the plain integrator with the exact event-driven motion in time, and with the plain integrator in shorter
//! steps.

use crate::stepper::plain::chain::Chain;
use crate::stepper::plain::{Input, Plain};
use crate::stepper::scenes::{BASE, ONE_ON_BASE, PAIR, WALL, WALL_BASE, sticky};
use frictiongen::System;
use fuzzing::Random;
use std::f64::consts::TAU;

/// Returns the largest difference from the exact motion, divided by the base's amplitude, and the number of events.
/// `steps` cubics in a cycle approximate the base motion.
fn off(text: &str, [r, beta]: [f64; 2], steps: i32) -> (f64, u64) {
    let system: System = text.parse().expect("a scene");
    let scene = system.scene();
    let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
    let (amplitude, omega) = (0.01, r * (k1 / m1).sqrt());
    let dt = TAU / omega / f64::from(steps);
    let rest = vec![0.0; scene.masses.len()];
    let chain = Chain::of(scene, &[]);
    let mut plain = Plain::new(chain, (&rest, &rest), [amplitude, 0.0]);
    plain.metered = false;
    let mut exact = system.simulation(r, beta).expect("a run");
    let mut worst = 0.0_f64;
    let at = |step: i32| {
        let (sine, cosine) = (TAU * f64::from(step % steps) / f64::from(steps)).sin_cos();
        [amplitude * cosine, -amplitude * omega * sine]
    };
    for step in 0..8 * steps {
        let input = Input {
            forces: vec![[0.0; 2]; rest.len()],
            base: hermite(at(step), at(step + 1), dt),
            friction: beta * k1 * amplitude,
        };
        plain.advance(&input, dt);
        let mut left = TAU / f64::from(steps);
        while left > 0.0 {
            left -= exact.advance(left).expect("a reach").length;
        }
        for mass in 0..rest.len() {
            let want = exact.run().mass(mass);
            let x = plain.x[mass] / amplitude - want.displacement();
            let v = plain.v[mass] / (amplitude * omega) - want.velocity();
            worst = worst.max(x.abs()).max(v.abs());
        }
    }
    (worst, plain.events)
}

/// Measures the order of the error for a base motion that cubics interpolate.
///
/// Cubics between instants approximate a cosine with an error of h⁴/384, where h is the step in radians. Their second
/// derivative has an error of h²/12, which affects a contact with the base. With μ > 1 this error delays a break-away
/// by as much, and the force that is neglected during the delay is not small. With μ = 1 it is small. The order is
/// therefore 4 for a contact with the wall, and 3 for a contact with the base. With μ > 1 the order is 2, but the
/// delay of a break-away changes its sign within a cubic.
#[test]
fn a_cosine_of_the_base() {
    for (text, at, mu, order, bar) in [
        (BASE, [0.7, 0.5], 1.0, 2.6, 5e-10),
        (BASE, [0.21, 0.2], 1.4, 0.8, 1e-7),
        (ONE_ON_BASE, [0.3, 0.1], 1.0, 2.6, 5e-10),
        (ONE_ON_BASE, [1.3, 0.6], 1.2, 0.8, 1e-7),
        (WALL_BASE, [0.4, 0.3], 1.0, 3.0, 1e-11),
        (WALL_BASE, [0.9, 0.5], 1.5, 3.0, 1e-11),
    ] {
        let text = sticky(text, mu);
        let [coarse, fine] = [500, 2000].map(|steps| off(&text, at, steps));
        let found = (coarse.0 / fine.0).log2() / 2.0;
        println!(
            "{at:?}, μ = {mu}: {:.1e}, order {found:.2}, {} events",
            fine.0, fine.1
        );
        assert!(fine.1 > 10, "{coarse:?}");
        assert!(fine.0 < bar && found > order, "{text}: {fine:?}, {found}");
    }
}

/// Returns the cubic with the given displacements and velocities at both end points of a step.
pub fn hermite([y0, v0]: [f64; 2], [y1, v1]: [f64; 2], dt: f64) -> [f64; 4] {
    let rise = (y1 - y0) / dt;
    [
        y0,
        v0,
        (3.0 * rise - 2.0 * v0 - v1) / dt,
        (v0 + v1 - 2.0 * rise) / (dt * dt),
    ]
}

/// Checks the energy of the plain integrator. Compares it with steps of half the length, for a friction law that
/// depends on the speed and forces on all masses.
#[test]
fn against_itself() {
    let laws: [&[[f64; 2]]; 2] = [&[], &[[0.2, 0.6], [0.5, 0.9]]];
    for text in [WALL, PAIR, ONE_ON_BASE] {
        for law in laws {
            let system: System = sticky(text, 1.2).parse().expect("a scene");
            let chain = Chain::of(system.scene(), law);
            let n = system.scene().masses.len();
            let rest = vec![0.0; n];
            let mut whole = Plain::new(chain, (&rest, &rest), [0.0; 2]);
            let mut halves = whole.clone();
            let mut random = Random(7);
            let mut forces = vec![0.0; n];
            let dt = 0.05;
            for _ in 0..2000 {
                let next: Vec<f64> = (0..n).map(|_| 20.0 * random.signed()).collect();
                let line = |from: f64, to: f64| -> Vec<[f64; 2]> {
                    let ends = forces.iter().zip(&next);
                    let line = ends.map(|(a, b)| [a + (b - a) * from, (b - a) * (to - from) / dt]);
                    line.collect()
                };
                let input = |forces: Vec<[f64; 2]>| Input {
                    forces,
                    base: [0.0; 4],
                    friction: 4.0,
                };
                whole.advance(&input(line(0.0, 1.0)), dt);
                halves.advance(&input(line(0.0, 1.0)), 0.5 * dt);
                halves.advance(&input(line(0.5, 1.5)), 0.5 * dt);
                forces = next;
            }
            let work = whole.work;
            let done = work.friction + work.damping + whole.stored();
            let apart = (&whole.x - &halves.x).amax() / whole.x.amax();
            println!(
                "{}: {} events, energy {:.1e}, halves {apart:.1e}",
                system.scene().name,
                whole.events,
                work.load / done - 1.0
            );
            assert!(whole.events > 100 && (work.load / done - 1.0).abs() < 1e-12);
            assert!(apart < 1e-10);
            assert_eq!(whole.events, halves.events);
        }
    }
}
