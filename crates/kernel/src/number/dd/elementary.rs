//! Elementary functions in double-double arithmetic, with errors of about 1e-31.

use super::tables::LN_2;
use super::{Dd, INVERSE_FACTORIAL, ordered_sum, two_product, two_sum};
use crate::number::float::POWER_400;
use crate::number::scalar::{Float, Plain, Scalar};
use crate::number::trig::double;

/// Returns the normalised sum `large + small`, where |large| must be at least 2·|small|.
#[inline]
fn dominated_sum(large: Dd, small: Dd) -> Dd {
    let (hi, rest) = ordered_sum(large.hi, small.hi);
    Dd::joined(hi, rest + (large.lo + small.lo))
}

/// Returns the sum of the series Σ cₖvᵏ, in which each term is far smaller than the previous term. From index `exact`
/// on, all terms are smaller than 2^−55 times the first term. The code therefore computes these terms in `f64`.
#[inline]
fn series<'a>(
    coefficients: impl DoubleEndedIterator<Item = &'a Dd> + ExactSizeIterator + Clone,
    exact: usize,
    v: Dd,
) -> Dd {
    let (head, tail) = (coefficients.clone().take(exact), coefficients.skip(exact));
    let tail = tail.rfold(0.0, |sum, coefficient| sum * v.hi + coefficient.hi);
    head.rfold(Dd::from(tail), |sum, coefficient| {
        dominated_sum(*coefficient, sum * v)
    })
}

/// Returns 18 inverse factorials in steps of two: 1/first!, 1/(first + 2)!, …. The series of a sine or cosine has these
/// coefficients.
#[expect(
    clippy::indexing_slicing,
    reason = "only while compiling, where a panic is an error of the build"
)]
const fn in_twos(first: usize) -> [Dd; 18] {
    let mut factorials = [Dd::ZERO; 18];
    let mut k = 0;
    while k < factorials.len() {
        factorials[k] = INVERSE_FACTORIAL[first + 2 * k];
        k += 1;
    }
    factorials
}
/// Inverse factorials of even numbers, 1/2!, 1/4! … 1/36!, for the cosine.
static EVEN: [Dd; 18] = in_twos(2);
/// Inverse factorials of odd numbers, 1/3!, 1/5! … 1/37!, for the sine.
static ODD: [Dd; 18] = in_twos(3);

/// Returns Σ factorials[k]·vᵏ over the first `terms` terms. From index `exact` on, the code computes the terms in
/// `f64`.
fn factorials_in_twos(factorials: &[Dd], terms: usize, exact: usize, v: Dd) -> Dd {
    series(factorials.iter().take(terms), exact, v)
}

/// Returns the integer q for which q/2 is nearest to h, and the exact remainder h − q/2. h is an angle in half-turns
/// (π rad). Only the two lowest bits of q are correct, because a sine or cosine needs only q modulo 4.
fn reduced(h: Dd) -> (u64, Dd) {
    // If `hi` is above 2^53, `hi` is an integer, but `lo` may still contain a fraction. The code therefore reduces both
    // `hi` and `lo`.
    let (q, high) = double::reduced_any(h.hi);
    let (p, low) = double::reduced_any(h.lo);
    let (sum, lost) = two_sum(high, low);
    let (o, rest) = double::reduced_any(sum);
    (q.wrapping_add(p).wrapping_add(o), Dd::sum(rest, lost))
}

