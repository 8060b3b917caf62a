//! Power series of one quantity over a time interval.

use crate::Float;

/// Number of coefficients of a power series in `f64`. In a time interval of 1.5 rad of the fastest oscillation, the
/// first neglected term is below 1.5²²/22! = 7e-18 of the first term.
pub const TERMS: usize = 22;

/// Returns the number of coefficients that a power series needs in this number type. In `f32`, the first neglected term
/// in a time interval of 1 rad of the fastest oscillation is below 1/12! = 2e-9 of the first term.
pub(super) fn terms_of<S: Float>() -> usize {
    if S::EPSILON < 1e-10 { TERMS } else { 12 }
}

/// Returns the number of coefficients that a power series needs in a time interval of `angle` rad of the fastest
/// oscillation, so that the first neglected term is below a quarter of the rounding unit of an increment. An increment of a
/// mass is at least of the order 2 in time, or of the order `degree` of an input.
pub(super) fn terms_within<S: Float>(angle: S, degree: usize) -> usize {
    let longest = terms_of::<S>();
    let least = S::constant(0.125 * S::EPSILON);
    let mut rest = S::constant(1.0);
    for count in degree + 1..longest {
        rest = rest * angle / S::whole(count);
        if count >= LEAST_TERMS && rest <= least {
            return count;
        }
    }
    longest
}

/// Smallest number of coefficients of a power series. A mass under a load that changes linearly needs four.
const LEAST_TERMS: usize = 5;

/// Returns the largest product, in rad, of the time interval of one power series and an upper bound on the fastest
/// angular frequency.
pub(super) fn angle_of<S: Float>() -> f64 {
    if S::EPSILON < 1e-10 { 1.5 } else { 1.0 }
}

/// Coefficients of the power series of one quantity over a time interval. The variable is the elapsed fraction of the
/// interval, from 0 to 1.
pub type Poly<S> = [S; TERMS];

/// Returns the coefficients of a quantity that is always 0.
pub(super) fn nothing<S: Float>() -> Poly<S> {
    [S::constant(0.0); TERMS]
}

/// Returns the value of the polynomial `terms` at the point `at`. The code sums the even and the odd terms separately,
/// because a processor can compute the two sums at the same time.
pub fn value<S: Float>(terms: &[S], at: S) -> S {
    let (zero, square) = (S::constant(0.0), at * at);
    let (pairs, last) = terms.as_chunks::<2>();
    let last = last.first().copied().unwrap_or(zero);
    let pairs = pairs.iter().rev();
    let (even, odd) = pairs.fold((last, zero), |(even, odd), [first, second]| {
        (even * square + *first, odd * square + *second)
    });
    even + at * odd
}

/// Returns the coefficients of the derivative of the polynomial `terms`.
#[must_use]
pub fn slope<S: Float>(terms: &Poly<S>) -> Poly<S> {
    let mut slope = nothing();
    for (order, (slope, term)) in slope.iter_mut().zip(terms.iter().skip(1)).enumerate() {
        *slope = S::whole(order + 1) * *term;
    }
    slope
}

/// Returns the value and the derivative of the polynomial `terms` at the point `at`.
pub(super) fn value_and_slope<S: Float>(terms: &[S], at: S) -> (S, S) {
    let (zero, square) = (S::constant(0.0), at * at);
    let (pairs, last) = terms.as_chunks::<2>();
    let last = last.first().copied().unwrap_or(zero);
    let start = ((last, zero), (zero, zero));
    let pairs = pairs.iter().rev();
    let (even, odd) = pairs.fold(start, |(even, odd), &[first, second]| {
        let raise = |(sum, slope): (S, S), term| (sum * square + term, slope * square + sum);
        (raise(even, first), raise(odd, second))
    });
    // The slopes in `even` and `odd` are derivatives with respect to the square of the variable.
    let slope = odd.0 + S::constant(2.0) * at * (even.1 + at * odd.1);
    (even.0 + at * odd.0, slope)
}
