//! Compares the stepper in double precision with the stepper in double-double.

use crate::stepper::independent::loads;
use crate::stepper::rig::{LINEAR, Load, advance, begin, rig, scene};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, WALL_BASE, sticky};
use frictiongen_kernel::number::dd::Dd;
use fuzzing::Random;

/// Returns the largest difference of a run, divided by the largest displacement, and the number of events.
fn off(text: &str, steps: u32, friction: f64) -> (f64, u64) {
    let scene = scene(text);
    let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
    let dt = 0.3 / omega;
    let mut next = loads(&scene, 5, dt);
    let mut load = move || {
        let load = next();
        Load {
            friction: friction * load.friction,
            ..load
        }
    };
    let mut narrow = rig::<f64>(&scene, LINEAR, dt);
    let mut wide = rig::<Dd>(&scene, LINEAR, dt);
    let start = load();
    begin(&mut narrow, &start);
    begin(&mut wide, &start);
    let (mut apart, mut size, mut events) = (0.0_f64, 0.0_f64, 0);
    for _ in 0..steps {
        let load = load();
        let stepped = advance(&mut narrow, &load);
        advance(&mut wide, &load);
        events += u64::from(stepped.events);
        for mass in 0..scene.masses.len() {
            let want = wide.mass(mass).displacement();
            let found = Dd::from(narrow.mass(mass).displacement());
            apart = apart.max((found - want).to_f64().abs());
            size = size.max(want.to_f64().abs());
        }
    }
    println!(
        "{}, μ = {}, F {friction} times: {steps} steps, {events} events, {:.1e}",
        scene.name,
        scene.stiction,
        apart / size
    );
    (apart / size, events)
}

/// Compares chains whose contact stays stuck. The chains have no event, except for a stop at the start if the base
/// already moves.
///
/// While the contact stays stuck, only damping reduces earlier errors. Without damping, the rounding of a frequency
/// adds an error of 1e-16 of the angle by which the mode has turned. (`ONE` does not move at all while its contact
/// sticks.)
#[test]
fn without_events() {
    for text in [WALL, BASE, PAIR, TEN] {
        let (error, events) = off(text, 4000, 1e4);
        assert!(events <= 1 && error < 1e-13, "{text}: {error:e}");
    }
}

/// Compares chains with events. With μ = 1 two motions never diverge, whatever events they have. With μ > 1 rounding
/// may delay a break-away. The contact force then differs until the next stop removes the difference.
#[test]
fn with_events() {
    for text in [WALL, BASE, PAIR, ONE, TEN] {
        for mu in [1.0, 1.3] {
            let (error, events) = off(&sticky(text, mu), 3000, 1.0);
            assert!(events > 200 && error < 1e-13, "{text}: {error:e}, {events}");
        }
    }
}

/// Compares steps that are far shorter than a turn of the fastest oscillator, with an input that jumps in each step.
/// The power series then has few terms, but must include the effect of the input within the step.
#[test]
fn short_steps() {
    let mut worst = 0.0_f64;
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE] {
        for radians in [1e-5, 1e-3, 1e-2, 0.1] {
            let scene = scene(text);
            let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
            let dt = radians / (k1 / m1).sqrt();
            let mut random = Random(6);
            let mut narrow = rig::<f64>(&scene, LINEAR, dt);
            let mut wide = rig::<Dd>(&scene, LINEAR, dt);
            let (mut apart, mut size) = ([0.0_f64; 2], [0.0_f64; 2]);
            for _ in 0..300 {
                let load = Load {
                    base: [random.signed(), random.signed() / dt],
                    forces: scene.masses.iter().map(|_| k1 * random.signed()).collect(),
                    friction: 0.2 * k1,
                };
                advance(&mut narrow, &load);
                advance(&mut wide, &load);
                for mass in 0..scene.masses.len() {
                    let (found, want) = (narrow.mass(mass), wide.mass(mass));
                    let pairs = [
                        (found.displacement(), want.displacement()),
                        (found.velocity(), want.velocity()),
                    ];
                    for (k, (found, want)) in pairs.into_iter().enumerate() {
                        apart[k] = apart[k].max((Dd::from(found) - want).to_f64().abs());
                        size[k] = size[k].max(want.to_f64().abs());
                    }
                }
            }
            let error = (apart[0] / size[0]).max(apart[1] / size[1]);
            println!("{}, {radians} rad a step: {error:.1e}", scene.name);
            // The change of a displacement in a step is smaller than the inputs that cause it, by up to a factor of
            // 100.
            worst = worst.max(error);
        }
    }
    assert!(worst < 1e-13, "{worst:e}");
}

/// Compares runs of 10⁵ steps with more than 10⁴ events. The difference must stay within the tolerance.
#[test]
#[ignore = "minutes"]
fn long() {
    for text in [WALL, BASE, PAIR, TEN] {
        let (error, events) = off(text, 100_000, 1e4);
        assert!(events <= 1 && error < 1e-13, "{text}: {error:e}");
    }
    for text in [WALL, BASE, PAIR, ONE, TEN] {
        for mu in [1.0, 1.3] {
            let (error, events) = off(&sticky(text, mu), 100_000, 1.0);
            assert!(
                events > 10_000 && error < 1e-13,
                "{text}: {error:e}, {events}"
            );
        }
    }
}
