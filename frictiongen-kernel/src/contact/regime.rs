//! Determines the regime from both limits, and checks the ranges of r and β.

use crate::errors::{Given, OutOfDomain, Regime, Slice};
use crate::number::scalar::{Float, Scalar};

/// Checks r: NaN and negative values are outside the domain, 0 and ∞ are not.
#[inline]
pub fn check_ratio<S: Float>(r: S) -> Result<S, OutOfDomain> {
    if r >= S::constant(0.0) {
        Ok(r)
    } else {
        Err(OutOfDomain::FrequencyRatio(Given::of(r)))
    }
}

/// Largest ratio between a resonance and 1 for which the range of r needs no reduction.
const ROOM: f64 = 1024.0;

/// Returns the smallest and the largest 1/r at which the formulas of a chain are evaluated. `resonances` are √λ of the
/// modes. The range is [`Float::inverse_ratio_range`]. If a √λ is below 1/1024 or above 1024, the range is smaller, so
/// that the square of √λ/r neither overflows nor underflows.
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

/// Checks β: NaN, negative and infinite values are outside the domain.
#[inline]
pub fn check_beta<S: Float>(beta: S) -> Result<S, OutOfDomain> {
    if beta >= S::constant(0.0) && beta.is_finite() {
        Ok(beta)
    } else {
        Err(OutOfDomain::FrictionRatio(Given::of(beta)))
    }
}

/// Returns the regime of β. The closed form exists below β_lim, a stuck state from β*_lim on.
#[inline]
pub fn regime<S: Float>(beta: S, continuous: S, sliding: S) -> Regime {
    regime_of(beta < continuous, beta < sliding)
}

/// Returns the regime of a β that is below β_lim if `slides_always`, and below β*_lim if `slides`.
#[inline]
pub(crate) fn regime_of(slides_always: bool, slides: bool) -> Regime {
    match (slides_always, slides) {
        (true, true) => Regime::Continuous,
        (false, true) => Regime::StickSlip,
        (false, false) => Regime::Stuck,
        (true, false) => Regime::Bistable,
    }
}

/// Both limits at one frequency ratio.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits<S> {
    /// β_lim. Below it a motion exists in which the contact slides all the time.
    pub continuous: S,
    /// β*_lim. From it on a stuck state exists. With μ = 1 the contact then becomes stuck from every start. With μ > 1
    /// sliding motions may exist as well.
    pub sliding: S,
}

impl<S: Float> Limits<S> {
    /// Returns the regime at β = F/P, without another search.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        Ok(regime(check_beta(beta)?, self.continuous, self.sliding))
    }

    /// Returns β/min(β_lim, β*_lim) − 1, without another search. It is negative below both limits, where the closed
    /// form exists. With μ = 1 the closed form is the only steady state there. With μ > 1 a stick-slip state may
    /// coexist.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        Ok(margin(check_beta(beta)?, self.continuous, self.sliding))
    }
}

/// Computes both limits over a slice of frequency ratios, into slices of the same length. The argument `limits`
/// computes them at one frequency ratio.
///
/// # Errors
/// [`OutOfDomain`] for a slice of another length, which leaves both slices unchanged, and at the first r for which
/// `limits` fails. The values before that r are filled in.
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

/// Checks that both result slices are as long as the slice of frequency ratios.
#[inline]
pub(crate) fn check_rooms(
    ratios: usize,
    continuous: usize,
    sliding: usize,
) -> Result<(), OutOfDomain> {
    for (room, slice) in [(continuous, Slice::Continuous), (sliding, Slice::Sliding)] {
        if room != ratios {
            return Err(OutOfDomain::Length(slice));
        }
    }
    Ok(())
}

/// Returns β/min(β_lim, β*_lim) − 1. It is negative below both limits. There the closed form exists, and with μ = 1 it
/// is the only steady state. It is 0 where β equals the lower limit, also if both are 0.
#[inline]
pub fn margin<S: Float>(beta: S, continuous: S, sliding: S) -> S {
    let limit = continuous.min(sliding);
    if beta == limit {
        S::constant(0.0)
    } else {
        beta / limit - S::constant(1.0)
    }
}

/// Returns a limit, with its values at r = 0 and r = ∞, where the sums themselves have none.
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
