//! The regime between the two limits, and the ends of both arguments' ranges.

use crate::errors::{OutOfDomain, Regime};
use crate::scalar::Float;

/// r, checked: NaN and negative values are out of the domain, 0 and ∞ are not.
#[inline]
pub fn check_ratio<S: Float>(value: S, argument: &'static str) -> Result<S, OutOfDomain> {
    if value >= S::constant(0.0) {
        Ok(value)
    } else {
        Err(OutOfDomain { argument })
    }
}

/// β, checked: NaN, negative and infinite values are out of the domain.
#[inline]
pub fn check_beta<S: Float>(beta: S) -> Result<S, OutOfDomain> {
    if beta >= S::constant(0.0) && beta.is_finite() {
        Ok(beta)
    } else {
        Err(OutOfDomain { argument: "beta" })
    }
}

/// The regime of β between the two limits.
#[inline]
pub fn regime<S: Float>(beta: S, continuous: S, sliding: S) -> Regime {
    if !(beta < sliding) {
        Regime::Stuck
    } else if beta < continuous {
        Regime::Continuous
    } else {
        Regime::StickSlip
    }
}

/// β/min(β_lim, β*_lim) − 1: negative in the continuous regime; 0 where β and the limit both are.
#[inline]
pub fn margin<S: Float>(beta: S, continuous: S, sliding: S) -> S {
    let limit = continuous.min(sliding);
    if beta == limit {
        S::constant(0.0)
    } else {
        beta / limit - S::constant(1.0)
    }
}

/// A limit with its values at r = 0 and r = ∞, where the sums themselves have none.
#[inline]
pub fn with_ends<S: Float>(r: S, limit: S, at_rest: S, at_infinity: S) -> S {
    if r == S::constant(0.0) {
        at_rest
    } else if r.is_finite() {
        limit
    } else {
        at_infinity
    }
}
