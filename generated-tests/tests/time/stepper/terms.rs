//! Tests the number of terms of a power series. The sum of the neglected terms bounds the remainder.

use frictiongen_kernel::Float;
use frictiongen_kernel::stepper::series_terms;

/// Asserts that the neglected terms x^n/n! add up to less than a rounding unit.
fn ends<S: Float>(epsilon: f64) {
    for tenth in 1..=10 {
        let rate = 0.1 * f64::from(tenth);
        let terms = series_terms::<S>(S::constant(rate), epsilon);
        let term = |n: u32| (1..=n).fold(1.0, |term, k| term * rate / f64::from(k));
        let left: f64 = (terms..terms + 20).map(term).sum();
        // The first neglected term is at most a sixteenth of a rounding unit. Each later term is less than a fifth of
        // the previous term.
        assert!(left < epsilon / 12.0, "{rate}: {left:e} after {terms}");
        // One term less would not be enough.
        assert!(epsilon / 16.0 < term(terms - 1), "{rate}: {terms}");
    }
}

#[test]
fn a_series_ends_below_a_rounding() {
    ends::<f64>(f64::EPSILON);
    ends::<f32>(f64::from(f32::EPSILON));
}
