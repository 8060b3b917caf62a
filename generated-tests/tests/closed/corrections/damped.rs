//! Tests of chapter 7: motion with modal damping.

use super::integration::{Steady, run};
use super::page::states;
use super::plain::{Contact, Plain, d_q, u_g, unit};
use super::{close, judged};
use std::f64::consts::PI;

const BETA: f64 = 0.15;

/// Integrates two equal masses until the transient has decayed, with the contact on m₂, the force on m₁ and ζ = 0.1.
/// After 60 periods a fraction e^−29 of the transient remains.
fn steady() -> (Plain, Steady) {
    let plain = unit(2, Contact::Wall(1)).damped(0.1).at(0.8);
    let steady = run(&plain, BETA, 60);
    assert_eq!(steady.stops, 0);
    (plain, steady)
}

/// Bound on the error of the integration: about 1e-11 by the Runge-Kutta method, and the rest by the remaining
/// transient.
const INTEGRATION: f64 = 1e-9;

/// Checks the displacements of both masses after a maximum of the contact's motion.
#[test]
fn eq_7_22_7_23_7_28_and_b_15() {
    let (plain, steady) = steady();
    let (v, u) = (plain.v(), plain.u());
    let (v_j, u_j) = (v[1], u[1]);
    let root = (v_j.norm_sqr() - (BETA * u_j).powi(2)).sqrt();
    let form = |k: usize, tau: f64, bracket: &dyn Fn(f64) -> f64| {
        let angle = tau + v[k].arg() - v_j.arg();
        let harmonic = root * angle.cos() + BETA * u_j * angle.sin();
        let of_friction = |big_r: f64| {
            let (u, g) = u_g(big_r, plain.zeta);
            1.0 - (1.0 + g) * bracket(big_r) - u * big_r * d_q(big_r, plain.zeta, tau).1
        };
        v[k].norm() / v_j.norm() * harmonic + BETA * plain.by_modes(of_friction)[k]
    };
    let (mut largest, mut compared) = (0.0_f64, 0);
    for tau in [0.0, 0.5, 1.3, 2.2, 3.0] {
        let exact = steady.at(tau).0;
        for k in 0..2 {
            let printed = form(k, tau, &|big_r| {
                let zeta = plain.zeta;
                let q = (1.0 - zeta * zeta).sqrt();
                let (sin, cos) = (tau * q / big_r).sin_cos();
                (-zeta * tau / big_r).exp() * (sin + zeta / q * cos)
            });
            let right = form(k, tau, &|big_r| d_q(big_r, plain.zeta, tau).0);
            close(right, exact[k], INTEGRATION);
            largest = largest.max((printed - exact[k]).abs());
            compared += 1;
        }
    }
    println!("{compared} displacements compared, none skipped");
    assert_eq!(compared, 5 * 2);
    assert!(largest > 0.1);
    // The project computes the same values as the right form.
    let system = unit(2, Contact::Wall(1)).damped(0.1).system();
    let motion = system.at(0.8).unwrap().motion(BETA).unwrap();
    let project = motion.mass("m1").unwrap().displacement(1.3);
    close(project, steady.at(1.3).0[0], INTEGRATION);
    close(motion.contact().phase(), steady.phi, INTEGRATION);
    states("eq_7_22_7_23_7_28_and_b_15", &[(largest, 3)]);
}

/// Checks the displacement of m₁ at τ = 0.
#[test]
fn eq_7_31() {
    let (plain, steady) = steady();
    let (v, u, g) = (plain.v(), plain.u(), plain.g());
    let (ratio, delta) = (v[0].norm() / v[1].norm(), v[0].arg() - v[1].arg());
    let root = (v[1].norm_sqr() - (BETA * u[1]).powi(2)).sqrt();
    let friction = BETA * u[1] * delta.sin();
    let printed = ratio * root * delta.cos() + friction - BETA * g[0];
    let right = ratio * (root * delta.cos() + friction) - BETA * g[0];
    judged(printed, right, steady.at(0.0).0[0], INTEGRATION);
    states("eq_7_31", &[(printed, 4), (right, 4)]);
}

/// Checks √(x̄² + x̄′²) of m₁ at τ = 0, in the damped motion.
#[test]
fn eq_7_33() {
    let (plain, steady) = steady();
    let (v, u, g) = (plain.v(), plain.u(), plain.g());
    let (ratio, delta) = (v[0].norm() / v[1].norm(), v[0].arg() - v[1].arg());
    let root = (v[1].norm_sqr() - (BETA * u[1]).powi(2)).sqrt();
    let form = |sign: f64| {
        let first = root * (g[0] * delta.cos() + sign * u[0] * delta.sin());
        let second = BETA * u[1] * (g[0] * delta.sin() + u[0] * delta.cos());
        let squares = v[0].norm_sqr() + BETA * BETA * (g[0] * g[0] + u[0] * u[0]);
        (squares - 2.0 * BETA * ratio * (first + second)).sqrt()
    };
    let (printed, right) = (form(1.0), form(-1.0));
    let (x, velocity) = steady.at(0.0);
    judged(printed, right, x[0].hypot(velocity[0]), INTEGRATION);
    let system = unit(2, Contact::Wall(1)).damped(0.1).system();
    let motion = system.at(0.8).unwrap().motion(BETA).unwrap();
    let project = motion.mass("m1").unwrap().amplitude_monoharmonic();
    close(project, right, 1e-13);
    states("eq_7_33", &[(printed, 4), (right, 4)]);
}

