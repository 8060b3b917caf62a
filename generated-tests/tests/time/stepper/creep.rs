//! Tests that a stuck contact does not creep.

use crate::stepper::rig::{HOLD, Kind, LINEAR, Load, advance, begin, rig, scene};
use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, WALL};
use frictiongen_kernel::Plain;
use frictiongen_model::scene::Excitation;
use fuzzing::Random;

/// Asserts that a stuck contact keeps its displacement to the bit under small oscillating forces.
///
/// A constant load produces a contact force of `share` times the break-away force. In addition, an oscillating force
/// of 4 % of the break-away force acts on the mass of the contact, and a small random force on every mass.
fn holds<S: Plain>(text: &str, kind: Kind<'_>, share: f64, steps: u32) {
    let scene = scene(text);
    let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
    let on_base = scene.excitation == Excitation::Base;
    let dt = 0.2 / (k1 / m1).sqrt();
    let friction = 0.004 * k1;
    let grip = scene.stiction * friction;
    let contact = scene.masses.len() - 1;
    let mut rig = rig::<S>(&scene, kind, dt);
    let mut load = Load {
        base: [0.0; 2],
        forces: vec![0.0; scene.masses.len()],
        friction,
    };
    begin(&mut rig, &load);
    // A push moves the contact away from the origin. The remaining motion then has time to die out.
    load.forces[contact] = 3.0 * grip;
    for _ in 0..40 {
        advance(&mut rig, &load);
    }
    load.forces[contact] = 0.0;
    for _ in 0..20_000 {
        advance(&mut rig, &load);
    }
    assert!(rig.contact().is_sticking(), "{text}");
    // A small additional force shows which fraction of a force on the mass is a force in the contact.
    let before = rig.contact().force().to_f64();
    load.forces[contact] = 0.01 * grip;
    for _ in 0..20_000 {
        advance(&mut rig, &load);
    }
    let felt = (rig.contact().force().to_f64() - before) / (0.01 * grip);
    let mean = (share * grip - before) / felt;
    // The load grows slowly, because a chain without damping would overshoot.
    for step in 0..2000 {
        load.forces[contact] = mean * f64::from(step) / 2000.0;
        advance(&mut rig, &load);
    }
    let place = rig.contact().displacement();
    assert!(place.to_f64() != 0.0, "{text}: nothing to creep from");
    let mut random = Random(3);
    let mut largest = 0.0_f64;
    for step in 0..steps {
        for (mass, force) in load.forces.iter_mut().enumerate() {
            let mean = if mass == contact { mean } else { 0.0 };
            *force = mean + 0.004 * grip * random.signed();
        }
        load.forces[contact] += 0.02 * grip * f64::from(2 * (step % 2)) - 0.02 * grip;
        if on_base {
            // The base moves slowly about its rest position.
            let angle = 1e-3 * f64::from(step % 6283);
            load.base = [1e-4 * friction / k1 * angle.sin(), 0.0];
            load.base[1] = 1e-4 * friction / k1 * 1e-3 / dt * angle.cos();
        }
        let stepped = advance(&mut rig, &load);
        let now = rig.contact();
        assert!(stepped.events == 0 && now.is_sticking(), "step {step}");
        assert!(now.displacement() == place && now.velocity().to_f64() == 0.0);
        largest = largest.max(now.force().to_f64().abs() / grip);
    }
    println!(
        "{}, {share}: force up to {largest:.3} of the grip",
        scene.name
    );
    assert!(largest > share && largest < 1.0);
    // A larger force makes the contact slip. The comparison of displacements must detect the slip, otherwise it
    // proves nothing.
    load.forces[contact] = 3.0 * grip + mean;
    advance(&mut rig, &load);
    advance(&mut rig, &load);
    assert!(rig.contact().displacement() != place);
}

fn all(steps: u32) {
    for share in [0.2, 0.5, 0.95] {
        holds::<f64>(ONE, LINEAR, share, steps);
        holds::<f32>(ONE, HOLD, share, steps);
        holds::<f64>(PAIR, LINEAR, share, steps / 4);
    }
    holds::<f64>(BASE, LINEAR, 0.95, steps / 10);
    holds::<f64>(ONE_ON_BASE, LINEAR, 0.5, steps / 10);
    holds::<f32>(WALL, LINEAR, 0.95, steps / 10);
}

#[test]
fn none() {
    all(1_000_000);
}

/// Checks a base that moves forth and back within one step. The spring force on the contact is then largest in the
/// middle of the step, and equal at both ends. The contact must slip if friction is below that largest force. It must
/// stick if friction is above it.
#[test]
fn the_force_within_a_step_counts() {
    let scene = scene(
        "struct Between { masses: { m: 1 }, springs: { base - m: 10, m - wall: 100 }, contact: m - base,
         excitation: base }",
    );
    let (dt, y, v) = (0.05, 1.0, 1.0);
    // The cubic is y + vt(1 − t/dt), and the mass moves with it, so the force is mÿ + ky.
    let middle = -2.0 * v / dt + 100.0 * (y + 0.25 * v * dt);
    for (share, slips) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
        let mut rig = rig::<f64>(&scene, LINEAR, dt);
        let load = |base: [f64; 2], friction: f64| Load {
            base,
            forces: vec![0.0],
            friction,
        };
        begin(&mut rig, &load([0.0; 2], 1e5));
        assert_eq!(advance(&mut rig, &load([y, v], 1e5)).events, 0);
        let stepped = advance(&mut rig, &load([y, -v], share * middle));
        assert_eq!(stepped.events > 0, slips, "{share}: {stepped:?}");
    }
}

#[test]
#[ignore = "minutes"]
fn none_in_a_hundred_million_steps() {
    all(100_000_000);
}
