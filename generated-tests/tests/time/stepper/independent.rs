//! Compares the stepper under random loads with the plain integrator, which shares no code with the stepper.

use crate::stepper::both::Both;
use crate::stepper::rig::{HOLD, Kind, LINEAR, Load, advance, begin, loaded, rig, scene};
use crate::stepper::scenes::{
    BASE, ONE, ONE_ON_BASE, PAIR, PAIR_BASE, WALL, WALL_BASE, from_base, sticky,
};
use frictiongen_kernel::stepper::Input;
use frictiongen_model::scene::{Excitation, Scene};
use fuzzing::Random;

/// Returns a function that gives the loads of successive steps: a ground motion of a few incommensurable sinusoids,
/// or random forces.
pub fn loads(scene: &Scene, seed: u64, dt: f64) -> impl FnMut() -> Load {
    let mut random = Random(seed);
    let n = scene.masses.len();
    let base = scene.excitation == Excitation::Base;
    let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
    let waves: Vec<[f64; 3]> = (0..7)
        .map(|_| {
            [
                random.between(0.2, 2.5) * omega,
                0.01 * random.signed(),
                random.between(0.0, 6.3),
            ]
        })
        .collect();
    let mut step = 0;
    move || {
        let t = dt * f64::from(step);
        step += 1;
        let mut motion = [0.0; 2];
        for [rate, size, phase] in &waves {
            let (sine, cosine) = (rate * t + phase).sin_cos();
            motion[0] += size * cosine;
            motion[1] -= size * rate * sine;
        }
        Load {
            base: if base { motion } else { [0.0; 2] },
            forces: (0..n)
                .map(|_| 0.02 * scene.springs[0].stiffness * random.signed())
                .collect(),
            friction: 0.004 * scene.springs[0].stiffness * random.between(0.5, 1.5),
        }
    }
}

/// Tolerance of the comparison. Both sides round each step. Friction reduces earlier errors, so the rounding errors
/// do not add up.
const BAR: f64 = 3e-14;

fn compare(text: &str, kind: Kind<'_>, steps: usize, bar: f64) {
    let scene = scene(text);
    let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
    let dt = 0.3 / omega;
    let mut next = loads(&scene, 11, dt);
    let mut both = Both::new(&scene, kind, dt, &next());
    for _ in 0..steps {
        both.advance(&next());
    }
    let (found, want) = (both.rig.work(), both.plain.work);
    let load = want.load - want.carried;
    // The stepper counts the energy that the base's displacement stores in its springs twice: as stored energy and as
    // work of the load. This energy therefore cancels in the difference.
    let damping = (found.damping - want.damping).abs() / load.abs();
    let friction = (found.friction - want.friction).abs() / load.abs();
    println!(
        "{}, μ = {}, {:?}, {} points: {} events, {} steps otherwise, error {:.1e}, damping {damping:.1e}, friction {friction:.1e}",
        scene.name,
        scene.stiction,
        kind.input,
        kind.law.len(),
        both.plain.events,
        both.otherwise,
        both.error(),
    );
    assert!(both.plain.events > steps as u64 / 20, "too quiet");
    assert_eq!((both.rig.exceeded(), both.otherwise), (0, 0));
    assert!(both.error() < bar, "{text}: {:e}", both.error());
    assert!(damping < 10.0 * bar && friction < 10.0 * bar);
}

/// Compares runs with Coulomb's law, both kinds of input and all contacts.
#[test]
fn any_load() {
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE] {
        for mu in [1.0, 1.3] {
            for kind in [LINEAR, HOLD] {
                compare(&sticky(text, mu), kind, 2000, BAR);
            }
        }
    }
}

/// Compares runs with damping relative to the moving base: contacts with the base, the wall and another mass, with
/// and without springs to the wall, both kinds of input, and a kinetic friction force that depends on the speed.
#[test]
fn damping_from_the_base() {
    let law: &[[f64; 2]] = &[[0.02, 0.7], [0.08, 0.5]];
    for text in [BASE, ONE_ON_BASE, WALL_BASE, PAIR_BASE] {
        for mu in [1.0, 1.3] {
            let text = sticky(&from_base(text), mu);
            for kind in [LINEAR, HOLD] {
                compare(&text, kind, 600, BAR);
            }
            let input = Input::Linear;
            compare(&text, Kind { input, law }, 400, BAR);
        }
    }
}

