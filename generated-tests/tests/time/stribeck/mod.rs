//! Tests of runs in time with a kinetic friction force that depends on the speed. `study/joined/tests/stribeck.rs`
//! compares such runs with another solver, which advances the masses in place of the modes.

mod coulomb;
mod edges;
mod emitted;
mod joined;
mod steps;

use crate::stepper::scenes::sticky;
use frictiongen::System;
use frictiongen::kernel::Float;
use frictiongen::study::scene::{Excitation, FrictionLaw, Provide, Scene};

/// Returns a scene with μ and a friction law, whose points are in the units of the scene. A list without points means
/// Coulomb's law.
pub fn lined(text: &str, mu: f64, law: &[[f64; 2]]) -> Scene {
    let system: System = sticky(text, mu).parse().expect("a scene");
    let mut scene = system.scene().clone();
    if !law.is_empty() {
        scene.friction = FrictionLaw::Stribeck(law.to_vec());
        scene.provide = vec![Provide::Simulation];
    }
    scene
}

/// Returns the factors that convert z̄ and dz̄/dτ to metres and metres per second at r, and the amplitude of the
/// load. This load causes displacements of about a centimetre.
pub fn units(scene: &Scene, r: f64) -> ([f64; 2], f64) {
    const LENGTH: f64 = 0.01;
    let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
    let amplitude = match scene.excitation {
        Excitation::Base => LENGTH,
        Excitation::Force(_) => LENGTH * k1,
    };
    ([LENGTH, LENGTH * r * (k1 / m1).sqrt()], amplitude)
}

/// Returns a friction law in the units of a scene, from a law whose speeds are values of dz̄/dτ.
pub fn scaled(law: &[[f64; 2]], speed: f64) -> Vec<[f64; 2]> {
    law.iter().map(|[v, f]| [v * speed, *f]).collect()
}

/// Advances a run to an instant, given in cycles, and returns the number of events.
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
