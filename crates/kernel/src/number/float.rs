//! Implementation of [`Scalar`] and [`Float`] for `f64` and `f32`.
//!
//! The crate `libm` provides the exponential functions and the arc tangent. All other functions consist of additions,
//! subtractions, multiplications, divisions and square roots. The results are therefore equal to the last bit on every
//! host. `tools/coefficients.py` computes the coefficients of the minimax polynomials.

use crate::number::scalar::{Float, Plain, Scalar};
use crate::number::trig::{double, polynomial, single};

/// Returns √x, correctly rounded.
#[inline]
pub(crate) fn sqrt_f64(x: f64) -> f64 {
    #[cfg(any(test, feature = "std"))]
    return x.sqrt();
    #[cfg(not(any(test, feature = "std")))]
    libm::sqrt(x)
}

/// Returns √x, correctly rounded.
#[inline]
fn sqrt_f32(x: f32) -> f32 {
    #[cfg(any(test, feature = "std"))]
    return x.sqrt();
    #[cfg(not(any(test, feature = "std")))]
    root(x)
}

/// Returns √x of an `f32`, correctly rounded, with half as many instructions as the function of libm. `root` is for
/// processors that have an instruction for division in single precision.
///
/// The iteration starts from an estimate of √x, for which the code halves the exponent of x. Three Heron steps leave
/// an error of at most one unit in the last place. The remainder x − root², computed exactly in integers, gives the
/// correction of this unit.
#[cfg(any(test, not(feature = "std")))]
fn root(x: f32) -> f32 {
    const TWO_TO_24: f32 = 16_777_216.0;
    const TWO_TO_12: f32 = 4096.0;
    const FRACTION: u32 = 0x007f_ffff;
    const ONE: u32 = 0x0080_0000;
    const INFINITE: u32 = 0x7f80_0000;
    let bits = x.to_bits();
    if bits.wrapping_sub(ONE) >= INFINITE - ONE {
        return if x > 0.0 && x < f32::MIN_POSITIVE {
            // The two scalings are exact, because their factors are powers of two.
            root(x * TWO_TO_24) / TWO_TO_12
        } else if x >= 0.0 {
            x
        } else {
            f32::NAN
        };
    }
    let mut near = f32::from_bits((bits >> 1) + 0x1fbd_1df5);
    near = 0.5 * (near + x / near);
    near = 0.5 * (near + x / near);
    near = 0.5 * (near + x / near);
    let near = near.to_bits();
    // The remainder x − near² fits into 32 bits, in units of the square of near's last place. The low 32 bits of both
    // terms are therefore enough. The left shift by at least 21 bits keeps only the low bits of x.
    let unit = (near & FRACTION) | ONE;
    let shift = ((bits >> 23) + 150).wrapping_sub(2 * (near >> 23));
    let remainder = bits
        .wrapping_shl(shift)
        .wrapping_sub(unit.wrapping_mul(unit));
    let (remainder, half) = (remainder.cast_signed(), unit.cast_signed());
    // Just below a power of two, adjacent numbers are half as far apart as just above it.
    let below = if unit == ONE { half / 2 } else { half };
    let (up, down) = (remainder > half, remainder <= -below);
    f32::from_bits(near + u32::from(up) - u32::from(down))
}

/// 2^400, the largest 1/r at which `f64` and double-double evaluate the formulas.
pub(crate) const POWER_400: f64 = f64::from_bits((1023 + 400) << 52);
/// 2^50, the largest 1/r at which `f32` evaluates the formulas.
const POWER_50: f32 = f32::from_bits((127 + 50) << 23);

