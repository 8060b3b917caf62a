//! Response of a mass-controlled mode to a unit force that changes its sign every half period. A mode is
//! mass-controlled if it resonates far below the excitation frequency. Its inertia then outweighs its spring.
//!
//! In a half period the response y obeys y″ + 2ζx y′ + x²y = 1. ζ is the damping ratio of the mode, and x its natural
//! frequency divided by the excitation frequency. In the next half period y repeats with the opposite sign.
//!
//! The solution is y = Σ_{n≥2} h_{n−2} e_n with e_n(τ) = πⁿE_n(τ/π)/n!, where E_n are the Euler polynomials. The
//! coefficients are h_0 = 1, h_1 = −2ζx, h_m = −2ζx h_{m−1} − x²h_{m−2}. The coefficients decrease like powers of |s|,
//! where s are the roots of s² + 2ζx s + x² = 0. For large n the polynomials e_n approach sinusoids. The code therefore
//! sums a few orders, and adds the remainder of the series as one sinusoid in closed form.
//!
//! For any other mode, the code computes y as the sum of three terms: the return from rest, the lag and the static
//! displacement (see [`motion`](crate::response::coefficients)). If the excitation is far above the resonance, each of
//! the three terms is of order 1, while y itself is small. At the start and end of the half period y vanishes, but the
//! three terms do not. In the middle y′ vanishes, but the slopes of the three terms do not. The rounding error of their
//! sum would exceed the motion of a mass far from load and contact. The Euler polynomials have no such error, because
//! they vanish at the same instants as y and y′.

use crate::number::complex::{self, Complex};
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::decay::{Basis, Instant};
use crate::oscillator::mode::Kind;

/// Upper bound on x = √λ/r of a mass-controlled mode, which resonates far below the excitation frequency. x is the
/// natural frequency of the mode divided by the excitation frequency. For an overdamped mode the bound applies to 2ζx,
/// with the damping ratio ζ.
const SLOW: f64 = 0.5;
/// Returns true if a mode is mass-controlled: its natural frequency divided by the excitation frequency, x = √λ/r, is
/// below [`SLOW`]. For an overdamped mode, the function compares 2ζx with this bound. For a scalar without Euler
/// polynomials the result is false.
#[inline]
pub(crate) fn is_mass_controlled<S: Scalar>(kind: Kind, zeta: S, x: S) -> S::Condition {
    if !S::MASS_CONTROLLED {
        return x.lt(S::constant(0.0));
    }
    // Both decay rates of an overdamped mode are smaller than 2ζx. A mode whose 2ζx is below the bound is therefore
    // slow enough.
    let rate = if kind == Kind::Over {
        (zeta + zeta) * x
    } else {
        x
    };
    // The code compares both kinds of rate with the same constant. A choice between two constants would cost a
    // conversion from double precision, which is expensive on a microcontroller.
    rate.lt(S::constant(SLOW))
}

