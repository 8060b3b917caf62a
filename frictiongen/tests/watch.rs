//! `Watch`: the amplitude at one frequency, followed in fixed memory.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use frictiongen::watch::{Watch, friction_ratio, transmissibility};
use frictiongen::{Complex, friction_system};
use std::f64::consts::TAU;

friction_system! {
    struct Block {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: base,
        provide: [limits, motion, orbit],
    }
}

/// Returns the plain sum over the last N samples.
fn direct(samples: &[f64], n: usize, cycles: f64) -> Complex<f64> {
    let from = samples.len() - n;
    let terms = samples.iter().enumerate().skip(from).map(|(t, x)| {
        let (sin, cos) = (TAU * cycles * (t % n) as f64 / n as f64).sin_cos();
        Complex::new(x * cos, -x * sin) * (2.0 / n as f64)
    });
    terms.sum()
}

/// After any number of samples the result is the sum of the last N, in both precisions. The error does not grow from a
/// hundred samples to a million.
#[test]
fn it_slides_without_drift() {
    let mut single = Watch::<f32, 48>::new(5).unwrap();
    let mut double = Watch::<f64, 48>::new(5).unwrap();
    let mut samples = Vec::new();
    let mut compared = 0;
    for i in 0..1_000_000_u32 {
        let x = (0.37 * f64::from(i)).sin() + 0.3 * f64::from(i % 11) + (f64::from(i) * 1e-5).cos();
        // These large values would leave their rounding in a sum that never restarts.
        let x = if (400_000..400_100).contains(&i) {
            1e6 * x
        } else {
            x
        };
        samples.push(x);
        single.push(x as f32);
        double.push(x);
        assert_eq!(double.fundamental().is_some(), 48 <= samples.len());
        let calm = !(399_000..=401_000).contains(&i);
        if 48 <= samples.len() && calm && !(300..=999_700).contains(&i) {
            let expected = direct(&samples, 48, 5.0);
            assert!(
                (double.fundamental().unwrap() - expected).norm() < 1e-13,
                "{i}"
            );
            let found = single.fundamental().unwrap();
            let found = Complex::new(f64::from(found.re), f64::from(found.im));
            // The bound is 48 terms of size 3 at 6e-8 each, added and subtracted.
            assert!(
                (found - expected).norm() < 3e-6,
                "{i}: {found} for {expected}"
            );
            compared += 1;
        }
    }
    assert!(compared > 500);
}

#[test]
fn frequencies_that_do_not_fit() {
    assert!(Watch::<f32, 16>::new(0).is_none());
    assert!(Watch::<f32, 16>::new(8).is_none());
    assert!(Watch::<f32, 16>::new(7).is_some());
    assert!(Watch::<f32, 0>::new(1).is_none());
    assert!(Watch::<f32, 2>::new(u16::MAX).is_none());
    let zero = Complex::new(0.0, 0.0);
    assert!(transmissibility(Complex::new(1.0, 0.0), zero).is_none());
    assert!(friction_ratio(zero, zero, zero, 0.1).is_none());
}

/// Samples of the exact motion, with all harmonics, give β. With stops the result is too small.
#[test]
fn friction_from_samples() {
    let watched = |r: f64, beta: f64| {
        let at = Block::at(r).unwrap();
        let orbit = at.orbit(beta).unwrap();
        let (mut base, mut mass) = (
            Watch::<f64, 256>::new(2).unwrap(),
            Watch::<f64, 256>::new(2).unwrap(),
        );
        for i in 0..600_u16 {
            let tau = TAU * f64::from(i) / 128.0;
            base.push(tau.cos());
            let terms = (0..60).map(|n| {
                let x = orbit.block().harmonic(n);
                let (sin, cos) = (f64::from(n) * tau).sin_cos();
                x.re * cos - x.im * sin
            });
            mass.push(terms.sum());
        }
        let measured =
            transmissibility(mass.fundamental().unwrap(), base.fundamental().unwrap()).unwrap();
        let fundamental = |beta: f64| at.motion(beta).unwrap().block().harmonic(1);
        friction_ratio(measured, fundamental(0.0), fundamental(0.05), 0.05).unwrap()
    };
    for (r, beta) in [(0.8, 0.3), (1.3, 0.6), (2.1, 0.4)] {
        assert!((watched(r, beta) - beta).abs() < 1e-9, "{r}, {beta}");
    }
    let stops = watched(0.4, 0.6);
    assert!(stops < 0.6, "{stops}");
}
