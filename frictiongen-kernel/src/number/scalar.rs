//! The scalar trait over which every formula of the project is written once.
//!
//! `f64` and `f32` read the formulas as numbers, [`Dd`](crate::number::dd::Dd) reads them with about 31
//! digits (the accuracy reference), and the expression type of the code generator reads them as
//! Rust source.  A formula must therefore not branch on a scalar: it builds a condition with
//! [`lt`](Scalar::lt) or [`is_zero`](Scalar::is_zero) and picks with [`select`](Scalar::select).

use core::f64::consts::FRAC_PI_4;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Stands for an exact zero of x² − 1, which it is far below in any precision.
pub const NEXT_TO_POLE: f64 = 1.0 / (1u64 << 60) as f64;

/// A number, or something that stands for one, in which the closed forms can be evaluated.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The outcome of a comparison.
    type Condition: Copy;
    /// Whether a mass's motion takes modes far below the excitation by the polynomials of [`Float::euler_terms`].
    const MASS_CONTROLLED: bool = false;

    /// The nearest representable value to `value`.
    fn constant(value: f64) -> Self;
    /// π.
    fn pi() -> Self;
    /// 1/π.
    fn inverse_pi() -> Self;
    /// `self < other`.
    fn lt(self, other: Self) -> Self::Condition;
    /// `self == 0`.
    fn is_zero(self) -> Self::Condition;
    /// `yes` where `condition` holds, else `no`.
    fn select(condition: Self::Condition, yes: Self, no: Self) -> Self;
    /// |self|.
    fn abs(self) -> Self;
    /// Correctly rounded √self (double-double: to its precision).
    fn sqrt(self) -> Self;
    /// The larger of two numbers that are not NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of two numbers that are not NaN.
    fn min(self, other: Self) -> Self;
    /// `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// e^self.
    fn exp(self) -> Self;
    /// e^self − 1, accurate near 0.
    fn exp_m1(self) -> Self;
    /// The angle of the vector (`x`, `self`), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// √(self² + other²), for numbers whose squares may overflow or vanish.
    #[inline]
    #[must_use]
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.abs(), other.abs());
        let large = a.max(b);
        let divisor = Self::select(large.is_zero(), Self::constant(1.0), large);
        let ratio = a.min(b) / divisor;
        large * (Self::constant(1.0) + ratio * ratio).sqrt()
    }
    /// (sin πh, cos πh): the argument `self` = h is reduced exactly, before π comes in.
    fn sin_cos_pi(self) -> (Self, Self);
    /// (sin π(h − d), cos π(h − d)) with h = `self`, where h is reduced before d is subtracted,
    /// so that a small d is not lost in a large h, nor beside a zero of the cosine.
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self);
    /// 1 − sin(πz)/(πz) with z = `self` in half-turns: relative accuracy down to z = 0 (result 0).
    fn one_minus_sinc_pi(self) -> Self;
    /// 1 − e^{−2a} − 2a·e^{−a} = 2e^{−a}(sinh a − a) for a = `self` ≥ 0: relative accuracy down to 0.
    fn scaled_sinh_defect(self) -> Self;

    /// x² − 1 of an undamped mode, where its exact zero is [`NEXT_TO_POLE`] instead.
    #[inline]
    #[must_use]
    fn detuning_off_pole(self) -> Self {
        Self::select(self.is_zero(), self.replaced(NEXT_TO_POLE), self)
    }
    /// cos(πx/2) of an undamped mode, where its exact zero is −π/4·[`NEXT_TO_POLE`] instead: beside x = 1 it is in that
    /// ratio to x² − 1.
    #[inline]
    #[must_use]
    fn cosine_off_pole(self) -> Self {
        Self::select(
            self.is_zero(),
            self.replaced(-FRAC_PI_4 * NEXT_TO_POLE),
            self,
        )
    }

    /// The constant in place of the value; what else a scalar carries, a derivative, stays.
    #[inline(always)]
    #[must_use]
    fn replaced(self, value: f64) -> Self {
        Self::constant(value)
    }
    /// Gives the value a name in emitted code; numbers ignore it.  `mode` is the zero-based mode
    /// that the value belongs to, if it belongs to one.
    #[inline(always)]
    #[must_use]
    fn named(self, name: &'static str, mode: Option<usize>) -> Self {
        let _ = (name, mode);
        self
    }
    /// sin πh.
    #[inline]
    fn sin_pi(self) -> Self {
        self.sin_cos_pi().0
    }
    /// cos πh.
    #[inline]
    fn cos_pi(self) -> Self {
        self.sin_cos_pi().1
    }
}