/// Evaluates the response y of a mass-controlled mode to a unit force that changes its sign every half period. x is
/// the natural frequency of the mode divided by the excitation frequency. The result has y in the field `rise`, y′ in
/// `free` and y″ in `slope`.
pub(crate) fn basis<S: Float>(x: S, zeta: S, at: &Instant<S>) -> Basis<S> {
    let (zero, half, one) = (S::constant(0.0), S::constant(0.5), S::constant(1.0));
    let w = at.tau * (S::pi() * (one - at.t));
    let w_slope = (S::pi() + S::pi()) * (half - at.t);
    // At τ = 0, w = τ(π − τ) is 0, and only the lowest power of w contributes to each polynomial and its derivative.
    // The derivative of a dual number also needs the other powers.
    let starts = at.t.is_zero() && !S::CARRIES;
    let (loss, square) = (-((zeta + zeta) * x), x * x);
    // At step m, `first`, `before` and `now` are the coefficients h_2m−4, h_2m−3 and h_2m−2, and `last` is the
    // polynomial e_2m−2.
    let (mut first, mut before, mut now, mut last) = (zero, zero, one, one);
    let (mut value, mut slope) = (zero, zero);
    let (mut rest, mut order, mut degree) = (S::euler_terms(), 1, one);
    // `sign` is (−1)^m.
    let mut sign = one;
    while let Some((row, others)) = rest.split_at_checked(order) {
        // `even` becomes e_2m, and `odd` becomes its derivative e_2m−1.
        let (mut even, mut odd, mut power) = (zero, zero, degree);
        let row = if starts {
            power = one;
            row.last().map_or(row, core::slice::from_ref)
        } else {
            row
        };
        for term in row {
            even = even * w + *term;
            odd = odd * w + *term * power;
            power = power - one;
        }
        let (even, odd) = (even * w, odd * w_slope);
        value = value + (before * odd + now * even);
        slope = slope + (before * last + now * odd);
        let next = loss * now - square * before;
        (first, before, now, last) = (now, next, loss * next - square * now, even);
        (rest, order, degree, sign) = (others, order + 1, degree + one, -sign);
    }
    // With N = 2m and the coefficients h_n of the series, the remainder of the series is 4/π Im[(−1)^m i (h_N−1 + i
    // x²h_N−2) e^{iτ}/(x² − 1 + 2iζx)].
    let denominator = Complex::new((x - one) * (x + one), -loss);
    let numerator = Complex::new(-(square * first), before);
    let turning = complex::mul(numerator, complex::reciprocal(denominator, true), true);
    let turning = complex::scale(turning, sign * S::constant(4.0) * S::inverse_pi());
    value = value + (turning.re * at.sine + turning.im * at.cosine);
    slope = slope + (turning.re * at.cosine - turning.im * at.sine);
    Basis {
        free: slope,
        slope: one + loss * slope - square * value,
        forced: zero,
        forced_slope: zero,
        rise: value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::dd::Dd;
    use crate::oscillator::decay::{Damped, Decay};
    use crate::oscillator::mode::Mode;

    /// Returns the response of a mode and its slope in double-double precision, as a reference for the tests. In each
    /// of the two sums, the terms nearly cancel. The cancellation multiplies the relative error by at most x⁻².
    /// Double-double has enough digits for this loss.
    fn put_together(mode: &Mode<Dd>, x: Dd, t: Dd) -> (Dd, Dd) {
        let response = mode.response(x, 0);
        let (u, g) = (response.u / response.size, response.g / response.size);
        let basis = Damped::of(mode).basis(x, &Instant::new(t));
        let square = x * x;
        let value = (Dd::ONE + g) * basis.rise - g / square - u * basis.free;
        let slope = (Dd::ONE + g) * basis.free - u * basis.slope;
        (value, slope)
    }

    fn mode(zeta: Dd) -> Mode<Dd> {
        let one = Dd::ONE;
        let kind = match zeta.to_f64() {
            0.0 => Kind::Undamped,
            zeta if zeta < 0.5 => Kind::Light,
            zeta if zeta < 1.0 => Kind::Heavy,
            1.0 => Kind::Critical,
            _ => Kind::Over,
        };
        let q = ((one - zeta) * (one + zeta)).abs().sqrt();
        Mode {
            kind,
            in_contact: true,
            resonance: one,
            zeta,
            q,
            q_defect: zeta * zeta / (one + q),
            load: one,
            contact: one,
            residue: one,
            contact_squared: one,
            static_residue: one,
        }
    }

    /// Compares the response y of mass-controlled modes and its slope y′ with a reference in double-double precision.
    /// The reference is the sum of the return from rest, the lag and the static displacement. The tolerances are
    /// fractions of y and y′, even close to their zeros.
    #[test]
    fn as_put_together() {
        for zeta in [0.0, 1e-9, 0.01, 0.3, 0.7, 1.0, 1.5, 9.0] {
            for x in [1e-6, 1e-3, 0.02, 0.1249, 0.25, 0.4999] {
                if !is_mass_controlled(mode(Dd::from(zeta)).kind, zeta, x) {
                    continue;
                }
                for t in [0.0, 1e-9, 0.1, 0.499_999, 0.5, 0.7, 1.0 - 1e-9, 1.0] {
                    let (value, slope) = put_together(&mode(zeta.into()), x.into(), t.into());
                    let got = basis(x, zeta, &Instant::new(t));
                    for (got, want) in [(got.rise, value), (got.free, slope)] {
                        // Bound on the rounding error of the reference, a double-double sum.
                        let lost = 1e-30 / (x * x);
                        let off = (Dd::from(got) - want).abs().to_f64();
                        let bar = 16.0 * f64::EPSILON * want.to_f64().abs() + lost;
                        assert!(off <= bar, "ζ {zeta}, x {x}, t {t}: {got:e} {want:?}");
                    }
                }
            }
        }
    }

    /// Returns the third harmonic of the errors of a response and of its slope in `f32`, divided by `f32::EPSILON`. The
    /// neglected orders of the series mainly cause a third harmonic. The average over many instants removes the
    /// rounding errors.
    fn third_harmonic_of_the_error(x: f64, zeta: f64) -> (f64, f64) {
        const INSTANTS: u32 = 4096;
        let (mut sine, mut cosine) = ((0.0, 0.0), (0.0, 0.0));
        for i in 0..INSTANTS {
            let t = (f64::from(i) + 0.5) / f64::from(INSTANTS);
            // The formulas in `f32` and in double-double get the same instant and the same mode, rounded to `f32`.
            let (t, x, zeta) = (t as f32, x as f32, zeta as f32);
            let wide = |value: f32| Dd::from(f64::from(value));
            let (value, slope) = put_together(&mode(wide(zeta)), wide(x), wide(t));
            let got = basis(x, zeta, &Instant::new(t));
            let (s, c) = (3.0 * core::f64::consts::PI * f64::from(t)).sin_cos();
            let off = f64::from(got.rise) - value.to_f64();
            sine = (sine.0 + off * s, sine.1 + off * c);
            let off = f64::from(got.free) - slope.to_f64();
            cosine = (cosine.0 + off * s, cosine.1 + off * c);
        }
        let unit = 2.0 / f64::from(INSTANTS) / f64::from(f32::EPSILON);
        (sine.0.hypot(sine.1) * unit, cosine.0.hypot(cosine.1) * unit)
    }

    /// Checks that the series of Euler polynomials in `f32` has enough orders, and not too many. The error from the
    /// neglected orders must be smaller than the rounding error. With one order less, it must be larger.
    #[test]
    fn single_precision_has_enough_orders() {
        let mut worst = (0.0_f64, 0.0_f64);
        for zeta in [0.0, 0.01, 0.3, 0.7] {
            for x in [0.3, 0.4, 0.45, 0.499] {
                let (value, slope) = third_harmonic_of_the_error(x, zeta);
                println!("ζ {zeta}, x {x}: {value} {slope}");
                worst = (worst.0.max(value), worst.1.max(slope));
            }
        }
        println!("16 modes; third harmonic of the error {worst:?} roundings");
        assert!(worst.0 < 0.25 && worst.1 < 0.25);
    }

    /// Compares the response of mass-controlled modes in `f32` with a reference in double-double precision, at each
    /// instant separately. The reference is the sum of the return from rest, the lag and the static displacement.
    #[test]
    fn as_put_together_in_single_precision() {
        let (mut compared, mut worst) = (0, 0.0_f64);
        for zeta in [0.0_f32, 1e-4, 0.01, 0.3, 0.7, 1.0, 1.5, 9.0] {
            for x in [1e-3_f32, 0.02, 0.1249, 0.25, 0.4, 0.4999] {
                let wide = |value: f32| Dd::from(f64::from(value));
                if !is_mass_controlled(mode(wide(zeta)).kind, zeta, x) {
                    continue;
                }
                for t in [0.0_f32, 1e-4, 0.1, 0.4999, 0.5, 0.7, 0.9999, 1.0] {
                    let (value, slope) = put_together(&mode(wide(zeta)), wide(x), wide(t));
                    let got = basis(x, zeta, &Instant::new(t));
                    for (got, want) in [(got.rise, value), (got.free, slope)] {
                        let lost = 1e-30 / f64::from(x * x);
                        let off = (wide(got) - want).abs().to_f64();
                        // At the bounds of the half period the response y vanishes, but its damping terms do not. The
                        // rounding errors of the damping terms remain. The tolerance therefore contains ζx.
                        let size = want.to_f64().abs() + f64::from(zeta * x);
                        let unit = f64::from(f32::EPSILON) * size + lost;
                        assert!(
                            off <= 4.0 * unit,
                            "ζ {zeta}, x {x}, t {t}: {got:e} {want:?}"
                        );
                        worst = worst.max(off / unit);
                        compared += 1;
                    }
                }
            }
        }
        println!("{compared} values, worst {worst} roundings");
        assert_eq!(compared, 656);
    }
}
