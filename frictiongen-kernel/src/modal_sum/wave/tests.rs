//! The bounds of a wave and of a sum against their derivatives, sampled.

use super::*;
use crate::oscillator::decay::{Damped, Undamped};
use crate::testing::{Lcg, TestWave, ZETAS, derivative, parts, random_waves, rest, sum_derivative};
use core::f64::consts::PI;
use std::collections::BTreeMap;

/// What rounding of the sampled derivatives may add to the exact ratio 1, a few thousand turns included.
const SLACK: f64 = 1e-9;

/// Rates from far below the excitation's to far above, and both sides of it.
const RATES: [f64; 15] = [
    1e-3, 0.05, 0.3, 0.7, 0.999, 1.0, 1.0001, 1.2, 1.49, 2.0, 5.0, 30.0, 300.0, 3000.0, 1e4,
];

/// Instants to look from: both ends, the first quarter turn of a fast mode, anywhere.
fn instants(x: f64) -> Vec<f64> {
    let mut out = vec![0.0, PI];
    for k in 1..12 {
        let k = f64::from(k);
        out.extend([0.21 * k / x.max(1.0), 0.26 * k]);
    }
    out.retain(|tau| *tau <= PI);
    out
}

/// From τ to the end of the half period: close where a fast mode turns and decays, and throughout.
fn onwards(tau: f64, rate: f64) -> impl Iterator<Item = f64> {
    let near = (0..64).map(move |k| tau + 0.11 * f64::from(k) / rate.max(1.0));
    let far = (0..=64).map(move |k| tau + (PI - tau) * f64::from(k) / 64.0);
    near.chain(far).filter(|tau| *tau <= PI)
}

/// The share of both bounds that the derivatives reach from an instant on.  A decay is formed as 1 less what is
/// lost, and what rounding leaves of it, a unit of the start, is no fault of a bound.
fn shares(sum: &Sum<'_, f64, Damped<f64>>, tau: f64, rate: f64) -> (f64, f64) {
    let (start, _) = sum.local(&Instant::new(0.0), None);
    let (local, _) = sum.local(&Instant::new(tau / PI), None);
    let bound = |here: f64, start: f64| here + f64::EPSILON * start;
    let second_bound = bound(local.curvature_bound, start.curvature_bound);
    let third_bound = bound(local.third_bound, start.third_bound);
    onwards(tau, rate).fold((0.0, 0.0), |(second, third): (f64, f64), later| {
        (
            second.max(sum_derivative(sum, later, 2).abs() / second_bound),
            third.max(sum_derivative(sum, later, 3).abs() / third_bound),
        )
    })
}

fn alone(wave: &TestWave) -> Sum<'_, f64, Damped<f64>> {
    Sum {
        waves: core::slice::from_ref(wave),
        cosine: 0.0,
        sine: 0.0,
    }
}

/// Every part of a wave by itself: nothing exceeds a bound, and bounds are no looser than stated.
#[test]
fn derivatives_stay_within_their_bounds() {
    let mut compared = 0;
    let mut over = Vec::new();
    // By part: the largest share of any instant, and the smallest of those from the start on.
    let mut found: BTreeMap<&str, [f64; 4]> = BTreeMap::new();
    for zeta in ZETAS {
        for x in RATES {
            for (name, wave) in parts(x, zeta) {
                let sum = alone(&wave);
                for tau in instants(x) {
                    let (second, third) = shares(&sum, tau, wave.rate());
                    compared += 1;
                    if !(second <= 1.0 + SLACK && third <= 1.0 + SLACK) {
                        over.push(format!(
                            "{name}, ζ {zeta}, x {x}, τ {tau}: {second}, {third}"
                        ));
                    }
                    let known = found.entry(name).or_insert([0.0, 0.0, 9.0, 9.0]);
                    (known[0], known[1]) = (known[0].max(second), known[1].max(third));
                    if tau == 0.0 && x > 2.0 && zeta <= 0.1 {
                        (known[2], known[3]) = (known[2].min(second), known[3].min(third));
                    }
                }
            }
        }
    }
    println!("{compared} instants; shares of the bounds, largest and from the start: {found:?}");
    assert_eq!(compared, 18_000);
    assert!(
        over.is_empty(),
        "{} over: {:#?}",
        over.len(),
        &over[..over.len().min(9)]
    );
    for (name, [second, third, second_least, third_least]) in found {
        // Somewhere each bound is reached, so that one a few hundredths too low would have been seen.
        assert!(second > 0.99 && third > 0.97, "{name}: {second}, {third}");
        // A mode that turns and hardly decays comes as near to its bounds as this.
        assert!(
            second_least > 0.5 && third_least > 0.5,
            "{name}: {second_least}, {third_least}"
        );
    }
}

