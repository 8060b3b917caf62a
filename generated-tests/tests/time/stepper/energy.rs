//! Tests the energy balance over many random steps. The work of the load must equal the sum of friction work, damping
//! work and stored energy, and no step may create energy.
//!
//! The stepper computes `Work::damping` from the remaining three energies, so the sum alone proves nothing. Without
//! damping `Work::damping` must vanish. With damping it must grow in every step, and equal a quadrature of ẋᵀCẋ
//! (`independent`). The stored energy must equal that of the motions of the masses.

use crate::stepper::independent::loads;
use crate::stepper::plain::chain::Chain;
use crate::stepper::rig::{HOLD, Kind, LINEAR, Rig, advance, begin, rig, scene};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, sticky};
use frictiongen_kernel::Plain;
use frictiongen_kernel::stepper::Input;
use frictiongen_model::scene::{Excitation, Scene};
use nalgebra::DVector;

fn without_damping(text: &str) -> String {
    let (before, after) = text
        .split_once("damping:")
        .map_or((text, ""), |parts| parts);
    let end = if after.is_empty() { "" } else { " }" };
    format!("{}{end}", before.trim_end().trim_end_matches(','))
}

/// Returns the stored energy ½ẋᵀMẋ + ½xᵀKx, which includes the energy of the springs to a moving base.
fn stored(scene: &Scene, chain: &Chain, [x, v]: [&DVector<f64>; 2], base: f64) -> f64 {
    let kinetic = v.component_mul(&chain.m).dot(v);
    let mut sum = 0.5 * (kinetic + (&chain.k * x).dot(x));
    if scene.excitation == Excitation::Base {
        sum += base * (0.5 * base * chain.to_base.sum() - chain.to_base.dot(x));
    }
    sum
}

/// Checks the energy balance over a run. Errors are divided by the energy that passes through the chain. `rounding`
/// is the rounding unit of the scalar type.
fn run<S: Plain>(text: &str, kind: Kind<'_>, steps: u32, rounding: f64) {
    let scene = scene(text);
    let chain = Chain::of(&scene, &[]);
    let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
    let dt = 0.3 / omega;
    let undamped = chain.c.amax() == 0.0;
    let mut next = loads(&scene, 23, dt);
    let mut rig = rig::<S>(&scene, kind, dt);
    let start = next();
    begin(&mut rig, &start);
    let n = scene.masses.len();
    let at_start = stored(
        &scene,
        &chain,
        [&DVector::zeros(n), &DVector::zeros(n)],
        start.base[0],
    );
    let work = |rig: &Rig<S>| {
        let work = rig.work();
        [work.load, work.friction, work.damping, work.stored].map(S::to_f64)
    };
    let mut before = work(&rig);
    // Errors are measured against the energy that passes through the chain.
    let (mut passed, mut largest, mut made, mut off) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for step in 0..steps {
        let load = next();
        advance(&mut rig, &load);
        let now = work(&rig);
        let gained = [0, 1, 2].map(|k| now[k] - before[k]);
        passed += gained[0].abs();
        largest = largest.max(now[3].abs()).max(gained[0].abs());
        // As the sums grow, the rounding error of their differences grows too.
        let noise = rounding * (now[0].abs() + largest);
        made = made.max(-gained[1] / noise);
        made = made.max(-gained[2] / noise);
        if step % 97 == 0 {
            let column = |of: &dyn Fn(usize) -> f64| DVector::from_fn(n, |mass, _| of(mass));
            let x = column(&|mass| rig.mass(mass).displacement().to_f64());
            let v = column(&|mass| rig.mass(mass).velocity().to_f64());
            // With zero-order hold the base moves with its velocity during a step. At the end of the step it is
            // therefore not at the sample's displacement.
            let base = match kind.input {
                Input::Hold => load.base[0] + load.base[1] * dt,
                Input::Linear => load.base[0],
            };
            let want = stored(&scene, &chain, [&x, &v], base) - at_start;
            off = off.max((now[3] - want).abs() / largest);
        }
        before = now;
    }
    let residue = if undamped {
        before[2].abs() / passed
    } else {
        0.0
    };
    println!(
        "{}: {steps} steps, load {:.3}, friction {:.3}, damping {:.3}: residue {residue:.1e}, stored off by \
         {off:.1e}, made at most {made:.1} roundings",
        scene.name, before[0], before[1], before[2],
    );
    // The stored energy is a sum of squares over the modes, with at most a hundred terms.
    assert!(off < 100.0 * rounding, "{text}: {off:e}");
    assert!(residue < 30.0 * rounding, "{text}: {residue:e}");
    assert!(made < 30.0, "{text}: {made}");
    assert!(before[1] > 0.0 && (undamped || before[2] > 0.0));
}

fn all(steps: u32) {
    for text in [ONE, PAIR, ONE_ON_BASE, WALL, BASE, TEN] {
        let steps = if text == TEN { steps / 5 } else { steps };
        let mut texts = vec![text.to_owned(), sticky(text, 1.3)];
        if text.contains("damping") {
            texts.push(without_damping(text));
        }
        for text in texts {
            run::<f64>(&text, LINEAR, steps, f64::EPSILON);
            run::<f32>(&text, LINEAR, steps, f64::from(f32::EPSILON));
        }
    }
    run::<f64>(PAIR, HOLD, steps, f64::EPSILON);
    run::<f64>(BASE, LINEAR, steps, f64::EPSILON);
}

#[test]
fn balance() {
    all(20_000);
}

#[test]
fn balance_over_a_million_steps() {
    run::<f64>(ONE, LINEAR, 1_000_000, f64::EPSILON);
    run::<f32>(ONE, LINEAR, 1_000_000, f64::from(f32::EPSILON));
}

#[test]
#[ignore = "minutes"]
fn balance_over_a_hundred_million_steps() {
    run::<f64>(ONE, LINEAR, 100_000_000, f64::EPSILON);
    run::<f32>(ONE, LINEAR, 100_000_000, f64::from(f32::EPSILON));
    run::<f64>(PAIR, LINEAR, 20_000_000, f64::EPSILON);
    run::<f32>(PAIR, LINEAR, 20_000_000, f64::from(f32::EPSILON));
}
