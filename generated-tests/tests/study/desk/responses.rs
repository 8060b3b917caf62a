//! Compares energy, rates and forces of a response with the work of the load and with the response's own
//! displacements.

use crate::desk::{SCENES, system};
use frictiongen::study::InitialState;
use frictiongen::study::response::{MotionQuantity, SystemResponse};
use frictiongen::study::scene::{Damping, Excitation, Node};
use frictiongen::{Of, System};
use std::f64::consts::{PI, TAU};

/// Points (r, β) at which the tests ask for responses. No point is near a resonance of the chains.
const PLACES: [(f64, f64); 8] = [
    (0.31, 0.05),
    (0.31, 0.4),
    (0.47, 0.3),
    (0.77, 0.2),
    (0.9, 0.6),
    (1.3, 0.35),
    (1.3, 1.1),
    (2.1, 0.15),
];

/// Returns the work of the load in a cycle, divided by P²/k₁ or by k₁Y², from the fundamental components.
fn input_work(system: &System, response: &SystemResponse<'_>) -> f64 {
    let scene = system.scene();
    let imaginary = |mass: usize| response.harmonic(Of::Mass(mass), 1).unwrap().im;
    match scene.excitation {
        // The work is ∮ cos τ dx̄ with x̄ = Re X e^{iτ}.
        Excitation::Force(mass) => -PI * imaginary(mass),
        // The base acts through its springs. The work is ∮ Σκ(ȳ − x̄) dȳ with ȳ = cos τ.
        Excitation::Base => {
            let first = scene.springs[0].stiffness;
            let springs = scene.springs.iter().map(|spring| {
                let mass = match (spring.from, spring.to) {
                    (Node::Base, Node::Mass(mass)) | (Node::Mass(mass), Node::Base) => mass,
                    _ => return 0.0,
                };
                -PI * imaginary(mass) * spring.stiffness / first
            });
            springs.sum()
        }
    }
}

/// Checks that without damping friction dissipates the work of the load. Both works are sums of order 1 over a cycle.
/// The work of the load follows from a harmonic by quadrature. The tolerance is 1e-10 times the larger of the works
/// and 1.
#[test]
fn friction_takes_out_what_the_load_puts_in() {
    let (mut checked, mut stops) = (0, 0);
    for (name, text) in SCENES {
        let system = system(text);
        // If the contact joins a mass to the base, friction also does work on the base. The springs are then not the
        // only load.
        let on_base =
            [system.scene().contact.from, system.scene().contact.to].contains(&Node::Base);
        if system.scene().damping != Damping::None || on_base {
            continue;
        }
        for (r, beta) in PLACES {
            let response = system.at(r).unwrap().response(beta).unwrap();
            if !response.is_settled() {
                continue;
            }
            let (taken, given) = (response.friction_work(), input_work(&system, &response));
            let scale = taken.abs().max(given.abs()).max(1.0);
            assert!(
                (taken - given).abs() < 1e-10 * scale,
                "{name}, r = {r}, β = {beta}: {taken} of {given}"
            );
            checked += 1;
            stops += usize::from(matches!(response, SystemResponse::StickSlip(_)));
        }
    }
    assert!(
        checked >= 30 && stops >= 8,
        "{checked} responses, {stops} with stops"
    );
}

/// Checks that for a motion that repeats after three cycles, the friction work is that of one cycle.
#[test]
fn friction_takes_out_as_much_of_each_of_three_cycles() {
    let system = system(
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a, stiction: 2 }",
    );
    let response = system.at(0.352).unwrap().response(0.1563).unwrap();
    assert_eq!(response.period(), 3);
    let (taken, given) = (response.friction_work(), input_work(&system, &response));
    // The work of the load comes from a harmonic by quadrature, which limits the tolerance.
    assert!((taken - given).abs() < 1e-10, "{taken} of {given}");
    assert!(given > 0.1, "{given}");
}

