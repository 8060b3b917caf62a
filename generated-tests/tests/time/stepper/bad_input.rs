//! Tests that a refused input does not change a stepper, and that `restore` restores a saved state to the bit.

use crate::stepper::independent::loads;
use crate::stepper::rig::{HOLD, Kind, LINEAR, Load, Rig, advance, begin, rig, scene, try_rig};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL};
use frictiongen::{Given, OutOfDomain};
use frictiongen_kernel::stepper::{Input, Sample};

/// Returns every number of the state as text, with enough digits to distinguish all values.
fn bits(rig: &Rig<f64>) -> String {
    format!("{:?}", rig.save())
}

#[test]
fn refused_and_unchanged() {
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE] {
        for kind in [LINEAR, HOLD] {
            let scene = scene(text);
            let dt = 0.01;
            let mut rig = rig::<f64>(&scene, kind, dt);
            let mut next = loads(&scene, 2, dt);
            begin(&mut rig, &next());
            for _ in 0..100 {
                advance(&mut rig, &next());
            }
            let before = bits(&rig);
            let sound = next();
            let mut cases: Vec<(OutOfDomain, Load)> = Vec::new();
            let mut case = |error, change: &dyn Fn(&mut Load)| {
                let mut load = sound.clone();
                change(&mut load);
                cases.push((error, load));
            };
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
                let (last, given) = (scene.masses.len() - 1, Given::of(bad));
                case(OutOfDomain::Force(given), &|load| load.forces[last] = bad);
                case(OutOfDomain::Friction(given), &|load| load.friction = bad);
                if scene.excitation == frictiongen_model::scene::Excitation::Base {
                    case(OutOfDomain::BaseMotion(given), &|load| load.base[0] = bad);
                    case(OutOfDomain::BaseMotion(given), &|load| load.base[1] = bad);
                }
            }
            case(OutOfDomain::Friction(Given::Negative), &|load| {
                load.friction = -1e-9
            });
            case(OutOfDomain::Forces, &|load| load.forces.push(0.0));
            case(OutOfDomain::Forces, &|load| load.forces.clear());
            for (wanted, load) in cases {
                let sample = Sample {
                    base: load.base,
                    forces: &load.forces,
                    friction: load.friction,
                };
                let error = rig.advance(sample).expect_err("a bad load");
                assert_eq!(error, wanted, "{load:?}");
                assert!(rig.begin(sample).is_err());
                assert_eq!(bits(&rig), before, "{load:?}");
            }
            for mu in [0.5, 0.0, -1.0, f64::NAN, f64::INFINITY] {
                let error = rig.set_stiction(mu).expect_err("a bad stiction");
                assert_eq!(error, OutOfDomain::Stiction(Given::of(mu)));
                assert_eq!(bits(&rig), before);
            }
            // After the first step the stepper must refuse `begin`.
            let sample = Sample {
                base: sound.base,
                forces: &sound.forces,
                friction: sound.friction,
            };
            assert_eq!(rig.begin(sample).expect_err("too late"), OutOfDomain::Begun);
            assert_eq!(bits(&rig), before);
            // The stepper must then accept a valid load, with the result of a stepper that never got the refused
            // loads.
            advance(&mut rig, &sound);
            assert_ne!(bits(&rig), before);
        }
    }
}

#[test]
fn steps_that_cannot_be_taken() {
    for text in [WALL, ONE, BASE] {
        let scene = scene(text);
        for dt in [
            0.0,
            -0.0,
            -1e-3,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            1e6,
            1e-300,
        ] {
            let error = try_rig::<f64>(&scene, LINEAR, dt).expect_err("a bad step");
            assert_eq!(error, OutOfDomain::Step(Given::of(dt)), "{dt}");
        }
    }
}

#[test]
fn saved_and_restored() {
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, TEN] {
        for kind in [LINEAR, HOLD] {
            let scene = scene(text);
            let dt = 0.02;
            let mut rig = rig::<f64>(&scene, kind, dt);
            let mut next = loads(&scene, 8, dt);
            begin(&mut rig, &next());
            let many: Vec<Load> = (0..400).map(|_| next()).collect();
            for load in &many[..150] {
                advance(&mut rig, load);
            }
            let saved = rig.save();
            let mut other = crate::stepper::rig::rig::<f64>(&scene, kind, dt);
            let run = |rig: &mut Rig<f64>| {
                for load in &many[150..] {
                    advance(rig, load);
                }
                bits(rig)
            };
            let mut twin = rig.clone();
            let first = run(&mut rig);
            rig.restore(&saved).expect("its own state");
            other.restore(&saved).expect("the state of one like it");
            assert_eq!(run(&mut rig), first);
            assert_eq!(run(&mut other), first);
            assert_eq!(run(&mut twin), first);
        }
    }
    let mut one = rig::<f64>(&scene(ONE), LINEAR, 0.02);
    let before = bits(&one);
    let error = one.restore(&rig::<f64>(&scene(PAIR), LINEAR, 0.02).save());
    assert_eq!(error.expect_err("another scene"), OutOfDomain::Saved);
    assert_eq!(bits(&one), before);
}

/// Checks that a stepper refuses the state of another scene or step. The refused state has the same size as a valid
/// state, but another meaning.
#[test]
fn the_state_of_another_stepper_is_refused() {
    let law = Kind {
        input: Input::Linear,
        law: &[[0.1, 0.5]],
    };
    let of = |text: &str, kind, dt| rig::<f64>(&scene(text), kind, dt);
    for (what, text, kind, dt) in [
        ("step", PAIR.to_owned(), LINEAR, 0.021),
        (
            "step in the last digit",
            PAIR.to_owned(),
            LINEAR,
            0.02_f64.next_up(),
        ),
        ("input", PAIR.to_owned(), HOLD, 0.02),
        ("law", PAIR.to_owned(), law, 0.02),
        ("mass", PAIR.replace("b: 2", "b: 2.5"), LINEAR, 0.02),
        ("spring", PAIR.replace("15", "16"), LINEAR, 0.02),
        ("damping", PAIR.replace("0.08", "0.09"), LINEAR, 0.02),
        (
            "damping of the other",
            PAIR.replace("0.03", "0.031"),
            LINEAR,
            0.02,
        ),
        ("contact", PAIR.replace("b - a,", "b - wall,"), LINEAR, 0.02),
        (
            "units",
            PAIR.replace("a: 1, b: 2", "a: 2, b: 4")
                .replace("10, a - b: 15", "20, a - b: 30"),
            LINEAR,
            0.02,
        ),
    ] {
        let mut one = of(PAIR, LINEAR, 0.02);
        let before = bits(&one);
        let error = one.restore(&of(&text, kind, dt).save());
        assert_eq!(error.expect_err(what), OutOfDomain::Saved);
        assert_eq!(bits(&one), before, "{what}");
        one.restore(&of(PAIR, LINEAR, 0.02).save())
            .expect("its own");
    }
}

/// Checks that the time is the number of steps times the step.
#[test]
fn time_passes() {
    let mut rig = rig::<f32>(&scene(ONE), LINEAR, 0.02);
    let load = Load {
        base: [0.0; 2],
        forces: vec![0.0],
        friction: 1.0,
    };
    for step in 1..=100_u8 {
        advance(&mut rig, &load);
        assert_eq!(rig.time().to_bits(), (f32::from(step) * 0.02).to_bits());
    }
}
