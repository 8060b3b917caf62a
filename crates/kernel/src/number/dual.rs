//! Dual numbers: a value together with its derivative with respect to one variable.
//!
//! A closed form that is evaluated with dual numbers gives its value and its exact derivative. Close to a resonance
//! this derivative is a small difference of large terms. Dual numbers of [`Dd`](crate::number::dd::Dd) keep the digits
//! of this difference.

use crate::number::scalar::{Float, Scalar};
use crate::number::special::{exp_m1_minus, versine_pi};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number f with its derivative ∂f/∂p for one variable p. Comparisons use f alone.
///
/// ```
/// use frictiongen_kernel::{Scalar, number::dual::Dual};
///
/// let p = Dual::variable(4.0_f64);
/// let root = p.sqrt();
/// assert_eq!((root.value, root.slope), (2.0, 0.25));
/// assert_eq!((root * root - p).slope, 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dual<S> {
    /// Value f of the function at the present value of the variable p.
    pub value: S,
    /// Derivative ∂f/∂p of the function with respect to the variable p.
    pub slope: S,
}

impl<S: Float> Dual<S> {
    /// Creates a dual number with derivative 0, for a quantity that does not depend on the variable p.
    pub fn fixed(value: S) -> Self {
        let slope = S::constant(0.0);
        Self { value, slope }
    }

    /// Creates the variable p itself, with the given value and the derivative 1.
    pub fn variable(value: S) -> Self {
        let slope = S::constant(1.0);
        Self { value, slope }
    }

    /// Returns f(self) by the chain rule. The arguments are `value` = f and `derivative` = f′, both at `self`.
    #[inline]
    fn chain(self, value: S, derivative: S) -> Self {
        let zero = S::constant(0.0);
        // A constant keeps the derivative 0 even if f′ is infinite. The product 0·∞ would be NaN.
        let slope = if self.slope == zero {
            zero
        } else {
            self.slope * derivative
        };
        Self { value, slope }
    }
}

impl<S: Float> PartialEq for Dual<S> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: Float> PartialOrd for Dual<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<S: Float> Add for Dual<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<S: Float> Sub for Dual<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<S: Float> Mul for Dual<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl<S: Float> Div for Dual<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            slope: (self.slope - value * other.slope) / other.value,
        }
    }
}

impl<S: Float> Neg for Dual<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl<S: Float> Scalar for Dual<S> {
    type Condition = bool;

    fn constant(value: f64) -> Self {
        Self::fixed(S::constant(value))
    }
    fn pi() -> Self {
        Self::fixed(S::pi())
    }
    fn inverse_pi() -> Self {
        Self::fixed(S::inverse_pi())
    }
    fn lt(self, other: Self) -> bool {
        self.value < other.value
    }
    fn is_zero(self) -> bool {
        self.value.is_zero()
    }
    fn select(condition: bool, yes: Self, no: Self) -> Self {
        if condition { yes } else { no }
    }
    fn abs(self) -> Self {
        self.copysign(Self::constant(1.0))
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, S::constant(0.5) / root)
    }
    fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    fn copysign(self, sign: Self) -> Self {
        let one = S::constant(1.0);
        let turned = one.copysign(self.value) != one.copysign(sign.value);
        if turned { -self } else { self }
    }
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    fn exp_m1(self) -> Self {
        self.chain(self.value.exp_m1(), self.value.exp())
    }
    fn replaced(self, value: f64) -> Self {
        Self {
            value: S::constant(value),
            ..self
        }
    }
    fn atan2(self, x: Self) -> Self {
        let (y, size) = (self, self.value.abs().max(x.value.abs()));
        let value = y.value.atan2(x.value);
        // The code divides y and x by `size`, the larger of |y| and |x|, because the square of `size` may overflow or
        // underflow.
        let (sy, sx) = (y.value / size, x.value / size);
        let slope = (sx * y.slope - sy * x.slope) / (size * (sx * sx + sy * sy));
        Self { value, slope }
    }
    fn sin_cos_pi(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos_pi();
        let pi = S::pi();
        (
            self.chain(sine, pi * cosine),
            self.chain(cosine, -(pi * sine)),
        )
    }
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos_pi_minus(d.value);
        let (pi, angle) = (S::pi(), self - d);
        (
            angle.chain(sine, pi * cosine),
            angle.chain(cosine, -(pi * sine)),
        )
    }
    fn one_minus_sinc_pi(self) -> Self {
        let z = self.value;
        let value = z.one_minus_sinc_pi();
        // The code computes the derivative (sinc − cos)/z from 1 − cos and 1 − sinc, with sinc = sin(πz)/(πz). Because
        // 1 − cos and 1 − sinc vanish with z, their difference loses hardly any digits.
        let derivative = if z.is_zero() {
            z
        } else {
            (versine_pi(z) - value) / z
        };
        self.chain(value, derivative)
    }
    fn scaled_sinh_defect(self) -> Self {
        let a = self.value;
        let derivative = S::constant(2.0) * (-a).exp() * exp_m1_minus(-a);
        self.chain(a.scaled_sinh_defect(), derivative)
    }
}

impl<S: Float> Float for Dual<S> {
    const EPSILON: f64 = S::EPSILON;
    const RESOLUTION: f64 = S::RESOLUTION;
    const CARRIES: bool = true;

    fn inverse_ratio_range() -> (Self, Self) {
        let (low, high) = S::inverse_ratio_range();
        (Self::fixed(low), Self::fixed(high))
    }
    fn floor(self) -> Self {
        Self::fixed(self.value.floor())
    }
    fn primal(self) -> Self {
        Self::fixed(self.value)
    }
    fn carried(self) -> Self {
        Self::fixed(self.slope)
    }
    fn vanishes(self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
}