/// A scalar whose value is at hand: what searches, and everything else that must branch, need.
pub trait Float:
    Scalar<Condition = bool> + PartialOrd + core::fmt::Debug + Send + Sync + 'static
{
    /// One unit in the last place of 1.
    const EPSILON: f64;
    /// What a search tells apart, relative to what it searches.
    const RESOLUTION: f64 = Self::EPSILON;
    /// Whether it carries a derivative beside its value.  What an iteration finds is then taken one step of Newton's
    /// method further, with which the derivative is right too.
    const CARRIES: bool = false;
    /// Whether a processor takes two of them at once.
    const PAIRS: bool = false;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The smallest and the largest 1/r at which the formulas are evaluated.  Beyond lie the limits
    /// r → ∞ and r → 0 to every digit; within, no square of a frequency overflows or vanishes.
    fn inverse_ratio_range() -> (Self, Self);
    /// The polynomials that a mode follows far above its resonance, to this scalar's precision: where
    /// [`Scalar::MASS_CONTROLLED`] says so.
    fn euler_terms() -> &'static [Self] {
        &[]
    }
    /// The largest integer that is not larger.
    #[must_use]
    fn floor(self) -> Self;
    /// The whole part as the index of a table; 0 for negative numbers and NaN.
    #[must_use]
    #[inline]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "what is meant: the cast saturates"
    )]
    fn to_index(self) -> usize {
        self.to_f64() as usize
    }
    /// Whether it is 0 and stays so when the variable of a derivative moves.
    fn vanishes(self) -> bool {
        self.is_zero()
    }
    /// The value alone, without its derivative: where something is looked at does not move with what it depends on.
    #[must_use]
    fn primal(self) -> Self {
        self
    }
    /// The derivative that it carries, as a number of its own; 0 where it carries none.
    #[must_use]
    fn carried(self) -> Self {
        Self::constant(0.0)
    }
    /// [`Scalar::sin_cos_pi`] of several numbers: the sines, then the cosines.
    #[inline(always)]
    fn sin_cos_pi_of<const N: usize>(h: [Self; N]) -> [[Self; N]; 2] {
        let both = h.map(Scalar::sin_cos_pi);
        [both.map(|(s, _)| s), both.map(|(_, c)| c)]
    }
    /// [`Scalar::sin_cos_pi_minus`] of several numbers: the sines, then the cosines.
    #[inline(always)]
    fn sin_cos_pi_minus_of<const N: usize>(h: [Self; N], d: [Self; N]) -> [[Self; N]; 2] {
        let mut found = [h, h];
        let [s, c] = &mut found;
        for ((s, c), d) in s.iter_mut().zip(c).zip(d) {
            (*s, *c) = s.sin_cos_pi_minus(d);
        }
        found
    }
    /// Whether it is no larger than another, neither of them negative or NaN. Their bits then have the same order, and
    /// of those a small processor need not fetch flags from its floating-point unit, or has none.
    #[must_use]
    #[inline]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }
    /// The bits that tell the value from any other, the sign of a zero included.
    #[must_use]
    fn bits(self) -> u64 {
        self.to_f64().to_bits()
    }
    /// Whether the value is neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }
}

/// A scalar that carries nothing beside its value.
///
/// Motions from rest and steady states are found by iteration, which stops as soon as the value is right: a
/// derivative that came along might not be right yet.  What starts from nothing asks for this trait, so that dual
/// numbers are refused when the program is compiled.  A steady state that is known gets its derivatives from
/// [`Orbit::carrying`](crate::orbit::Orbit::carrying).
pub trait Plain: Float {}
