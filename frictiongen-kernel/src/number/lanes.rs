//! Two numbers side by side, which a processor takes at once.
//!
//! Every operation is that of either number alone, with the same bits.

use crate::number::scalar::{Float, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Two numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes<S>(pub [S; 2]);

impl<S: Float> Lanes<S> {
    /// The same number twice.
    #[inline(always)]
    pub(crate) fn both(value: S) -> Self {
        Self([value; 2])
    }

    #[inline(always)]
    fn each(self, f: impl Fn(S) -> S) -> Self {
        let [a, b] = self.0;
        Self([f(a), f(b)])
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        let ([a, b], [c, d]) = (self.0, other.0);
        Self([f(a, c), f(b, d)])
    }
}

impl<S: Float> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<S: Float> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<S: Float> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<S: Float> Div for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<S: Float> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|a| -a)
    }
}

impl<S: Float> Scalar for Lanes<S> {
    type Condition = [bool; 2];

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self::both(S::constant(value))
    }
    #[inline(always)]
    fn pi() -> Self {
        Self::both(S::pi())
    }
    #[inline(always)]
    fn inverse_pi() -> Self {
        Self::both(S::inverse_pi())
    }
    #[inline(always)]
    fn lt(self, other: Self) -> [bool; 2] {
        let ([a, b], [c, d]) = (self.0, other.0);
        [a.lt(c), b.lt(d)]
    }
    #[inline(always)]
    fn is_zero(self) -> [bool; 2] {
        self.0.map(|a| a.is_zero())
    }
    #[inline(always)]
    fn select(condition: [bool; 2], yes: Self, no: Self) -> Self {
        let ([c, d], [a, b], [e, f]) = (condition, yes.0, no.0);
        Self([S::select(c, a, e), S::select(d, b, f)])
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.each(Scalar::abs)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(Scalar::sqrt)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.with(other, Scalar::max)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.with(other, Scalar::min)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.with(sign, Scalar::copysign)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        self.each(Scalar::exp)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        self.each(Scalar::exp_m1)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.with(x, Scalar::atan2)
    }
    #[inline(always)]
    fn sin_cos_pi(self) -> (Self, Self) {
        let [s, c] = S::sin_cos_pi_of_two(self.0);
        (Self(s), Self(c))
    }
    #[inline(always)]
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        let [s, c] = S::sin_cos_pi_minus_of_two(self.0, d.0);
        (Self(s), Self(c))
    }
    #[inline(always)]
    fn one_minus_sinc_pi(self) -> Self {
        self.each(Scalar::one_minus_sinc_pi)
    }
    #[inline(always)]
    fn scaled_sinh_defect(self) -> Self {
        self.each(Scalar::scaled_sinh_defect)
    }
    #[inline(always)]
    fn replaced(self, value: f64) -> Self {
        self.each(|a| a.replaced(value))
    }
}
