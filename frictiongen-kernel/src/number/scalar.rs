//! The scalar trait, over which every formula of the project is written once.
//!
//! `f64` and `f32` evaluate the formulas as numbers. [`Dd`](crate::number::dd::Dd) evaluates them with about 31 digits
//! and is the accuracy reference. The expression type of the code generator turns them into Rust source. A formula must
//! therefore not branch on a scalar. It builds a condition with [`lt`](Scalar::lt) or [`is_zero`](Scalar::is_zero) and
//! chooses with [`select`](Scalar::select).

use core::f64::consts::FRAC_PI_4;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Replacement for an exact zero of x² − 1. It is far below every other value of x² − 1 in any precision.
pub const NEXT_TO_POLE: f64 = 1.0 / (1u64 << 60) as f64;

/// A number, or a symbol for a number, with which the closed forms can be evaluated.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Result of a comparison.
    type Condition: Copy;
    /// True if a mass's motion represents modes far below the excitation by the polynomials of [`Float::euler_terms`].
    const MASS_CONTROLLED: bool = false;

    /// Returns the representable number nearest to `value`.
    fn constant(value: f64) -> Self;
    /// Returns π.
    fn pi() -> Self;
    /// Returns 1/π.
    fn inverse_pi() -> Self;
    /// Compares, `self < other`.
    fn lt(self, other: Self) -> Self::Condition;
    /// Compares, `self == 0`.
    fn is_zero(self) -> Self::Condition;
    /// Returns `yes` where `condition` is true, `no` elsewhere.
    fn select(condition: Self::Condition, yes: Self, no: Self) -> Self;
    /// Returns |self|.
    fn abs(self) -> Self;
    /// Returns √self, correctly rounded (in double-double to its precision).
    fn sqrt(self) -> Self;
    /// Returns the larger of two numbers that are not NaN.
    fn max(self, other: Self) -> Self;
    /// Returns the smaller of two numbers that are not NaN.
    fn min(self, other: Self) -> Self;
    /// Returns `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Returns e^self.
    fn exp(self) -> Self;
    /// Returns e^self − 1, accurate near 0.
    fn exp_m1(self) -> Self;
    /// Returns the angle of the vector (`x`, `self`), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// Returns √(self² + other²), also for numbers whose squares may overflow or underflow.
    #[inline]
    #[must_use]
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.abs(), other.abs());
        let large = a.max(b);
        let divisor = Self::select(large.is_zero(), Self::constant(1.0), large);
        let ratio = a.min(b) / divisor;
        large * (Self::constant(1.0) + ratio * ratio).sqrt()
    }
    /// Returns (sin πh, cos πh) with h = `self`. The argument is reduced exactly before the multiplication by π.
    fn sin_cos_pi(self) -> (Self, Self);
    /// Returns (sin π(h − d), cos π(h − d)) with h = `self`. It reduces h before it subtracts d. A small d is then lost
    /// neither in a large h nor close to a zero of the cosine.
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self);
    /// Returns 1 − sin(πz)/(πz) with z = `self` in half-turns. Its relative accuracy is kept down to z = 0, where the
    /// result is 0.
    fn one_minus_sinc_pi(self) -> Self;
    /// Returns 1 − e^{−2a} − 2a·e^{−a} = 2e^{−a}(sinh a − a) for a = `self` ≥ 0. Its relative accuracy is kept down to
    /// 0.
    fn scaled_sinh_defect(self) -> Self;

    /// Returns x² − 1 of an undamped mode, with [`NEXT_TO_POLE`] in place of an exact zero.
    #[inline]
    #[must_use]
    fn detuning_off_pole(self) -> Self {
        Self::select(self.is_zero(), self.replaced(NEXT_TO_POLE), self)
    }
    /// Returns cos(πx/2) of an undamped mode, with −π/4·[`NEXT_TO_POLE`] in place of an exact zero. This is its ratio
    /// to x² − 1 close to x = 1.
    #[inline]
    #[must_use]
    fn cosine_off_pole(self) -> Self {
        Self::select(
            self.is_zero(),
            self.replaced(-FRAC_PI_4 * NEXT_TO_POLE),
            self,
        )
    }

    /// Returns the constant in place of the value. A derivative that the scalar carries is kept.
    #[inline(always)]
    #[must_use]
    fn replaced(self, value: f64) -> Self {
        Self::constant(value)
    }
    /// Gives the value a name in emitted code; numbers ignore it. `mode` is the zero-based index of the mode that the
    /// value belongs to, if any.
    #[inline(always)]
    #[must_use]
    fn named(self, name: &'static str, mode: Option<usize>) -> Self {
        let _ = (name, mode);
        self
    }
    /// Returns sin πh with h = `self`.
    #[inline]
    fn sin_pi(self) -> Self {
        self.sin_cos_pi().0
    }
    /// Returns cos πh with h = `self`.
    #[inline]
    fn cos_pi(self) -> Self {
        self.sin_cos_pi().1
    }
}

