//! Tests the step of an oscillator against Runge-Kutta, and the peaks against the closed form of a half sine.

use super::{Oscillator, Recording, periods, response_spectrum};
use crate::measure::CsvRequest;
use std::f64::consts::{PI, TAU};

/// Integrates u″ + 2ζωu′ + ω²u = −a(t) by the classical Runge-Kutta method, with `parts` Runge-Kutta steps in each step
/// of length `dt`.
fn integrated(omega: f64, zeta: f64, steps: &[[f64; 2]], dt: f64, parts: u32) -> Vec<[f64; 2]> {
    let mut state = [0.0, 0.0];
    let mut all = Vec::new();
    for [from, to] in steps {
        let h = dt / f64::from(parts);
        for part in 0..parts {
            let rate = |[u, v]: [f64; 2], share: f64| {
                let a = from + (to - from) * (f64::from(part) + share) / f64::from(parts);
                [v, -a - 2.0 * zeta * omega * v - omega * omega * u]
            };
            let moved = |[u, v]: [f64; 2], [du, dv]: [f64; 2], t: f64| [u + t * du, v + t * dv];
            let one = rate(state, 0.0);
            let two = rate(moved(state, one, 0.5 * h), 0.5);
            let three = rate(moved(state, two, 0.5 * h), 0.5);
            let four = rate(moved(state, three, h), 1.0);
            let sum = [0, 1].map(|i| (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]) / 6.0);
            state = moved(state, sum, h);
        }
        all.push(state);
    }
    all
}

/// Compares one step of an oscillator with the classical Runge-Kutta method. The step is exact. The difference is
/// therefore the sum of rounding and the error of Runge-Kutta. This error is about (ωh)⁴ for Runge-Kutta steps of
/// length h, here below 1e-10.
#[test]
fn a_step_is_exact_for_a_line() {
    let values = [0.0, 3.0, -1.0, 4.0, 4.0, -2.5, 0.0];
    let steps: Vec<[f64; 2]> = values.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let mut compared = 0;
    for zeta in [0.0, 0.05, 0.7] {
        for omega in [0.4, 6.0, 50.0] {
            let oscillator = Oscillator::new(omega, zeta);
            let step = oscillator.step(0.02);
            let expected = integrated(omega, zeta, &steps, 0.02, 400);
            let mut state = [0.0, 0.0];
            for (from, expected) in steps.iter().zip(expected) {
                state = step.of(state, *from);
                for (found, expected) in state.iter().zip(expected) {
                    // The tolerance is in m for displacements, which are below 2e-3 m, and in m/s for velocities, which
                    // are below 0.2 m/s.
                    assert!(
                        (found - expected).abs() < 1e-11,
                        "{zeta} {omega} {found} {expected}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, 9 * 6 * 2);
}

/// Returns a record of the acceleration in m/s²: a half sine of length 1 s, and then rest.
fn half_sine(samples: u32, rest: u32) -> Recording {
    let mut text = String::from("time_s,base_m_s2\n");
    for sample in 0..=samples + rest {
        let time = f64::from(sample) / f64::from(samples);
        let acceleration = if sample < samples {
            (PI * time).sin()
        } else {
            0.0
        };
        text += &format!("{time},{acceleration}\n");
    }
    Recording::inputs_from_csv(&text, &CsvRequest::default()).unwrap()
}

/// Compares the undamped response to a half sine of length 1 s and amplitude 1 m/s² with its closed form. With Ω = π
/// rad/s, the closed form is u = (sin Ωt − (Ω/ω) sin ωt)/(Ω² − ω²) during the pulse, and a free vibration after the
/// pulse.
#[test]
fn a_half_sine_has_its_shock_spectrum() {
    let samples = 4000;
    let record = half_sine(samples, samples);
    for period in [0.11, 0.4, 0.9, 1.3, 1.9] {
        let omega = TAU / period;
        let scale = 1.0 / (PI * PI - omega * omega);
        let u = |t: f64| scale * ((PI * t).sin() - PI / omega * (omega * t).sin());
        let v = |t: f64| scale * PI * ((PI * t).cos() - (omega * t).cos());
        let residual = u(1.0).hypot(v(1.0) / omega);
        // The displacement has extremes during the pulse where cos Ωt = cos ωt: t = 2πn/(ω ± Ω).
        let within = (1..200_u32).flat_map(|n| [omega + PI, omega - PI].map(|sum| (n, sum)));
        let within = within
            .map(|(n, sum)| TAU * f64::from(n) / sum.abs())
            .filter(|t| *t <= 1.0);
        let expected = within.map(|t| u(t).abs()).fold(residual, f64::max);
        let found = response_spectrum(&record, 0.0, &[period]).unwrap();
        let found = found[0].displacement;
        // Straight lines between 4000 samples deviate from the half sine by (π/4000)²/8, which is 8e-8. The error of
        // the peak is at most 5e-6.
        assert!(
            (found / expected - 1.0).abs() < 5e-6,
            "{period}: {found} {expected}"
        );
    }
}

/// Checks that a motion of the base has the same spectrum if it is recorded as velocity or as displacement. A straight
/// line between two of 4000 samples leaves out at most (1/4000)²/8 of the second derivative. Relative to the response,
/// the mean of this error is (π/4000)²/12 under velocities and (ω/4000)²/12 under displacements.
#[test]
fn velocities_and_displacements_give_the_same_spectrum() {
    let samples = 4000_u32;
    let mut text = [
        String::from("time_s,base_m_s\n"),
        String::from("time_s,base_mm\n"),
    ];
    for sample in 0..=samples {
        let time = f64::from(sample) / f64::from(samples);
        let velocity = (1.0 - (PI * time).cos()) / PI;
        let place = 1e3 * (time - (PI * time).sin() / PI) / PI;
        text[0] += &format!("{time},{velocity}\n");
        text[1] += &format!("{time},{place}\n");
    }
    let periods = [0.2, 0.9, 3.0];
    let expected = response_spectrum(&half_sine(samples, 0), 0.05, &periods).unwrap();
    for text in text {
        let record = Recording::inputs_from_csv(&text, &CsvRequest::default()).unwrap();
        let found = response_spectrum(&record, 0.05, &periods).unwrap();
        for (found, expected) in found.iter().zip(&expected) {
            let error = found.displacement / expected.displacement - 1.0;
            let omega = 2.0 * PI / found.period;
            let bound = 2e-6 + (omega / 4000.0).powi(2) / 12.0;
            assert!(error.abs() < bound, "{error:e} at {} s", found.period);
        }
    }
}

#[test]
fn periods_span_the_record() {
    let record = half_sine(100, 0);
    let all = periods(&record);
    assert!((all[0] - 0.02).abs() < 1e-12);
    assert!((all.last().unwrap() - 1.0).abs() < 1e-12);
    assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(response_spectrum(&record, 0.05, &[]).unwrap().is_empty());
}
