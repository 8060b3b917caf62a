//! Tests of chapters 3 and 6 about contacts that stick.

use super::integration::run_from;
use super::page::states;
use super::plain::{Contact, Scene, unit};
use super::{close, judged};
use frictiongen::Regime;
use nalgebra::{DMatrix, DVector};

/// Returns the scene of two masses that rub on each other, with γ = κ = 0.5 and the force on m₁.
fn between() -> Scene {
    Scene {
        gamma: vec![1.0, 0.5],
        kappa: vec![1.0, 0.5],
        ..unit(2, Contact::Between(0, 1))
    }
}

fn regime(scene: &Scene, r: f64, beta: f64) -> Regime {
    scene.system().at(r).unwrap().regime(beta).unwrap()
}

/// Checks the contact of one mass whose static friction exceeds the kinetic friction, at one β ≥ β*_lim. From z̄ = 4
/// the contact slides for ever. If it starts from the stuck state, it sticks.
#[test]
fn sections_3_4_3_and_3_6() {
    let (scene, r, beta) = (unit(1, Contact::Base(0)).stiction(2.0), 1.1, 0.65);
    let plain = scene.at(r);
    let (x, force) = plain.stuck();
    let sliding_limit = force.norm() / plain.mu;
    let printed_sticks = beta >= sliding_limit;
    let limit = plain.velocity_limit(2.0).min(plain.break_away_limit(2.0));
    let right_slides = beta < limit;
    // The base starts at 1, so z̄ = 4 is x̄ = 5.
    let steady = run_from(&plain, beta, 400, DVector::from_element(1, 5.0));
    assert_eq!(steady.stops, 0);
    assert!(printed_sticks && right_slides);
    let amplitude = steady.at(0.0).0[0] - steady.phi.cos();
    close(amplitude, plain.amplitude_phase(beta).0, 1e-8);
    // The stuck state exists in addition to the sliding motion. If the mass starts with the base's displacement and
    // velocity, the contact never slides.
    let held = run_from(&plain, beta, 40, x.map(|x| x.re));
    assert_eq!(held.at(0.0).0[0] - 1.0, 0.0);
    // The project reports both states as possible.
    let system = scene.system();
    let at = system.at(r).unwrap();
    close(at.sliding_limit(), sliding_limit, 1e-14);
    close(at.continuous_limit(), limit, 1e-6);
    assert_eq!(at.regime(beta), Ok(Regime::Bistable));
    close(
        at.motion(beta).unwrap().contact().amplitude(),
        amplitude,
        1e-8,
    );
    let numbers = [(sliding_limit, 3), (limit, 3), (amplitude, 2)];
    states("sections_3_4_3_and_3_6", &numbers);
}

/// Checks when the available static friction suffices for the force in the stuck contact.
#[test]
fn eq_6_21_and_6_30() {
    // The printed form is (6.21), with γ_AB = 0.5 and l = A.
    let (scene, r, beta, gamma_ab) = (between(), 1.0, 1.2, 0.5);
    let plain = scene.at(r);
    let (x, force) = plain.stuck();
    let k = &plain.k;
    let row = |row: usize| k[(row, 0)] * x[0].re + k[(row, 1)] * x[1].re;
    let load = (row(1) - gamma_ab * row(0) + gamma_ab).abs();
    let printed_sticks = load > beta * (1.0 + gamma_ab);
    let right_sticks = load <= beta * (1.0 + gamma_ab);
    // The force that holds the contact is less than the available friction.
    close(load, force.norm() * (1.0 + gamma_ab), 1e-12);
    let truth = force.norm() <= plain.mu * beta;
    assert!(truth && right_sticks && !printed_sticks);
    assert_eq!(regime(&scene, r, beta), Regime::Stuck);

    // In (6.30) m₁ moves with the base, x̄₁ = cos τ, and the excitation is at its maximum.
    let base = unit(1, Contact::Base(0));
    let beta = 1.2;
    let load = (1.0_f64 - (1.0 + r * r)).abs();
    close(base.at(1.0 + 1e-9).stuck().1.norm(), load, 1e-8);
    assert!(load <= beta);
    assert_eq!(regime(&base, r, beta), Regime::Stuck);
    // Where the printed condition is true, the contact cannot stick.
    assert!(load > 0.5 && regime(&base, r, 0.5) != Regime::Stuck);
    states(
        "eq_6_21_and_6_30",
        &[(force.norm(), 1), (plain.mu * 1.2, 1)],
    );
}

