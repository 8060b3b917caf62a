//! Functions such as 1 − cos πz that keep full relative accuracy where a plain difference would cancel. The
//! coefficients of the minimax polynomials come from `tools/coefficients.py`.

use crate::number::dd::INVERSE_FACTORIAL;
use crate::number::scalar::Float;
use crate::number::trig::polynomial;

/// Returns 1 − cos πz. The result has full relative accuracy for every z, even near even integers z, where the result
/// is 0.
///
/// The result is within 2.5 units in the last place of `f64` and `f32`, and within 1e-30 in double-double.
///
/// ```
/// use frictiongen_kernel::number::special::versine_pi;
///
/// assert_eq!(versine_pi(0.5), 1.0);
/// assert_eq!(versine_pi(1.0_f32), 2.0);
/// assert!((versine_pi(1e-12) / 4.934802200544679e-24 - 1.0_f64).abs() < 1e-15);
/// ```
#[inline]
#[must_use]
pub fn versine_pi<T: Float>(z: T) -> T {
    versine_beside(z, z.cos_pi())
}

/// Returns 1 − cos πz, from z and the known `cosine` = cos πz.
#[inline]
pub(crate) fn versine_beside<T: Float>(z: T, cosine: T) -> T {
    // If 1 − cos πz is not small, the plain difference does not lose digits. The code then uses the plain difference,
    // because it has fewer roundings.
    let versine = T::constant(1.0) - cosine;
    if versine < T::constant(0.5) {
        let sin = (z * T::constant(0.5)).sin_pi();
        T::constant(2.0) * sin * sin
    } else {
        versine
    }
}

/// Returns e^a − 1 − a. The result has full relative accuracy for every a, even near a = 0, where the result is 0.
///
/// The result is within 3.5 units in the last place of `f64` and `f32`, and within 1e-30 in double-double.
///
/// ```
/// use frictiongen_kernel::number::special::exp_m1_minus;
///
/// assert!((exp_m1_minus(1e-10) / 5.000000000166667e-21 - 1.0_f64).abs() < 1e-15);
/// assert_eq!(exp_m1_minus(f64::INFINITY), f64::INFINITY);
/// ```
#[inline]
#[must_use]
pub fn exp_m1_minus<T: Float>(a: T) -> T {
    if a.abs() < T::constant(1.0) {
        let c = T::constant;
        // Each number type has its own branch. T::EPSILON is a constant, so that the compiler removes the branches of
        // other types.
        let curve = if T::EPSILON < 1e-20 {
            INVERSE_FACTORIAL
                .iter()
                .take(32)
                .skip(2)
                .rev()
                .fold(c(0.0), |sum, coefficient| {
                    sum * a + (c(coefficient.hi) + c(coefficient.lo))
                })
        } else if T::EPSILON < 1e-10 {
            c(0.5)
                + a * polynomial!(
                    a,
                    c(0.16666666666666666),
                    c(0.041666666666666664),
                    c(0.00833333333333324),
                    c(0.001388888888888958),
                    c(0.0001984126984137176),
                    c(2.480158730119695e-05),
                    c(2.755731917507634e-06),
                    c(2.7557319324962825e-07),
                    c(2.505212041332562e-08),
                    c(2.08767448204811e-09),
                    c(1.6057462240887358e-10),
                    c(1.1471241254813485e-11),
                    c(7.752867030331909e-13),
                    c(4.7988420380473736e-14),
                )
        } else {
            c(0.5)
                + a * polynomial!(
                    a,
                    c(0.16666667),
                    c(0.041666668),
                    c(0.008333345),
                    c(0.0013888859),
                    c(0.00019837049),
                    c(2.4804369e-05),
                    c(2.8123015e-06),
                    c(2.7712534e-07),
                )
        };
        return a * a * curve;
    }
    let grown = a.exp_m1();
    // If e^a − 1 overflows, the result is infinite. Subtracting an infinite a from this result would give NaN.
    if grown.is_finite() { grown - a } else { grown }
}
