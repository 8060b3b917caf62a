//! Tests of the derivatives of a modal sum against other formulas.

use super::*;
use crate::oscillator::decay::{Damped, Undamped};
use crate::testing::{Lcg, TestWave, at_rest, derivative, parts, random_waves, sum_derivative};
use core::f64::consts::PI;

/// Returns test instants in the half period: both bounds, the first quarter turns of a fast mode, and instants between
/// the bounds.
fn instants(x: f64) -> Vec<f64> {
    let mut out = vec![0.0, PI];
    for k in 1..12 {
        let k = f64::from(k);
        out.extend([0.21 * k / x.max(1.0), 0.26 * k]);
    }
    out.retain(|tau| *tau <= PI);
    out
}

fn alone(wave: &TestWave) -> Sum<'_, f64, Damped<f64>> {
    Sum {
        waves: core::slice::from_ref(wave),
        cosine: 0.0,
        sine: 0.0,
    }
}

/// Compares derivatives of y = sin τ − sin(xτ)/x close to the resonance x = 1, without damping, with a form that does
/// not lose digits. This form is y″ = 2 cos((x + 1)τ/2) sin((x − 1)τ/2) + (x − 1) sin xτ, and its derivative.
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
            for (name, want) in [("forced", second), ("forced_slope", third)] {
                let jet = alone(of(name)).jet(&Instant::new(tau / PI));
                // The error may be a few roundings of terms of the size |x − 1|.
                assert!(
                    (jet.curvature - want).abs() < 1e-13 * apart.abs(),
                    "{name}, x − 1 = {apart:e}, τ {tau}: {} instead of {want}",
                    jet.curvature
                );
                compared += 1;
            }
        }
    }
    println!("{compared} derivatives compared, none skipped");
    assert_eq!(compared, 192);
}

/// Checks the values and the first three derivatives of modal sums, and the bound on the size of each modal term.
#[test]
fn sums_have_their_derivatives() {
    let mut random = Lcg(11);
    let mut compared = 0;
    for case in 0..600 {
        let waves = random_waves(&mut random, (1e-2, 300.0), case % 3 == 0, case % 2 == 0);
        let sum = Sum {
            waves: &waves,
            cosine: random.signed(),
            sine: random.signed(),
        };
        let rate = waves.iter().map(|w| w.x * (1.0 + 2.0 * w.decay.zeta()));
        let rate = rate.fold(1.0, f64::max);
        let largest = waves.iter().map(Wave::amplitude_bound).sum::<f64>();
        for _ in 0..5 {
            let tau = PI * random.unit();
            let jet = sum.jet(&Instant::new(tau / PI));
            // The phase xτ of the fastest mode has about ten digits more than this tolerance requires.
            let scale = largest + sum.cosine.abs() + sum.sine.abs();
            for (order, got) in [jet.value, jet.slope, jet.curvature, jet.third]
                .into_iter()
                .enumerate()
            {
                let want = sum_derivative(&sum, tau, order);
                let bar = 1e-9 * scale * rate.powi(order as i32);
                assert!(
                    (got - want).abs() <= bar,
                    "case {case}, τ {tau}, order {order}: {got} {want}"
                );
                compared += 1;
            }
            for wave in &waves {
                let value = derivative(wave, tau, 0).abs();
                assert!(value <= wave.amplitude_bound() * (1.0 + 1e-9));
            }
        }
    }
    println!("{compared} values and derivatives");
    assert_eq!(compared, 12_000);
}

/// Checks that the phase of a mode counts as known until its rounding error reaches a radian, or until the mode has
/// decayed.
#[test]
fn turns_are_unknown_from_where_rounding_turns_by_a_radian() {
    let asked = |x: f64, zeta: f64| {
        let forced = Wave {
            forced: 1.0,
            ..at_rest(x, zeta)
        };
        let slope = Wave {
            forced_slope: 1.0,
            ..at_rest(x, zeta)
        };
        assert_eq!(forced.turns_unknown(), slope.turns_unknown());
        forced.turns_unknown()
    };
    // Without damping the phase is unknown for x ≥ 1/(πε) = 1.43e15, where ε is the machine epsilon.
    assert!(!asked(1.4e15, 0.0) && asked(1.5e15, 0.0) && asked(1e300, 0.0));
    // The mode decays within a time 1/ζx, in which its phase advances by 1/ζ.
    assert!(!asked(1.5e15, 1e-9) && !asked(1e300, 1e-3) && asked(1e300, 1e-16));
    // The phase of a mode that the contact does not drive counts as unknown.
    assert!(at_rest(3.0, 0.0).turns_unknown());
    let single = Wave {
        forced: 1.0,
        ..Wave::at_rest(2.7e6_f32, Undamped)
    };
    assert!(single.turns_unknown());
    assert!(!Wave { x: 2.6e6, ..single }.turns_unknown());
}
