//! The stepper with an elastic contact: against a reference, its energy balance, creep, and saved states.

use super::joints::references;
use super::random::scene as random_scene;
use frictiongen::answer::Contact;
use frictiongen::study::scene::{Excitation, Provide};
use frictiongen::study::{System, SystemInput};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt as _, SeedableRng};
use std::f64::consts::TAU;

const BLOCK: &str = "struct Block { masses: { block: 2.0 }, springs: { base - block: 800.0 },
    contact: block - wall, stiffness: 3000.0, excitation: block, damping: modal(0.05), stiction: 1.2,
    provide: [stepper] }";

/// States after each of three cycles against `joints.json`, for the scenes that the base drives.  The cubic interpolation
/// of a base motion at 2000 samples a cycle has an error of 3e-13 of its amplitude, and an event does not magnify it.
#[test]
fn base_motions_follow_the_reference() {
    let mut compared = 0;
    for reference in references() {
        let system = &reference.system;
        if system.scene().excitation != Excitation::Base {
            continue;
        }
        let (omega, samples) = (reference.omega, 2000_u32);
        let friction = reference.beta * system.scene().first_stiffness() * reference.unit;
        let base = |step: u32| {
            let (sine, cosine) = (TAU * f64::from(step) / f64::from(samples)).sin_cos();
            let [y, v] = [cosine, -omega * sine].map(|one| reference.unit * one);
            SystemInput::base(y, v).friction(friction)
        };
        let mut stepper = system
            .stepper(TAU / omega / f64::from(samples))
            .expect("a stepper");
        stepper.begin(base(0)).expect("an input");
        for cycle in 0..3 {
            for step in 1..=samples {
                stepper.advance(base(step)).expect("a step");
            }
            let after = &reference.value["after_cycles"][cycle];
            for (index, mass) in system.scene().masses.iter().enumerate() {
                let [x, v] = ["x", "v"].map(|name| after[name][index].as_f64().expect("a number"));
                let now = stepper.mass(&mass.name).expect("a mass");
                let size = reference.unit.max(x.abs());
                let (dx, dv) = (now.displacement() - x, now.velocity() - v);
                assert!(
                    dx.abs() < 1e-10 * size,
                    "cycle {cycle}: {} for {x}",
                    now.displacement()
                );
                assert!(
                    dv.abs() < 1e-10 * size * omega,
                    "cycle {cycle}: {} for {v}",
                    now.velocity()
                );
                compared += 1;
            }
        }
        assert_eq!(stepper.exceeded(), 0);
    }
    println!("{compared} states");
    assert!(compared >= 6);
}

/// The force of each step is that of the law: it changes by k times the motion while the contact sticks, and is ±F while it
/// slides.
#[test]
fn forces_are_those_of_the_spring() {
    let system: System = BLOCK.parse().expect("a scene");
    let mut stepper = system.stepper(1e-3).expect("a stepper");
    let (friction, mut slid, mut stuck, mut slips) = (6.0, 0, 0, 0);
    let mut before = stepper.contact();
    for step in 1..=4000_u32 {
        let load = 60.0 * (0.012 * f64::from(step)).sin();
        let stepped = stepper
            .advance(SystemInput::force(load).friction(friction))
            .expect("a step");
        let now = stepper.contact();
        assert_eq!(
            (stepped.force, stepped.contact),
            (now.force(), now.contact())
        );
        assert_eq!(
            now.displacement(),
            stepper.mass("block").expect("a mass").displacement()
        );
        if stepped.events == 0 && now.is_sticking() && before.is_sticking() {
            let moved = 3000.0 * (now.displacement() - before.displacement());
            assert!(
                (now.force() - before.force() - moved).abs() < 1e-12,
                "{step}"
            );
            assert!(now.force().abs() <= 1.2 * friction * (1.0 + 1e-14));
            stuck += 1;
        } else if !now.is_sticking() {
            let sign = if now.contact() == Contact::Forward {
                1.0
            } else {
                -1.0
            };
            assert!((now.force() - sign * friction).abs() < 1e-14);
            assert!(0.0 <= sign * now.velocity());
            slid += 1;
        }
        slips += stepped.events;
        before = now;
    }
    assert!(
        slid > 1000 && stuck > 300 && slips > 20,
        "{slid} {stuck} {slips}"
    );
}

