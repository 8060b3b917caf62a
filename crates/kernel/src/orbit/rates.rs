//! Finds the largest velocity and the largest acceleration within a segment of a steady motion.
//!
//! The search evaluates sixteen instants in half a turn of the fastest oscillation, and refines every local maximum of
//! these samples. The search can miss a maximum only if another maximum lies within one sampling step. Two maxima so
//! close together differ by less than a thousandth of their value.

use crate::motion::OscillatorSum;
use crate::number::scalar::Float;

/// Number of samples in half a turn of the fastest oscillation.
const PLACES: f64 = 16.0;
/// Smallest number of samples in a segment.
const FEWEST: f64 = 8.0;
/// Largest number of samples in a segment.
const MOST: f64 = 4096.0;
/// Number of steps of a golden-section search. Each step reduces the interval to 0.62 of its length. After the last
/// step, the interval is as short as a rounding error.
const STEPS: usize = 40;

/// Returns the largest |f′(τ)| for τ from 0 to `sum.reach`. The function f(τ) is the given sum over oscillators.
pub(super) fn largest_slope<S: Float>(sum: &OscillatorSum<'_, S>) -> S {
    largest(sum, |tau| sum.local(tau).slope.abs())
}

/// Returns the largest |f″(τ)| for τ from 0 to `sum.reach`. The function f(τ) is the given sum over oscillators.
pub(super) fn largest_curve<S: Float>(sum: &OscillatorSum<'_, S>) -> S {
    largest(sum, |tau| sum.local(tau).curve.abs())
}

/// Returns the largest value of the function `size` of τ, for τ from 0 to `sum.reach`.
fn largest<S: Float>(sum: &OscillatorSum<'_, S>, size: impl Fn(S) -> S) -> S {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let wanted = sum.rate * sum.reach * S::inverse_pi() * S::constant(PLACES);
    let places = -(-wanted.max(S::constant(FEWEST)).min(S::constant(MOST))).floor();
    let step = sum.reach / places;
    let (mut before, mut here) = (zero, size(zero));
    let mut best = here;
    // A maximum next to an end of the segment does not lie between three samples. The code therefore searches the first
    // and the last sampling step separately.
    for from in [zero, sum.reach - step] {
        best = best.max(summit(from, from + step, &size));
    }
    let mut place = one;
    while place <= places {
        let next = size(step * place);
        best = best.max(next);
        if before <= here && next <= here && one < place {
            best = best.max(summit(step * (place - one - one), step * place, &size));
        }
        (before, here) = (here, next);
        place = place + one;
    }
    best
}

/// Returns the largest value of the function `size` between the instants `low` and `high`, by golden-section search.
fn summit<S: Float>(mut low: S, mut high: S, size: &impl Fn(S) -> S) -> S {
    let golden = S::constant(0.618_033_988_749_894_8);
    let (mut a, mut b) = (high - (high - low) * golden, low + (high - low) * golden);
    let (mut at_a, mut at_b) = (size(a), size(b));
    for _ in 0..STEPS {
        if at_a < at_b {
            (low, a, at_a) = (a, b, at_b);
            b = low + (high - low) * golden;
            at_b = size(b);
        } else {
            (high, b, at_b) = (b, a, at_a);
            a = high - (high - low) * golden;
            at_a = size(a);
        }
    }
    at_a.max(at_b)
}
