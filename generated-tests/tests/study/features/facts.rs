//! Tests the numbers of the facts F01 to F32 that are features of a scene. The expected numbers follow from the
//! governing equations in extended precision.

use crate::features::scenes::{base, chain, unit, wall};
use frictiongen::study::{
    System,
    features::{Certainty, Condition, Edge, InvariantPoint, InvariantQuantity, RegimeEnd},
};
use frictiongen::{Of, Regime};
use std::f64::consts::{FRAC_PI_4, PI, SQRT_2};

const M1: Of = Of::Mass(0);
const M2: Of = Of::Mass(1);
/// Tolerance of numbers that the reference gives with six digits.
const DIGITS: f64 = 1e-6;
/// Tolerance of a closed form that has a few rounding errors.
const ROUNDING: f64 = 1e-14;

fn close(value: f64, want: f64, tolerance: f64) {
    assert!(
        (value - want).abs() <= tolerance * want.abs(),
        "{value} instead of {want}"
    );
}

fn all_close(values: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(values.len(), wanted.len(), "{values:?} {wanted:?}");
    for (value, want) in values.iter().zip(wanted) {
        close(*value, *want, tolerance);
    }
}

fn thresholds(system: &System) -> Vec<f64> {
    let resonances = system.features(None).unwrap().resonances();
    let each = resonances.into_iter();
    each.map(|resonance| resonance.threshold.unwrap().value)
        .collect()
}

fn points(
    system: &System,
    of: Of,
    measured: InvariantQuantity,
    range: [f64; 2],
) -> Vec<InvariantPoint> {
    let features = system.features(None).unwrap();
    features.invariant_points(of, measured, range).unwrap()
}

fn places(system: &System, of: Of, measured: InvariantQuantity, range: [f64; 2]) -> Vec<f64> {
    let points = points(system, of, measured, range);
    points.iter().map(|point| point.r).collect()
}

#[test]
fn f01_f02_one_mass() {
    let system = wall("");
    all_close(&thresholds(&system), &[FRAC_PI_4], ROUNDING);
    let resonance = system.features(None).unwrap().resonances().remove(0);
    close(resonance.continuous_limit, FRAC_PI_4, ROUNDING);
    for (mu, want) in [(1.0, 0.537029), (1.5, 0.460414)] {
        let system = wall(&format!("stiction: {mu:?}"));
        let ends = system.features(None).unwrap().limits_at_infinity();
        close(ends.continuous.value, want, DIGITS);
        close(ends.sliding.value, 1.0 / mu, ROUNDING);
    }
}

/// Checks that with β*_lim = r²/μ the contact slides from r = √(μβ) on.
#[test]
fn f04_sliding_from() {
    for mu in [1.0, 1.2, 2.0] {
        let system = base(mu);
        let features = system.features(None).unwrap();
        let ranges = features.sliding_ranges(0.7, [0.1, 3.0]).unwrap();
        assert_eq!(ranges.len(), 1);
        close(ranges[0].from, (mu * 0.7).sqrt(), ROUNDING);
        assert_eq!(ranges[0].to, 3.0);
    }
}

#[test]
fn f07_moving_base() {
    let system = base(1.0);
    let found = points(&system, M1, InvariantQuantity::Fundamental, [0.52, 3.0]);
    let last = found.last().unwrap();
    close(last.r, 1.506310, DIGITS);
    assert_eq!(last.condition, Condition::Balance);
}

/// Checks that the exact amplitudes at two friction ratios cross between r = 1.4 and 1.55.
#[test]
fn f08_exact_amplitudes() {
    let system = base(1.0);
    let features = system.features(None).unwrap();
    let betas = [0.05, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4];
    let (mut first, mut last, mut seen) = (f64::INFINITY, 0.0_f64, 0);
    for (i, more) in betas.iter().enumerate() {
        for less in &betas[..i] {
            let found = features.crossings(M1, [*less, *more], [1.3, 1.7]).unwrap();
            assert_eq!(found.len(), 1, "{less} {more}");
            assert!(found[0].amplitude < 1.0);
            (first, last) = (first.min(found[0].r), last.max(found[0].r));
            seen += 1;
        }
    }
    assert_eq!(seen, 28);
    close(first, 1.4316, 5e-5);
    close(last, 1.5423, 5e-5);
}

/// Checks that at β = 1, μ = 1.5 the regime changes from stuck directly to continuous at r = √1.5.
#[test]
fn f10_without_stick_slip() {
    let system = base(1.5);
    let features = system.features(None).unwrap();
    let (ranges, certainty) = features.regimes(1.0, [0.6, 1.4]).unwrap();
    assert_eq!(certainty, Certainty::Proven);
    let regimes: Vec<Regime> = ranges.iter().map(|range| range.regime).collect();
    assert_eq!(
        regimes,
        [Regime::Stuck, Regime::Bistable, Regime::Continuous]
    );
    close(ranges[1].to, 1.5_f64.sqrt(), ROUNDING);
    assert!(matches!(ranges[1].end, RegimeEnd::Sliding(_)));
    assert!(matches!(ranges[0].end, RegimeEnd::Continuous(_)));
    // With μ = 1 a stick-slip range lies between the stuck and the continuous range. At the resonance β*_lim equals β,
    // because V − βH has no pole at the resonance.
    let system = base(1.0);
    let features = system.features(None).unwrap();
    let (ranges, _) = features.regimes(1.0, [0.6, 1.4]).unwrap();
    let regimes: Vec<Regime> = ranges.iter().map(|range| range.regime).collect();
    assert_eq!(
        regimes,
        [Regime::Stuck, Regime::StickSlip, Regime::Continuous]
    );
    close(ranges[0].to, 1.0, ROUNDING);
}

