//! The Taylor series of a sum against derivatives by other formulas, and how far it is trusted.

use super::*;
use crate::modal_sum::wave::Sum;
use crate::oscillator::decay::Damped;
use crate::testing::{Lcg, ZETAS, parts, random_waves, sum_derivative};
use core::f64::consts::PI;

const SLACK: f64 = 1e-9;

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

/// The share of the last term's bound that the last derivative reaches from the instant on, with a unit of the
/// start for what rounding leaves of a decay.
fn share(sum: &Sum<'_, f64, Damped<f64>>, tau: f64) -> f64 {
    let series = Series::of(sum, &Instant::new(tau / PI));
    let start = Series::of(sum, &Instant::new(0.0));
    let bound = series.bound() + f64::EPSILON * start.bound();
    let weight = series.unit.powi(ORDER as i32) / factorial(ORDER);
    let near = (0..64).map(|k| tau + 0.11 * f64::from(k) * series.unit);
    let far = (0..=64).map(|k| tau + (PI - tau) * f64::from(k) / 64.0);
    near.chain(far)
        .filter(|later| *later <= PI)
        .map(|later| (sum_derivative(sum, later, ORDER) * weight).abs() / bound)
        .fold(0.0, f64::max)
}

#[test]
fn coefficients_are_derivatives() {
    let mut compared = 0;
    let mut worst = 0.0_f64;
    for zeta in ZETAS {
        for x in [0.05, 0.3, 0.999, 1.2, 5.0, 300.0] {
            for (name, wave) in parts(x, zeta) {
                let sum = Sum {
                    waves: &[wave],
                    cosine: 0.3,
                    sine: -0.7,
                };
                for tau in [0.0, 0.3 / (1.0 + x), 1.1, PI] {
                    let series = Series::of(&sum, &Instant::new(tau / PI));
                    let largest = series
                        .coefficients
                        .iter()
                        .fold(0.0_f64, |a, b| a.max(b.abs()));
                    for (order, got) in series.coefficients.into_iter().enumerate() {
                        let want = sum_derivative(&sum, tau, order)
                            * series.unit.powi(order as i32)
                            / factorial(order);
                        // The angle xτ in radians loses three digits, a slow wave's share of rest 1/x².
                        let off = (got - want).abs() / largest.max(1.0);
                        assert!(
                            off < 1e-11,
                            "{name}, ζ {zeta}, x {x}, τ {tau}, {order}: {got} {want}"
                        );
                        worst = worst.max(off);
                        compared += 1;
                    }
                }
            }
        }
    }
    println!("{compared} coefficients, worst {worst:e}");
    assert!(compared > 16_000);
}

#[test]
fn the_last_term_stays_within_its_bound() {
    let mut compared = 0;
    let (mut most, mut least) = (0.0_f64, 9.0_f64);
    for zeta in ZETAS {
        for x in [
            1e-3, 0.05, 0.3, 0.7, 0.999, 1.0, 1.0001, 1.2, 2.0, 5.0, 300.0, 1e4,
        ] {
            for (name, wave) in parts(x, zeta) {
                let sum = Sum {
                    waves: &[wave],
                    cosine: 0.0,
                    sine: 0.0,
                };
                for tau in [0.0, 0.3, 1.1, 2.0, 3.0].map(|tau: f64| tau / x.max(1.0)) {
                    let share = share(&sum, tau);
                    assert!(
                        share <= 1.0 + SLACK,
                        "{name}, ζ {zeta}, x {x}, τ {tau}: {share}"
                    );
                    most = most.max(share);
                    if tau == 0.0 && x >= 2.0 && zeta <= 0.01 {
                        least = least.min(share);
                    }
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} instants; shares of the bound {most}, from the start on {least} at least");
    // A bound a few hundredths too low would be seen, and none is looser than by a half where modes turn.
    assert!(compared > 2500 && most > 0.98 && least > 0.5);
}

#[test]
fn random_sums_stay_within_the_bound() {
    let mut random = Lcg(5);
    let mut most = 0.0_f64;
    for case in 0..400 {
        let waves = random_waves(&mut random, (1e-2, 300.0), case % 3 == 0, case % 2 == 0);
        let sum = Sum {
            waves: &waves,
            cosine: random.signed(),
            sine: random.signed(),
        };
        let tau = PI * random.unit();
        let share = share(&sum, tau);
        assert!(share <= 1.0 + SLACK, "case {case}, τ {tau}: {share}");
        most = most.max(share);
    }
    println!("400 sums, largest share {most}");
    assert!(most > 0.9);
}

/// Where only the bound on the last term keeps the sum below: as far as the reach it does, and not much further.
#[test]
fn the_last_term_ends_the_reach() {
    let mut series = Series {
        coefficients: [0.0; ORDER],
        bound: 1e-3,
        unit: 0.5,
    };
    let mut compared = 0;
    for exponent in 0..12 {
        let below = 0.5_f64.powi(exponent);
        series.coefficients[0] = -below;
        // −below + bound·uᴺ ≤ 0.
        let exact = (below / series.bound).powf(1.0 / ORDER as f64);
        let reach = series.reach() / series.unit;
        assert!(reach <= exact, "{below}: {reach} against {exact}");
        // A power of two, and the most that counts is 2.
        assert!(
            exact.min(2.0) < 2.0 * reach * (1.0 + SLACK),
            "{below}: {reach} against {exact}"
        );
        compared += 1;
    }
    assert_eq!(compared, 12);
}

/// Within its reach a series' sum stays at or below 0, whichever term would lift it.
#[test]
fn sums_stay_below_within_the_reach() {
    let mut random = Lcg(23);
    let (mut compared, mut none) = (0, 0);
    let mut nearest = f64::INFINITY;
    for case in 0..2000 {
        let waves = random_waves(&mut random, (1e-2, 60.0), case % 3 == 0, case % 2 == 0);
        let sum = Sum {
            waves: &waves,
            cosine: random.signed(),
            sine: random.signed(),
        };
        let tau = PI * random.unit();
        let at = Instant::new(tau / PI);
        let negative = case % 5 == 0;
        let sine = case % 2 == 1;
        let sign = if negative { -1.0 } else { 1.0 };
        let value = sign * sum_derivative(&sum, tau, 0);
        let gap = random.log_uniform(1e-8, 1.0);
        let level = if sine {
            value / at.sine + gap
        } else {
            value + gap
        };
        let series = Series::of(&sum, &at).excess(negative, level, sine, &at);
        let reach = series.reach();
        if reach == 0.0 {
            none += 1;
            continue;
        }
        let excess = |later: f64| {
            let weight = if sine { later.sin() } else { 1.0 };
            sign * sum_derivative(&sum, later, 0) - level * weight
        };
        let size = level.abs()
            + waves
                .iter()
                .map(|w| w.free.abs() / w.x + w.swing.abs())
                .sum::<f64>();
        let mut crossing = f64::INFINITY;
        for k in 1..=800 {
            let h = reach * f64::from(k) / 200.0;
            if tau + h > PI {
                break;
            }
            if excess(tau + h) > 1e-11 * size {
                crossing = h / reach;
                break;
            }
        }
        assert!(
            crossing > 1.0,
            "case {case}, τ {tau}: {crossing} of the reach {reach}"
        );
        nearest = nearest.min(crossing);
        compared += 1;
    }
    println!("{compared} reaches, {none} of nothing; the nearest crossing at {nearest} of one");
    assert_eq!(compared + none, 2000);
    // A reach is one of powers of two: the nearest is only just within.
    assert!(none < 800 && nearest < 1.1);
}
