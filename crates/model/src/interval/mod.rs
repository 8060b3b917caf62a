//! Interval arithmetic with outward rounding. A result contains every value that the function takes over the interval.
//! A [`Jet`] also bounds the slope of the function.

mod jet;

pub use jet::{Arithmetic, Jet};

use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An interval: all numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower bound of the interval.
    pub low: f64,
    /// The upper bound of the interval.
    pub high: f64,
}

/// Bound on the absolute error of the kernel's sine and cosine. The actual error is at most 1.1 units in the last
/// place.
const SINE: f64 = 1e-15;
/// 1 minus one unit in the last place of 1.
const BELOW: f64 = 1.0 - f64::EPSILON;
/// 1 plus one unit in the last place of 1.
const ABOVE: f64 = 1.0 + f64::EPSILON;
/// Allowance for underflow in a product. A subnormal number would suffice, but processors compute much more slowly
/// with subnormal numbers. Products with this number are normal.
pub const TINY: f64 = 1e-290;
/// Bound on the relative error of libm's exponential. It is more than two units in the last place. The actual error is
/// at most one unit.
const EXPONENTIAL: f64 = 5e-16;

impl Interval {
    /// The interval that contains all numbers.
    pub const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };
    /// The interval that contains only 0.
    pub const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };
    /// The interval that contains only 1.
    pub const ONE: Self = Self {
        low: 1.0,
        high: 1.0,
    };

    /// Returns the interval from `low` to `high`. `high` must not be less than `low`.
    #[inline(always)]
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// Returns the interval of one number.
    #[inline(always)]
    #[must_use]
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Returns an interval for a number whose nearest double is `value` or a neighbour of `value`.
    #[must_use]
    pub fn rounded(value: f64) -> Self {
        Self::outward(value, value)
    }

    /// Returns an interval that contains a double-double number.
    #[must_use]
    pub fn of(value: Dd) -> Self {
        if value.lo == 0.0 && value.hi.is_finite() {
            Self::point(value.hi)
        } else {
            Self::rounded(value.to_f64())
        }
    }

    /// Returns the interval from −`size` to `size`.
    #[must_use]
    pub fn within(size: f64) -> Self {
        Self::new(-size, size)
    }

    /// Splits the interval into `count` intervals of equal length.
    pub fn parts(self, count: usize) -> impl Iterator<Item = Self> {
        let Self { low, high } = self;
        let step = (high - low) / count as f64;
        (0..count).map(move |part| {
            let from = low + step * part as f64;
            let to = if part + 1 < count {
                low + step * (part + 1) as f64
            } else {
                high
            };
            Self::new(from, to)
        })
    }

    /// Returns an interval that contains π.
    #[must_use]
    pub fn pi() -> Self {
        // The nearest double is below π.
        Self::new(std::f64::consts::PI, std::f64::consts::PI * ABOVE)
    }

    /// Returns the interval times 2, without rounding.
    #[inline(always)]
    #[must_use]
    pub fn doubled(self) -> Self {
        Self::new(2.0 * self.low, 2.0 * self.high)
    }

    /// Returns the interval divided by a positive number.
    #[inline(always)]
    #[must_use]
    pub fn divided_by(self, divisor: f64) -> Self {
        Self::outward(self.low / divisor, self.high / divisor)
    }

    /// Returns the interval with its bounds rounded outward. Returns `ALL` if a bound is NaN.
    ///
    /// The code computes a product and a difference, not the next representable number. In a macro, which runs
    /// without optimisation, a call for the next representable number would take longer.
    #[inline(always)]
    fn outward(low: f64, high: f64) -> Self {
        // The product shifts a bound outward by one or two units in the last place. `TINY` covers underflow.
        let low = if low > 0.0 { low * BELOW } else { low * ABOVE } - TINY;
        let high = if high > 0.0 {
            high * ABOVE
        } else {
            high * BELOW
        } + TINY;
        #[allow(
            clippy::eq_op,
            reason = "NaN alone is not itself, and `is_nan` is a call"
        )]
        if low != low || high != high {
            return Self::ALL;
        }
        Self { low, high }
    }

    /// Returns the bounds of the product of two intervals, rounded to nearest. If a bound 0 is multiplied by an
    /// infinite bound, a bound of the result may be NaN.
    #[inline(always)]
    #[must_use]
    pub fn ends_times(self, other: Self) -> (f64, f64) {
        let Self { low: a, high: b } = self;
        let Self { low: c, high: d } = other;
        // In most cases the signs of the bounds decide which two products are the bounds of the result.
        if 0.0 <= a {
            (
                if 0.0 <= c { a * c } else { b * c },
                if 0.0 <= d { b * d } else { a * d },
            )
        } else if b <= 0.0 {
            (
                if 0.0 <= d { a * d } else { b * d },
                if 0.0 <= c { b * c } else { a * c },
            )
        } else if 0.0 <= c {
            (a * d, b * d)
        } else if d <= 0.0 {
            (b * c, a * c)
        } else {
            let both = self.straddling(other);
            (both.low, both.high)
        }
    }

    /// Returns true if the interval contains only 0.
    #[inline(always)]
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// Returns true if the interval contains 0.
    #[inline(always)]
    #[must_use]
    pub fn holds_zero(&self) -> bool {
        !(0.0 < self.low || self.high < 0.0)
    }

    /// Returns 1 or −1, or 0 if the interval does not determine the sign.
    #[must_use]
    pub fn sign(&self) -> i8 {
        if 0.0 < self.low {
            1
        } else if self.high < 0.0 {
            -1
        } else {
            0
        }
    }

    /// Returns a number in the middle of the interval.
    #[must_use]
    pub fn middle(&self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// Returns the largest modulus of a number in the interval.
    #[inline(always)]
    #[must_use]
    pub fn size(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Returns the intersection of two intervals, which must contain a common number.
    #[must_use]
    pub fn both(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.min(other.high))
    }

    /// Returns the smallest interval that contains both intervals.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// Returns z cot z for all z in the interval, for |z| < 1. The values are between 1 − 0.36z² and 1.
    #[must_use]
    pub fn cotangent_times(self) -> Self {
        let most = self.size();
        if most < 1.0 {
            Self::outward(1.0 - 0.36 * most * most, 1.0)
        } else {
            Self::ALL
        }
    }

    /// Returns the squares of all numbers in the interval.
    #[inline]
    #[must_use]
    pub fn squared(self) -> Self {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.holds_zero() { 0.0 } else { a.min(b) };
        let most = a.max(b);
        let square = Self::outward(least * least, most * most);
        Self::new(square.low.max(0.0), square.high)
    }

    /// Returns the square roots of all non-negative numbers in the interval. Returns `ALL` if all are negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if !(0.0 <= self.high) {
            return Self::ALL;
        }
        let root = Self::outward(self.low.max(0.0).sqrt(), self.high.sqrt());
        Self::new(root.low.max(0.0), root.high)
    }

    /// Returns the exponentials of all numbers in the interval.
    #[must_use]
    pub fn exp(self) -> Self {
        let low = Scalar::exp(self.low) * (1.0 - EXPONENTIAL);
        let high = Scalar::exp(self.high) * (1.0 + EXPONENTIAL);
        let outward = Self::outward(low, high);
        Self::new(outward.low.max(0.0), outward.high)
    }

    /// Returns (sin πh, cos πh) for all h in the interval.
    #[must_use]
    pub fn sine_cosine(self) -> (Self, Self) {
        let (low, high) = (self.low.sin_cos_pi(), self.high.sin_cos_pi());
        if !(self.high - self.low < 2.0) {
            let all = Self::new(-1.0, 1.0);
            return (all, all);
        }
        // sin πh = cos π(h − ½), so the extremes of the sine are those of the cosine, shifted by ½ in h.
        let sine = Self::wave([low.0, high.0], [self.low - 0.5, self.high - 0.5]);
        let cosine = Self::wave([low.1, high.1], [self.low, self.high]);
        (sine, cosine)
    }

    /// Returns the bounds of cos πh for h from `from` to `to`. `first` and `last` are cos πh at `from` and at `to`.
    #[inline]
    fn wave([first, last]: [f64; 2], [from, to]: [f64; 2]) -> Self {
        let mut low = first.min(last) - SINE;
        let mut high = first.max(last) + SINE;
        // An integer h that is within rounding of an end counts as inside, because cos πh has its extremes at
        // integers.
        let slack = 2.0 * f64::EPSILON * (1.0 + from.abs() + to.abs());
        let (least, most) = ((from - slack).ceil(), (to + slack).floor());
        if least <= most {
            let is_even = (0.5 * least).floor() * 2.0 == least;
            let several = 1.0 <= most - least;
            if several || is_even {
                high = 1.0;
            }
            if several || !is_even {
                low = -1.0;
            }
        }
        Self::new(low.max(-1.0), high.min(1.0))
    }
}

