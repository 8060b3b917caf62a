//! Real and complex numbers in double-double, with bounds on their errors.

use frictiongen_kernel::number::dd::Dd;
use std::ops::{Add, Mul, Neg, Sub};

/// Bound on the relative error of a double-double operation: 2^−102. The actual error is below 2^−103.
const ROUNDING: f64 = 1.0 / 5_070_602_400_912_917_605_986_812_821_504.0;
/// Bound on the absolute error that underflow causes in an operation. The bound is not valid for tiny operands.
const LOST: f64 = 1e-280;
/// Factor on a sum of errors in double precision. It covers the rounding of the sum itself.
pub(super) const UP: f64 = 1.0 + 1e-14;
/// Modulus below which the square of a number may underflow.
const SQUARED_AWAY: f64 = 1e-150;

/// An uncertain number: `at` with an absolute error of at most `off`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub at: Dd,
    pub off: f64,
}

impl Ball {
    /// Creates a ball that contains only one double-double number.
    pub fn exact(at: Dd) -> Self {
        Self { at, off: 0.0 }
    }

    pub fn number(at: f64) -> Self {
        Self::exact(Dd::from(at))
    }

    /// Returns the modulus of the middle of the ball, rounded upwards.
    fn middle(&self) -> f64 {
        self.at.abs().to_f64() * UP
    }

    /// Returns an upper bound on the modulus of the uncertain number.
    pub fn most(&self) -> f64 {
        (self.middle() + self.off) * UP
    }

    /// Returns a lower bound on the modulus of the uncertain number.
    pub fn least(&self) -> f64 {
        (self.at.abs().to_f64() * (2.0 - UP) - self.off * UP).max(0.0)
    }

    fn rounded(at: Dd, off: f64) -> Self {
        let off = (off + at.abs().to_f64() * ROUNDING) * UP + LOST;
        // A NaN bound becomes infinite.
        let off = if off.is_nan() { f64::INFINITY } else { off };
        Self { at, off }
    }

    /// Returns the reciprocal of the uncertain number, with a bound on its error.
    pub fn inverse(self) -> Self {
        let least = self.least();
        let off = if least > 0.0 {
            self.off / (least * least) * UP
        } else {
            f64::INFINITY
        };
        Self::rounded(Dd::ONE / self.at, off)
    }

    /// Returns the square root of an uncertain number that is not negative.
    pub fn sqrt(self) -> Self {
        let root = self.at.max(Dd::ZERO).sqrt();
        // |√a − √b| is at most |a − b|/√a, and also at most √|a − b|.
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

/// An uncertain complex number. Real and imaginary part are each a [`Ball`].
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

    /// Returns an upper bound on the modulus of the uncertain complex number.
    pub fn most(&self) -> f64 {
        let (re, im) = (self.re.most(), self.im.most());
        // `SQUARED_AWAY` is added because the squares may underflow.
        (re * re + im * im).sqrt() * UP + SQUARED_AWAY
    }

    /// Returns a lower bound on the modulus of the uncertain complex number.
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