/// Checks the range in which friction enlarges the fundamental. It extends from the pole of U at r = 1/3 to the r at
/// which U = −(2/π)V.
#[test]
fn f13_inversion_of_the_fundamental() {
    let system = wall("");
    let features = system.features(None).unwrap();
    let found = features
        .inversions(Of::Contact, InvariantQuantity::Fundamental, [0.3, 2.0])
        .unwrap();
    assert_eq!(found.len(), 1);
    close(found[0].from, 1.0 / 3.0, ROUNDING);
    close(found[0].to, 0.605258, DIGITS);
    assert_eq!(
        (found[0].from_edge, found[0].to_edge),
        (Edge::Pole, Edge::Invariant)
    );
}

#[test]
fn f14_f15_f16_three_masses() {
    let system = unit(3, "m2 - wall", "m1");
    all_close(&thresholds(&system), &[0.435863, 1.76477, 0.62984], 5e-6);
    let features = system.features(None).unwrap();
    for beta in [0.1, 0.3, 0.49] {
        let start = features.quasi_static_start(beta).unwrap().unwrap();
        let start: Vec<f64> = start.into_iter().map(|start| start.value).collect();
        let two = 1.0 - 2.0 * beta;
        all_close(&start, &[1.0 - beta, two, two], 1e-13);
    }
    assert!(features.quasi_static_start(0.5).unwrap().is_none());
    close(features.limits_at_rest().sliding.value, 0.5, ROUNDING);
    // The stuck chain consists of two separate parts: one mass between two springs, and m₃.
    let held: Vec<f64> = features
        .held_resonances()
        .iter()
        .map(|held| held.r)
        .collect();
    all_close(&held, &[1.0, SQRT_2], ROUNDING);
    for beta in [0.6_f64, 0.8, 1.0, 2.0, 50.0] {
        let ranges = features.sliding_ranges(beta, [0.05, 4.0]).unwrap();
        assert_eq!(ranges.len(), 1, "{beta}");
        close(ranges[0].from, ((2.0 * beta - 1.0) / beta).sqrt(), ROUNDING);
        close(ranges[0].to, ((2.0 * beta + 1.0) / beta).sqrt(), ROUNDING);
    }
    // For β below 1/2 the lower bound of the range is r = 0.
    let ranges = features.sliding_ranges(0.4, [0.05, 4.0]).unwrap();
    assert!(ranges[0].from_frequency.is_none() && ranges[0].to_frequency.is_some());
}

#[test]
fn f17_f18_contact_below() {
    let system = unit(2, "m1 - wall", "m1");
    let root = 5_f64.sqrt();
    for of in [Of::Contact, M1] {
        let found = places(&system, of, InvariantQuantity::Amplitude, [0.5, 4.0]);
        all_close(&found, &[0.25 * root, 0.5 * root], ROUNDING);
    }
    let features = system.features(None).unwrap();
    let found = features
        .inversions(M2, InvariantQuantity::Amplitude, [0.5, 4.0])
        .unwrap();
    // At r = 1 the contact does not move without friction, so it slides for no β.
    let ends: Vec<f64> = found
        .iter()
        .flat_map(|found| [found.from, found.to])
        .collect();
    close(ends[ends.len() - 2], 1.0, ROUNDING);
    close(ends[ends.len() - 1], 1.20079, 5e-6);
    assert_eq!(found.last().unwrap().from_edge, Edge::Still);
    close(ends[ends.len() - 4], 0.527585, DIGITS);
    close(ends[ends.len() - 3], 0.575595, DIGITS);
    let still = features.antiresonances(Of::Contact, [0.5, 4.0]).unwrap();
    assert_eq!(still.len(), 1);
    close(still[0].r, 1.0, ROUNDING);
}

#[test]
fn f19_f20_regimes() {
    let system = unit(2, "m1 - wall", "m1");
    let features = system.features(None).unwrap();
    let (ranges, _) = features.regimes(0.2, [0.34, 0.56]).unwrap();
    let continuous: Vec<_> = ranges
        .iter()
        .filter(|range| range.regime == Regime::Continuous)
        .collect();
    assert_eq!(continuous.len(), 2, "{ranges:?}");
    close(continuous[0].from, 0.3784, 1e-4);
    close(continuous[0].to, 0.5237, 1e-4);
    let (ranges, _) = features.regimes(0.4, [0.53, 0.9]).unwrap();
    assert_eq!(ranges.len(), 3);
    assert_eq!(ranges[1].regime, Regime::Continuous);
    close(ranges[1].from, 0.55875, 5e-6 / 0.55875);
}

