//! One mass: F01 to F08, F10 to F13, F29, F31.

use super::{amplitude, ask, chain, close, fundamental, limit, peak, root, sliding_limit, unit};
use frictiongen::Regime;
use frictiongen::study::System;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

/// Closed forms are rounded a few times in double precision.
const ROUNDING: f64 = 1e-14;

fn wall() -> System {
    unit(1, "m1 - wall", "m1")
}

fn base() -> System {
    unit(1, "m1 - base", "base")
}

fn with_stiction(contact: &str, excitation: &str, mu: f64) -> System {
    let rest = format!("stiction: {mu:?},");
    chain(&[1.0], &[1.0], contact, excitation, &rest)
}

/// Printed π/4.
#[test]
fn f01() {
    let system = wall();
    close(limit(&system, 1.0), FRAC_PI_4, ROUNDING);
    close(limit(&system, 1.0), 0.785398, 5e-7);
    // β_lim has a finite slope at r = 1: 1e-7 beside it, it differs by about as much.
    for r in [1.0 - 1e-7, 1.0 + 1e-7] {
        close(limit(&system, r), FRAC_PI_4, 1e-6);
    }
    assert_eq!(system.resonance_thresholds().len(), 1);
    close(
        system.resonance_thresholds()[0].unwrap(),
        FRAC_PI_4,
        ROUNDING,
    );
}

/// Printed 0.537 for μ = 1; (2.31) would give 0.502 for μ = 1.5.
#[test]
fn f02() {
    for (mu, comes_out) in [(1.0, 0.537029), (1.5, 0.460414)] {
        let system = with_stiction("m1 - wall", "m1", mu);
        close(limit(&system, f64::INFINITY), comes_out, 5e-7);
        close(system.high_frequency_limits().0, comes_out, 5e-7);
        // β_lim approaches it as 1/r².
        close(limit(&system, 1e4), comes_out, 6e-7);
    }
    close(limit(&wall(), f64::INFINITY), 0.537, 5e-4);
    let printed: f64 = 2.0 / (4.0 * 1.5 + PI * PI).sqrt();
    close(printed, 0.502, 5e-4);
}

/// Printed 1.
#[test]
fn f03() {
    let system = wall();
    let constraint = |r: f64| {
        // β_lim = |V|/√(U² + S²) with μ = 1, solved for S; m* = 1.
        let (v, u) = (1.0 / (1.0 - r * r), (PI / (2.0 * r)).tan() / r);
        r * r * ((v / limit(&system, r)).powi(2) - u * u).sqrt()
    };
    for r in [0.51, 0.55, 0.6, 0.7, 0.9, 1.1, 1.5, 2.0, 3.0] {
        // Next to r = 1, (V/β)² − U² loses some digits.
        close(constraint(r), 1.0, 1e-12);
    }
    // Below 1/2 it is more.
    for r in [0.35, 0.4, 0.45] {
        assert!(constraint(r) > 1.01, "{} at {r}", constraint(r));
    }
}

/// Printed r²/μ.
#[test]
fn f04() {
    for mu in [1.0, 1.2, 2.0] {
        let system = with_stiction("m1 - base", "base", mu);
        for r in [0.1_f64, 0.5, 0.9, 1.0, 1.3, 2.5] {
            close(sliding_limit(&system, r), r * r / mu, ROUNDING * r * r);
        }
    }
}

/// Printed 0.55 and 0.79; the first comes out as 0.56.
#[test]
fn f05() {
    let system = base();
    let width = |r: f64| sliding_limit(&system, r) - limit(&system, r);
    let widest = peak(width, 0.51, 0.65);
    let narrowest = peak(|r| -width(r), 0.7, 0.9);
    close(widest, 0.56, 5e-3);
    assert!((widest - 0.55).abs() > 5e-3, "{widest}");
    close(narrowest, 0.79, 5e-3);
    assert!(width(widest) > width(narrowest) + 0.01);
}

/// Printed about 1.2; comes out between 1.20 and 1.25.
#[test]
fn f06() {
    // The smallest width of the stick-slip region; it opens from the corner at r = 0.
    let narrowest = |mu: f64| {
        let system = with_stiction("m1 - base", "base", mu);
        (100..2000)
            .map(|i| 1e-3 * f64::from(i))
            .map(|r| sliding_limit(&system, r) - limit(&system, r))
            .fold(f64::INFINITY, f64::min)
    };
    assert!(narrowest(1.20) > 0.0 && narrowest(1.25) < 0.0);
    let start = root(narrowest, 1.20, 1.25);
    println!("the limits start to intersect at mu = {start}");
}

/// Printed 1.504; comes out as 1.506310 for every β.
#[test]
fn f07() {
    let system = base();
    for (one, other) in [(0.1, 0.5), (0.1, 1.4), (0.7, 1.2)] {
        let invariant = root(
            |r| fundamental(&system, "m1", r, one) - fundamental(&system, "m1", r, other),
            1.48,
            1.55,
        );
        close(invariant, 1.506310, 5e-7);
    }
}

