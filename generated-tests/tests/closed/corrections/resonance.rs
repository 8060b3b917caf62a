//! Tests of chapter 7 at resonance and with a stuck contact, tests of complex amplitudes, and tests of appendix B.

use super::integration::{run, run_on};
use super::page::states;
use super::plain::{Contact, d_q, u_g, unit};
use super::{close, judged};
use nalgebra::Complex;
use std::f64::consts::PI;

/// Checks the monoharmonic amplitude of m₁ at the first resonance of a damped chain.
#[test]
fn eq_7_58() {
    let (beta, zeta): (f64, f64) = (0.3, 0.02);
    let scene = unit(2, Contact::Wall(1)).damped(zeta);
    let r = scene.at(1.0).lambda.map(f64::sqrt).min();
    let plain = scene.at(r);
    let (v, u, g) = (plain.v().map(|v| v.norm()), plain.u(), plain.g());
    let squares = v[0] * v[0] + beta * beta * (g[0] * g[0] + u[0] * u[0]);
    let products = (u[1] * u[0]).abs();
    let printed = (squares - beta * (2.0 * v[0] * g[0].abs() - products)).sqrt();
    // In the first mode both masses move in the same direction, so sgn(ψ_kiψ_ji) = 1.
    let of_friction =
        2.0 * beta * v[0] * g[0].abs() + 2.0 * beta * beta * v[0] / v[1] * u[1] * u[0];
    let right = (squares - of_friction).sqrt();
    // Both the printed and the right form neglect two terms of (7.33): the deviation of V's phase from ∓π/2, and
    // (βU/V)².
    let x = plain.motion(beta);
    let h = 1e-4;
    let truth = x(0, 0.0).hypot((x(0, h) - x(0, -h)) / (2.0 * h));
    assert!((right - truth).abs() < 0.5 * (printed - truth).abs());
    // The second comparison removes the neglected terms. It uses the two terms of (7.33) with cos Δ = 1 and sin Δ =
    // 0.
    let root = v[1];
    let bracket = root * g[0] + beta * u[1] * u[0];
    let reduced = (squares - 2.0 * beta * v[0] / v[1] * bracket).sqrt();
    judged(printed, right, reduced, 1e-12);
    states("eq_7_58", &[(printed, 4), (right, 4), (truth, 4)]);
}

/// Checks the friction ratio from which the contact stops at r = 1.
#[test]
fn eq_7_62() {
    let zeta: f64 = 0.1;
    let printed = ((zeta * PI).cosh() - 1.0) / (2.0 * zeta * (zeta * PI).sinh());
    let mut compared = 0;
    for (mu, right) in [(1.0, 0.6720), (2.0, 0.5924)] {
        let scene = unit(1, Contact::Wall(0)).damped(zeta).stiction(mu);
        close(scene.limit(1.0), right, 5e-5);
        // The integration starts from the continuous motion, because at μ = 2 a contact at rest would stay at rest.
        // It runs at friction ratios 1 % below and 1 % above the limit. The printed value is far above the limit.
        let plain = scene.at(1.0);
        let stops = |beta: f64| run_on(&plain, beta, 40).stops > 0;
        assert!(!stops(0.99 * right) && stops(1.01 * right));
        assert!(stops(0.99 * printed));
        compared += 4;
    }
    println!(
        "two limits and whether {} motions stop compared, none skipped",
        compared - 2
    );
    assert_eq!(compared, 2 * (1 + 3));
    states("eq_7_62", &[(printed, 4), (0.6720, 4), (0.5924, 4)]);
}

/// Checks the force in the stuck contact on m₂, in a damped chain of three masses.
#[test]
fn section_7_4_3() {
    let (scene, r) = (unit(3, Contact::Wall(1)).damped(0.1), 1.2_f64);
    let plain = scene.at(r);
    // (6.11a) takes m₁ alone, between the base and the stuck m₂, with its own damping.
    let lone = Complex::new(plain.k[(0, 0)] - r * r, plain.c[(0, 0)]);
    let printed = 1.0 / lone.norm();
    let right = (plain.v_contact() / plain.on_contact(&plain.h())).norm();
    // The true value solves the equations with the constraint as one more equation.
    judged(printed, right, plain.stuck().1.norm(), 1e-12);
    close(scene.sliding_limit(r), right, 1e-12);
    // Without damping the printed form and the right form agree.
    let free = unit(3, Contact::Wall(1)).at(r);
    close(free.stuck().1.norm(), 1.0 / (2.0 - r * r).abs(), 1e-12);
    states("section_7_4_3", &[(printed, 3), (right, 3)]);
}