/// Compares runs with a base that jumps, with or without a velocity at each sample. With linear input the
/// displacement is a cubic within a step. With held input the base jumps away from its contact, which may stay stuck.
#[test]
fn jumping_base() {
    for text in [BASE, ONE_ON_BASE, WALL_BASE] {
        for kind in [LINEAR, HOLD] {
            for (velocity, grip) in [(1.0, 0.5), (0.0, 0.5), (0.0, 10.0)] {
                // With zero-order hold, a contact that sticks firmly keeps a mass at rest while the base only jumps,
                // so nothing can be compared.
                if grip > 1.0 && kind.input == Input::Hold {
                    continue;
                }
                let scene = scene(&sticky(text, 1.2));
                let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
                let dt = 0.3 / (k1 / m1).sqrt();
                let mut random = Random(5);
                let mut next = || Load {
                    base: [
                        0.01 * random.signed(),
                        velocity * 0.01 * random.signed() / dt,
                    ],
                    forces: vec![0.0; scene.masses.len()],
                    friction: grip * 0.01 * k1 * random.between(0.8, 1.2),
                };
                let mut both = Both::new(&scene, kind, dt, &next());
                for _ in 0..300 {
                    both.advance(&next());
                }
                println!(
                    "{}, {:?}, {velocity}, {grip}: {} events, {} otherwise, {:.1e}",
                    scene.name,
                    kind.input,
                    both.events,
                    both.otherwise,
                    both.error()
                );
                // The two sides may count an event at a sample in different steps.
                assert!(both.otherwise <= 3, "{text}, {velocity}, {grip}");
                assert!(
                    both.error() < 1e-12,
                    "{text}, {velocity}, {grip}: {:e}",
                    both.error()
                );
            }
        }
    }
}

/// Compares runs in which some masses are loaded, in any order, or none. The motion must equal that with zero force
/// on the other masses.
#[test]
fn some_masses_loaded() {
    for text in [WALL, BASE, PAIR, WALL_BASE] {
        for masses in [&[1][..], &[1, 0], &[0], &[]] {
            for kind in [LINEAR, HOLD] {
                let scene = scene(&sticky(text, 1.2));
                let dt = 0.02;
                let mut next = loads(&scene, 6, dt);
                let mut some = loaded::<f64>(&scene, kind, dt, masses).expect("a step");
                let mut all = rig::<f64>(&scene, kind, dt);
                let (mut apart, mut size) = (0.0_f64, 0.0_f64);
                for step in 0..1000 {
                    let load = next();
                    let chosen = Load {
                        forces: masses.iter().map(|mass| 4.0 * load.forces[*mass]).collect(),
                        ..load.clone()
                    };
                    let mut every = Load {
                        forces: vec![0.0; scene.masses.len()],
                        ..load
                    };
                    for (mass, force) in masses.iter().zip(&chosen.forces) {
                        every.forces[*mass] = *force;
                    }
                    if step == 0 {
                        begin(&mut some, &chosen);
                        begin(&mut all, &every);
                        continue;
                    }
                    advance(&mut some, &chosen);
                    advance(&mut all, &every);
                    for mass in 0..scene.masses.len() {
                        let [one, other] = [&some, &all].map(|rig| rig.mass(mass).displacement());
                        apart = apart.max((one - other).abs());
                        size = size.max(other.abs());
                    }
                }
                let (work, want) = (some.work().load, all.work().load);
                let moves = size > 0.0;
                assert!(
                    apart <= 1e-13 * size && (work - want).abs() <= 1e-12 * want.abs(),
                    "{text}, {masses:?}"
                );
                assert_eq!(
                    moves,
                    !masses.is_empty() || text.contains("excitation: base")
                );
            }
        }
    }
}

/// Compares runs with a law that falls and rises so steeply that it changes the motion faster than the spring does. A
/// power series then converges only over a fraction of a step.
#[test]
fn steep_law() {
    let law = &[[0.002, 0.2], [0.005, 1.1]];
    for text in [ONE, PAIR] {
        for input in [Input::Linear, Input::Hold] {
            compare(&sticky(text, 1.2), Kind { input, law }, 1000, BAR);
        }
    }
}

/// Compares runs with a kinetic friction force that depends on the speed.
#[test]
fn stribeck() {
    let laws: [&[[f64; 2]]; 2] = [&[[0.02, 0.7], [0.08, 0.5]], &[[0.03, 0.6], [0.1, 0.9]]];
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE] {
        for law in laws {
            for input in [Input::Linear, Input::Hold] {
                compare(&sticky(text, 1.2), Kind { input, law }, 1000, BAR);
            }
        }
    }
}