/// Printed 1.4 to 1.55.
#[test]
fn f08() {
    let system = base();
    let betas = [0.05, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4];
    let (mut first, mut last) = (f64::INFINITY, 0.0_f64);
    for (i, one) in betas.iter().enumerate() {
        for other in &betas[..i] {
            let difference =
                |r| amplitude(&system, "m1", r, *one) - amplitude(&system, "m1", r, *other);
            // From where the larger β begins to slide all the time, up to beyond the inversion.
            let begin = if limit(&system, 1.35) > *one {
                1.35
            } else {
                root(|r| limit(&system, r) - one, 1.35, 2.0) + 1e-9
            };
            let inversion = root(difference, begin, 1.7);
            first = first.min(inversion);
            last = last.max(inversion);
        }
    }
    println!("exact amplitudes cross between r = {first} and r = {last}");
    assert!(1.4 < first && last < 1.55);
    assert!(last - first > 0.01, "a region, not a point");
}

/// Printed: yes.
#[test]
fn f10() {
    let system = with_stiction("m1 - base", "base", 1.5);
    let begin = 1.5_f64.sqrt();
    close(sliding_limit(&system, begin), 1.0, ROUNDING);
    close(limit(&system, begin), 1.024, 5e-4);
    let regime = |r: f64| system.at(r).unwrap().regime(1.0).unwrap();
    assert_eq!(regime(begin - 1e-9), Regime::Stuck);
    assert_eq!(regime(begin + 1e-9), Regime::Continuous);
    // With μ = 1 there is stick-slip between.
    let regime = |r: f64| base().at(r).unwrap().regime(1.0).unwrap();
    assert_eq!(regime(1.0 + 1e-9), Regime::StickSlip);
}

/// Printed 1/3, the limit at r = 1/2.
#[test]
fn f11() {
    close(limit(&wall(), 0.5), 1.0 / 3.0, ROUNDING);
}

/// Printed 0.083, the limit at r = 1/2: 1/12.
#[test]
fn f12() {
    close(limit(&base(), 0.5), 0.083, 5e-4);
    close(limit(&base(), 0.5), 1.0 / 12.0, ROUNDING);
}

/// Printed 0.334 to 0.604; the upper end comes out as 0.605258, the lower is the pole at 1/3.
#[test]
fn f13() {
    let system = wall();
    let growth = |r: f64| {
        // Both β inside the continuous region; what is compared is exact for any pair.
        let beta = 0.9 * limit(&system, r);
        fundamental(&system, "m1", r, beta) - fundamental(&system, "m1", r, 0.5 * beta)
    };
    close(root(growth, 0.55, 0.65), 0.605258, 5e-7);
    // Below 1/3 the pole of U has the other sign.
    assert!(growth(1.0 / 3.0 - 1e-6) < 0.0 && growth(1.0 / 3.0 + 1e-6) > 0.0);
    for i in 1..27 {
        let r = 1.0 / 3.0 + 0.01 * f64::from(i);
        assert!(growth(r) > 0.0, "at {r}");
    }
    assert!(growth(0.61) < 0.0 && growth(0.7) < 0.0);
}

/// (7.61) and (7.62), both for small ζ; computed here and stated beside the exact values.
#[test]
fn f29() {
    let damped = |zeta: f64| {
        let rest = format!("damping: modal({zeta:?}),");
        chain(&[1.0], &[1.0], "m1 - wall", "m1", &rest)
    };
    // ζ, β, peak by (7.61), exact amplitude at r = 1, threshold by (7.62), β_lim at r = 1.
    for (zeta, beta, peak, threshold, exact_threshold) in [
        (0.01, 0.3, 30.8998, 0.7853, 0.7732),
        (0.1, 0.3, 3.0745, 0.7790, 0.6720),
    ] {
        let system = damped(zeta);
        let (sinh, cosh) = ((zeta * PI).sinh(), (zeta * PI).cosh());
        let estimate = system.resonant_peak_estimate(0, 0, beta).unwrap();
        close(
            estimate,
            0.5 / zeta - beta * sinh / (cosh - 1.0),
            1e-12 / zeta,
        );
        close(estimate, peak, 5e-5);
        let exact = amplitude(&system, "m1", 1.0, beta);
        println!("zeta = {zeta}: (7.61) {estimate}, exact {exact}");
        // What the estimate leaves out is of the order ζ.
        close(estimate / exact, 1.0, zeta);
        close((cosh - 1.0) / (2.0 * zeta * sinh), threshold, 5e-5);
        close(limit(&system, 1.0), exact_threshold, 5e-5);
    }
}

/// Printed f_n = 3.086 Hz.
#[test]
fn f31() {
    // Only √(k/m) is printed; any mass will do.
    let (mass, omega) = (3.25, TAU * 3.086);
    let stiffness = mass * omega * omega;
    let system = chain(&[mass], &[stiffness], "m1 - wall", "base", "");
    close(system.natural_frequencies()[0] / TAU, 3.086, 1e-14);
    close(system.frequency_ratio(omega), 1.0, ROUNDING);
    // Twice that frequency is r = 2, whose amplitude without friction is (4.1).
    let r = system.frequency_ratio(2.0 * omega);
    let free = ask(&system, r, 0.0, |motion| {
        motion.mass("m1").unwrap().amplitude()
    });
    close(free, 1.0 / 3.0, ROUNDING);
}
