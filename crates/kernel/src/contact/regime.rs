//! Regime of the motion (continuous, stick-slip, stuck or bistable), and checks of the ranges of r and β.

use crate::errors::{Given, OutOfDomain, Regime, Slice};
use crate::number::scalar::{Float, Scalar};

/// Checks a frequency ratio r and returns it. NaN and negative numbers are errors. The numbers 0 and ∞ are allowed.
#[inline]
pub fn check_ratio<S: Float>(r: S) -> Result<S, OutOfDomain> {
    if r >= S::constant(0.0) {
        Ok(r)
    } else {
        Err(OutOfDomain::FrequencyRatio(Given::of(r)))
    }
}

/// Largest factor by which a resonance √λ may differ from 1 before the range of the frequency ratio r becomes smaller.
const ROOM: f64 = 1024.0;

/// Returns the smallest and the largest 1/r at which the code evaluates the formulas of a chain. `resonances` contains
/// √λ of the modes. The range is [`Float::inverse_ratio_range`]. If a √λ is less than 1/1024 or more than 1024, the
/// range is smaller. The square of √λ/r then neither overflows nor underflows.
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

/// Checks a friction ratio β and returns it. NaN, negative and infinite numbers are errors.
#[inline]
pub fn check_beta<S: Float>(beta: S) -> Result<S, OutOfDomain> {
    if beta >= S::constant(0.0) && beta.is_finite() {
        Ok(beta)
    } else {
        Err(OutOfDomain::FrictionRatio(Given::of(beta)))
    }
}

/// Returns the regime at the friction ratio β from the limits `continuous` = β_lim and `sliding` = β*_lim. Continuous
/// motion exists for β < β_lim, and a stuck state for β ≥ β*_lim.
#[inline]
pub fn regime<S: Float>(beta: S, continuous: S, sliding: S) -> Regime {
    regime_of(beta < continuous, beta < sliding)
}

/// Returns the regime at a friction ratio β. The argument `slides_always` is true if β < β_lim, and `slides` is true if
/// β < β*_lim.
#[inline]
pub(crate) fn regime_of(slides_always: bool, slides: bool) -> Regime {
    match (slides_always, slides) {
        (true, true) => Regime::Continuous,
        (false, true) => Regime::StickSlip,
        (false, false) => Regime::Stuck,
        (true, false) => Regime::Bistable,
    }
}

/// Limit of continuous motion β_lim and limit of sliding β*_lim, at one frequency ratio.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits<S> {
    /// Limit β_lim of continuous motion. For β < β_lim a motion exists in which the contact slides all the time.
    pub continuous: S,
    /// Limit β*_lim of sliding. For β ≥ β*_lim a stuck state exists. With μ = 1 the contact then becomes stuck from
    /// every initial state. With μ > 1 sliding motions may also exist.
    pub sliding: S,
}

impl<S: Float> Limits<S> {
    /// Returns the regime at the friction ratio β = F/P, by comparison of β with the stored limits. No search is
    /// needed.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn regime(&self, beta: S) -> Result<Regime, OutOfDomain> {
        Ok(regime(check_beta(beta)?, self.continuous, self.sliding))
    }

    /// Returns the margin β/min(β_lim, β*_lim) − 1 from the stored limits, without a search. The margin is negative if
    /// β is smaller than both limits. A continuous motion then exists, and with μ = 1 it is the only steady state. With
    /// μ > 1 a stick-slip state may coexist.
    ///
    /// # Errors
    /// [`OutOfDomain`] for NaN, negative and infinite β.
    pub fn margin(&self, beta: S) -> Result<S, OutOfDomain> {
        Ok(margin(check_beta(beta)?, self.continuous, self.sliding))
    }
}

/// Computes the limits β_lim and β*_lim at each frequency ratio of a slice, and writes them into two slices of the same
/// length. The closure `limits` computes the limits at one frequency ratio.
///
/// # Errors
/// [`OutOfDomain`] if the length of a result slice differs from the length of the slice of frequency ratios. The
/// function then changes no result slice. At the first r for which `limits` fails, the function stops and returns the
/// error of `limits`. The result slices then contain the limits for all earlier frequency ratios.
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

/// Checks that both result slices have as many elements as the slice of frequency ratios.
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

/// Returns the margin β/min(β_lim, β*_lim) − 1. The margin is negative if β is smaller than both limits. A continuous
/// motion then exists, and with μ = 1 it is the only steady state. The margin is 0 if β equals the lower limit, even if
/// β and this limit are 0.
#[inline]
pub fn margin<S: Float>(beta: S, continuous: S, sliding: S) -> S {
    let limit = continuous.min(sliding);
    if beta == limit {
        S::constant(0.0)
    } else {
        beta / limit - S::constant(1.0)
    }
}

/// Returns `limit` for a finite r > 0, `at_rest` for r = 0, and `at_infinity` for r = ∞. The modal sums are not defined
/// at r = 0 and r = ∞. The caller therefore passes the limiting values `at_rest` and `at_infinity`.
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