/// Returns the term of one mode in the velocity constraint, divided by sin τ, by the corrected form of (7.38).
fn constraint(big_r: f64, zeta: f64, tau: f64) -> f64 {
    let ((u, g), (_, q)) = (u_g(big_r, zeta), d_q(big_r, zeta, tau));
    let root = (1.0 - zeta * zeta).sqrt();
    let (sin, cos) = (tau * root / big_r).sin_cos();
    let fast = (-zeta * tau / big_r).exp() * (cos - zeta / root * sin);
    ((1.0 + g) * big_r * q + u * big_r * big_r * (tau.cos() - fast)) / tau.sin()
}

/// Checks that with damping the sum of the modes' maxima is not the maximum of the sum.
#[test]
fn eq_7_37() {
    let (scene, r) = (unit(3, Contact::Wall(1)).damped(0.01), 0.35);
    let plain = scene.at(r);
    let mode = |i: usize, tau: f64| {
        plain.inverse_mass_of(i) / (r * r) * constraint(plain.big_r(i), plain.zeta, tau)
    };
    // The grid includes the first instants after the reversal, because with damping the largest value is at one of
    // these instants.
    let largest = |f: &dyn Fn(f64) -> f64| {
        let instants = (1..4000).map(|i| PI * f64::from(i) / 4000.0);
        instants
            .chain([1e-5, 1e-4])
            .map(f)
            .fold(0.0, generated_tests::larger)
    };
    let sum_of_maxima: f64 = (0..3).map(|i| largest(&|tau| mode(i, tau))).sum();
    let of_the_sum = largest(&|tau| (0..3).map(|i| mode(i, tau)).sum());
    let limit = |s: f64| plain.v_contact().norm() / plain.w.dot(&plain.u()).hypot(s);
    let (printed, right) = (limit(sum_of_maxima), limit(of_the_sum));
    // The true value comes from a grid of 200 instants, and S from 4000 instants.
    judged(printed, right, plain.velocity_limit(0.4), 1e-4);
    close(scene.limit(r), right, 1e-5);
    states("eq_7_37", &[(printed, 3), (right, 3)]);
}

/// Checks the velocity constraint of a damped mass at one instant.
#[test]
fn eq_7_38() {
    let (r, zeta, tau): (f64, f64, f64) = (0.35, 0.1, 1.0);
    let ((u, g), (_, q)) = (u_g(r, zeta), d_q(r, zeta, tau));
    let root = (1.0 - zeta * zeta).sqrt();
    let (sin, cos) = (tau * root / r).sin_cos();
    let bracket = (-zeta * tau / r).exp() * (sin + zeta / root * cos);
    let printed = ((1.0 + g) * r * q - u * r * r * bracket) / tau.sin();
    let right = constraint(r, zeta, tau);
    // The velocity is z̄′ = −(Z + βG) sin τ + βU cos τ + β d/dτ[…]. With one mode b = 1, so s_d is r² times the term
    // that the constraint compares with Z + βG.
    let h = |tau: f64| {
        let (d, q) = d_q(r, zeta, tau);
        1.0 - (1.0 + g) * d - u * r * q
    };
    let step = 1e-4;
    let slope = (h(tau + step) - h(tau - step)) / (2.0 * step);
    let truth = r * r * (slope + u * tau.cos()) / tau.sin();
    // A central difference has an error of step²/r³.
    judged(printed, right, truth, 1e-6);
    // In this scene the velocity constraint decides the limit, so the limit follows from it.
    let scene = unit(1, Contact::Wall(0)).damped(0.001);
    let plain = scene.at(r);
    let instants = (1..4000).map(|i| PI * f64::from(i) / 4000.0);
    let s = instants
        .map(|tau| constraint(r, 0.001, tau))
        .fold(0.0, generated_tests::larger)
        / (r * r);
    let limit = plain.v_contact().norm() / plain.u()[0].hypot(s);
    close(limit, plain.velocity_limit(0.4), 1e-4);
    close(limit, scene.limit(r), 1e-5);
    states("eq_7_38", &[(printed, 3), (right, 3)]);
}

/// Checks the limit of s_d for τ → 0, where s_d is the term of a damped mode in the velocity constraint.
#[test]
fn eq_7_50() {
    let (r, zeta): (f64, f64) = (0.4, 0.1);
    let (u, g) = u_g(r, zeta);
    // τ is small compared with R, but large compared with the rounding of a double.
    let tau = 1e-6;
    let shrunk = 1.0 - zeta * tau / r;
    let form = |sign: f64| {
        let bracket = 1.0 - shrunk * shrunk;
        ((1.0 + g) * shrunk * tau + sign * u * r * r * bracket) / tau
    };
    let (printed, right) = (form(-1.0), form(1.0));
    // The printed form neglects terms of the order τ.
    judged(printed, right, constraint(r, zeta, tau), 1e-4);
    judged(printed, 1.0 + g + 2.0 * zeta * r * u, right, 1e-5);
    states("eq_7_50", &[(printed, 3), (right, 3)]);
}
