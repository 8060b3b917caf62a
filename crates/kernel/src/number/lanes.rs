//! Arrays of numbers that a processor can compute at the same time with packed (SIMD) instructions.
//!
//! Each operation on an array acts on each number of the array separately. Each result equals the result of the same
//! operation on a single number, to the last bit.

use crate::number::scalar::{Float, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Array of `N` numbers that is itself a [`Scalar`], so that one formula evaluates `N` numbers at the same time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes<S, const N: usize = 2>(pub [S; N]);

impl<S: Float, const N: usize> Lanes<S, N> {
    /// Creates an array whose `N` numbers all equal `value`.
    #[inline(always)]
    pub(crate) fn all(value: S) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn each(mut self, f: impl Fn(S) -> S) -> Self {
        for a in &mut self.0 {
            *a = f(*a);
        }
        self
    }

    #[inline(always)]
    fn with(mut self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = f(*a, b);
        }
        self
    }
}

impl<S: Float, const N: usize> Add for Lanes<S, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<S: Float, const N: usize> Sub for Lanes<S, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<S: Float, const N: usize> Mul for Lanes<S, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<S: Float, const N: usize> Div for Lanes<S, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<S: Float, const N: usize> Neg for Lanes<S, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|a| -a)
    }
}

impl<S: Float, const N: usize> Scalar for Lanes<S, N> {
    type Condition = [bool; N];

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self::all(S::constant(value))
    }
    #[inline(always)]
    fn pi() -> Self {
        Self::all(S::pi())
    }
    #[inline(always)]
    fn inverse_pi() -> Self {
        Self::all(S::inverse_pi())
    }
    #[inline(always)]
    fn lt(self, other: Self) -> [bool; N] {
        let mut less = [false; N];
        for (less, (a, b)) in less.iter_mut().zip(self.0.iter().zip(other.0)) {
            *less = Scalar::lt(*a, b);
        }
        less
    }
    #[inline(always)]
    fn is_zero(self) -> [bool; N] {
        self.0.map(|a| a.is_zero())
    }
    #[inline(always)]
    fn select(condition: [bool; N], yes: Self, no: Self) -> Self {
        let mut chosen = no;
        for (chosen, (condition, yes)) in chosen.0.iter_mut().zip(condition.iter().zip(yes.0)) {
            *chosen = S::select(*condition, yes, *chosen);
        }
        chosen
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
        let [s, c] = S::sin_cos_pi_of(self.0);
        (Self(s), Self(c))
    }
    #[inline(always)]
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        let [s, c] = S::sin_cos_pi_minus_of(self.0, d.0);
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
