//! Compares runs with other steps, runs from other states, and runs with the stepper.

use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, WALL, WALL_BASE};
use crate::stribeck::{follow, lined, scaled, units};
use frictiongen::System;
use frictiongen::study::SystemInput;
use frictiongen::study::scene::Excitation;
use std::f64::consts::TAU;

const ALL: [&str; 6] = [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE];
const LAW: [[f64; 2]; 3] = [[0.1, 0.7], [0.5, 0.5], [0.9, 0.9]];

fn system(text: &str, r: f64) -> (System, f64) {
    let ([_, speed], amplitude) = units(&lined(text, 1.2, &[]), r);
    let scene = lined(text, 1.2, &scaled(&LAW, speed));
    (scene.try_into().expect("a scene"), amplitude)
}

/// Checks that the events of a run do not depend, bit for bit, on the steps in which the caller advances it.
#[test]
fn steps_do_not_matter() {
    let mut compared = 0;
    for text in ALL {
        for [r, beta] in [[0.3, 0.3], [1.1, 0.3]] {
            let (system, amplitude) = system(text, r);
            let mut whole = system.simulation_under(r, beta, amplitude).expect("a run");
            let mut short = whole.clone();
            let mut met = 0;
            while met < 12 && whole.cycles() < 200 {
                let Some(event) = whole.next().expect("no end").event else {
                    continue;
                };
                let found = loop {
                    let segment = short.advance(0.0137).expect("a reach");
                    if let Some(event) = segment.event {
                        break event;
                    }
                };
                assert_eq!(event, found);
                assert_eq!(whole.phase().to_bits(), short.phase().to_bits());
                assert_eq!(whole.cycles(), short.cycles());
                assert_eq!(whole.relative(), short.relative());
                met += 1;
            }
            compared += met;
        }
    }
    println!("{compared} events");
    assert!(100 < compared);
}

/// Checks that a run which starts from the state of an earlier run, a cycle later, equals the earlier run. The lines of
/// the law follow from the state.
#[test]
fn from_a_state() {
    let mut compared = 0;
    for text in ALL {
        let (r, beta) = (0.8, 0.25);
        let (system, amplitude) = system(text, r);
        let mut run = system.simulation_under(r, beta, amplitude).expect("a run");
        for start in 1..=6 {
            follow(&mut run, start, 0.0);
            let masses = 0..system.scene().masses.len();
            let state = |of: fn(frictiongen::kernel::simulation::Moment<f64>) -> f64| -> Vec<f64> {
                masses
                    .clone()
                    .map(|mass| of(run.run().mass(mass)))
                    .collect()
            };
            let (x, v) = (state(|now| now.displacement()), state(|now| now.velocity()));
            let from = system.simulation_under_from(r, beta, amplitude, (&x, &v));
            let (mut from, mut on) = (from.expect("a run"), run.clone());
            follow(&mut from, 1, 0.4);
            follow(&mut on, start + 1, 0.4);
            for mass in masses.clone() {
                let (a, b) = (from.run().mass(mass), on.run().mass(mass));
                // The two runs have different rounding errors. In addition, the state of the masses does not tell
                // whether a contact at rest sticks.
                let off = (a.displacement() - b.displacement()).abs()
                    + (a.velocity() - b.velocity()).abs();
                assert!(off < 1e-12, "{text}: {off:e}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 66);
}

/// Compares the stepper under a sampled cosine with a run. The difference is of the order of the squared step,
/// because straight lines between samples miss h²/8 of the cosine.
#[test]
fn beside_the_stepper() {
    let mut compared = 0;
    for text in ALL {
        for [r, beta] in [[0.4, 0.3], [1.2, 0.25]] {
            let (system, amplitude) = system(text, r);
            let ([length, speed], _) = units(system.scene(), r);
            let friction = beta * length * system.scene().springs[0].stiffness;
            let (omega, base) = (
                speed / length,
                system.scene().excitation == Excitation::Base,
            );
            let off = |steps: u32| {
                let dt = TAU / omega / f64::from(steps);
                let at = |step: u32| {
                    let (sine, cosine) =
                        (TAU * f64::from(step % steps) / f64::from(steps)).sin_cos();
                    let input = match base {
                        true => SystemInput::base(amplitude * cosine, -amplitude * omega * sine),
                        false => SystemInput::force(amplitude * cosine),
                    };
                    input.friction(friction)
                };
                let mut stepper = system.stepper(dt).expect("a step");
                stepper.begin(at(0)).expect("an input");
                let mut run = system.simulation_under(r, beta, amplitude).expect("a run");
                let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
                for step in 1..=6 * steps {
                    stepper.advance(at(step)).expect("an input");
                    if step % (steps / 50) != 0 {
                        continue;
                    }
                    follow(
                        &mut run,
                        u64::from(step / steps),
                        f64::from(step % steps) / f64::from(steps),
                    );
                    for mass in 0..system.scene().masses.len() {
                        let found = run.run().mass(mass).displacement() * length;
                        let want = stepper.mass_at(mass).displacement();
                        worst = worst.max((found - want).abs());
                        largest = largest.max(want.abs());
                    }
                }
                assert_eq!(stepper.exceeded(), 0);
                worst / largest
            };
            let [coarse, fine] = [400, 3200].map(off);
            println!("{}, {r}, {beta}: {coarse:.1e}, {fine:.1e}", &text[7..14]);
            // The difference should fall by a factor of 64. The factor varies, because a break-away may be late by a
            // fraction of a step.
            assert!(fine < 1e-5 && fine < coarse / 16.0, "{coarse:e}, {fine:e}");
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}
