//! Arithmetic for functions of frequency, over numbers, over intervals, or over intervals with a slope.

use super::Interval;
use frictiongen_kernel::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Trait of numbers with which functions of frequency can be evaluated: numbers, intervals, or intervals with a
/// slope.
pub trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Returns the number `value` in this arithmetic.
    fn number(value: f64) -> Self;
    /// Returns π in this arithmetic.
    fn pi() -> Self;
    /// Returns (sin πh, cos πh) with h = `self`.
    fn sine_cosine(self) -> (Self, Self);
    /// Returns the square of the number or function.
    #[must_use]
    fn squared(self) -> Self {
        self * self
    }
}

impl<S: Scalar> Arithmetic for S {
    fn number(value: f64) -> Self {
        S::constant(value)
    }
    fn pi() -> Self {
        <S as Scalar>::pi()
    }
    fn sine_cosine(self) -> (Self, Self) {
        self.sin_cos_pi()
    }
}

impl Arithmetic for Interval {
    fn number(value: f64) -> Self {
        Self::point(value)
    }
    fn pi() -> Self {
        Interval::pi()
    }
    fn sine_cosine(self) -> (Self, Self) {
        Interval::sine_cosine(self)
    }
    fn squared(self) -> Self {
        Interval::squared(self)
    }
}

/// Bounds on a function and on its slope, over an interval of the variable.
#[derive(Clone, Copy, Debug)]
pub struct Jet {
    /// Bounds of the value of the function.
    pub value: Interval,
    /// Bounds of the slope of the function.
    pub slope: Interval,
}

impl Jet {
    /// Returns the bounds on a constant function, whose slope is 0.
    #[must_use]
    pub fn fixed(value: Interval) -> Self {
        let slope = Interval::point(0.0);
        Self { value, slope }
    }

    /// Returns the bounds on the variable itself, whose slope is 1.
    #[must_use]
    pub fn variable(value: Interval) -> Self {
        let slope = Interval::point(1.0);
        Self { value, slope }
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            slope: (self.slope - value * other.slope) / other.value,
        }
    }
}

impl Arithmetic for Jet {
    fn number(value: f64) -> Self {
        Self::fixed(Interval::point(value))
    }
    fn pi() -> Self {
        Self::fixed(Interval::pi())
    }
    fn sine_cosine(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sine_cosine();
        let rate = Interval::pi() * self.slope;
        let of = |value: Interval, slope: Interval| Self {
            value,
            slope: slope * rate,
        };
        (of(sine, cosine), of(cosine, -sine))
    }
    fn squared(self) -> Self {
        let twice = self.value + self.value;
        Self {
            value: self.value.squared(),
            slope: twice * self.slope,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Arithmetic, Interval, Jet};

    /// Evaluates a formula that uses every operation of the arithmetic.
    fn formula<T: Arithmetic>(h: T) -> T {
        let (sine, cosine) = h.sine_cosine();
        (sine * h - cosine.squared()) / (h.squared() + T::number(0.5)) + -h
    }

    /// Checks that a result over an interval contains the values at points of the interval, and that its slope
    /// contains the difference quotients.
    #[test]
    fn hold_what_they_should() {
        let mut state = 7_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut seen = 0;
        for _ in 0..20_000 {
            let low = 8.0 * next() - 4.0;
            let high = low + 3.0 * next().powi(6);
            let jet = formula(Jet::variable(Interval::new(low, high)));
            let place = |share: f64| (low + (high - low) * share).clamp(low, high);
            let places = [place(0.0), place(next()), place(next()), place(1.0)];
            for h in places {
                let value = formula(h);
                assert!(jet.value.low <= value && value <= jet.value.high, "{h}");
                seen += 1;
            }
            let [a, b] = [places[1], places[2]];
            if 1e-3 < (a - b).abs() {
                let slope = (formula(a) - formula(b)) / (a - b);
                assert!(jet.slope.low <= slope + 1e-10 && slope - 1e-10 <= jet.slope.high);
            }
        }
        assert_eq!(seen, 80_000);
    }
}