/// Beside x = 1 the two parts that compare the mode with the excitation hardly move, and their bounds say so:
/// by π(|x − 1| + 3ζx) of the waves' difference and a few units of |x − 1| + 2ζx, eight in all.
#[test]
fn bounds_shrink_beside_the_resonance() {
    let mut compared = 0;
    for zeta in [0.0, 1e-9, 1e-6, 1e-3, 0.01] {
        for apart in [-0.01, -1e-4, 1e-8, 1e-5, 1e-3] {
            let x = 1.0 + apart;
            for (name, wave) in parts(x, zeta) {
                if !name.starts_with("swing") {
                    continue;
                }
                let most = 8.0 * (apart.abs() + 3.0 * zeta * x);
                for tau in instants(x) {
                    let (local, _) = alone(&wave).local(&Instant::new(tau / PI), None);
                    assert!(
                        local.curvature_bound < most && local.third_bound < most,
                        "{name}, ζ {zeta}, x − 1 = {apart}, τ {tau}: {}, {} of {most}",
                        local.curvature_bound,
                        local.third_bound
                    );
                    compared += 2;
                }
            }
        }
    }
    println!("{compared} bounds compared, none skipped");
    assert!(compared > 2_000);
}

/// There, without damping, y = sin τ − sin(xτ)/x has y″ = 2 cos((x + 1)τ/2) sin((x − 1)τ/2) + (x − 1) sin xτ,
/// and that keeps its digits.
#[test]
fn differences_keep_their_digits_beside_the_resonance() {
    let mut compared = 0;
    for step in [-1e-4, 1e-9, 1e-6, 1e-3] {
        let x = 1.0 + step;
        let apart: f64 = x - 1.0;
        let parts = parts(x, 0.0);
        let of = |wanted: &str| &parts.iter().find(|(name, _)| *name == wanted).unwrap().1;
        for tau in instants(x) {
            let (half, turned) = (apart * tau / 2.0, x * tau);
            let (sum, slow) = ((x + 1.0) * tau / 2.0, half.sin());
            let second = 2.0 * sum.cos() * slow + apart * turned.sin();
            let third = -(x + 1.0) * sum.sin() * slow
                + apart * sum.cos() * half.cos()
                + apart * x * turned.cos();
            for (name, want) in [("swing", second), ("swing_slope", third)] {
                let (local, _) = alone(of(name)).local(&Instant::new(tau / PI), None);
                // A few roundings of terms of the size of |x − 1|.
                assert!(
                    (local.curvature - want).abs() < 1e-13 * apart.abs(),
                    "{name}, x − 1 = {apart:e}, τ {tau}: {} instead of {want}",
                    local.curvature
                );
                compared += 1;
            }
        }
    }
    println!("{compared} derivatives compared, none skipped");
    assert_eq!(compared, 192);
}

