//! Numbers in double-double with what they may be off by: real ones and complex ones.

use frictiongen_kernel::number::dd::Dd;
use std::ops::{Add, Mul, Neg, Sub};

/// 2^−102, more than the relative error of an operation in double-double, which is below 2^−103.
const ROUNDING: f64 = 1.0 / 5_070_602_400_912_917_605_986_812_821_504.0;
/// More than what an operation loses by underflow, among numbers that are not tiny.
const LOST: f64 = 1e-280;
/// By this a sum of errors in double precision is enlarged for its own roundings.
const UP: f64 = 1.0 + 1e-14;
/// What is smaller may vanish when it is squared.
const SQUARED_AWAY: f64 = 1e-150;

/// A number that is within `off` of `at`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub at: Dd,
    pub off: f64,
}

impl Ball {
    /// A number in double-double as it stands.
    pub fn exact(at: Dd) -> Self {
        Self { at, off: 0.0 }
    }

    pub fn number(at: f64) -> Self {
        Self::exact(Dd::from(at))
    }

    /// The size of what is in the middle.
    fn middle(&self) -> f64 {
        self.at.abs().to_f64() * UP
    }

    /// No size in it is larger.
    pub fn most(&self) -> f64 {
        (self.middle() + self.off) * UP
    }

    /// No size in it is smaller.
    pub fn least(&self) -> f64 {
        (self.at.abs().to_f64() * (2.0 - UP) - self.off * UP).max(0.0)
    }

    fn rounded(at: Dd, off: f64) -> Self {
        let off = (off + at.abs().to_f64() * ROUNDING) * UP + LOST;
        // What is not a number may be anything.
        let off = if off.is_nan() { f64::INFINITY } else { off };
        Self { at, off }
    }

    /// 1 over it.
    pub fn inverse(self) -> Self {
        let least = self.least();
        let off = if least > 0.0 {
            self.off / (least * least) * UP
        } else {
            f64::INFINITY
        };
        Self::rounded(Dd::ONE / self.at, off)
    }

    /// The root of a number that is not negative.
    pub fn sqrt(self) -> Self {
        let root = self.at.max(Dd::ZERO).sqrt();
        // |√a − √b| ≤ |a − b|/√a, and no more than √|a − b|.
        let size = root.to_f64();
        let plain = self.off.sqrt() * UP;
        let off = if size > 0.0 {
            (self.off / size * UP).min(plain)
        } else {
            plain
        };
        Self::rounded(root, off)
    }
}

impl Add for Ball {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::rounded(self.at + other.at, self.off + other.off)
    }
}

impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            at: -self.at,
            off: self.off,
        }
    }
}

impl Sub for Ball {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let off = self.middle() * other.off + self.off * (other.middle() + other.off);
        Self::rounded(self.at * other.at, off)
    }
}

/// A complex number by its parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    pub re: Ball,
    pub im: Ball,
}

impl Disc {
    pub fn new(re: Ball, im: Ball) -> Self {
        Self { re, im }
    }

    pub fn real(re: Ball) -> Self {
        Self::new(re, Ball::number(0.0))
    }

    /// No size in it is larger.
    pub fn most(&self) -> f64 {
        let (re, im) = (self.re.most(), self.im.most());
        // What is lost by underflow of the squares is below the last number.
        (re * re + im * im).sqrt() * UP + SQUARED_AWAY
    }

    /// No size in it is smaller.
    pub fn least(&self) -> f64 {
        let (re, im) = (self.re.least(), self.im.least());
        ((re * re + im * im).sqrt() * (2.0 - UP) - SQUARED_AWAY).max(0.0)
    }

    pub fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }

    pub fn inverse(self) -> Self {
        let square = (self.re * self.re + self.im * self.im).inverse();
        Self::new(self.re * square, -(self.im * square))
    }
}

impl Add for Disc {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Disc {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Disc {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}
