//! Sums over the few coefficients of an input. The code contains no loops for them, because on a microcontroller a loop
//! would cost more than the sum.

use crate::number::scalar::Float;

/// Returns `start` + Σ a·b. The function first sums the products a·b, and then adds `start`. If an input changes its
/// sign within a sub-interval, the products cancel. If the sum began with `start`, its rounding errors could then
/// exceed Σ a·b.
#[inline(always)]
pub(super) fn dot<S: Float, const D: usize>(start: S, a: &[S; D], b: &[S; D]) -> S {
    match (a.as_slice(), b.as_slice()) {
        ([a0], [b0]) => start + *a0 * *b0,
        ([a0, a1], [b0, b1]) => start + (*a0 * *b0 + *a1 * *b1),
        ([a0, a1, a2, a3], [b0, b1, b2, b3]) => {
            start + (*a0 * *b0 + *a1 * *b1 + *a2 * *b2 + *a3 * *b3)
        }
        (a, b) => {
            let pairs = a.iter().zip(b);
            pairs.fold(start, |sum, (a, b)| sum + *a * *b)
        }
    }
}

/// Adds `factor` times the coefficients `terms` to the coefficients `sum`.
#[inline(always)]
pub(super) fn add<S: Float, const D: usize>(sum: &mut [S; D], factor: S, terms: &[S; D]) {
    match (sum.as_mut_slice(), terms.as_slice()) {
        ([s0], [t0]) => *s0 = *s0 + factor * *t0,
        ([s0, s1], [t0, t1]) => {
            *s0 = *s0 + factor * *t0;
            *s1 = *s1 + factor * *t1;
        }
        ([s0, s1, s2, s3], [t0, t1, t2, t3]) => {
            *s0 = *s0 + factor * *t0;
            *s1 = *s1 + factor * *t1;
            *s2 = *s2 + factor * *t2;
            *s3 = *s3 + factor * *t3;
        }
        (sum, terms) => {
            for (sum, term) in sum.iter_mut().zip(terms) {
                *sum = *sum + factor * *term;
            }
        }
    }
}

/// Returns upper bounds on the absolute values of a drive polynomial and of its derivative in a sub-interval.
#[inline(always)]
pub(super) fn sizes<S: Float, const D: usize>(drive: &[S; D]) -> (S, S) {
    let (two, three) = (S::constant(2.0), S::constant(3.0));
    match drive.as_slice() {
        [a] => (a.abs(), S::constant(0.0)),
        [a, b] => (a.abs() + b.abs(), b.abs()),
        [a, b, c, d] => {
            let (b, c, d) = (b.abs(), c.abs(), d.abs());
            (a.abs() + b + c + d, b + two * c + three * d)
        }
        drive => {
            let (mut total, mut change) = (S::constant(0.0), S::constant(0.0));
            let mut order = S::constant(0.0);
            for term in drive {
                total = total + term.abs();
                change = change + order * term.abs();
                order = order + S::constant(1.0);
            }
            (total, change)
        }
    }
}

/// Computes the moments ∫ sʲ y′ ds of an oscillator for j ≥ 1. y′ is the velocity of the oscillator, and s is the time
/// since the start of the sub-interval. `rows` contains one row of the constant table for each moment.
#[inline(always)]
pub(super) fn later<S, R, const D: usize>(
    moments: &mut [S; D],
    rows: &[R; D],
    of: impl Fn(&R) -> S,
) {
    match (moments.as_mut_slice(), rows.as_slice()) {
        ([_, m1], [_, r1]) => *m1 = of(r1),
        ([_, m1, m2, m3], [_, r1, r2, r3]) => {
            *m1 = of(r1);
            *m2 = of(r2);
            *m3 = of(r3);
        }
        (moments, rows) => {
            for (moment, row) in moments.iter_mut().zip(rows).skip(1) {
                *moment = of(row);
            }
        }
    }
}
