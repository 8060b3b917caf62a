//! Coefficients of the Euler polynomials of even order, e_n(τ) = πⁿE_n(τ/π)/n!, as polynomials in w = τ(π − τ).
//!
//! The polynomials describe the motion of a free mass under a unit force that changes its sign every half period. The
//! module `modal_sum::mass_controlled` uses them.

/// Number of Euler polynomials of even order that the code sums in `f64`. `SINGLE` is the number for `f32`. The sum
/// contains the orders n up to 2·`DOUBLE`. With each order, even or odd, the third harmonic of the neglected remainder
/// becomes at least six times smaller. (1/6)^(2·`DOUBLE`) is smaller than the rounding error.
const DOUBLE: usize = 11;
const SINGLE: usize = 5;

/// Coefficients of the Euler polynomials e_2m in `f64`, for m = 1, 2, …. For each m the coefficients are listed from
/// the power wᵐ down to w¹, with w = τ(π − τ).
pub(crate) const DOUBLE_TERMS: [f64; terms(DOUBLE)] = coefficients();
/// Coefficients of the Euler polynomials e_2m in `f32`, rounded from [`DOUBLE_TERMS`].
pub(crate) const SINGLE_TERMS: [f32; terms(SINGLE)] = rounded(coefficients());

const fn terms(orders: usize) -> usize {
    orders * (orders + 1) / 2
}

/// Computes the coefficients of each Euler polynomial e_n from those of e_(n−2), because e_(n−2) is the second
/// derivative of e_n. The recurrence runs from the highest power of w = τ(π − τ) down to the lowest. In this order no
/// terms cancel.
#[allow(clippy::indexing_slicing, reason = "at compile time")]
const fn coefficients<const N: usize>() -> [f64; N] {
    const SQUARE: f64 = core::f64::consts::PI * core::f64::consts::PI;
    let mut out = [0.0; N];
    out[0] = -0.5;
    let (mut order, mut row, mut before) = (2, 1, 0);
    while row < N {
        let mut power = order;
        while power > 0 {
            let at = row + order - power;
            // `lower` is the coefficient of w^(power−1) in e_2m−2, and `higher` is the coefficient of w^(power+1) in
            // e_2m.
            let lower = if power > 1 {
                out[before + order - power]
            } else {
                0.0
            };
            let higher = if power < order { out[at - 1] } else { 0.0 };
            let k = power as f64;
            out[at] = (k * (k + 1.0) * SQUARE * higher - lower) / (2.0 * k * (2.0 * k - 1.0));
            power -= 1;
        }
        (before, row) = (row, row + order);
        order += 1;
    }
    out
}

#[allow(clippy::indexing_slicing, reason = "at compile time")]
#[allow(clippy::cast_possible_truncation, reason = "rounding is meant")]
const fn rounded<const N: usize>(exact: [f64; N]) -> [f32; N] {
    let mut out = [0.0; N];
    let mut index = 0;
    while index < N {
        out[index] = exact[index] as f32;
        index += 1;
    }
    out
}
