//! Intervals that hold every value that a function takes, with outward rounding, and such intervals with a slope or as Taylor series.

mod jet;
mod series;

pub use jet::{Jet, Number};
pub use series::Series;

use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least of them.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

/// The kernel's sine and cosine are within 1.1 units in the last place: within this of theirs.
const SINE: f64 = 1e-15;
/// 1 less and more a unit in the last place of numbers about 1.
const BELOW: f64 = 1.0 - f64::EPSILON;
const ABOVE: f64 = 1.0 + f64::EPSILON;
/// Room for what underflows.  A subnormal number would do, but processors are much slower with these; products with this one are
/// still normal numbers.
const TINY: f64 = 1e-290;
/// libm's exponential is within one unit in the last place; this is relative and more than two.
const EXPONENTIAL: f64 = 5e-16;

impl Interval {
    /// Every number.
    pub const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };
    /// 0 alone.
    pub const ZERO: Self = Self {
        low: 0.0,
        high: 0.0,
    };
    /// 1 alone.
    pub const ONE: Self = Self {
        low: 1.0,
        high: 1.0,
    };

    /// From `low` to `high`, which is not less.
    #[inline(always)]
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// One number.
    #[inline(always)]
    #[must_use]
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// A number of which `value` is the nearest double, or next to it.
    #[must_use]
    pub fn rounded(value: f64) -> Self {
        Self::outward(value, value)
    }

    /// A number in double-double.
    #[must_use]
    pub fn of(value: Dd) -> Self {
        if value.lo == 0.0 && value.hi.is_finite() {
            Self::point(value.hi)
        } else {
            Self::rounded(value.to_f64())
        }
    }

    /// From −`size` to `size`.
    #[must_use]
    pub fn within(size: f64) -> Self {
        Self::new(-size, size)
    }

    /// Its parts of equal length, so many of them.
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

    /// π.
    #[must_use]
    pub fn pi() -> Self {
        // The nearest double is below π.
        Self::new(std::f64::consts::PI, std::f64::consts::PI * ABOVE)
    }

    /// Twice all of it, without a rounding.
    #[inline(always)]
    #[must_use]
    pub fn doubled(self) -> Self {
        Self::new(2.0 * self.low, 2.0 * self.high)
    }

    /// Over a positive number.
    #[inline(always)]
    #[must_use]
    pub fn divided_by(self, divisor: f64) -> Self {
        Self::outward(self.low / divisor, self.high / divisor)
    }

    /// The same with room for a rounding of either end; everything where an end is not known.
    ///
    /// By a product and a difference: macros run without optimisation, where each call of a function counts.
    #[inline(always)]
    fn outward(low: f64, high: f64) -> Self {
        // One unit in the last place at least, and two at most, then room for what underflows.
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

    /// The ends of a product, rounded to nearest; NaN where 0 meets an infinite end.
    #[inline(always)]
    fn ends_times(self, other: Self) -> (f64, f64) {
        let Self { low: a, high: b } = self;
        let Self { low: c, high: d } = other;
        // By signs: two products for most.
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

    /// Whether it is 0 alone.
    #[inline(always)]
    pub(crate) fn is_nothing(&self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// Whether 0 is in it.
    #[inline(always)]
    #[must_use]
    pub fn holds_zero(&self) -> bool {
        !(0.0 < self.low || self.high < 0.0)
    }

    /// 1, −1, or 0 where the interval does not tell.
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

    /// A number in the middle of it.
    #[must_use]
    pub fn middle(&self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// The largest size of a number in it.
    #[inline(always)]
    #[must_use]
    pub fn size(&self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// What is in both of two intervals that hold the same number.
    #[must_use]
    pub fn both(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.min(other.high))
    }

    /// What is in either, and between them.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// z cot z on |z| < 1, between 1 − 0.36z² and 1.
    #[must_use]
    pub fn cotangent_times(self) -> Self {
        let most = self.size();
        if most < 1.0 {
            Self::outward(1.0 - 0.36 * most * most, 1.0)
        } else {
            Self::ALL
        }
    }

    /// The squares of all of it.
    #[inline]
    #[must_use]
    pub fn squared(self) -> Self {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.holds_zero() { 0.0 } else { a.min(b) };
        let most = a.max(b);
        let square = Self::outward(least * least, most * most);
        Self::new(square.low.max(0.0), square.high)
    }

    /// The roots of what is not negative in it; everything where all is negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if !(0.0 <= self.high) {
            return Self::ALL;
        }
        let root = Self::outward(self.low.max(0.0).sqrt(), self.high.sqrt());
        Self::new(root.low.max(0.0), root.high)
    }

    /// e to all of it.
    #[must_use]
    pub fn exp(self) -> Self {
        let low = Scalar::exp(self.low) * (1.0 - EXPONENTIAL);
        let high = Scalar::exp(self.high) * (1.0 + EXPONENTIAL);
        let outward = Self::outward(low, high);
        Self::new(outward.low.max(0.0), outward.high)
    }

    /// (sin πh, cos πh) of all h in it.
    #[must_use]
    pub fn sine_cosine(self) -> (Self, Self) {
        let (low, high) = (self.low.sin_cos_pi(), self.high.sin_cos_pi());
        if !(self.high - self.low < 2.0) {
            let all = Self::new(-1.0, 1.0);
            return (all, all);
        }
        // Of the sine the extremes lie half a half-turn farther.
        let sine = Self::wave([low.0, high.0], [self.low - 0.5, self.high - 0.5]);
        let cosine = Self::wave([low.1, high.1], [self.low, self.high]);
        (sine, cosine)
    }

    /// A cosine of π times what lies between two ends, from its values there.
    #[inline]
    fn wave([first, last]: [f64; 2], [from, to]: [f64; 2]) -> Self {
        let mut low = first.min(last) - SINE;
        let mut high = first.max(last) + SINE;
        // A whole number as close to an end as its rounding counts as inside.
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
    /// The product of intervals that both hold 0, or an infinite end.
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

/// A product of ends: nothing, whatever it is multiplied by.
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
