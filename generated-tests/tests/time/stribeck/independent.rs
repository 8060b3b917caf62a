//! Compares runs with a plain integrator that shares no code with them.

use crate::stepper::plain::chain::Chain;
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, WALL_BASE};
use crate::stribeck::plain::{Load, Run};
use crate::stribeck::{follow, lined, scaled, units};
use frictiongen::System;
use frictiongen::study::scene::Excitation;

/// Returns the difference of a run and the plain integrator, divided by the largest displacement or velocity. The
/// further results are the number of events of the run and of the integrator, and how often the speed reached a point
/// of the law.
fn apart(text: &str, law: &[[f64; 2]], [r, beta]: [f64; 2], steps: usize) -> (f64, [usize; 3]) {
    const CYCLES: usize = 12;
    let ([length, speed], amplitude) = units(&lined(text, 1.2, &[]), r);
    let law = scaled(law, speed);
    let scene = lined(text, 1.2, &law);
    let on = match scene.excitation {
        Excitation::Force(mass) => Some(mass),
        Excitation::Base => None,
    };
    let omega = speed / length;
    let load = Load {
        on,
        amplitude,
        omega,
        friction: beta * length * scene.springs[0].stiffness,
    };
    let mut plain = Run::new(Chain::of(&scene, &law), load);
    let system: System = scene.try_into().expect("a sound scene");
    let mut run = system.simulation_under(r, beta, amplitude).expect("a run");
    let (mut worst, mut largest, mut events) = ([0.0_f64; 2], [0.0_f64; 2], 0);
    for step in 1..=CYCLES * steps {
        plain.step(step - 1, std::f64::consts::TAU / omega / steps as f64);
        if step % 32 != 0 {
            continue;
        }
        let (cycle, part) = (step / steps, (step % steps) as f64 / steps as f64);
        events += follow(&mut run, cycle as u64, part);
        for mass in 0..plain.x.len() {
            let now = run.run().mass(mass);
            let found = [now.displacement() * length, now.velocity() * speed];
            for (side, want) in [plain.x[mass], plain.v[mass]].into_iter().enumerate() {
                worst[side] = worst[side].max((found[side] - want).abs());
                largest[side] = largest[side].max(want.abs());
            }
        }
    }
    let worst = (worst[0] / largest[0]).max(worst[1] / largest[1]);
    (worst, [events, plain.events, plain.crossed])
}

/// Compares runs with all contacts, damped and undamped: at a low frequency with many stops, near a resonance, and
/// above it. The friction of one law falls with speed, and that of the second law falls and then rises. The function
/// runs one of `one_in` cases.
///
/// The remaining difference is the error of the integrator. With four times as many steps it must be a 256th.
/// Exceptions are runs whose coarse steps missed an event, and runs whose difference is mostly rounding, about 1e-12
/// of the motion.
fn runs(one_in: usize) -> [usize; 4] {
    let falls = [[0.3, 0.7], [0.8, 0.5]];
    let rises = [[0.2, 0.6], [0.7, 1.1]];
    let (mut compared, mut events, mut crossed, mut ordered) = (0, 0, 0, 0);
    let mut turn = 0;
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE, TEN] {
        for at in [[0.3, 0.3], [0.9, 0.4], [1.4, 0.2]] {
            for law in [falls, rises] {
                turn += 1;
                if turn % one_in != 0 {
                    continue;
                }
                let (coarse, _) = apart(text, &law, at, 1024);
                let (fine, [found, want, points]) = apart(text, &law, at, 4096);
                println!(
                    "{}, {at:?}: {coarse:.1e}, {fine:.1e}, {found} events, {points} points met",
                    &text[7..14]
                );
                // The last event may lie just before or just after the end of the run.
                assert!(want.abs_diff(found) <= 1, "{want} events, {found}");
                assert!(fine < 1e-7, "{fine:e}");
                ordered += usize::from(fine < coarse / 128.0);
                (compared, events, crossed) = (compared + 1, events + found, crossed + points);
            }
        }
    }
    println!("{compared} runs, {ordered} of them in order, {events} events, {crossed} points met");
    assert_eq!(ordered, compared);
    [compared, ordered, events, crossed]
}

/// Runs every fifth case, which covers all scenes, points and laws.
#[test]
fn runs_from_rest() {
    let [compared, _, events, crossed] = runs(5);
    assert_eq!(compared, 8);
    assert!(100 < events && 250 < crossed, "{events}, {crossed}");
}

#[test]
#[ignore = "a minute; one in five runs in every run of the tests"]
fn all_runs_from_rest() {
    let [compared, _, events, crossed] = runs(1);
    assert_eq!(compared, 42);
    assert!(1000 < events && 2500 < crossed);
}