/// Checks products of a complex response function and a real cosine, as (7.7) and other equations print them.
#[test]
fn eq_7_7_and_others() {
    let (r, zeta, beta): (f64, f64, f64) = (0.8, 0.1, 0.2);
    let v = 1.0 / Complex::new(1.0 - r * r, 2.0 * zeta * r);
    // In (7.7) only the real part of the forced term can be meant.
    let printed = |tau: f64| (v * tau.cos()).re;
    let right = |tau: f64| v.norm() * (tau + v.arg()).cos();
    let residual = |x: &dyn Fn(f64) -> f64| {
        let h = 1e-4;
        [0.2_f64, 1.0, 1.9]
            .map(|tau| {
                let slope = (x(tau + h) - x(tau - h)) / (2.0 * h);
                let second = (x(tau + h) - 2.0 * x(tau) + x(tau - h)) / (h * h);
                (r * r * second + 2.0 * zeta * r * slope + x(tau) - tau.cos()).abs()
            })
            .into_iter()
            .fold(0.0, generated_tests::larger)
    };
    // The differences in `residual` have a step of 1e-4.
    judged(residual(&printed), residual(&right), 0.0, 1e-6);
    // The forms (7.13), (7.14) and, with one mode, (7.9), (7.10) give cos φ and sin φ from the integrated amplitude.
    let plain = unit(1, Contact::Wall(0)).damped(zeta).at(r);
    let steady = run(&plain, beta, 40);
    let (u, g) = u_g(r, zeta);
    let amplitude = steady.at(0.0).0[0];
    let (cosine, sine) = ((amplitude + beta * g) / v, -beta * u / v);
    assert!(cosine.im.abs() > 0.1, "no cosine of a real angle: {cosine}");
    // The right forms (7.18) and (7.19) have the modulus of V, and the angle φ + ∠V.
    let (right_cosine, right_sine) = ((amplitude + beta * g) / v.norm(), -beta * u / v.norm());
    let shifted = steady.phi + v.arg();
    judged(cosine.re, right_cosine, shifted.cos(), 1e-9);
    judged(sine.re, right_sine, shifted.sin(), 1e-9);
    // Nor is the real part of the printed form equal to cos φ.
    assert!((cosine.re - steady.phi.cos()).abs() > 1e-2);
    // The amplitude from the real part alone is compared with the exact amplitude.
    let from_real = (v.re.powi(2) - (beta * u).powi(2)).sqrt() - beta * g;
    judged(from_real, plain.amplitude_phase(beta).0, amplitude, 1e-9);
    states("eq_7_7_and_others", &[(from_real, 3), (amplitude, 3)]);
}

/// Checks the velocity of a damped mode that belongs to its displacement (B.6).
#[test]
fn eq_b_7() {
    let (big_r, zeta, tau) = (0.7_f64, 0.1_f64, 0.9_f64);
    let (psi_j, forced, beta, phi) = (0.8, 1.3, 0.3, 0.4_f64);
    let (start, start_velocity) = (0.9, -0.2);
    let square = big_r * big_r;
    // The variable `forced` is ψ_liR_i²v_di of (B.6), taken as real.
    let eta = |tau: f64| {
        let (d, q) = d_q(big_r, zeta, tau);
        d * start
            + big_r * q * start_velocity
            + psi_j * square * (1.0 - d) * beta
            + forced * ((tau.cos() - d) * phi.cos() + (big_r * q - tau.sin()) * phi.sin())
    };
    let root = (1.0 - zeta * zeta).sqrt();
    let (sin, cos) = (tau * root / big_r).sin_cos();
    let d_slope = -d_q(big_r, zeta, tau).1 / big_r;
    let q_slope = (-zeta * tau / big_r).exp() * (cos - zeta / root * sin) / big_r;
    let form = |sign: f64| {
        sign * d_slope * start + big_r * q_slope * start_velocity
            - psi_j * square * d_slope * beta
            - forced
                * ((tau.sin() + d_slope) * phi.cos() + (tau.cos() - big_r * q_slope) * phi.sin())
    };
    let h = 1e-4;
    let truth = (eta(tau + h) - eta(tau - h)) / (2.0 * h);
    // A central difference has an error of h²/R³.
    judged(form(-1.0), form(1.0), truth, 1e-7);
    states("eq_b_7", &[(form(-1.0), 3), (form(1.0), 3)]);
}