/// Checks the equation of motion of the centroid of two masses that stick together.
#[test]
fn eq_6_24() {
    let scene = Scene {
        gamma: vec![1.0, 2.0, 0.5],
        kappa: vec![1.0, 0.8, 1.5],
        load: Some(2),
        ..unit(3, Contact::Between(0, 1))
    };
    let (r, m1) = (0.7_f64, 3.0);
    let plain = scene.at(r);
    let x = plain.stuck().0.map(|x| x.re);
    close(x[0], x[1], 1e-13);
    // The amplitudes are those at the excitation's maximum, so x̄_c″ = −x̄_c.
    let centroid = (x[0] + 2.0 * x[1]) / 3.0;
    let sum = |by: &dyn Fn(usize) -> f64| -> f64 {
        (0..3)
            .map(|k| (plain.k[(0, k)] + plain.k[(1, k)]) * by(k))
            .sum()
    };
    // The printed form has a number i over which it does not sum. If i is the row's own number A, δ_Ai + δ_Bi = 1.
    let printed = -(m1 + 2.0 * m1) * centroid + sum(&|_| x[0]) - 1.0;
    // The load acts on m₃, so δ_lA + δ_lB = 0.
    let right = -(1.0 + 2.0) * r * r * centroid + sum(&|k| x[k]) - 0.0;
    judged(printed, right, 0.0, 1e-13);
    // x solves all equations together with a force in the contact.
    let force = plain.stuck().1.re;
    let dynamic = &plain.k - DMatrix::from_diagonal(&plain.gamma) * (r * r);
    assert!((dynamic * &x + &plain.w * force - &plain.p).amax() < 1e-13);
    let stuck = scene.system();
    let stuck = stuck.at(r).unwrap();
    close(stuck.stuck().unwrap().mass("m1").unwrap().re, x[0], 1e-13);
    states("eq_6_24", &[(printed, 3)]);
}

/// Checks the direction of the inequality (6.27): a contact slides if β is below the bound.
#[test]
fn eq_6_27() {
    let (scene, r, gamma_ab) = (between().stiction(1.2), 1.0, 0.5);
    let plain = scene.at(r);
    let (x, force) = plain.stuck();
    let row = |row: usize| plain.k[(row, 0)] * x[0].re + plain.k[(row, 1)] * x[1].re;
    let load = (row(1) - gamma_ab * row(0) + gamma_ab).abs();
    let bound = load / (plain.mu * (1.0 + gamma_ab));
    close(bound, scene.sliding_limit(r), 1e-12);
    let mut compared = 0;
    for (beta, sticks) in [(0.9 * bound, false), (1.1 * bound, true)] {
        let printed_sticks = beta < bound;
        // Static friction can reach μβ, so the contact sticks up to this force.
        let truth = force.norm() <= plain.mu * beta;
        assert!(truth == sticks && printed_sticks != truth);
        assert_eq!(regime(&scene, r, beta) == Regime::Stuck, truth);
        compared += 3;
    }
    println!("{compared} verdicts compared, none skipped");
    assert_eq!(compared, 2 * 3);
    states("eq_6_27", &[(bound, 4)]);
}

/// Checks the loads on the masses next to a mass that sticks to the moving base.
#[test]
fn eq_6_32() {
    let r = 0.3;
    let (gamma, kappa) = (vec![1.0, 2.0, 0.5], vec![1.0, 0.8, 1.5]);
    let mut off = Vec::new();
    for stuck in 0..3 {
        let scene = Scene {
            gamma: gamma.clone(),
            kappa: kappa.clone(),
            ..unit(3, Contact::Base(stuck))
        };
        let plain = scene.at(r);
        let truth = plain.stuck().0.map(|x| x.re);
        close(truth[stuck], 1.0, 1e-13);
        let j = stuck + 1;
        let delta = |one: usize, other: usize| if one == other { 1.0 } else { 0.0 };
        // κ_{j+1} of the last mass does not exist, so it counts as 0.
        let above = kappa.get(j).copied().unwrap_or(0.0);
        // The remaining masses keep their original numbers, from 1.
        let rest: Vec<usize> = (1..=3).filter(|i| *i != j).collect();
        let solve = |load: &dyn Fn(usize, usize) -> f64| {
            let dynamic = DMatrix::from_fn(2, 2, |a, b| {
                let (i, k) = (rest[a] - 1, rest[b] - 1);
                plain.k[(i, k)] - if a == b { r * r * gamma[i] } else { 0.0 }
            });
            let load = DVector::from_fn(2, |a, _| load(a + 1, rest[a]));
            let x = dynamic.lu().solve(&load).unwrap();
            // The compared error is the largest error of all masses, against the solution of the full equations.
            let error = |a: usize| (x[a] - truth[rest[a] - 1]).abs();
            error(0).max(error(1))
        };
        // The printed form is evaluated twice: with the numbers of the remaining masses, and with the original
        // numbers.
        let printed = |i: usize| delta(1, i) + delta(j - 1, i) * kappa[stuck] + delta(j, i) * above;
        let reduced = solve(&|new, _| printed(new));
        let original = solve(&|_, old| printed(old));
        let right = solve(&|_, old| {
            delta(1, old) + delta(j - 1, old) * kappa[stuck] + delta(j + 1, old) * above
        });
        assert!(right < 1e-13, "j = {j}: {right}");
        // With the numbers of the remaining masses, the printed form fails for j = 1 only. With the original numbers,
        // it fails for every mass that has another mass above it.
        assert_eq!(reduced > 0.1, j == 1, "j = {j}: {reduced}");
        assert_eq!(original > 0.1, j < 3, "j = {j}: {original}");
        off.push(reduced);
        let limit = plain.stuck().1.norm();
        close(scene.sliding_limit(r), limit, 1e-12 * limit);
    }
    println!(
        "{} masses compared, five values each, none skipped",
        off.len()
    );
    assert_eq!(off.len(), 3);
    states("eq_6_32", &[(off[0], 3)]);
}
