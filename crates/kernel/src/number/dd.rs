//! Double-double arithmetic, the accuracy reference of the project.
//!
//! A [`Dd`] is the unevaluated sum of two `f64`, with about 31 digits. All operations consist of `f64` additions,
//! subtractions, multiplications, divisions and square roots, without fused multiply-add. Their results are therefore
//! equal to the last bit on every host. For bounds on the errors see Joldes, Muller and Popescu, "Tight and rigorous
//! error bounds for basic building blocks of double-word arithmetic" (2017).

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

mod display;
mod elementary;
mod tables;

pub(crate) use tables::INVERSE_FACTORIAL;

/// A number with about 31 digits: `hi + lo`, where `hi` is the sum rounded to an `f64`.
///
/// ```
/// use frictiongen_kernel::number::dd::Dd;
///
/// let third = Dd::from(1.0) / Dd::from(3.0);
/// let one = third + third + third;
/// assert!((one - Dd::from(1.0)).abs() < Dd::from(1e-31));
/// assert_eq!(third.to_f64(), 1.0 / 3.0);
/// ```
#[derive(Clone, Copy, PartialEq, Default)]
pub struct Dd {
    /// Leading term, which is the exact number rounded to `f64`.
    pub hi: f64,
    /// Remainder, which is at most half a unit in the last place of `hi`.
    pub lo: f64,
}

/// Returns the rounded sum a + b and its rounding error.
#[inline]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// Returns the rounded sum a + b and its rounding error, for |a| ≥ |b| or a = 0.
#[inline]
fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Splits a number into a sum of two numbers with at most 26 bits each (Dekker's splitting).
#[inline]
fn split(a: f64) -> (f64, f64) {
    const LARGE: f64 = 6.696928794914171e299;
    // Without this division, the multiplication by `FACTOR` could overflow.
    if a.abs() > LARGE {
        return split_large(a);
    }
    halved(a)
}

#[inline]
fn halved(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0;
    let scaled = FACTOR * a;
    let hi = scaled - (scaled - a);
    (hi, a - hi)
}

#[cold]
fn split_large(a: f64) -> (f64, f64) {
    const DOWN: f64 = 1.0 / 268_435_456.0;
    if !a.is_finite() {
        return (a, 0.0);
    }
    let (hi, lo) = halved(a * DOWN);
    (hi / DOWN, lo / DOWN)
}

/// Returns the rounded product a·b and its rounding error. The error is exact unless it underflows.
#[inline]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_hi, a_lo), (b_hi, b_lo)) = (split(a), split(b));
    (
        product,
        ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo,
    )
}

impl Dd {
    /// The number 0 in double-double precision.
    pub const ZERO: Self = Self::new(0.0, 0.0);
    /// The number 1 in double-double precision.
    pub const ONE: Self = Self::new(1.0, 0.0);
    /// The number π in double-double precision, to about 32 digits.
    pub const PI: Self = Self::new(core::f64::consts::PI, 1.2246467991473532e-16);

    /// Creates the number `hi + lo`. The two terms must be normalised: `hi` is the sum `hi + lo` rounded to `f64`.
    #[inline]
    #[must_use]
    pub const fn new(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// Returns the exact sum of two `f64`. Either of them may be the larger one.
    ///
    /// ```
    /// use frictiongen_kernel::number::dd::Dd;
    ///
    /// assert_eq!(Dd::sum(1e-20, 1.0), Dd { hi: 1.0, lo: 1e-20 });
    /// ```
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self::finished(hi, lo)
    }