impl Interval {
    /// Returns the product of two intervals that both contain 0, or of which one has an infinite bound.
    fn straddling(self, other: Self) -> Self {
        let Self { low: a, high: b } = self;
        let Self { low: c, high: d } = other;
        let (ad, bc) = (product(a, d), product(b, c));
        let (ac, bd) = (product(a, c), product(b, d));
        if ad.is_nan() || bc.is_nan() || ac.is_nan() || bd.is_nan() {
            return Self::ALL;
        }
        Self::outward(ad.min(bc).min(ac).min(bd), ac.max(bd).max(ad).max(bc))
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

/// Returns the product of two bounds. The product of 0 and infinity is 0.
#[inline]
fn product(a: f64, b: f64) -> f64 {
    let product = a * b;
    if product.is_nan() && (a == 0.0 || b == 0.0) {
        0.0
    } else {
        product
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (low, high) = self.ends_times(other);
        #[allow(
            clippy::eq_op,
            reason = "NaN alone is not itself, and `is_nan` is a call"
        )]
        if low != low || high != high {
            return self.straddling(other);
        }
        Self::outward(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.holds_zero() {
            return Self::ALL;
        }
        self * Self::outward(1.0 / other.high, 1.0 / other.low)
    }
}

#[cfg(test)]
mod tests;
