//! Tests the energy balance of the steady state: over a cycle the work of the load equals the losses by friction and
//! modal damping.

use frictiongen::System;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::orbit::SystemOrbit;
use std::f64::consts::{PI, TAU};

/// Nodes and weights of Gauss's quadrature rule with eight points.
pub const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Returns x̄ and x̄′ of every mass at a maximum of the excitation.
pub fn section(system: &System, orbit: &SystemOrbit<'_>) -> (Vec<f64>, Vec<f64>) {
    let tau = -orbit.origin();
    let masses = 0..system.scene().masses.len();
    masses
        .map(|mass| {
            let motion = orbit.mass_at(mass).expect("a mass");
            (motion.displacement(tau), motion.velocity(tau))
        })
        .unzip()
}

/// Returns the work of the load minus all losses, and the losses by modal damping, both divided by the work of the
/// load.
fn balance(system: &System, r: f64, beta: f64) -> (f64, f64) {
    let orbit = system.at(r).expect("in the domain").orbit(beta);
    let orbit = orbit.unwrap_or_else(|error| panic!("r = {r}, β = {beta}: {error}"));
    let scene = system.scene();
    let (m1, k1) = (scene.masses[0].value, scene.springs[0].stiffness);
    // The work of the load in a cycle is ∮ pᵀx̄′ cos τ dτ = −π Im X₁ of the loaded mass. Base motion acts through the
    // springs to the base.
    let moved = |mass: usize| orbit.mass_at(mass).expect("a mass").harmonic(1).im;
    let input = match scene.excitation {
        frictiongen::study::scene::Excitation::Force(mass) => -PI * moved(mass),
        frictiongen::study::scene::Excitation::Base => {
            use frictiongen::study::scene::Node::{Base, Mass};
            let springs = scene
                .springs
                .iter()
                .map(|spring| match (&spring.from, &spring.to) {
                    (Base, Mass(mass)) | (Mass(mass), Base) => {
                        -PI * moved(*mass) * spring.stiffness / k1
                    }
                    _ => 0.0,
                });
            springs.sum()
        }
    };
    // A run in time from this state gives the exact sliding distances and the events.
    let (x, v) = section(system, &orbit);
    let mut run = system
        .simulation_from(r, beta, (&x, &v))
        .expect("in the domain");
    let (mut left, mut slid, mut damped, mut at) = (TAU, 0.0, 0.0, 0.0);
    let modal = system.modal();
    while left > 1e-13 {
        let before = run.run().relative().0;
        let segment = run.advance(left).expect("a reach");
        if segment.contact != Contact::Stuck {
            slid += (run.run().relative().0 - before).abs();
        }
        // The loss by damping is ∮ x̄′ᵀC̄x̄′ dτ = Σ 2ζ r√λ ∮ (φᵀΓx̄′)² dτ. The panels of the quadrature are so short
        // that the phase of no mode changes much in one panel.
        let panels = (segment.length * 4.0 * (1.0 + 3.0 / r)).ceil();
        let width = segment.length / panels;
        for panel in 0..panels as usize {
            for (node, weight) in GAUSS {
                for side in [-node, node] {
                    let tau = at + width * (panel as f64 + (1.0 + side) * 0.5);
                    let tau = tau - orbit.origin();
                    let velocities: Vec<f64> = (0..x.len())
                        .map(|mass| orbit.mass_at(mass).expect("a mass").velocity(tau))
                        .collect();
                    for (mode, shape) in modal.shapes.iter().enumerate() {
                        let rate: f64 = (0..x.len())
                            .map(|mass| {
                                let gamma = scene.masses[mass].value / m1;
                                shape[mass].to_f64() * gamma * velocities[mass]
                            })
                            .sum();
                        let zeta = modal.damping_ratios[mode].to_f64();
                        let loss = 2.0 * zeta * r * modal.resonances[mode].to_f64();
                        damped += loss * rate * rate * weight * width * 0.5;
                    }
                }
            }
        }
        at += segment.length;
        left -= segment.length;
    }
    ((input - beta * slid - damped) / input, damped / input)
}

#[test]
fn over_a_cycle() {
    let scenes: [(&str, &[(f64, f64)]); 4] = [
        (
            "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
            contact: block - wall, excitation: block, damping: none }",
            &[
                (0.3, 0.4),
                (1.0 / 3.0, 0.01),
                (0.9, 0.3),
                (2.0, 0.7),
                (0.1, 0.2),
            ],
        ),
        (
            "struct Frame { masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }",
            &[(0.3, 0.4), (0.5, 0.3), (0.9, 0.4)],
        ),
        (
            "struct Pair { masses: { a: 1, b: 1.3, c: 0.7 },
            springs: { base - a: 1, a - b: 2, b - c: 0.9 },
            contact: a - c, excitation: b, damping: rayleigh(0.02, 0.05) }",
            &[(0.4, 0.1), (0.8, 0.2), (1.9, 0.05)],
        ),
        (
            "struct Five { masses: { a: 1, b: 1.2, c: 0.9, d: 1.1, e: 1 },
            springs: { base - a: 1, a - b: 1.3, b - c: 1, c - d: 0.8, d - e: 1 },
            contact: c - wall, excitation: a, damping: modal(0.03) }",
            &[(0.3, 0.4), (0.7, 0.3)],
        ),
    ];
    let (mut losses, mut compared) = (0.0_f64, 0);
    for (text, points) in scenes {
        let system: System = text.parse().expect("a scene");
        for (r, beta) in points {
            let (rest, damped) = balance(&system, *r, *beta);
            assert!(rest.abs() < 1e-12, "{text}\nr = {r}, β = {beta}: {rest:e}");
            losses = losses.max(damped);
            compared += 1;
        }
    }
    println!("{compared} balances compared, none skipped");
    assert_eq!(compared, 5 + 3 + 3 + 2);
    assert!(losses > 0.2, "{losses}");
}