/// Work of the load, friction and stored energy balance without damping, under random forces and random friction, which
/// also vanishes.  With damping no energy appears.
#[test]
fn energy_is_balanced() {
    let mut random = ChaCha8Rng::seed_from_u64(4545);
    let (mut events, mut undamped, mut worst) = (0, 0, 0.0_f64);
    for index in 0..40 {
        let (text, _, _) = random_scene(&mut random);
        let mut scene = text.parse::<System>().expect("a scene").scene().clone();
        scene.provide = vec![Provide::Stepper];
        scene.excitation = Excitation::Force(random.random_range(0..scene.masses.len()));
        let damped = scene.damping != frictiongen::study::scene::Damping::None;
        let system = System::<f64>::try_from(scene).expect("a scene");
        let names: Vec<_> = system
            .scene()
            .masses
            .iter()
            .map(|mass| mass.name.clone())
            .collect();
        let mut stepper = system
            .stepper(0.05 + 0.3 * random.random::<f64>())
            .expect("a stepper");
        let mut load = 0.0;
        let mut friction = 0.3;
        let mut size = 0.0_f64;
        for step in 0..400 {
            load += random.random_range(-0.3..0.3) - 0.02 * load;
            if step % 7 == 0 {
                friction =
                    [0.0, 0.1, 0.5, 0.9][random.random_range(0..4_usize)] * random.random::<f64>();
            }
            let more = random.random_range(-0.2..0.2);
            let input = SystemInput::force(load)
                .on(&names[0], more)
                .friction(friction);
            events += stepper.advance(input).expect("a step").events;
            let work = stepper.work();
            size = size
                .max(work.load.abs())
                .max(work.friction)
                .max(work.stored);
            assert!(
                work.friction >= -1e-14 * size,
                "scene {index}, step {step}: {work:?}"
            );
            assert!(
                -1e-12 * size <= work.damping,
                "scene {index}, step {step}: {work:?} {text}"
            );
            if !damped {
                worst = worst.max(work.damping.abs() / size.max(1e-3));
            }
        }
        undamped += usize::from(!damped);
    }
    println!("{events} events, the undamped balance lacks at most {worst:e}");
    assert!(
        worst < 1e-11 && undamped > 4 && events > 1000,
        "{worst:e} {undamped} {events}"
    );
}

/// Under a constant load below the grip nothing creeps: once the transient is gone, displacement and force keep their bits.
fn holds(share: f64, steps: u32) {
    // The transient dies out by e^(-10) in a second.
    let text = BLOCK.replace("modal(0.05)", "modal(0.5)");
    let system: System = text.parse().expect("a scene");
    let friction = 5.0;
    let mut stepper = system.stepper(2e-3).expect("a stepper");
    // A push moves the slider away from its first place.
    for _ in 0..50 {
        stepper
            .advance(SystemInput::force(60.0).friction(friction))
            .expect("a step");
    }
    for _ in 0..6000 {
        stepper
            .advance(SystemInput::force(0.0).friction(friction))
            .expect("a step");
    }
    assert!(stepper.contact().is_sticking());
    // The spring of the contact carries 3000/3800 of a slow load.
    let rest = stepper.contact();
    let load = (share * 1.2 * friction - rest.force()) * 3800.0 / 3000.0;
    for step in 1..=8000_u32 {
        let load = load * f64::from(step.min(2000)) / 2000.0;
        stepper
            .advance(SystemInput::force(load).friction(friction))
            .expect("a step");
    }
    let held = stepper.contact();
    assert!(held.displacement() != rest.displacement() && held.displacement() != 0.0);
    assert!(
        (held.force() / (1.2 * friction) - share).abs() < 1e-9,
        "{}",
        held.force()
    );
    for step in 0..steps {
        let stepped = stepper
            .advance(SystemInput::force(load).friction(friction))
            .expect("a step");
        let now = stepper.contact();
        assert_eq!(
            (stepped.events, now.displacement().to_bits()),
            (0, held.displacement().to_bits()),
            "step {step}"
        );
        assert_eq!(
            (now.force(), now.velocity()),
            (held.force(), held.velocity()),
            "step {step}"
        );
    }
}

