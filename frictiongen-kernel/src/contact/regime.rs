//! The regime between the two limits, and the ends of both arguments' ranges.

use crate::errors::{OutOfDomain, Regime};
use crate::number::scalar::{Float, Scalar};

/// r, checked: NaN and negative values are out of the domain, 0 and ∞ are not.
#[inline]
pub fn check_ratio<S: Float>(value: S, argument: &'static str) -> Result<S, OutOfDomain> {
    if value >= S::constant(0.0) {
        Ok(value)
    } else {
        Err(OutOfDomain { argument })
    }
}

/// How far a natural frequency may be from 1 before the range of r gives way to it.
const ROOM: f64 = 1024.0;

/// The smallest and the largest 1/r at which a chain with these resonances is evaluated: those of the
/// scalar, and less where a resonance is so far from 1 that the square of √λ/r would overflow or vanish.
pub fn inverse_ratio_range<S: Float>(resonances: impl Iterator<Item = S>) -> (S, S) {
    let (low, high) = S::inverse_ratio_range();
    let (mut smallest, mut largest) = (1.0 / ROOM, ROOM);
    for resonance in resonances {
        let resonance = resonance.to_f64();
        smallest = Scalar::min(smallest, resonance);
        largest = Scalar::max(largest, resonance);
    }
    (
        low * S::constant(1.0 / ROOM / smallest),
        high * S::constant(ROOM / largest),
    )
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

/// The regime of β from which steady states exist: the closed form below β_lim, a stuck state from β*_lim on.
#[inline]
pub fn regime<S: Float>(beta: S, continuous: S, sliding: S) -> Regime {
    regime_of(beta < continuous, beta < sliding)
}

/// The regime of a β that is or is not below β_lim, and is or is not below β*_lim.
#[inline]
pub(crate) fn regime_of(slides_always: bool, slides: bool) -> Regime {
    match (slides_always, slides) {
        (true, true) => Regime::Continuous,
        (false, true) => Regime::StickSlip,
        (false, false) => Regime::Stuck,
        (true, false) => Regime::Bistable,
    }
}

/// Both boundaries at one frequency ratio.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits<S> {
    /// β_lim, exact: below it a motion exists in which the contact slides all the time.
    pub continuous: S,
    /// β*_lim: from it on a stuck state exists.  With μ = 1 the contact then ends stuck whatever the start; with μ > 1
    /// sliding motions may exist as well.
    pub sliding: S,
}

impl<S: Float> Limits<S> {
    /// The regime at β = F/P, without another search.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        Ok(regime(check_beta(beta)?, self.continuous, self.sliding))
    }

    /// β/min(β_lim, β*_lim) − 1, without another search: negative below both limits, where the closed form exists. With
    /// μ = 1 the closed form is the only state there; with μ > 1 stick-slip may exist beside it.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        Ok(margin(check_beta(beta)?, self.continuous, self.sliding))
    }
}

/// Both limits over a slice of frequency ratios, into slices of the same length, by what answers at one of them.
///
/// # Errors
/// [`OutOfDomain`] for a slice of another length, which leaves both as they are, and at the first r that has no answer;
/// what came before it is filled in.
#[inline]
pub fn limits_into<S: Float>(
    rs: &[S],
    continuous: &mut [S],
    sliding: &mut [S],
    limits: impl Fn(S) -> Result<Limits<S>, OutOfDomain>,
) -> Result<(), OutOfDomain> {
    check_rooms(rs.len(), continuous.len(), sliding.len())?;
    for ((r, continuous), sliding) in rs.iter().zip(continuous).zip(sliding) {
        let limits = limits(*r)?;
        (*continuous, *sliding) = (limits.continuous, limits.sliding);
    }
    Ok(())
}

/// Whether what answers go into is as long as the slice of frequency ratios.
#[inline]
pub(crate) fn check_rooms(
    ratios: usize,
    continuous: usize,
    sliding: usize,
) -> Result<(), OutOfDomain> {
    for (room, argument) in [(continuous, "continuous"), (sliding, "sliding")] {
        if room != ratios {
            return Err(OutOfDomain { argument });
        }
    }
    Ok(())
}

/// β/min(β_lim, β*_lim) − 1: negative below both limits, where the closed form exists and
/// with μ = 1 is the only state; 0 where β and the limit both are.
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
