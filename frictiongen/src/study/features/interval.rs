//! Intervals that hold every value that a function takes, with outward rounding, and such intervals with a slope.

use frictiongen_kernel::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the functions of frequency are read in: numbers, intervals, intervals with slopes.
pub(super) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn number(value: f64) -> Self;
    /// π.
    fn pi() -> Self;
    /// (sin πh, cos πh).
    fn sine_cosine(self) -> (Self, Self);
    fn squared(self) -> Self {
        self * self
    }
}

impl<S: Scalar> Number for S {
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

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub low: f64,
    pub high: f64,
}

/// The kernel's sine and cosine are within this of theirs.
const SINE: f64 = 1e-15;

impl Interval {
    pub const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    pub fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// A number of which `value` is the nearest double, or next to it.
    pub fn rounded(value: f64) -> Self {
        Self::outward(value, value)
    }

    /// The same with room for a rounding of either end; everything where an end is not known.
    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::ALL;
        }
        Self::new(low.next_down(), high.next_up())
    }

    pub fn holds_zero(&self) -> bool {
        !(0.0 < self.low || self.high < 0.0)
    }

    /// 1, −1, or 0 where the interval does not tell.
    pub fn sign(&self) -> i8 {
        if 0.0 < self.low {
            1
        } else if self.high < 0.0 {
            -1
        } else {
            0
        }
    }

    /// What is in both of two intervals that hold the same number.
    pub fn both(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.min(other.high))
    }

    /// z cot z on |z| < 1, between 1 − 0.36z² and 1.
    pub fn cotangent_times(self) -> Self {
        let most = self.low.abs().max(self.high.abs());
        if most < 1.0 {
            Self::outward(1.0 - 0.36 * most * most, 1.0)
        } else {
            Self::ALL
        }
    }

    /// Cosine of π times all of it, where a half turn more is the next extreme.
    fn cosine(self) -> Self {
        let [first, last] = [self.low, self.high].map(|h| h.sin_cos_pi().1);
        let mut low = first.min(last) - SINE;
        let mut high = first.max(last) + SINE;
        let (least, most) = (self.low.ceil(), self.high.floor());
        if least <= most {
            let is_even = |whole: f64| (0.5 * whole).floor() * 2.0 == whole;
            let several = 1.0 <= most - least;
            if several || is_even(least) {
                high = 1.0;
            }
            if several || !is_even(least) {
                low = -1.0;
            }
        }
        if !(self.high - self.low < 2.0) {
            return Self::new(-1.0, 1.0);
        }
        Self::new(low.max(-1.0), high.min(1.0))
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // Nothing, whatever it is multiplied by.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let all = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        let low = all.into_iter().fold(f64::INFINITY, f64::min);
        let high = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self::outward(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.holds_zero() {
            return Self::ALL;
        }
        self * Self::outward(1.0 / other.high, 1.0 / other.low)
    }
}

impl Number for Interval {
    fn number(value: f64) -> Self {
        Self::point(value)
    }
    fn pi() -> Self {
        Self::rounded(std::f64::consts::PI)
    }
    fn sine_cosine(self) -> (Self, Self) {
        // A quarter turn back, with the rounding of the difference.
        let turned = self - Self::point(0.5);
        (turned.cosine(), self.cosine())
    }
    fn squared(self) -> Self {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.holds_zero() { 0.0 } else { a.min(b) };
        let most = a.max(b);
        let square = Self::outward(least * least, most * most);
        Self::new(square.low.max(0.0), square.high)
    }
}

/// What a function and its slope are in over an interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet {
    pub value: Interval,
    pub slope: Interval,
}

impl Jet {
    pub fn fixed(value: Interval) -> Self {
        let slope = Interval::point(0.0);
        Self { value, slope }
    }

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

impl Number for Jet {
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
    use super::{Interval, Jet, Number};

    /// A formula with every operation, its value and its slope.
    fn formula<T: Number>(h: T) -> T {
        let (sine, cosine) = h.sine_cosine();
        (sine * h - cosine.squared()) / (h.squared() + T::number(0.5)) + -h
    }

    /// What is computed at points lies in what is computed over intervals, and so do difference quotients.
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

    #[test]
    fn cotangent() {
        for i in 1..100 {
            let z = 0.01 * f64::from(i);
            let held = Interval::new(-z, z).cotangent_times();
            assert!(held.low <= z / z.tan() && z / z.tan() <= held.high);
        }
        assert!(Interval::new(-1.0, 0.1).cotangent_times().low.is_infinite());
    }
}