/// A scalar whose value is known, so that code may branch on it. Searches, for instance, need it.
pub trait Float:
    Scalar<Condition = bool> + PartialOrd + core::fmt::Debug + Send + Sync + 'static
{
    /// One unit in the last place of 1.
    const EPSILON: f64;
    /// Relative resolution of a search: the difference that it can still distinguish.
    const RESOLUTION: f64 = Self::EPSILON;
    /// True if the scalar carries a derivative next to its value. Code then takes the result of an iteration one Newton
    /// step further, so that the derivative is right too.
    const CARRIES: bool = false;
    /// True if a processor can compute with two of these numbers at once.
    const PAIRS: bool = false;
    /// Returns the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns the smallest and the largest 1/r at which the formulas are evaluated. Outside this range the limits r →
    /// ∞ and r → 0 are exact to every digit. Inside it no square of a frequency overflows or underflows.
    fn inverse_ratio_range() -> (Self, Self);
    /// Returns the polynomials that a mode follows far above its resonance, to this scalar's precision. They exist
    /// where [`Scalar::MASS_CONTROLLED`] is true.
    fn euler_terms() -> &'static [Self] {
        &[]
    }
    /// Returns the largest integer that is not larger than `self`.
    #[must_use]
    fn floor(self) -> Self;
    /// Returns the integer part as an index into a table, and 0 for negative numbers and NaN.
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
    /// Returns true if the value is 0 and also the derivative that it may carry.
    fn vanishes(self) -> bool {
        self.is_zero()
    }
    /// Returns the value without its derivative. It is used for positions, which must not depend on the variable of a
    /// derivative.
    #[must_use]
    fn primal(self) -> Self {
        self
    }
    /// Returns the derivative that the scalar carries, as a number of its own; 0 if it carries none.
    #[must_use]
    fn carried(self) -> Self {
        Self::constant(0.0)
    }
    /// Evaluates [`Scalar::sin_cos_pi`] of several numbers. Returns the sines, then the cosines.
    #[inline(always)]
    fn sin_cos_pi_of<const N: usize>(h: [Self; N]) -> [[Self; N]; 2] {
        let both = h.map(Scalar::sin_cos_pi);
        [both.map(|(s, _)| s), both.map(|(_, c)| c)]
    }
    /// Evaluates [`Scalar::sin_cos_pi_minus`] of several numbers. Returns the sines, then the cosines.
    #[inline(always)]
    fn sin_cos_pi_minus_of<const N: usize>(h: [Self; N], d: [Self; N]) -> [[Self; N]; 2] {
        let mut found = [h, h];
        let [s, c] = &mut found;
        for ((s, c), d) in s.iter_mut().zip(c).zip(d) {
            (*s, *c) = s.sin_cos_pi_minus(d);
        }
        found
    }
    /// Returns true if `self` is no larger than `other`, where neither is negative or NaN. Their bits then have the
    /// same order. A comparison of the bits spares a small processor the transfer of flags from its floating-point
    /// unit, and also works without such a unit.
    #[must_use]
    #[inline]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }
    /// Returns the bits that distinguish the value from any other, including the sign of a zero.
    #[must_use]
    fn bits(self) -> u64 {
        self.to_f64().to_bits()
    }
    /// Returns true if the value is neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }
}

/// A scalar that carries nothing next to its value.
///
/// Motions from rest and steady states are found by iteration, which stops as soon as the value is right. A derivative
/// carried along might not be right yet. Functions that start such an iteration therefore require this trait, so that
/// the compiler rejects dual numbers. [`Orbit::carrying`](crate::orbit::Orbit::carrying) gives a known steady state its
/// derivatives.
pub trait Plain: Float {}