/// Returns the sine and cosine of πr + qπ/2, for |r| ≤ 1/4.
fn turned(q: u64, r: Dd) -> (Dd, Dd) {
    let x = r * Dd::PI;
    let u = x * x;
    let sin = x - x * u * factorials_in_twos(&ODD, 15, 8, -u);
    let cos = Dd::ONE - u * factorials_in_twos(&EVEN, 16, 9, -u);
    match q & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Returns 2^k for −1022 ≤ k ≤ 1023.
fn power_of_two(k: i32) -> f64 {
    f64::from_bits(u64::from((1023 + k).unsigned_abs()) << 52)
}

/// Returns the integer k nearest to x/ln 2, and e^(x − k ln 2) − 1, for |x| < 800.
fn reduced_exp_m1(x: Dd) -> (i32, Dd) {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    const HALVINGS: usize = 4;
    let k = (x.hi * core::f64::consts::LOG2_E + SHIFT) - SHIFT;
    let [first, second, third] = LN_2;
    let (third, lost) = two_product(k, third);
    let rest = x - Dd::from(k * first) - Dd::from(k * second) - Dd::new(third, lost);
    let r = rest.scaled(1.0 / f64::from(1 << HALVINGS));
    let series = series(INVERSE_FACTORIAL.iter().take(17).skip(1), 8, r);
    // Each step doubles the argument of the exponential function: (1 + p)² − 1 = 2p + p².
    let grown = (0..HALVINGS).fold(series * r, |p, _| p.scaled(2.0) + p * p);
    (k as i32, grown)
}

impl Scalar for Dd {
    type Condition = bool;

    fn constant(value: f64) -> Self {
        Self::from(value)
    }
    fn pi() -> Self {
        Self::PI
    }
    fn inverse_pi() -> Self {
        Self::ONE / Self::PI
    }
    fn lt(self, other: Self) -> bool {
        self < other
    }
    fn is_zero(self) -> bool {
        Self::is_zero(self)
    }
    fn select(condition: bool, yes: Self, no: Self) -> Self {
        if condition { yes } else { no }
    }
    fn abs(self) -> Self {
        Self::abs(self)
    }
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }
    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }
    fn copysign(self, sign: Self) -> Self {
        if self.hi.is_sign_negative() == sign.hi.is_sign_negative() {
            self
        } else {
            -self
        }
    }

    fn exp(self) -> Self {
        if self.hi.is_nan() || self.hi > 710.0 {
            return Self::from(self.hi * f64::INFINITY);
        }
        if self.hi < -746.0 {
            return Self::ZERO;
        }
        let (k, grown) = reduced_exp_m1(self);
        // The code scales the result in two steps, because 2^1024 and the powers below 2^−1022 are not representable as
        // `f64`.
        let half = k / 2;
        (Self::ONE + grown)
            .scaled(power_of_two(half))
            .scaled(power_of_two(k - half))
    }

    fn exp_m1(self) -> Self {
        if self.hi.is_nan() || self.hi.abs() > 64.0 {
            return self.exp() - Self::ONE;
        }
        let (k, grown) = reduced_exp_m1(self);
        if k == 0 {
            return grown;
        }
        let power = power_of_two(k);
        grown.scaled(power) + Self::sum(power, -1.0)
    }

    fn atan2(self, x: Self) -> Self {
        let (mut y, mut x) = (self, x);
        let start = Scalar::atan2(y.hi, x.hi);
        if !start.is_finite() || !y.hi.is_finite() || !x.hi.is_finite() {
            return Self::from(start);
        }
        if y.is_zero() {
            return if x.hi < 0.0 { Self::PI } else { Self::ZERO };
        }
        // An angle smaller than 1e-17 equals the quotient y/x. The general method would scale y and lose the last
        // digits of y.
        if x.hi > 0.0 && start.abs() < 1e-17 {
            return y / x;
        }
        // The angle depends only on the quotient of y and x. The scaling avoids overflow and keeps the last digits.
        let size = y.hi.abs().max(x.hi.abs());
        let power = match size {
            size if size > 1e100 => power_of_two(-700),
            size if size < 1e-100 => power_of_two(700),
            _ => 1.0,
        };
        (y, x) = (y.scaled(power), x.scaled(power));
        // One Newton step adds the tangent of the remaining angle. The tangent may replace the angle itself, because
        // the cube of this angle is below 1e-45.
        let (sin, cos) = (Self::from(start) / Self::PI).sin_cos_pi();
        Self::from(start) + (y * cos - x * sin) / (x * cos + y * sin)
    }

    fn sin_cos_pi(self) -> (Self, Self) {
        let (q, r) = reduced(self);
        turned(q, r)
    }

    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        let (q, r) = reduced(self);
        let (p, s) = reduced(d);
        let (difference, lost) = two_sum(r.hi, -s.hi);
        let (o, rest) = double::reduced_any(difference);
        // The next sum is the only step that rounds. All earlier steps are exact.
        let rest = Self::sum(rest, lost) + Self::sum(r.lo, -s.lo);
        turned(q.wrapping_sub(p).wrapping_add(o), rest)
    }

    fn one_minus_sinc_pi(self) -> Self {
        let x = self * Self::PI;
        if self.hi.abs() < 0.5 {
            let u = x * x;
            return u * factorials_in_twos(&ODD, 18, 10, -u);
        }
        Self::ONE - self.sin_cos_pi().0 / x
    }

    fn scaled_sinh_defect(self) -> Self {
        // e^{−a} rounds to 0 long before a = 1000. Without this bound, an infinite a would give the product a·e^{−a} =
        // NaN.
        let a = if self.hi > 1000.0 {
            Self::from(1000.0)
        } else {
            self
        };
        let decay = (-a).exp();
        if a.hi < 2.0 {
            let u = a * a;
            return (a * u * factorials_in_twos(&ODD, 18, 11, u) * decay).scaled(2.0);
        }
        Self::ONE - decay * (decay + a.scaled(2.0))
    }
}

impl Float for Dd {
    /// Rounding unit of double-double arithmetic, 2^−104.
    const EPSILON: f64 = 1.0 / (1_u128 << 104) as f64;
    /// Resolution of a search in double-double arithmetic, 2^−90. Sums of many terms are not more accurate.
    const RESOLUTION: f64 = 1.0 / (1_u128 << 90) as f64;

    fn inverse_ratio_range() -> (Self, Self) {
        (Self::from(POWER_400.recip()), Self::from(POWER_400))
    }

    fn floor(self) -> Self {
        let hi = libm::floor(self.hi);
        let lo = if hi == self.hi {
            libm::floor(self.lo)
        } else {
            0.0
        };
        Self::from(hi) + Self::from(lo)
    }

    fn to_f64(self) -> f64 {
        Self::to_f64(self)
    }
}

impl Plain for Dd {}
