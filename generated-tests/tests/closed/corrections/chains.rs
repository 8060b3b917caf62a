//! Tests of chapters 5 and 6 for a contact with a fixed wall, and of appendix A.

use super::integration::run_on;
use super::page::states;
use super::plain::{Contact, Scene, bisect, u_g, unit};
use super::{close, judged};
use nalgebra::{Matrix2, Vector2};
use std::f64::consts::PI;

/// Checks that the printed modal coordinate (5.28) does not have the initial velocity of (5.24) and (5.27).
#[test]
fn eq_5_28() {
    let (big_r, psi_j, psi_l, beta, phi) = (0.7_f64, 0.8, 1.1, 0.3, 0.4_f64);
    let (v, u) = (1.0 / (1.0 - big_r * big_r), u_g(big_r, 0.0).0);
    let square = big_r * big_r;
    // The start follows from (5.24) and (5.27).
    let start = psi_l * square * v * phi.cos();
    let start_velocity = -psi_l * square * v * phi.sin() - psi_j * square * u * beta;
    let eta = |tau: f64, of_friction: f64| {
        start * tau.cos()
            + (start_velocity + of_friction) * tau.sin()
            + beta * psi_j * square * (1.0 - (tau / big_r).cos() - u * big_r * (tau / big_r).sin())
    };
    let printed = |tau: f64| eta(tau, psi_j * square * u);
    let right = |tau: f64| eta(tau, psi_j * square * u * beta);
    let h = 1e-4;
    let slope = |eta: &dyn Fn(f64) -> f64| (eta(h) - eta(-h)) / (2.0 * h);
    // A central difference with step h has an error of h².
    judged(slope(&printed), slope(&right), start_velocity, 1e-6);
    // `residual` returns the largest residual of η″ + η/R² = ψ_jβ + ψ_l cos(τ + φ).
    let residual = |eta: &dyn Fn(f64) -> f64| {
        [0.3_f64, 1.2, 2.5]
            .map(|tau| {
                let second = (eta(tau - h) - 2.0 * eta(tau) + eta(tau + h)) / (h * h);
                (second + eta(tau) / square - psi_j * beta - psi_l * (tau + phi).cos()).abs()
            })
            .into_iter()
            .fold(0.0, generated_tests::larger)
    };
    judged(residual(&printed), residual(&right), 0.0, 1e-6);
    let numbers = [(slope(&printed), 3), (start_velocity, 3)];
    states("eq_5_28", &numbers);
}

/// Checks that the printed S_j is only an upper bound on S.
#[test]
fn eq_5_55_and_5_56() {
    let (scene, r) = (unit(3, Contact::Wall(1)), 0.35);
    let plain = scene.at(r);
    let (v, u) = (plain.v_contact().re, plain.w.dot(&plain.u()));
    let modes = |tau: f64, i: usize| {
        let (big_r, u) = (plain.big_r(i), u_g(plain.big_r(i), 0.0).0);
        let slow = tau.cos() - (tau / big_r).cos();
        let sum = big_r * (tau / big_r).sin() + u * big_r * big_r * slow;
        plain.inverse_mass_of(i) / (r * r) * sum / tau.sin()
    };
    let largest = |f: &dyn Fn(f64) -> f64| {
        let instants = (1..4000).map(|i| PI * f64::from(i) / 4000.0);
        instants.map(f).fold(0.0, generated_tests::larger)
    };
    let sum_of_maxima: f64 = (0..3).map(|i| largest(&|tau| modes(tau, i))).sum();
    let of_the_sum = largest(&|tau| (0..3).map(|i| modes(tau, i)).sum());
    assert!(sum_of_maxima > of_the_sum);
    let limit = |s: f64| v.abs() / u.hypot(s);
    let (printed, right) = (limit(sum_of_maxima), limit(of_the_sum));
    let truth = plain.velocity_limit(0.4);
    // The true value comes from a grid of 200 instants, and S of the right form from 4000 instants.
    judged(printed, right, truth, 1e-4);
    close(scene.limit(r), right, 1e-5);
    // Between both limits, the motion satisfies the equations of motion and does not stop.
    let beta = 0.18;
    let x = plain.motion(beta);
    let phi = plain.amplitude_phase(beta).1;
    assert!(plain.defect(beta, phi, x) < 1e-7);
    assert!(printed < beta && plain.force_at_reversal(beta).abs() > beta);
    let per_mode = scene.system().at(r).unwrap().continuous_limit_per_mode();
    close(per_mode, printed, 1e-4);
    let numbers = [(per_mode, 4), (scene.limit(r), 4)];
    states("eq_5_55_and_5_56", &numbers);
}

/// Checks that β_∞ of a chain follows from the force at the reversal of its motion.
#[test]
fn eq_6_6() {
    let mu: f64 = 2.0;
    let scene = unit(2, Contact::Wall(0)).stiction(mu);
    let printed = 1.0 / (mu + PI * PI / 4.0).sqrt();
    let right = 1.0 / (mu * mu + PI * PI / 4.0).sqrt();
    // For large r the limit approaches its value with an error of the order 1/r².
    let r = 200.0;
    let truth = scene.at(r).break_away_limit(0.6);
    judged(printed, right, truth, 2.0 / (r * r));
    close(scene.limit(1e6), right, 1e-10);
    states("eq_6_6", &[(printed, 4), (right, 4)]);
}

