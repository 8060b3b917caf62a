//! Compares Floquet multipliers with finite differences of the period map, which the test evaluates by runs in time.

use super::cycle_energy::section;
use frictiongen::System;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Step of the central differences. Their error is of the order of the step's square, plus the rounding ε divided by
/// the step.
const STEP: f64 = 1e-5;
/// Tolerance: both errors of the differences, multiplied by the sensitivity of the eigenvalues.
const TOLERANCE: f64 = 1e-6;

/// Returns the state of a run one period after `state`, which is at a maximum of the excitation.
fn period(system: &System, r: f64, beta: f64, state: &[f64]) -> Vec<f64> {
    let (x, v) = state.split_at(state.len() / 2);
    let mut run = system
        .simulation_from(r, beta, (x, v))
        .expect("in the domain");
    let mut left = TAU;
    while left > 1e-14 {
        left -= run.advance(left).expect("a reach").length;
    }
    let masses = system.scene().masses.iter();
    let ends: Vec<_> = masses
        .map(|mass| run.mass(&mass.name).expect("a mass"))
        .collect();
    let x = ends.iter().map(|end| end.displacement());
    x.chain(ends.iter().map(|end| end.velocity())).collect()
}

#[test]
fn finite_differences() {
    let scenes: [(&str, &[(f64, f64)]); 4] = [
        (
            "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
            contact: block - wall, excitation: block }",
            &[
                (0.3, 0.4),
                (1.0 / 3.0, 0.01),
                (0.9, 0.3),
                (2.0, 0.7),
                (0.8, 0.6),
            ],
        ),
        (
            "struct Frame { masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }",
            &[(0.3, 0.4), (0.5, 0.3), (0.9, 0.4), (1.5, 0.5)],
        ),
        (
            "struct Pair { masses: { a: 1, b: 1.3, c: 0.7 },
            springs: { base - a: 1, a - b: 2, b - c: 0.9 },
            contact: a - c, excitation: b, damping: rayleigh(0.02, 0.05) }",
            &[(0.4, 0.1), (0.8, 0.2), (1.9, 0.05)],
        ),
        (
            "struct Moving { masses: { a: 1, b: 0.8 }, springs: { base - a: 1, a - b: 1.5 },
            contact: b - base, excitation: base, damping: modal(0.05) }",
            &[(0.3, 0.05), (0.8, 0.5), (1.7, 0.8)],
        ),
    ];
    let (mut fixed, mut compared) = (0, 0);
    for (text, points) in scenes {
        let system: System = text.parse().expect("a scene");
        for &(r, beta) in points {
            let what = format!("{text}\nr = {r}, β = {beta}");
            let orbit = system.at(r).expect("in the domain").orbit(beta);
            let orbit = orbit.unwrap_or_else(|error| panic!("{what}: {error}"));
            let (x, v) = section(&system, &orbit);
            let state = [x, v].concat();
            // The state must be a fixed point of the map.
            let again = period(&system, r, beta, &state);
            assert_eq!(again.len(), state.len());
            for (a, b) in again.iter().zip(&state) {
                assert!((a - b).abs() < 1e-11, "{what}: {a} after {b}");
                fixed += 1;
            }
            let size = state.len();
            let mut map = DMatrix::zeros(size, size);
            for column in 0..size {
                let moved = |by: f64| {
                    let mut state = state.clone();
                    state[column] += by;
                    period(&system, r, beta, &state)
                };
                let (ahead, behind) = (moved(STEP), moved(-STEP));
                for row in 0..size {
                    map[(row, column)] = (ahead[row] - behind[row]) / (2.0 * STEP);
                }
            }
            let mut expected: Vec<_> = map.complex_eigenvalues().iter().copied().collect();
            assert_eq!(expected.len(), orbit.multipliers().len(), "{what}");
            for found in orbit.multipliers() {
                let distance = |value: &nalgebra::Complex<f64>| {
                    (value.re - found.re).hypot(value.im - found.im)
                };
                let nearest = (0..expected.len())
                    .min_by(|a, b| distance(&expected[*a]).total_cmp(&distance(&expected[*b])));
                let nearest = expected.swap_remove(nearest.expect("one is left"));
                assert!(
                    distance(&nearest) < TOLERANCE,
                    "{what}: {found} against {nearest}"
                );
                compared += 1;
            }
        }
    }
    println!("{fixed} coordinates and {compared} multipliers compared, none skipped");
    // The points have one, two, three and two masses. Each mass has two multipliers.
    let all = 5 * 2 + 4 * 4 + 3 * 6 + 3 * 4;
    assert_eq!((fixed, compared), (all, all));
}

/// Checks the multipliers of a contact that never slides. The upper mass stays in place and loses its velocity. The
/// lower mass vibrates alone on two springs, with λ² + (α + 2β)λ + 2 = 0 for the Rayleigh factors α and β.
#[test]
fn of_a_contact_that_never_slides() {
    let mut compared = 0;
    for (mass, stiffness) in [(0.0, 0.0), (0.1, 0.05), (1.0, 2.0)] {
        let text = format!(
            "struct Pair {{ masses: {{ lower: 1, upper: 1 }}, springs: {{ base - lower: 1, lower - upper: 1 }},
            contact: upper - wall, excitation: lower, damping: rayleigh({mass}, {stiffness}) }}"
        );
        let system: System = text.parse().expect("a scene");
        for r in [0.35, 0.9, 2.2] {
            let orbit = system.at(r).expect("in the domain").orbit(5.0);
            let orbit = orbit.unwrap_or_else(|error| panic!("{text}, r = {r}: {error}"));
            assert_eq!(orbit.stuck_fraction(), 1.0);
            let loss = nalgebra::Complex::new(mass + 2.0 * stiffness, 0.0);
            let root = (loss * loss - 8.0).sqrt();
            let swings = [root, -root].map(|root| ((root - loss) * 0.5 * TAU / r).exp());
            let mut expected = vec![1.0.into(), 0.0.into()];
            expected.extend(swings);
            assert_eq!(orbit.multipliers().len(), expected.len());
            for found in orbit.multipliers() {
                let found = nalgebra::Complex::new(found.re, found.im);
                let distances = expected.iter().map(|value| (value - found).norm());
                let (nearest, distance) = distances
                    .enumerate()
                    .min_by(|a, b| a.1.total_cmp(&b.1))
                    .expect("one is left");
                // The tolerance allows for the rounding of a few rotations.
                assert!(distance < 1e-12, "{text}, r = {r}: {found} of {expected:?}");
                expected.swap_remove(nearest);
                compared += 1;
            }
        }
    }
    println!("{compared} multipliers compared, none skipped");
    assert_eq!(compared, 36);
}