#[test]
fn nothing_creeps() {
    for share in [0.2, 0.5, 0.95] {
        holds(share, 100_000);
    }
}

#[test]
#[ignore = "three million steps take a minute"]
fn nothing_creeps_in_a_million_steps() {
    for share in [0.2, 0.5, 0.95] {
        holds(share, 1_000_000);
    }
}

/// A saved state continues to the bit, with the place of the slider.  Another stiffness, and a rigid contact, have another
/// hash.
#[test]
fn saved_states_continue() {
    let system: System = BLOCK.parse().expect("a scene");
    let mut stepper = system.stepper(1e-3).expect("a stepper");
    let input = |step: u32| SystemInput::force(50.0 * (0.01 * f64::from(step)).sin()).friction(6.0);
    for sticks in [true, false] {
        let mut step = 0;
        while step < 400 || stepper.contact().is_sticking() != sticks {
            stepper.advance(input(step)).expect("a step");
            step += 1;
        }
        let saved = stepper.save();
        let run = |stepper: &mut frictiongen::study::stepper::SystemStepper<'_>| {
            let steps = (step..step + 500).map(|step| {
                let stepped = stepper.advance(input(step)).expect("a step");
                let now = stepper.contact();
                [
                    stepped.force.to_bits(),
                    now.displacement().to_bits(),
                    now.velocity().to_bits(),
                ]
            });
            steps.collect::<Vec<_>>()
        };
        let first = run(&mut stepper);
        stepper.restore(&saved).expect("the same scene");
        assert_eq!(run(&mut stepper), first);
        let other: System = BLOCK.replace("3000.0", "3000.5").parse().expect("a scene");
        assert!(
            other
                .stepper(1e-3)
                .expect("a stepper")
                .restore(&saved)
                .is_err()
        );
        let rigid: System = BLOCK
            .replace("stiffness: 3000.0,", "")
            .parse()
            .expect("a scene");
        assert!(
            rigid
                .stepper(1e-3)
                .expect("a stepper")
                .restore(&saved)
                .is_err()
        );
    }
}

/// Single precision follows double precision.  Each of 3000 steps rounds to 6e-8.
#[test]
fn single_precision_follows() {
    let double: System = BLOCK.parse().expect("a scene");
    let single: System<f32> = BLOCK.parse().expect("a scene");
    let (mut a, mut b) = (
        double.stepper(1e-3).expect("a stepper"),
        single.stepper(1e-3).expect("a stepper"),
    );
    let mut largest = 0.0_f64;
    for step in 1..=3000_u32 {
        let load = 60.0 * (0.012 * f64::from(step)).sin();
        a.advance(SystemInput::force(load).friction(6.0))
            .expect("a step");
        b.advance(SystemInput::force(load as f32).friction(6.0))
            .expect("a step");
        let (a, b) = (a.contact(), b.contact());
        largest = largest.max(a.displacement().abs());
        assert!(
            (a.displacement() - f64::from(b.displacement())).abs() < 1e-5 * largest.max(1e-3),
            "{step}"
        );
        assert!(
            (a.force() - f64::from(b.force())).abs() < 0.02,
            "{step}: {} {}",
            a.force(),
            b.force()
        );
    }
}
