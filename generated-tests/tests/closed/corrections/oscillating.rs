//! Tests of sections 5.6 and 6.5: sliding contacts between two oscillating bodies.

use super::page::states;
use super::plain::{Contact, Plain, Scene, bisect, unit};
use super::{close, judged};
use nalgebra::Complex;
use std::f64::consts::PI;

/// Returns the scene of two masses that rub on each other, with γ = κ = 0.5 and the force on m₁.
fn between() -> Scene {
    Scene {
        gamma: vec![1.0, 0.5],
        kappa: vec![1.0, 0.5],
        ..unit(2, Contact::Between(0, 1))
    }
}

/// Checks the load in the contact of two oscillating masses at a reversal of the contact.
#[test]
fn eq_5_78() {
    let (r, beta, gamma_ab) = (1.5, 0.1, 0.5);
    let plain = between().at(r);
    let (v, v_contact) = (plain.v().map(|v| v.re), plain.v_contact().re);
    let (z, phi) = plain.amplitude_phase(beta);
    let stiffness = |row: usize, by: &dyn Fn(usize) -> f64| -> f64 {
        (0..2).map(|k| plain.k[(row, k)] * by(k)).sum()
    };
    // With l = A, δ_lA = 1 and δ_lB = 0.
    let printed = (stiffness(1, &|_| 1.0) - gamma_ab * (stiffness(0, &|k| v[k]) - 1.0)).abs();
    let right = (z / v_contact
        * (stiffness(1, &|k| v[k]) - gamma_ab * (stiffness(0, &|k| v[k]) - 1.0)))
        .abs();
    // The true value is (5.77) itself at τ = 0, with the displacements of the motion.
    let x = plain.motion(beta);
    assert!(plain.defect(beta, phi, &x) < 1e-7);
    let truth =
        stiffness(1, &|k| x(k, 0.0)) - gamma_ab * (stiffness(0, &|k| x(k, 0.0)) - phi.cos());
    judged(printed, right, truth.abs(), 1e-12);
    // The load is (1 + γ_AB) times the force that would keep the contact stuck.
    let force = plain.force_at_reversal(beta).abs();
    close(truth.abs(), (1.0 + gamma_ab) * force, 1e-7);
    states("eq_5_78", &[(printed, 4), (right, 4)]);
}

/// Checks that β_lim of a contact between two masses follows from the force at the reversal.
#[test]
fn eq_5_79_and_5_80() {
    let (r, mu) = (1.5, 1.3);
    let scene = between().stiction(mu);
    let plain = scene.at(r);
    let (v, u) = (plain.v_contact().re, plain.w.dot(&plain.u()));
    // Here 1/γ_A + 1/γ_B = 3. With this μ the break-away term exceeds S.
    let root = u.hypot(3.0 * mu / (r * r));
    let (printed, right) = (v * v / root, v.abs() / root);
    let truth = plain.break_away_limit(0.6);
    // The velocities of the true motion are central differences with a step of 1e-4.
    judged(printed, right, truth, 1e-7);
    assert!(truth < plain.velocity_limit(0.6));
    close(scene.limit(r), right, 1e-12);
    states("eq_5_79_and_5_80", &[(printed, 4), (right, 4)]);
}

/// Checks the condition for a stop of a contact on the moving base, and the dependence of both limits on r.
#[test]
fn section_6_5_2() {
    let scene = unit(2, Contact::Base(0));
    // A stop needs z̄′ = 0. At a β just below the limit, the contact reverses far from z̄ = 0, and passes z̄ = 0 at
    // full speed.
    let r = 1.1;
    let plain = scene.at(r);
    let beta = 0.99 * scene.limit(r);
    let (x, (z, phi)) = (plain.motion(beta), plain.amplitude_phase(beta));
    let relative = |tau: f64| x(0, tau) - (tau + phi).cos();
    let slope = |tau: f64| (relative(tau + 1e-4) - relative(tau - 1e-4)) / 2e-4;
    close(relative(0.0), z, 1e-12);
    // The error of a central difference is 1e-8.
    close(slope(0.0), 0.0, 1e-6);
    let crossing = bisect(|tau| relative(tau) > 0.0, 0.0, PI);
    assert!(z > 0.5 && slope(crossing) < -0.5, "{z} {}", slope(crossing));
    // β_lim and β*_lim grow as r², and vanish for r → 0.
    let limits = |r: f64| [scene.limit(r), scene.sliding_limit(r)];
    let mut compared = 0;
    for (low, high) in limits(1e-2).into_iter().zip(limits(1e2)) {
        assert!(low < 1e-3, "{low}");
        assert!(high > 1e3, "{high}");
        compared += 2;
    }
    println!("{compared} limits compared, none skipped");
    assert_eq!(compared, 2 * 2);
    let quotient = scene.sliding_limit(1e3) / scene.sliding_limit(1e2);
    close(quotient, 100.0, 0.1);
    // The force in the stuck contact gives the same limit.
    close(
        scene.at(1e2).stuck().1.norm(),
        scene.sliding_limit(1e2),
        1e-6,
    );
    close(
        scene.at(1e-2).stuck().1.norm(),
        scene.sliding_limit(1e-2),
        1e-12,
    );
    let numbers = [
        (limits(1e-2)[1] * 1e4, 3),
        (limits(1e2)[1] * 1e-4, 3),
        (z, 2),
    ];
    states("section_6_5_2", &numbers);
}

/// Returns the fundamental component of the contact's relative motion, by a plain sum over instants.
fn fundamental(plain: &Plain, beta: f64) -> f64 {
    let (x, phi) = (plain.motion(beta), plain.amplitude_phase(beta).1);
    let n = 400;
    let sum: Complex<f64> = (0..=n)
        .map(|i| {
            let tau = PI * f64::from(i) / f64::from(n);
            let end = i == 0 || i == n;
            let weight = if end {
                1.0
            } else {
                2.0 + 2.0 * f64::from(i % 2)
            };
            Complex::from_polar(weight * (x(0, tau) - (tau + phi).cos()), -tau)
        })
        .sum();
    // The weights are those of Simpson's rule.
    (sum * (2.0 / PI) * (PI / f64::from(n) / 3.0)).norm()
}

/// Checks that m₂ acts as an absorber for m₁: at one frequency m₁ has no fundamental component for any friction.
#[test]
fn section_6_5_3() {
    let scene = Scene {
        gamma: vec![1.0, 0.9772],
        kappa: vec![1.0, 1.1119],
        ..unit(2, Contact::Base(0))
    };
    let spread = |r: f64| fundamental(&scene.at(r), 0.5) - fundamental(&scene.at(r), 0.1);
    let (printed, right) = (1.09, f64::sqrt(1.1119 / 0.9772));
    let sign = spread(1.05).signum();
    let truth = bisect(|r| spread(r) * sign > 0.0, 1.05, 1.12);
    judged(printed, right, truth, 1e-7);
    close(spread(right), 0.0, 1e-9);
    assert!(spread(printed).abs() > 1e-3, "{}", spread(printed));
    let mut compared = 0;
    for beta in [0.1, 0.5] {
        close(fundamental(&scene.at(right), beta), 1.0, 1e-9);
        let motion = scene.system();
        let motion = motion.at(right).unwrap().motion(beta).unwrap();
        close(motion.contact().harmonic(1).norm(), 1.0, 1e-12);
        compared += 2;
    }
    println!("{compared} fundamentals compared, none skipped");
    assert_eq!(compared, 2 * 2);
    let numbers = [(printed, 2), (right, 4), (spread(printed), 4)];
    states("section_6_5_3", &numbers);
}
