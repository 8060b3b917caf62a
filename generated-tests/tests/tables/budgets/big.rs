//! Numbers of about 190 digits, against which double-double is measured. They consist of integers.
//!
//! This module shares nothing with the kernel. A significand has [`BITS`] bits, and each operation is cut off after
//! them. Elementary functions are Taylor series. The printed formulas are evaluated as they are. The digits that they
//! lose by cancellation are far fewer than the digits of the numbers.

use frictiongen_kernel::number::dd::Dd;
use num_bigint::{BigInt, Sign};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

const BITS: u64 = 640;

/// A number: `significand` times 2 to the power of `exponent`.
#[derive(Clone, Debug)]
pub struct Big {
    significand: BigInt,
    exponent: i64,
}

impl Big {
    fn new(significand: BigInt, exponent: i64) -> Self {
        let surplus = significand.bits().saturating_sub(BITS);
        Self {
            significand: significand >> surplus,
            exponent: exponent + surplus as i64,
        }
    }

    pub fn integer(n: i64) -> Self {
        Self::new(BigInt::from(n), 0)
    }

    /// Returns the big number that equals `x`, which must be finite.
    pub fn of(x: f64) -> Self {
        assert!(x.is_finite(), "{x} has no value");
        let bits = x.abs().to_bits();
        let (raw, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
        let significand = if raw == 0 {
            fraction
        } else {
            fraction | 1 << 52
        };
        let number = Self::new(BigInt::from(significand), raw.max(1) - 1075);
        if x < 0.0 { -number } else { number }
    }

    pub fn of_dd(x: Dd) -> Self {
        Self::of(x.hi) + Self::of(x.lo)
    }

    pub fn is_zero(&self) -> bool {
        self.significand.sign() == Sign::NoSign
    }

    pub fn is_negative(&self) -> bool {
        self.significand.sign() == Sign::Minus
    }

    pub fn abs(&self) -> Self {
        if self.is_negative() {
            -self.clone()
        } else {
            self.clone()
        }
    }

    /// Returns the exponent of the power of two that the leading bit stands for.
    pub fn order(&self) -> i64 {
        self.significand.bits() as i64 - 1 + self.exponent
    }

    /// Returns the number times 2 to the power of `power`.
    pub fn shifted(mut self, power: i64) -> Self {
        self.exponent += power;
        self
    }

    /// Returns the nearest `f64`, or 0 or ∞ beyond the range of `f64`.
    pub fn to_f64(&self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        let surplus = self.significand.bits() as i64 - 62;
        let leading = if surplus > 0 {
            &self.significand >> surplus as u64
        } else {
            self.significand.clone()
        };
        let exponent = self.exponent + surplus.max(0);
        let leading = i64::try_from(leading).expect("62 bits") as f64;
        let half = (exponent / 2).clamp(-2000, 2000) as i32;
        let rest = (exponent - exponent / 2).clamp(-2000, 2000) as i32;
        leading * 2.0_f64.powi(half) * 2.0_f64.powi(rest)
    }

    /// Returns the nearest integer.
    fn rounded(&self) -> BigInt {
        let half = Self::new(BigInt::from(1), -1);
        let sum = self.clone() + half;
        if sum.exponent >= 0 {
            sum.significand << sum.exponent as u64
        } else {
            // A shift of a negative number to the right rounds it down.
            sum.significand >> (-sum.exponent) as u64
        }
    }

    /// Returns the largest integer that is not larger than the number.
    pub fn floor(&self) -> Self {
        if self.exponent >= 0 {
            return self.clone();
        }
        Self::new(&self.significand >> (-self.exponent) as u64, 0)
    }

    pub fn sqrt(&self) -> Self {
        let mut up = 2 * BITS as i64 - self.significand.bits() as i64;
        up += (self.exponent - up) & 1;
        let root = (&self.significand << up.max(0) as u64).sqrt();
        Self::new(root, (self.exponent - up) / 2)
    }

    /// Returns Σ x^k/k! from k = `first` in steps of `step`, alternating or not, for |x| < 1.
    fn series(x: &Self, first: u32, step: u32, alternating: bool) -> Self {
        let mut term = Self::integer(1);
        for k in 1..=first {
            term = term * x.clone() / Self::integer(k.into());
        }
        let (mut sum, mut k) = (Self::integer(0), first);
        while !term.is_zero() && (sum.is_zero() || term.order() > sum.order() - BITS as i64) {
            sum = sum + term.clone();
            for _ in 0..step {
                k += 1;
                term = term * x.clone() / Self::integer(k.into());
            }
            if alternating {
                term = -term;
            }
        }
        sum
    }

    pub fn exp(&self) -> Self {
        if self.is_zero() {
            return Self::integer(1);
        }
        let halvings = (self.order() + 8).max(0);
        assert!(halvings < 100, "e^{} is out of any range", self.to_f64());
        let mut power = Self::series(&self.clone().shifted(-halvings), 0, 1, false);
        for _ in 0..halvings {
            power = power.clone() * power;
        }
        power
    }

    /// Returns e^x − 1.
    pub fn exp_m1(&self) -> Self {
        if self.is_zero() || self.order() < -8 {
            return Self::series(self, 1, 1, false);
        }
        self.exp() - Self::integer(1)
    }

    /// Returns e^x − 1 − x.
    pub fn exp_m1_minus(&self) -> Self {
        if self.is_zero() || self.order() < -8 {
            return Self::series(self, 2, 1, false);
        }
        self.exp() - Self::integer(1) - self.clone()
    }

    /// Returns π by Machin's formula.
    pub fn pi() -> Self {
        static PI: OnceLock<Big> = OnceLock::new();
        let inverse_tangent = |n: i64| {
            let (mut power, mut sum, mut k) =
                (Self::integer(1) / Self::integer(n), Self::integer(0), 1);
            while power.order() > -(BITS as i64) - 8 {
                sum = sum + power.clone() / Self::integer(k);
                power = -(power / Self::integer(n * n));
                k += 2;
            }
            sum
        };
        PI.get_or_init(|| {
            Self::integer(16) * inverse_tangent(5) - Self::integer(4) * inverse_tangent(239)
        })
        .clone()
    }

    /// Returns (sin πh, cos πh).
    pub fn sin_cos_pi(&self) -> (Self, Self) {
        let quarters = self.clone().shifted(1).rounded();
        let rest = self.clone() - Self::new(quarters.clone(), -1);
        let x = rest * Self::pi();
        let (sin, cos) = (Self::series(&x, 1, 2, true), Self::series(&x, 0, 2, true));
        let turn = i64::try_from(((quarters % 4) + 4) % 4_i64).expect("below 4");
        match turn {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// Returns 1 − cos πh.
    pub fn versine_pi(&self) -> Self {
        let (sin, _) = self.clone().shifted(-1).sin_cos_pi();
        (sin.clone() * sin).shifted(1)
    }
}

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.significand, self.exponent)
    }
}

