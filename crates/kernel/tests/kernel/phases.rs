//! The phase of a motion with several equal maxima is the lag of smallest size.  If two lags of smallest size differ in
//! sign, the positive lag counts.

use frictiongen_kernel::Complex;
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Undamped;
use frictiongen_kernel::response::coefficients::{Friction, Fundamental};
use frictiongen_kernel::response::motion::Motion;
use std::f64::consts::PI;

/// Phase of cosine·(cos τ − b cos kτ) + sine·(sin τ + b sin kτ), k odd, as a mass's motion with a contact of this lag.
fn phase(cosine: f64, sine: f64, (k, b): (f64, f64), lag: f64) -> f64 {
    let mut wave = Wave::at_rest(k, Undamped);
    wave.free = sine * k * b;
    wave.forced_slope = cosine * b;
    let zero = Complex::new(0.0, 0.0);
    let fundamental = Fundamental {
        cosine: cosine * (1.0 - b),
        sine,
        response: zero,
    };
    let friction = Friction {
        beta: 1.0,
        root: 1.0,
        amplitude: 1.0,
        phase: lag,
        unscale: 1.0,
    };
    Motion::of_mass(friction, fundamental, [wave]).phase()
}

/// An angle shifted into (−π, π].
fn wrapped(angle: f64) -> f64 {
    let turns = (angle / (2.0 * PI)).round();
    let angle = angle - 2.0 * PI * turns;
    if angle <= -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
}

/// Instant in the first half at which sin τ + b sin kτ (even) or cos τ − b cos kτ (odd) is largest.  The slope is
/// bisected about the highest point of a grid.
fn first_maximum(odd: bool, (k, b): (f64, f64)) -> f64 {
    let value = |tau: f64| {
        if odd {
            tau.cos() - b * (k * tau).cos()
        } else {
            tau.sin() + b * (k * tau).sin()
        }
    };
    let slope = |tau: f64| {
        if odd {
            b * k * (k * tau).sin() - tau.sin()
        } else {
            tau.cos() + b * k * (k * tau).cos()
        }
    };
    let step = PI / 2.0 / 4096.0;
    let best = (1..=4096).fold(0.0, |best, i| {
        let tau = f64::from(i) * step;
        if value(best) < value(tau) { tau } else { best }
    });
    let (mut low, mut high) = (best - step, best + step);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if slope(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

const SHAPES: [(f64, f64); 5] = [(3.0, 0.5), (3.0, 0.3), (7.0, 0.2), (15.0, 0.2), (31.0, 0.4)];

/// Two maxima of one sign are equally far from the middle on both sides, so that the lags are φ + τ and φ + π − τ.
#[test]
fn the_smaller_lag_counts() {
    let (mut compared, mut equal) = (0, 0);
    for shape in SHAPES {
        let tau = first_maximum(false, shape);
        for i in -31..=32 {
            let lag = f64::from(i) * PI / 32.0;
            for sign in [1.0, -1.0] {
                let turned = if sign < 0.0 { PI } else { 0.0 };
                let lags = [tau, PI - tau].map(|tau| wrapped(lag + tau + turned));
                if (lags[0].abs() - lags[1].abs()).abs() < 1e-9 {
                    equal += 1;
                    continue;
                }
                let want = if lags[0].abs() < lags[1].abs() {
                    lags[0]
                } else {
                    lags[1]
                };
                let got = phase(0.0, sign, shape, lag);
                assert!(
                    (got - want).abs() < 1e-9,
                    "{shape:?}, φ {lag}, {sign}: {got}, of {lags:?}"
                );
                compared += 1;
            }
        }
    }
    println!("{compared} phases, {equal} of lags that differ in sign alone");
    assert_eq!(compared + equal, 640);
    assert!(equal <= 20);
}

/// Two maxima have one height, and their lags differ in sign alone, to rounding.
#[test]
fn of_lags_that_differ_in_sign_the_positive_counts() {
    let mut compared = 0;
    for shape in SHAPES {
        // cos τ − b cos kτ is odd about the middle, so that the lags are τ and −τ where the contact has no lag.
        let want = first_maximum(true, shape);
        for sign in [1.0, -1.0] {
            let lag = if sign < 0.0 { PI } else { 0.0 };
            let got = phase(sign, 0.0, shape, lag);
            assert!(
                (got - want).abs() < 1e-9,
                "{shape:?}, {sign}: {got}, not {want}"
            );
            compared += 1;
        }
        // The even shape has such lags where the contact lags or leads by a quarter turn.
        let tau = first_maximum(false, shape);
        for (sign, lag) in [(1.0, -PI / 2.0), (-1.0, PI / 2.0)] {
            let want = PI / 2.0 - tau;
            let got = phase(0.0, sign, shape, lag);
            assert!(
                (got - want).abs() < 1e-9,
                "{shape:?}, {sign}: {got}, not {want}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 20);
}