/// Sums of waves: values and two derivatives, their bounds, what the tail comes to, and the largest values.
#[test]
fn sums_stay_within_their_bounds() {
    let mut random = Lcg(11);
    let (mut compared, mut tails) = (0, 0);
    let (mut most, mut most_of_tail) = ((0.0_f64, 0.0_f64), 0.0_f64);
    for case in 0..600 {
        let waves = random_waves(&mut random, (1e-2, 300.0), case % 3 == 0, case % 2 == 0);
        let sum = Sum {
            waves: &waves,
            cosine: random.signed(),
            sine: random.signed(),
        };
        let rate = 1.0 / sum.unit();
        let largest = waves.iter().map(Wave::amplitude_bound).sum::<f64>();
        let over_sine = sum.bound_over_sine();
        let tail = sum.tail(random.log_uniform(1e-2, 10.0));
        for _ in 0..5 {
            let tau = PI * random.unit();
            let at = Instant::new(tau / PI);
            let (local, slow) = sum.local(&at, tail.as_ref());
            let (second, third) = shares(&sum, tau, rate);
            assert!(
                second <= 1.0 + SLACK && third <= 1.0 + SLACK,
                "case {case}, τ {tau}: {second}, {third}"
            );
            most = (most.0.max(second), most.1.max(third));
            let bounds = [
                local.curvature_bound / (rate * rate),
                local.curvature_bound / rate,
                local.curvature_bound,
            ];
            // The angle xτ of the fastest wave has some ten digits more than this.
            let scale = largest + sum.cosine.abs() + sum.sine.abs();
            for (order, got) in [local.value, local.slope, local.curvature]
                .into_iter()
                .enumerate()
            {
                let want = sum_derivative(&sum, tau, order);
                let bar = 1e-9 * (bounds[order] + scale * rate.powi(order as i32));
                assert!(
                    (got - want).abs() <= bar,
                    "case {case}, τ {tau}, order {order}: {got} {want}"
                );
                compared += 1;
            }
            let value = |wave: &TestWave| derivative(wave, tau, 0);
            for wave in &waves {
                assert!(value(wave).abs() <= wave.amplitude_bound() * (1.0 + SLACK));
            }
            let swings = |wave: &TestWave| wave.swing * tau.sin();
            let less = waves
                .iter()
                .map(|wave| value(wave) - swings(wave))
                .sum::<f64>();
            if case % 2 == 1 {
                assert!(
                    less.abs() <= over_sine * (1.0 + SLACK),
                    "case {case}: {less} {over_sine}"
                );
            }
            if let (Some(tail), Some(slow)) = (&tail, slow) {
                tails += 1;
                let left = (local.value - slow.value).abs();
                assert!(
                    left <= tail.amplitude * (1.0 + SLACK),
                    "case {case}: {left} {}",
                    tail.amplitude
                );
                most_of_tail = most_of_tail.max(left / tail.amplitude);
            }
        }
    }
    println!(
        "{compared} values and derivatives, {tails} tails; shares {most:?}, of a tail {most_of_tail}"
    );
    assert_eq!(compared, 9000);
    assert!(tails > 500 && most.0 > 0.99 && most.1 > 0.99 && most_of_tail > 0.9);
}

/// A wave's angle is known until its rounding has grown to a radian, or it has died out.
#[test]
fn turns_are_unknown_from_where_rounding_turns_by_a_radian() {
    let asked = |x: f64, zeta: f64| {
        let swing = Wave {
            swing: 1.0,
            ..rest(x, zeta)
        };
        let slope = Wave {
            swing_slope: 1.0,
            ..rest(x, zeta)
        };
        assert_eq!(swing.turns_unknown(), slope.turns_unknown());
        swing.turns_unknown()
    };
    // 1/(πε) = 1.43e15.
    assert!(!asked(1.4e15, 0.0) && asked(1.5e15, 0.0) && asked(1e300, 0.0));
    // It lives 1/ζx, in which it turns by 1/ζ.
    assert!(!asked(1.5e15, 1e-9) && !asked(1e300, 1e-3) && asked(1e300, 1e-16));
    // One that the contact does not drive says nothing either.
    assert!(rest(3.0, 0.0).turns_unknown());
    let single = Wave {
        swing: 1.0,
        ..Wave::rest(2.7e6_f32, Undamped)
    };
    assert!(single.turns_unknown());
    assert!(!Wave { x: 2.6e6, ..single }.turns_unknown());
}
