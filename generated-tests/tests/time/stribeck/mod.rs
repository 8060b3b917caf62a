//! Runs in time with a kinetic level that changes with the speed.
//!
//! `plain` is an integrator that shares no code with them: Runge-Kutta steps of the equations of motion.

mod coulomb;
mod edges;
mod emitted;
mod independent;
mod plain;
mod steps;

use crate::stepper::scenes::sticky;
use frictiongen::System;
use frictiongen::kernel::Float;
use frictiongen::study::scene::{Excitation, FrictionLaw, Provide, Scene};

/// A scene with stiction and with a law in its own units; Coulomb's without points.
pub fn lined(text: &str, mu: f64, law: &[[f64; 2]]) -> Scene {
    let system: System = sticky(text, mu).parse().expect("a scene");
    let mut scene = system.scene().clone();
    if !law.is_empty() {
        scene.friction = FrictionLaw::Stribeck(law.to_vec());
        scene.provide = vec![Provide::Simulation];
    }
    scene
}

/// What takes z̄ and dz̄/dτ to metres and metres a second, at r under a load that moves things by about a centimetre; and
/// that load's amplitude.
pub fn units(scene: &Scene, r: f64) -> ([f64; 2], f64) {
    const LENGTH: f64 = 0.01;
    let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
    let amplitude = match scene.excitation {
        Excitation::Base => LENGTH,
        Excitation::Force(_) => LENGTH * k1,
    };
    ([LENGTH, LENGTH * r * (k1 / m1).sqrt()], amplitude)
}

/// A law whose speeds are dz̄/dτ, in a scene's units.
pub fn scaled(law: &[[f64; 2]], speed: f64) -> Vec<[f64; 2]> {
    law.iter().map(|[v, f]| [v * speed, *f]).collect()
}

/// Moves a run on to an instant, in cycles; how many events it met.
pub fn follow<S: Float>(
    run: &mut impl frictiongen::Run<Scalar = S>,
    cycle: u64,
    part: f64,
) -> usize {
    let tau = S::pi() + S::pi();
    let mut events = 0;
    loop {
        let whole = S::constant(cycle as f64 - run.cycles() as f64);
        let left = whole * tau + (tau * S::constant(part) - run.phase());
        if !(S::constant(16.0 * S::EPSILON) < left) {
            return events;
        }
        let segment = run.advance(left).expect("a reach");
        events += usize::from(segment.event.is_some());
    }
}