    /// Returns the exact product of two `f64`, unless the remainder `lo` underflows.
    ///
    /// ```
    /// use frictiongen_kernel::number::dd::Dd;
    ///
    /// let x = 1.0 + f64::EPSILON;
    /// let square = Dd::product(x, x);
    /// assert_eq!(square.hi, 1.0 + 2.0 * f64::EPSILON);
    /// assert_eq!(square.lo, f64::EPSILON * f64::EPSILON);
    /// ```
    #[inline]
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self::finished(hi, lo)
    }

    /// Creates the number `hi + lo`, but with `lo` = 0 if `hi` is not finite. For an infinite `hi`, `lo` would
    /// otherwise be NaN, and every later result would be NaN.
    #[inline]
    fn finished(hi: f64, lo: f64) -> Self {
        if hi.is_finite() {
            Self { hi, lo }
        } else {
            Self { hi, lo: 0.0 }
        }
    }

    /// Adds a leading term and a smaller correction. The result is normalised: its `hi` is the sum rounded to `f64`.
    #[inline]
    fn joined(hi: f64, lo: f64) -> Self {
        if !hi.is_finite() {
            return Self { hi, lo: 0.0 };
        }
        let (hi, lo) = ordered_sum(hi, lo);
        Self::finished(hi, lo)
    }

    /// Returns `hi + lo` rounded to the nearest `f64`.
    #[inline]
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.hi + self.lo
    }

    /// Returns true if the number is 0.
    #[inline]
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.hi == 0.0
    }

    /// Returns |self|.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        if self.hi < 0.0 || (self.hi == 0.0 && self.hi.is_sign_negative()) {
            -self
        } else {
            self
        }
    }

    /// Returns the larger of two numbers that are not NaN.
    #[inline]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }

    /// Returns the smaller of two numbers that are not NaN.
    #[inline]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// Returns √self, with a relative error of about 1e-32. Negative numbers give NaN.
    ///
    /// ```
    /// use frictiongen_kernel::number::dd::Dd;
    ///
    /// let root = Dd::from(2.0).sqrt();
    /// assert!((root * root - Dd::from(2.0)).abs() < Dd::from(1e-31));
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        const TINY: f64 = 1e-200;
        const UP: f64 = 1_267_650_600_228_229_401_496_703_205_376.0;
        if self.hi <= 0.0 || !self.hi.is_finite() {
            return Self::new(crate::number::float::sqrt_f64(self.hi), 0.0);
        }
        // The scaling keeps the last digits of root², and prevents an overflow of root².
        if self.hi < TINY {
            return self.scaled(UP).scaled(UP).sqrt().scaled(1.0 / UP);
        }
        if self.hi > 1.0 / TINY {
            return self.scaled(1.0 / UP).scaled(1.0 / UP).sqrt().scaled(UP);
        }
        let root = crate::number::float::sqrt_f64(self.hi);
        let rest = self - Self::product(root, root);
        Self::joined(root, rest.to_f64() / (2.0 * root))
    }

    /// Multiplies by `power`, which must be a power of two. The multiplication is then exact unless it overflows or
    /// underflows.
    #[inline]
    pub(crate) fn scaled(self, power: f64) -> Self {
        Self::finished(self.hi * power, self.lo * power)
    }
}

impl From<f64> for Dd {
    #[inline]
    fn from(value: f64) -> Self {
        Self::new(value, 0.0)
    }
}

impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            ordering => ordering,
        }
    }
}

impl Neg for Dd {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.hi, -self.lo)
    }
}

impl Add for Dd {
    type Output = Self;
    /// Adds two numbers with a relative error below 3·2^−106, even if the two numbers nearly cancel.
    #[inline]
    fn add(self, other: Self) -> Self {
        let (hi, mut rest) = two_sum(self.hi, other.hi);
        let (lo, lost) = two_sum(self.lo, other.lo);
        rest += lo;
        if !hi.is_finite() {
            return Self::new(hi, 0.0);
        }
        let (hi, rest) = ordered_sum(hi, rest);
        Self::joined(hi, rest + lost)
    }
}

impl Sub for Dd {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;
    /// Multiplies two numbers with a relative error below 5·2^−106.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (hi, rest) = two_product(self.hi, other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi + self.lo * other.lo;
        Self::joined(hi, rest + cross)
    }
}

impl Div for Dd {
    type Output = Self;
    /// Divides two numbers by long division with three digits of base 2^53. The relative error is below 2^−103.
    #[inline]
    fn div(self, other: Self) -> Self {
        const LARGE: f64 = 1e290;
        const DOWN: f64 = 1.0 / 1_267_650_600_228_229_401_496_703_205_376.0;
        let first = self.hi / other.hi;
        if !first.is_finite() || !other.hi.is_finite() || first == 0.0 {
            return Self::new(first, 0.0);
        }
        // Without scaling, the products of `other` with the quotient's digits could overflow, and so could the
        // splittings of their factors.
        if self.hi.abs() > LARGE || other.hi.abs() > LARGE {
            return self.scaled(DOWN) / other.scaled(DOWN);
        }
        let rest = self - other * Self::from(first);
        let second = rest.hi / other.hi;
        let rest = rest - other * Self::from(second);
        let third = rest.hi / other.hi;
        let (hi, lo) = ordered_sum(first, second);
        Self::joined(hi, lo + third)
    }
}

/// Writes the number in scientific notation with 32 digits, or with the precision that the format requests.
///
/// ```
/// use frictiongen_kernel::number::dd::Dd;
///
/// assert_eq!(format!("{:.29}", Dd::PI), "3.14159265358979323846264338328e0");
/// assert_eq!(format!("{}", Dd::from(-0.5)), "-5.0000000000000000000000000000000e-1");
/// ```
impl fmt::Display for Dd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        display::write(*self, f)
    }
}

impl fmt::Debug for Dd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Dd({:e} + {:e})", self.hi, self.lo)
    }
}