#[test]
fn f21_to_f25_contact_above() {
    let system = unit(2, "m2 - wall", "m1");
    all_close(&thresholds(&system), &[0.485403, 1.2708], 5e-6);
    let found = points(&system, M2, InvariantQuantity::Amplitude, [0.62, 4.0]);
    assert_eq!(found.len(), 1);
    close(found[0].r, 1.44981, 5e-6);
    assert!(found[0].phase_too);
    let found = places(&system, M1, InvariantQuantity::Amplitude, [0.7, 4.0]);
    let tail = &found[found.len() - 2..];
    all_close(tail, &[0.828219, 1.54936], 5e-6);
    let found = points(&system, M2, InvariantQuantity::Fundamental, [1.0, 4.0]);
    let own = found
        .iter()
        .find(|point| point.condition == Condition::Receptance);
    close(own.unwrap().r, SQRT_2, ROUNDING);
    close(own.unwrap().amplitude, 1.0, ROUNDING);
    for kappa in [1.0, 0.2, 3.5] {
        let system = chain(&[1.0; 2], &[1.0, kappa], "m2 - wall", "m1", "");
        let held = system.features(None).unwrap().held_resonances();
        assert_eq!(held.len(), 1);
        close(held[0].r, (1.0 + kappa).sqrt(), ROUNDING);
        assert_eq!(held[0].sliding_limit, f64::INFINITY);
    }
}

#[test]
fn f27_f28_between_two_masses() {
    let system = chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "");
    all_close(&thresholds(&system), &[0.785398, 0.392699], DIGITS);
    let features = system.features(None).unwrap();
    let ends = features.limits_at_infinity();
    close(ends.continuous.value, 0.17901, 5e-5);
    close(ends.sliding.value, 1.0 / 3.0, ROUNDING);
    let found = places(&system, M1, InvariantQuantity::Amplitude, [0.71, 4.0]);
    all_close(&found[found.len() - 2..], &[0.777873, 1.21352], 5e-6);
    for (pair, first, second) in [
        ([0.01, 0.02], 0.7776, 1.2143),
        ([0.05, 0.2], 0.7755, 1.2199),
        ([0.2, 0.3], 0.7737, 1.2241),
    ] {
        let found = features.crossings(M1, pair, [0.74, 1.25]).unwrap();
        let found: Vec<f64> = found.iter().map(|crossing| crossing.r).collect();
        all_close(&found, &[first, second], 5e-5);
    }
}

#[test]
fn f29_peaks() {
    for (zeta, estimate, peak, limit) in [
        (0.01_f64, 30.8998, 30.9043, 0.7732),
        (0.1, 3.0745, 3.1196, 0.6720),
    ] {
        let system = wall(&format!("damping: modal({zeta:?})"));
        let features = system.features(None).unwrap();
        let found = features.resonant_peaks(M1, 0.3).unwrap();
        let typed = 0.5 / zeta - 0.3 * (zeta * PI).sinh() / ((zeta * PI).cosh() - 1.0);
        close(found[0].estimate.as_ref().unwrap().value, typed, 1e-12);
        close(found[0].estimate.as_ref().unwrap().value, estimate, 5e-5);
        let found = found[0].peak.as_ref().unwrap();
        close(found.amplitude.value, peak, 5e-5);
        assert_eq!(found.regime, Some(Regime::Continuous));
        close(features.resonances()[0].continuous_limit, limit, 1e-4);
        assert!(matches!(
            features.invariant_points(M1, InvariantQuantity::Amplitude, [0.5, 2.0]),
            Err(frictiongen::study::features::FeatureError::Damped)
        ));
    }
}

/// Checks that without friction m₁ does not move at ω₀, and moves with the base at ω_z0.
#[test]
fn f30_f32_rig() {
    let (gamma, kappa) = (0.9772, 1.1119);
    let system = chain(&[1.0, gamma], &[1.0, kappa], "m1 - base", "base", "");
    let features = system.features(None).unwrap();
    let own = (kappa / gamma).sqrt();
    let still = features.antiresonances(M1, [0.1, 4.0]).unwrap();
    assert_eq!(still.len(), 1);
    close(still[0].r, own, ROUNDING);
    let together = features.antiresonances(Of::Contact, [0.1, 4.0]).unwrap();
    assert_eq!(together.len(), 1);
    close(together[0].r, own * (1.0 + gamma).sqrt(), ROUNDING);
    let found = points(
        &system,
        Of::Contact,
        InvariantQuantity::Fundamental,
        [0.9, 1.3],
    );
    let found = found
        .iter()
        .find(|point| point.condition == Condition::Receptance);
    close(found.unwrap().r, own, ROUNDING);
    close(found.unwrap().amplitude, 1.0, ROUNDING);
}