/// Checks that U₁ = 0 at the invariant points, which are the frequency ratios where the response of m₁ does not
/// depend on β.
#[test]
fn section_6_3_2() {
    let scene = unit(2, Contact::Wall(0));
    let u = |r: f64| scene.at(r).u()[0];
    let exact = [5.0_f64.sqrt() / 4.0, 5.0_f64.sqrt() / 2.0];
    let mut compared = 0;
    for (r, printed) in exact.into_iter().zip([0.559, 1.123]) {
        close(u(r), 0.0, 1e-13);
        assert!(u(r - 1e-3) * u(r + 1e-3) < 0.0);
        assert!(u(printed).abs() > 1e-4);
        compared += 3;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 2 * 3);
    // At the printed r = 1.123 the response still depends on β, through the square of U.
    let share = |r: f64| {
        let amplitude = |beta| scene.at(r).amplitude_phase(beta).0;
        1.0 - amplitude(0.6) / amplitude(0.0)
    };
    judged(share(1.123), share(exact[1]), 0.0, 1e-14);
    // The printed ratio 0.559 is right to its digits. The printed ratio 1.123 is not.
    close(exact[0], 0.559, 5e-4);
    assert!((exact[1] - 1.123).abs() > 4e-3);
    let numbers = [(0.559, 3), (1.123, 3), (exact[0], 4), (exact[1], 4)];
    states("section_6_3_2", &numbers);
}

/// Checks that a mass in contact has three invariant points, although the stuck chain has two peaks.
#[test]
fn section_6_3_3() {
    let scene = unit(5, Contact::Wall(2));
    let u = |r: f64| scene.at(r).u()[2];
    let step = 1e-3;
    let ratios: Vec<f64> = (0..2000)
        .map(|i| 1.0 + step * (f64::from(i) + 0.5))
        .collect();
    let values: Vec<(f64, f64)> = ratios.iter().map(|r| (*r, u(*r))).collect();
    // At a resonance U changes its sign through infinity.
    let changes = values.windows(2).filter(|pair| {
        let (one, other) = (pair[0].1, pair[1].1);
        one * other < 0.0 && one.abs().max(other.abs()) < 1.0
    });
    let points: Vec<f64> = changes
        .map(|pair| bisect(|r| u(r) * pair[0].1 > 0.0, pair[0].0, pair[1].0))
        .collect();
    assert_eq!(points.len(), 3, "{points:?}");
    for r in &points {
        let (plain, beta) = (scene.at(*r), 0.5 * scene.limit(*r));
        let steady = run_on(&plain, beta, 4);
        close(steady.at(0.0).0[2].abs(), plain.v()[2].norm(), 1e-8);
    }
    let stuck = |r: f64| scene.at(r).stuck().0[0].re;
    let peaks = [1.0, 3.0_f64.sqrt()];
    for peak in peaks {
        assert!(stuck(peak - 1e-6) > 1e5 && stuck(peak + 1e-6) < -1e5);
    }
    let found = points.iter().map(|point| (*point, 6));
    let numbers: Vec<_> = found.chain(peaks.map(|peak| (peak, 4))).collect();
    states("section_6_3_3", &numbers);
}

/// Checks that amplitude and stiffness ratio of the two-storey rig follow from its frequencies.
#[test]
fn eq_a_11_and_a_20() {
    let (m1, m2, k1, k2) = (3.27_f64, 3.25, 1190.0, 1323.0);
    let scene = Scene {
        gamma: vec![1.0, m2 / m1],
        kappa: vec![1.0, k2 / k1],
        load: None,
        ..unit(2, Contact::Wall(0))
    };
    let reference = (k1 / m1).sqrt();
    let natural = scene.at(1.0).lambda.map(|lambda| lambda.sqrt() * reference);
    let product = natural[0] * natural[1];
    let (antiresonance, omega) = ((k2 / m2).sqrt(), 9.0);
    let fraction = (antiresonance.powi(2) - omega * omega)
        / (natural
            .map(|natural| natural * natural - omega * omega)
            .product());
    let printed = product / antiresonance * fraction;
    let right = (product / antiresonance).powi(2) * fraction;
    // The true value is the solution of (A.1) itself for Y = 1.
    let dynamic = Matrix2::new(
        k1 + k2 - omega * omega * m1,
        -k2,
        -k2,
        k2 - omega * omega * m2,
    );
    let truth = dynamic.lu().solve(&Vector2::new(k1, 0.0)).unwrap()[0];
    judged(printed, right, truth, 1e-10);
    let gamma = m2 / m1;
    let printed_ratio = (antiresonance / product).powi(2) * gamma;
    let right_ratio = (antiresonance.powi(2) / product).powi(2) * gamma;
    judged(printed_ratio, right_ratio, k2 / k1, 1e-12);
    let numbers = [
        (printed, 4),
        (right, 4),
        (printed_ratio, 4),
        (right_ratio, 4),
    ];
    states("eq_a_11_and_a_20", &numbers);
}