/// Checks that velocities and accelerations are the derivatives of the displacements at 4000 instants of a period.
/// Difference quotients with a step h are within h² of the derivatives. The check leaves out instants next to a jump
/// of an acceleration.
#[test]
fn rates_are_those_of_the_displacements() {
    let mut checked = 0;
    for (name, text) in SCENES {
        let system = system(text);
        let parts = (0..system.scene().masses.len())
            .map(Of::Mass)
            .chain([Of::Contact]);
        for of in parts {
            for (r, beta) in PLACES {
                let at = system.at(r).unwrap();
                let response = at.response(beta).unwrap();
                let Ok(orbit) = at.orbit(beta) else { continue };
                if matches!(response, SystemResponse::Stuck(_)) || !response.is_settled() {
                    continue;
                }
                let motion = match of {
                    Of::Contact => orbit.contact(),
                    Of::Mass(mass) => orbit.mass_at(mass).unwrap(),
                    _ => continue,
                };
                let count = 4000 * orbit.period();
                let h = TAU * f64::from(orbit.period()) / f64::from(count);
                let x: Vec<f64> = (0..count + 2)
                    .map(|i| motion.displacement(h * f64::from(i)))
                    .collect();
                let velocity = x
                    .windows(3)
                    .map(|x| ((x[2] - x[0]) / (2.0 * h)).abs())
                    .fold(0.0, f64::max);
                let found = response.largest(of, MotionQuantity::Velocity).unwrap();
                let scale = response.largest(of, MotionQuantity::Acceleration).unwrap();
                let what = format!("{name}, {of:?}, r = {r}, β = {beta}");
                assert!(
                    (found - velocity).abs() < 2.0 * h * scale,
                    "{what}: {found} for {velocity}"
                );
                assert!(
                    velocity <= found + 1e-9 * scale.max(1.0),
                    "{what}: {found} below {velocity}"
                );
                let curves = x
                    .windows(3)
                    .map(|x| (x[2] - 2.0 * x[1] + x[0]).abs() / (h * h));
                let curve = curves.fold(0.0, f64::max);
                // Across a jump the second difference lies between the values on both sides.
                assert!(
                    curve <= scale * (1.0 + 1e-6) + 1e-6,
                    "{what}: {scale} below {curve}"
                );
                assert!(scale < 1.02 * curve + 1e-3, "{what}: {scale} above {curve}");
                checked += 1;
            }
        }
    }
    assert!(checked > 80, "{checked}");
}

/// Checks that the response returns the largest friction force of a late cycle of motion from rest. The response also
/// starts from rest, so that a contact that never slides keeps its force.
#[test]
fn contact_forces_are_those_of_a_run() {
    for (name, text) in SCENES {
        let system = system(text);
        let rest = InitialState::rest(system.scene().masses.len());
        let system = system.starting_from(rest);
        for (r, beta) in PLACES {
            let at = system.at(r).unwrap();
            let Ok(response) = at.response(beta) else {
                continue;
            };
            if system.scene().damping == Damping::None
                && !matches!(response, SystemResponse::StickSlip(_))
            {
                // The test skips scenes whose transient does not decay.
                continue;
            }
            let mut run = system.simulation(r, beta).unwrap();
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            while run.cycles() < 800 {
                // The run takes long steps until the last cycle.
                run.advance(if run.cycles() < 799 { 3.0 } else { 0.005 })
                    .unwrap();
                if run.cycles() == 799 {
                    (low, high) = (low.min(run.friction()), high.max(run.friction()));
                }
            }
            let largest = high.max(-low);
            let told = response.contact_force();
            // With a step of 0.005 in τ, samples miss the maximum of a sticking force by an error of second order.
            assert!(
                largest <= told * (1.0 + 1e-6),
                "{name}, r = {r}, β = {beta}: {largest} for {told}"
            );
            assert!(
                told * (1.0 - 0.01) < largest,
                "{name}, r = {r}, β = {beta}: {largest} for {told}"
            );
        }
    }
}