macro_rules! real {
    (
        $float:ident, trig: $trig:ident, sqrt: $sqrt:path, exp: $exp:path, exp_m1: $exp_m1:path,
        atan2: $atan2:path, floor: $floor:path,
        inverse_range: $inverse_range:expr, euler_terms: $euler_terms:expr,
        sixth_pi_squared: $sixth_pi_squared:expr,
        sinc: [$sinc_first:expr, $($sinc:expr),+ $(,)?],
        sinh: [$sinh_first:expr, $($sinh:expr),+ $(,)?] $(,)?
    ) => {
        impl Scalar for $float {
            const MASS_CONTROLLED: bool = true;
            type Condition = bool;

            #[inline(always)]
            fn constant(value: f64) -> Self {
                value as Self
            }
            #[inline(always)]
            fn pi() -> Self {
                core::$float::consts::PI
            }
            #[inline(always)]
            fn inverse_pi() -> Self {
                core::$float::consts::FRAC_1_PI
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn is_zero(self) -> bool {
                self == 0.0
            }
            #[inline(always)]
            fn select(condition: bool, yes: Self, no: Self) -> Self {
                if condition { yes } else { no }
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self < other { other } else { self }
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if other < self { other } else { self }
            }
            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }
            #[inline]
            fn exp(self) -> Self {
                $exp(self)
            }
            #[inline]
            fn exp_m1(self) -> Self {
                $exp_m1(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                // The addition of 0 turns −0 into +0. Otherwise the sign of a sine that is exactly zero would decide
                // between the angles π and −π.
                $atan2(self + 0.0, x + 0.0)
            }
            #[inline]
            fn sin_cos_pi(self) -> (Self, Self) {
                $trig::sin_cos_pi(self)
            }
            #[inline]
            fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
                $trig::sin_cos_pi_minus(self, d)
            }
            #[inline]
            fn one_minus_sinc_pi(self) -> Self {
                let z = self;
                if z.abs() > 0.75 {
                    return 1.0 - $trig::sin_pi(z) / (core::$float::consts::PI * z);
                }
                // The product of the leading bits of two numbers has no rounding error, as in the module `trig`.
                const SIXTH_PI_SQUARED: [$float; 2] = $sixth_pi_squared;
                let u = z * z;
                let high = $trig::leading(z);
                let low = z - high;
                let main = high * high * SIXTH_PI_SQUARED[0];
                let rest = (z + high) * low * SIXTH_PI_SQUARED[0] + u * SIXTH_PI_SQUARED[1];
                main + (rest + u * u * ($sinc_first + u * polynomial!(u, $($sinc),+)))
            }
            #[inline]
            fn scaled_sinh_defect(self) -> Self {
                // e^{−a} rounds to 0 long before a = 1000. Without this bound, an infinite a would give the product
                // a·e^{−a} = NaN.
                let a = if self > 1000.0 { 1000.0 } else { self };
                let decay = Scalar::exp(-a);
                if a < 2.0 {
                    // The cube of the leading bits is exact. The code therefore rounds a³ only once.
                    let u = a * a;
                    let high = $trig::leading(a);
                    let square = high * high;
                    let cube = square * high + (a - high) * (u + a * high + square);
                    cube * (decay * ($sinh_first + u * polynomial!(u, $($sinh),+)))
                } else {
                    (1.0 - 2.0 * a * decay) - decay * decay
                }
            }
        }

        impl Float for $float {
            const EPSILON: f64 = $float::EPSILON as f64;
            const PAIRS: bool = true;

            #[inline(always)]
            fn inverse_ratio_range() -> (Self, Self) {
                $inverse_range
            }

            fn euler_terms() -> &'static [Self] {
                &$euler_terms
            }

            #[inline(always)]
            fn floor(self) -> Self {
                $floor(self)
            }

            #[inline(always)]
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "what is meant: the cast saturates"
            )]
            fn to_index(self) -> usize {
                self as u32 as usize
            }
            #[inline(always)]
            #[allow(clippy::cast_precision_loss, reason = "what is meant: the cast rounds")]
            fn whole(number: usize) -> Self {
                number as Self
            }
            #[inline(always)]
            fn sin_cos_pi_of<const N: usize>(h: [Self; N]) -> [[Self; N]; 2] {
                $trig::sin_cos_pi_of(h)
            }
            #[inline(always)]
            fn sin_cos_pi_minus_of<const N: usize>(h: [Self; N], d: [Self; N]) -> [[Self; N]; 2] {
                $trig::sin_cos_pi_minus_of(h, d)
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn at_most(self, other: Self) -> bool {
                self.to_bits() <= other.to_bits()
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
        }

        impl Plain for $float {}
    };
}

real! {
    f64, trig: double, sqrt: sqrt_f64, exp: libm::exp, exp_m1: libm::expm1, atan2: libm::atan2,
    floor: libm::floor, inverse_range: (POWER_400.recip(), POWER_400),
    euler_terms: super::euler::DOUBLE_TERMS,
    sixth_pi_squared: [1.6449356079101562, -1.5410619298135275e-06],
    sinc: [
        -0.8117424252833522,
        0.19075182412199804,
        -0.02614784781598732,
        0.002346081019796654,
        -0.00014842871143860948,
        6.975625221234919e-06,
        -2.526814375588628e-07,
        6.882639598707224e-09,
    ],
    sinh: [
        0.3333333333333333,
        0.016666666666666663,
        0.0003968253968254174,
        5.511463844743564e-06,
        5.0104216840524636e-08,
        3.2118082603021776e-10,
        1.5294543890514389e-12,
        5.617543964768898e-15,
        1.7156822258697436e-17,
    ],
}

real! {
    f32, trig: single, sqrt: sqrt_f32, exp: libm::expf, exp_m1: libm::expm1f, atan2: libm::atan2f,
    floor: libm::floorf, inverse_range: (POWER_50.recip(), POWER_50),
    euler_terms: super::euler::SINGLE_TERMS,
    sixth_pi_squared: [1.6484375, -0.0035034332],
    sinc: [-0.8117424, 0.19075158, -0.026145883, 0.0023391352, -0.00013717386],
    sinh: [0.33333334, 0.016666658, 0.00039684158, 5.499997e-06, 5.3386835e-08],
}

#[cfg(test)]
mod tests {
    use super::root;

    /// Compares the square root of `f32` with that of the standard library. The last bit of a root depends only on the
    /// significand and on the parity of the exponent. The test therefore covers one even and one odd exponent densely.
    #[test]
    fn roots_of_single_precision_are_rounded_correctly() {
        let edges = [0, 1, 2, 0x007f_ffff, 0x0080_0000, 0x7f7f_ffff, 0x7f80_0000].into_iter();
        let dense = (0x3f00_0000..0x4000_0000).step_by(if cfg!(debug_assertions) { 61 } else { 1 });
        let near = (0x3f7f_ff00..0x3f80_0100).chain(0x407f_ff00..0x4080_0100);
        let wide = (0..0x7f80_0000).step_by(100_003);
        for bits in edges.chain(dense).chain(near).chain(wide) {
            let x = f32::from_bits(bits);
            assert_eq!(root(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
        }
        assert!(root(-1.0).is_nan() && root(f32::NAN).is_nan());
        assert_eq!(root(-0.0).to_bits(), (-0.0_f32).to_bits());
    }
}
