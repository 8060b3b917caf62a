//! Tests extreme loads and steps. The stepper must keep to the bound on its events, report when it reaches the bound,
//! create no energy, and return no NaN.

use crate::stepper::both::Both;
use crate::stepper::rig::{HOLD, Kind, LINEAR, Load, Rig, advance, rig, scene};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, WALL_BASE, sticky};
use frictiongen::OutOfDomain;
use frictiongen_kernel::Plain;
use frictiongen_kernel::stepper::{Input, MAX_EVENTS, MAX_PARTS, Sample};
use frictiongen_model::scene::{Excitation, Scene};
use fuzzing::Random;

/// Numbers of events and of exceeded bounds in a run.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    events: u64,
    most: u32,
    exceeded: u64,
}

/// Runs a stepper, and checks the properties of every step.
fn run<S: Plain>(
    scene: &Scene,
    (kind, radians): (Kind<'_>, f64),
    steps: u32,
    mut load: impl FnMut(u32) -> Load,
    rounding: f64,
) -> Seen {
    let fastest = crate::stepper::plain::chain::Chain::of(scene, &[]).fastest;
    let dt = radians / fastest;
    let mut rig: Rig<S> = rig(scene, kind, dt);
    let mut seen = Seen::default();
    let mut before = [0.0; 3];
    let mut through = 0.0_f64;
    for step in 0..steps {
        let load = load(step);
        let stepped = advance(&mut rig, &load);
        seen.events += u64::from(stepped.events);
        seen.most = seen.most.max(stepped.events);
        seen.exceeded += u64::from(stepped.exceeded);
        let what = format!("{}, {radians} rad, step {step}: {stepped:?}", scene.name);
        // The fastest mode of the chain with a stuck contact is no faster than that of the free chain. Its damping
        // may be larger, so the bound has a factor of 2.
        let parts = (2.0 * radians).ceil().max(1.0) as u32;
        assert!(
            stepped.events <= parts.min(MAX_PARTS) * MAX_EVENTS,
            "{what}"
        );
        assert!(stepped.force.to_f64().is_finite(), "{what}");
        for mass in 0..scene.masses.len() {
            let now = rig.mass(mass);
            let sound = now.displacement().is_finite() && now.velocity().is_finite();
            assert!(sound, "{what}");
        }
        let work = rig.work();
        let now = [work.load, work.friction, work.damping].map(S::to_f64);
        through = through.max(work.stored.to_f64().abs());
        through = through.max((now[0] - before[0]).abs());
        // Every part of a step rounds the state once, and thereby changes the energy by a rounding.
        let noise = rounding * (now[0].abs() + through) * (100.0 + f64::from(parts));
        for k in [1, 2] {
            assert!(now[k] - before[k] >= -noise, "{what}: {now:?}, {before:?}");
        }
        before = now;
    }
    assert_eq!(
        rig.exceeded(),
        seen.exceeded,
        "what is told is what is counted"
    );
    seen
}

const ALL: [&str; 7] = [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE, TEN];

/// Angles, in rad, by which the fastest mode turns in a step, from far below a radian to far above.
const RADIANS: [f64; 5] = [1e-3, 0.3, 3.0, 40.0, 900.0];

fn steps(radians: f64) -> u32 {
    if radians > 10.0 { 20 } else { 150 }
}

/// Runs cases with a force on every mass that changes its sign in every step. The force is 10⁻⁴ to 10⁴ times the
/// break-away force. The base moves as irregularly. The function runs one of `one_in` cases.
fn alternating(one_in: usize) -> Seen {
    let (mut all, mut turn) = (Seen::default(), 0);
    for text in ALL {
        let scene = scene(&sticky(text, 1.2));
        let k1 = scene.springs[0].stiffness;
        let on_base = scene.excitation == Excitation::Base;
        for radians in RADIANS {
            for times in [1e4, 30.0, 1.0, 1e-4] {
                for kind in [LINEAR, HOLD] {
                    turn += 1;
                    if turn % one_in != 0 {
                        continue;
                    }
                    let friction = 1e-3 * k1;
                    let wild = || {
                        let mut random = Random(1);
                        let scene = &scene;
                        move |step: u32| {
                            let size = times * friction * (f64::from(step % 2) * 2.0 - 1.0);
                            let y = if on_base { size / k1 } else { 0.0 };
                            Load {
                                base: [y, 10.0 * y * random.signed()],
                                forces: scene.masses.iter().map(|_| size * random.unit()).collect(),
                                friction,
                            }
                        }
                    };
                    let (count, kind) = (steps(radians), (kind, radians));
                    let seen = run::<f64>(&scene, kind, count, wild(), f64::EPSILON);
                    run::<f32>(&scene, kind, count, wild(), f64::from(f32::EPSILON));
                    all.events += seen.events;
                    all.most = all.most.max(seen.most);
                    all.exceeded += seen.exceeded;
                }
            }
        }
    }
    println!("{all:?}");
    all
}

/// Runs every ninth case. Nine has no common divisor with the numbers of cases in the loops, so all kinds of cases
/// occur.
#[test]
fn alternating_at_the_step_rate() {
    let all = alternating(9);
    assert!(all.events > 1000 && all.most > 20, "{all:?}");
}

#[test]
#[ignore = "half a minute; one in nine runs in every run of the tests"]
fn all_alternating_at_the_step_rate() {
    let all = alternating(1);
    assert!(all.events > 10_000 && all.most > 50);
}

/// Runs cases with forces near the break-away force. F varies in time, or is 0.
#[test]
fn grazing() {
    let mut events = 0;
    for text in ALL {
        for mu in [1.0, 1.0 + 1e-15, 1.5] {
            let scene = scene(&sticky(text, mu));
            let friction = 1e-3 * scene.springs[0].stiffness;
            let mut random = Random(9);
            let load = |step: u32| {
                let grip = mu * friction;
                let beside = [1.0, 1.0 - 1e-15, 1.0 + 1e-15, 1.0 - 1e-9, -1.0];
                let times = *random.pick(&beside).expect("one of them");
                Load {
                    base: [0.0; 2],
                    forces: vec![times * grip; scene.masses.len()],
                    friction: match step % 50 {
                        48 => 0.0,
                        49 => 1e-300,
                        _ => friction,
                    },
                }
            };
            let seen = run::<f64>(&scene, (LINEAR, 0.4), 2000, load, f64::EPSILON);
            events += seen.events;
        }
    }
    println!("{events} events");
    assert!(events > 1000);
}

/// Compares the stepper under forces near the break-away force with the plain integrator. None of the forces is within
/// a rounding unit of the break-away force.
#[test]
fn grazing_moves_as_the_plain_integrator_says() {
    for text in ALL {
        for mu in [1.0, 1.5] {
            let scene = scene(&sticky(text, mu));
            let friction = 1e-3 * scene.springs[0].stiffness;
            let dt = 0.4 / crate::stepper::plain::chain::Chain::of(&scene, &[]).fastest;
            let mut random = Random(9);
            let mut load = || {
                let beside = [1.0 - 1e-6, 1.0 + 1e-6, 1.0 - 1e-9, 1.0 + 1e-9, -1.0 - 1e-7];
                let times = *random.pick(&beside).expect("one of them");
                Load {
                    base: [0.0; 2],
                    forces: vec![times * mu * friction; scene.masses.len()],
                    friction,
                }
            };
            let mut both = Both::new(&scene, LINEAR, dt, &load());
            for _ in 0..500 {
                both.advance(&load());
            }
            println!(
                "{}, μ = {mu}: {} events, {} otherwise, {:.1e}",
                scene.name,
                both.events,
                both.otherwise,
                both.error()
            );
            assert_eq!(both.otherwise, 0, "{text}, {mu}");
            // A zero that is nearly a double zero is known only to the square root of a rounding unit.
            assert!(
                both.events > 20 && both.error() < 1e-8,
                "{text}, {mu}: {:e}",
                both.error()
            );
        }
    }
}

/// Checks steep friction laws, with which the contact stops and slips in quick succession. The stepper must refuse a
/// law that is too steep for its step.
#[test]
fn steep_laws() {
    let mut all = Seen::default();
    let steepest = scene(ONE);
    let k1 = steepest.springs[0].stiffness;
    let law = &[[1e-9, 0.2]][..];
    let mut refused = rig::<f64>(
        &steepest,
        Kind {
            input: Input::Linear,
            law,
        },
        0.01,
    );
    let error = refused.advance(Sample {
        base: [0.0; 2],
        forces: &[0.0],
        friction: 1e-3 * k1,
    });
    assert_eq!(error.expect_err("too steep"), OutOfDomain::StepSteepness);
    for text in ALL {
        let scene = scene(&sticky(text, 1.2));
        let friction = 1e-3 * scene.springs[0].stiffness;
        for law in [
            &[[2e-3, 0.2]][..],
            &[[5e-3, 0.1], [1e-2, 1.0], [1.5e-2, 0.1], [2e-2, 1.0]],
            &[[1e-2, 0.0], [2e-2, 0.9]],
        ] {
            for input in [Input::Linear, Input::Hold] {
                let mut random = Random(4);
                let load = |_| Load {
                    base: [0.0; 2],
                    forces: scene
                        .masses
                        .iter()
                        .map(|_| 2.0 * friction * random.signed())
                        .collect(),
                    friction,
                };
                let kind = Kind { input, law };
                let seen = run::<f64>(&scene, (kind, 0.3), 1000, load, f64::EPSILON);
                all.events += seen.events;
                all.exceeded += seen.exceeded;
                all.most = all.most.max(seen.most);
            }
        }
    }
    println!("{all:?}");
    assert!(all.events > 1000);
}

/// Checks a law with so many lines that the speed cannot pass through all lines in one part of a step. The stepper must
/// report this, and must create no energy.
#[test]
fn more_than_is_followed() {
    let mut exceeded = 0;
    for text in [ONE, PAIR, WALL, ONE_ON_BASE] {
        let scene = scene(&sticky(text, 1.2));
        let friction = 1e-3 * scene.springs[0].stiffness;
        let point = |k: u32| [1e-3 * f64::from(k + 1), 0.6 - 0.05 * f64::from(k % 2)];
        let law: Vec<[f64; 2]> = (0..300).map(point).collect();
        let mut random = Random(12);
        let load = |_| Load {
            base: [0.0; 2],
            forces: scene
                .masses
                .iter()
                .map(|_| 50.0 * friction * random.signed())
                .collect(),
            friction,
        };
        let kind = Kind {
            input: Input::Linear,
            law: &law,
        };
        let seen = run::<f64>(&scene, (kind, 0.9), 500, load, f64::EPSILON);
        println!("{}: {seen:?}", scene.name);
        exceeded += seen.exceeded;
    }
    assert!(exceeded > 100);
}

/// Checks the work under the strongest accepted force, which acts along the motion in every step. The work grows
/// until a step is refused. Until then it must be finite.
#[test]
fn work_stays_finite() {
    fn check<S: Plain>(text: &str, radians: f64) {
        let scene = scene(text);
        let dt = radians / crate::stepper::plain::chain::Chain::of(&scene, &[]).fastest;
        let of = |force: f64| Load {
            base: [0.0; 2],
            forces: vec![force; scene.masses.len()],
            friction: 0.0,
        };
        let mut rig: Rig<S> = rig(&scene, LINEAR, dt);
        let taken =
            |force: f64| crate::stepper::rig::try_advance(&mut rig.clone(), &of(force)).is_ok();
        let mut strongest = 1e300;
        while !taken(strongest) {
            strongest *= 0.5;
        }
        assert!(
            strongest > 1e9 * scene.springs[0].stiffness,
            "{strongest:e}"
        );
        let mut refused = false;
        for step in 0..20_000 {
            let velocity = rig.mass(0).velocity().to_f64();
            match crate::stepper::rig::try_advance(&mut rig, &of(strongest.copysign(velocity))) {
                Ok(_) => {}
                Err(error) => {
                    assert_eq!(error, OutOfDomain::Work);
                    refused = true;
                    break;
                }
            }
            let work = rig.work();
            for value in [work.load, work.friction, work.damping, work.stored] {
                assert!(
                    value.is_finite(),
                    "{text}, {radians} rad, step {step}: {work:?}"
                );
            }
        }
        // In a step with many turns of a mode the force cannot follow the direction of the motion.
        assert!(
            refused || radians > 10.0,
            "{text}, {radians} rad, {strongest:e}: {:?}",
            rig.work()
        );
    }
    for stiffness in ["6e-4", "600", "6e9"] {
        for radians in [0.05, 0.9, 900.0] {
            let text = ONE.replace("600", stiffness);
            check::<f32>(&text, radians);
            check::<f64>(&text, radians);
        }
    }
}

/// Checks that a motion that has decayed to subnormal numbers causes no events in a contact without friction.
#[test]
fn decay_without_friction_has_no_events() {
    for text in [PAIR, WALL, ONE_ON_BASE] {
        let scene = scene(text);
        let mut rig: Rig<f32> = rig(&scene, LINEAR, 0.05);
        let mut events = 0;
        for step in 0..200_000 {
            let load = Load {
                base: [0.0; 2],
                forces: vec![if step == 0 { 1.0 } else { 0.0 }; scene.masses.len()],
                friction: 0.0,
            };
            events += advance(&mut rig, &load).events;
        }
        assert_eq!(events, 0, "{text}");
    }
}