impl Add for Big {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (high, low) = if self.exponent < other.exponent {
            (other, self)
        } else {
            (self, other)
        };
        let distance = (high.exponent - low.exponent) as u64;
        // A number that is below every stored bit of the other number does not change the sum.
        if high.order() - low.order() > 2 * BITS as i64 {
            return high;
        }
        Self::new(
            (high.significand << distance) + low.significand,
            low.exponent,
        )
    }
}

impl Sub for Big {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Big {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.significand * other.significand,
            self.exponent + other.exponent,
        )
    }
}

impl Div for Big {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let up = BITS + other.significand.bits();
        Self::new(
            (self.significand << up) / other.significand,
            self.exponent - up as i64 - other.exponent,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Big;

    /// Asserts that |a − b| is below 2^−600 times |b|.
    fn agree(a: Big, b: Big) {
        let off = a - b.clone();
        assert!(
            off.is_zero() || off.order() < b.order() - 600,
            "{}",
            off.to_f64()
        );
    }

    #[test]
    fn identities_hold() {
        for x in [0.3, 1.7, 12.0, 1e-9, -3.3] {
            let big = Big::of(x);
            assert_eq!(big.to_f64(), x);
            let (sin, cos) = big.sin_cos_pi();
            agree(
                sin.clone() * sin.clone() + cos.clone() * cos.clone(),
                Big::integer(1),
            );
            agree(
                big.clone().shifted(1).sin_cos_pi().0,
                (sin * cos).shifted(1),
            );
            agree(big.exp() * (-big.clone()).exp(), Big::integer(1));
            let root = (big.clone() * big.clone()).sqrt();
            agree(root, big.abs());
        }
        // The expected π and e are sums of two `f64`, for their first digits.
        let off = Big::pi() - Big::of(std::f64::consts::PI) - Big::of(1.2246467991473532e-16);
        assert!(off.order() < -105);
        let off =
            Big::integer(1).exp() - Big::of(std::f64::consts::E) - Big::of(1.4456468917292502e-16);
        assert!(off.order() < -105);
        // For a small argument sin πh equals the first terms of its series.
        let x = Big::pi() * Big::of(1e-120);
        agree(
            Big::of(1e-120).sin_cos_pi().0,
            x.clone() - x.clone() * x.clone() * x / Big::integer(6),
        );
    }
}
