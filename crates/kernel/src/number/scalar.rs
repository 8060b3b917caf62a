//! Trait [`Scalar`], over which the project writes every formula once.
//!
//! With `f64` and `f32` a formula evaluates to a number. With [`Dd`](crate::number::dd::Dd) the number has about 31
//! digits and serves as the accuracy reference. With the expression type of the code generator a formula becomes Rust
//! source. A formula must therefore not branch on a scalar. The formula builds a condition with [`lt`](Scalar::lt) or
//! [`is_zero`](Scalar::is_zero), and passes the condition to [`select`](Scalar::select).

use core::f64::consts::FRAC_PI_4;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Number that replaces an exact zero of x² − 1, where x is the natural frequency of a mode divided by the excitation
/// frequency. In any precision this number is far smaller than every |x² − 1| that is not zero.
pub const NEXT_TO_POLE: f64 = 1.0 / (1u64 << 60) as f64;

/// A number, or a symbol for a number, over which all closed forms are written.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Result of a comparison of two scalars. For numbers the result is a `bool`. For other scalars it is a symbol, or
    /// an array of `bool`.
    type Condition: Copy;
    /// True if the function [`Float::euler_terms`] returns polynomials for this scalar. The motion of a mass uses these
    /// polynomials for modes that resonate far below the excitation frequency.
    const MASS_CONTROLLED: bool = false;

    /// Returns the number of this type that is nearest to `value`.
    fn constant(value: f64) -> Self;
    /// Returns the number π.
    fn pi() -> Self;
    /// Returns the number 1/π.
    fn inverse_pi() -> Self;
    /// Returns the condition `self < other`.
    fn lt(self, other: Self) -> Self::Condition;
    /// Returns the condition `self == 0`.
    fn is_zero(self) -> Self::Condition;
    /// Returns `yes` if `condition` is true, and `no` if `condition` is false.
    fn select(condition: Self::Condition, yes: Self, no: Self) -> Self;
    /// Returns |self|, the absolute value.
    fn abs(self) -> Self;
    /// Returns √self. The result is correctly rounded in `f64` and `f32`, and accurate to about 1e-32 in double-double.
    fn sqrt(self) -> Self;
    /// Returns the larger of two numbers that are not NaN.
    fn max(self, other: Self) -> Self;
    /// Returns the smaller of two numbers that are not NaN.
    fn min(self, other: Self) -> Self;
    /// Returns a number with the absolute value of `self` and the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Returns e^self.
    fn exp(self) -> Self;
    /// Returns e^self − 1, with full relative accuracy near 0.
    fn exp_m1(self) -> Self;
    /// Returns the angle of the vector (`x`, `self`), in rad, in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// Returns √(`self`² + `other`²). No intermediate result overflows or underflows, even if the square of `self` or
    /// `other` would.
    #[inline]
    #[must_use]
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.abs(), other.abs());
        let large = a.max(b);
        let divisor = Self::select(large.is_zero(), Self::constant(1.0), large);
        let ratio = a.min(b) / divisor;
        large * (Self::constant(1.0) + ratio * ratio).sqrt()
    }
    /// Returns (sin πh, cos πh) with h = `self`. The function subtracts a multiple of 1/2 from h without rounding,
    /// before it multiplies by π.
    fn sin_cos_pi(self) -> (Self, Self);
    /// Returns (sin π(h − d), cos π(h − d)) with h = `self`. The function reduces h to a small remainder before it
    /// subtracts d. The result therefore keeps the digits of a small d, even for a large h and close to a zero of the
    /// cosine.
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self);
    /// Returns 1 − sin(πz)/(πz) for z = `self`. The result has full relative accuracy for every z, even near z = 0,
    /// where the result is 0.
    fn one_minus_sinc_pi(self) -> Self;
    /// Returns 1 − e^{−2a} − 2a·e^{−a} = 2e^{−a}(sinh a − a) for a = `self` ≥ 0. The result has full relative accuracy
    /// for every a, even near a = 0, where the result is 0.
    fn scaled_sinh_defect(self) -> Self;

    /// Replaces an exact zero of x² − 1. `self` is x² − 1 of an undamped mode, where x is the natural frequency of the
    /// mode divided by the excitation frequency. The result is [`NEXT_TO_POLE`] if `self` is exactly zero, and `self`
    /// otherwise.
    #[inline]
    #[must_use]
    fn detuning_off_pole(self) -> Self {
        Self::select(self.is_zero(), self.replaced(NEXT_TO_POLE), self)
    }
    /// Replaces an exact zero of cos(πx/2). `self` is cos(πx/2) of an undamped mode, where x is the natural frequency
    /// of the mode divided by the excitation frequency. The result is −π/4·[`NEXT_TO_POLE`] if `self` is exactly zero,
    /// and `self` otherwise. The factor −π/4 is the ratio of cos(πx/2) to x² − 1 close to x = 1.
    #[inline]
    #[must_use]
    fn cosine_off_pole(self) -> Self {
        Self::select(
            self.is_zero(),
            self.replaced(-FRAC_PI_4 * NEXT_TO_POLE),
            self,
        )
    }

    /// Returns the constant `value`, which replaces `self`. For a dual number, the result has the value `value` and the
    /// derivative of `self`.
    #[inline(always)]
    #[must_use]
    fn replaced(self, value: f64) -> Self {
        Self::constant(value)
    }
    /// Names the local variable that emitted code uses for `self`. For scalars that are numbers, the function ignores
    /// the name and the text, and returns `self`.
    ///
    /// `about` explains the quantity and gives its equation number. Emitted code contains `about` as a comment above
    /// the variable. `mode` is the zero-based index of the mode to which `self` belongs, if any. If a formula names a
    /// value twice, emitted code uses the first name.
    #[inline(always)]
    #[must_use]
    fn named(self, name: &'static str, about: &'static str, mode: Option<usize>) -> Self {
        let _ = (name, about, mode);
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

/// Scalar that has a numerical value, so that code can branch on it. Searches and iterations require this trait.
pub trait Float:
    Scalar<Condition = bool> + PartialOrd + core::fmt::Debug + Send + Sync + 'static
{
    /// Distance from 1 to the next larger number of this precision.
    const EPSILON: f64;
    /// Smallest relative difference between two values that a search can detect in this precision.
    const RESOLUTION: f64 = Self::EPSILON;
    /// True if the scalar has a derivative in addition to its value. Iterations then make one more Newton step, because
    /// the derivative becomes correct one step later than the value.
    const CARRIES: bool = false;
    /// True if a processor can compute with two numbers of this type at the same time.
    const PAIRS: bool = false;
    /// Converts a whole number, and rounds it if it has more bits than the scalar. For `f32` the conversion is direct,
    /// not through `f64`, so that a processor without double precision needs no additional function.
    #[must_use]
    #[inline]
    #[allow(clippy::cast_precision_loss, reason = "what is meant: the cast rounds")]
    fn whole(number: usize) -> Self {
        Self::constant(number as f64)
    }
    /// Returns `self` rounded to the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Returns the smallest and the largest 1/r at which the code evaluates the formulas, where r is the frequency
    /// ratio. Outside this range the formulas equal their limits for r → ∞ and r → 0 in every digit. Inside this range
    /// no square of a frequency overflows or underflows.
    fn inverse_ratio_range() -> (Self, Self);
    /// Returns the coefficients of polynomials that describe a mode which resonates far below the excitation frequency.
    /// The slice is empty unless [`Scalar::MASS_CONTROLLED`] is true.
    fn euler_terms() -> &'static [Self] {
        &[]
    }
    /// Returns the largest integer that is not larger than `self`.
    #[must_use]
    fn floor(self) -> Self;
    /// Returns the integer part of `self`, as an index into a table. For negative numbers and NaN the result is 0.
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
    /// Returns true if `self` is 0. For a dual number, both its value and its derivative must be 0.
    fn vanishes(self) -> bool {
        self.is_zero()
    }
    /// Returns `self` without its derivative. Searches use this function for the instants that they evaluate, because
    /// these instants must not depend on the variable of the derivative.
    #[must_use]
    fn primal(self) -> Self {
        self
    }
    /// Returns the derivative of `self` as a scalar. The result is 0 if the number type has no derivatives.
    #[must_use]
    fn carried(self) -> Self {
        Self::constant(0.0)
    }
    /// Evaluates [`Scalar::sin_cos_pi`] for each number of the array `h`. Returns the array of sines, then the array of
    /// cosines.
    #[inline(always)]
    fn sin_cos_pi_of<const N: usize>(h: [Self; N]) -> [[Self; N]; 2] {
        let both = h.map(Scalar::sin_cos_pi);
        [both.map(|(s, _)| s), both.map(|(_, c)| c)]
    }
    /// Evaluates [`Scalar::sin_cos_pi_minus`] for each pair (h, d) of the arrays `h` and `d`. Returns the array of
    /// sines, then the array of cosines.
    #[inline(always)]
    fn sin_cos_pi_minus_of<const N: usize>(h: [Self; N], d: [Self; N]) -> [[Self; N]; 2] {
        let mut found = [h, h];
        let [s, c] = &mut found;
        for ((s, c), d) in s.iter_mut().zip(c).zip(d) {
            (*s, *c) = s.sin_cos_pi_minus(d);
        }
        found
    }
    /// Returns true if `self` ≤ `other`. `self` and `other` must not be negative or NaN. `f64` and `f32` compare the
    /// bits of the two numbers as integers, which have the same order as the numbers. The comparison of integers is
    /// cheaper on a small processor and needs no floating-point unit.
    #[must_use]
    #[inline]
    fn at_most(self, other: Self) -> bool {
        self <= other
    }
    /// Returns the bits of `self`. Two numbers have the same bits only if they are identical. A positive and a negative
    /// zero have different bits.
    #[must_use]
    fn bits(self) -> u64 {
        self.to_f64().to_bits()
    }
    /// Returns true if `self` is neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }
}

/// Scalar without a derivative. Dual numbers do not implement this trait.
///
/// Some functions find motions from rest and steady states by iteration. An iteration stops as soon as its value is
/// correct, but a derivative may still be wrong at that step. These functions require `Plain`, so that the compiler
/// rejects dual numbers. [`Orbit::carrying`](crate::orbit::Orbit::carrying) adds derivatives to a steady state that is
/// already known.
pub trait Plain: Float {}
