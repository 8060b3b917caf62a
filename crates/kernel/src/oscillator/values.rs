//! Result types of the formulas for every kind of damping, and calculation steps that several kinds share.

use crate::number::complex::Complex;
use crate::number::scalar::{Float, Scalar};
use crate::number::special::exp_m1_minus;

/// Response and damping functions of one mode at one frequency. The code multiplies u, g and `reversal` by `size`. The
/// products stay finite at the resonance x = 1.
#[derive(Clone, Copy, Debug)]
pub struct ModeResponse<S> {
    /// Natural frequency of the mode divided by the excitation frequency, x = √λ/r. R is the inverse 1/x.
    pub x: S,
    /// Denominator of the mode's response v to the load, x² − 1 + 2iζx = x²/v.
    pub denominator: Complex<S>,
    /// |Re| + |Im| of `denominator`. This number is a measure of the distance from the resonance.
    pub size: S,
    /// Damping function u (7.11) of the mode, multiplied by R² and by `size`. A square wave of friction force causes a
    /// response of the mode. u is the slope of this response at the reversal.
    pub u: S,
    /// Damping function g (7.12) of the mode, multiplied by `size`. A square wave of friction force causes a response
    /// of the mode. g is the value of this response at the reversal. Without damping g is 0.
    pub g: S,
    /// Damping term g + 2ζRu of the mode, multiplied by `size`. This number is a term of H_c, the contribution of
    /// damping to the acceleration of the contact at a reversal. Without damping the number is 0.
    pub reversal: S,
}

/// An instant of the half period. The type stores the phase τ = ωt from a maximum of the relative displacement z̄, and
/// the sine and the cosine of τ.
#[derive(Clone, Copy, Debug)]
pub struct Instant<S> {
    /// Phase of the instant in half-turns (π rad), t = τ/π.
    pub t: S,
    /// Phase τ of the instant, in rad.
    pub tau: S,
    /// Sine of the phase τ.
    pub sine: S,
    /// Cosine of the phase τ.
    pub cosine: S,
    /// 1 − cos τ, where τ is the phase.
    pub versine: S,
}

/// Functions of time of one mode at one instant: the free displacement p, and quantities that the code derives from p.
/// The motion of the mode in the half period is a linear combination of these functions.
#[derive(Clone, Copy, Debug)]
pub struct Basis<S> {
    /// Free displacement p = e^{−ζxτ} sin(qxτ)/(qx) of the mode. This free motion starts from 0 with unit speed. x is
    /// the natural frequency divided by the excitation frequency.
    pub free: S,
    /// Derivative p′ of the free displacement p with respect to the phase τ.
    pub slope: S,
    /// Difference sin τ − p, where p is the free displacement of the mode.
    pub forced: S,
    /// Difference cos τ − p′, where p is the free displacement of the mode. This difference is the derivative of sin τ
    /// − p.
    pub forced_slope: S,
    /// (1 − d)/x², where d = p′ + 2ζx·p is the free motion of the mode that starts at rest from displacement 1.
    pub rise: S,
}

impl<S: Float> Basis<S> {
    /// Computes the fields of [`Basis`] from the free displacement p, its derivative p′, and 1 − d. Here d = p′ + 2ζx·p
    /// is the free motion of the mode that starts at rest from displacement 1.
    ///
    /// For τ → 0 both cos τ and p′ tend to 1, so that a subtraction would lose digits of cos τ − p′. The code therefore
    /// computes this difference from 1 − d. The digits matter in the search for the velocity constraint (the condition
    /// that the contact slides without a stop). The search divides a sum of such differences by sin τ, which also tends
    /// to 0.
    #[inline]
    pub(super) fn damped(
        x: S,
        zeta: S,
        free: S,
        slope: S,
        one_minus_d: S,
        at: &Instant<S>,
    ) -> Self {
        Self {
            free,
            slope,
            forced: at.sine - free,
            forced_slope: one_minus_d + (zeta + zeta) * x * free - at.versine,
            rise: one_minus_d / (x * x),
        }
    }
}

/// Free motion of one mode during a time τ. The motion consists of c = e^{−ζxτ}cos(qxτ) and s = e^{−ζxτ}sin(qxτ)/q,
/// where x is the natural frequency divided by the excitation frequency, and q² = 1 − ζ². Both c and s depend on q only
/// through q². A negative q² therefore describes an overdamped mode.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn<S> {
    pub c: S,
    pub s: S,
    /// Factor e^{−ζxτ} by which an oscillation of the mode decays during the time τ. For a mode that does not oscillate
    /// the factor is 1.
    pub decay_factor: S,
}

impl<S: Float> Turn<S> {
    /// Returns the free displacement y and the scaled velocity u = y′/x after the time τ, from y and u at the start. x
    /// is the natural frequency divided by the excitation frequency.
    #[inline]
    pub(crate) fn moved(&self, zeta: S, [y, u]: [S; 2]) -> [S; 2] {
        let drag = zeta * self.s;
        [
            y * (self.c + drag) + u * self.s,
            u * (self.c - drag) - y * self.s,
        ]
    }
}

/// Returns the denominator x² − 1 + 2iζx of a mode's response, and the sum |Re| + |Im| of the denominator.
#[inline]
pub(super) fn denominator<S: Scalar>(x: S, zeta: S, at: Option<usize>) -> (Complex<S>, S) {
    let one = S::constant(1.0);
    let re = ((x - one) * (x + one)).named("detuning", "x² − 1", at);
    let im = (S::constant(2.0) * zeta * x).named("loss", "2ζx", at);
    (
        Complex::new(re, im),
        (re.abs() + im).named("size", "|x² − 1| + 2ζx, small beside the resonance", at),
    )
}

/// Returns the two numbers 1 − e^{−decay} and e^{−decay}, each with full relative accuracy. The code does not compute
/// one number as 1 minus the other, because a small result would lose digits.
#[inline]
pub(super) fn complement_and_factor<S: Scalar>(decay: S, at: Option<usize>) -> (S, S) {
    let half = (decay * S::constant(-0.5)).exp_m1();
    let half = half.named("half_decay_minus_one", "exp(−a/2) − 1", at);
    let factor = (S::constant(1.0) + half).named("half_decay_factor", "exp(−a/2)", at);
    let (m, e) = (-(half * (S::constant(1.0) + factor)), factor * factor);
    (
        m.named("decay_complement", "1 − e", at),
        e.named("decay_factor", "e = exp(−a) with a = πζx (7.11)", at),
    )
}

/// Returns x·sin τ − sin xτ and cos τ − cos xτ. x is the natural frequency divided by the excitation frequency. Close
/// to the resonance x = 1 each result is a difference of nearly equal terms, and the damping function that multiplies
/// it is large. The code therefore computes products instead of differences. For τ → 0 the code also keeps the digits
/// of cos τ − cos xτ, because the velocity constraint divides this difference by sin τ.
#[inline]
pub(super) fn differences<S: Float>(x: S, sine_x: S, versine_x: S, at: &Instant<S>) -> (S, S) {
    let one = S::constant(1.0);
    let half = S::constant(0.5);
    let y = x - one;
    if y.abs() < half {
        let (s, _) = (y * at.t * half).sin_cos_pi();
        let (sum_sine, sum_cosine) = ((x + one) * half * at.t).sin_cos_pi();
        let two_s = s + s;
        (y * at.sine - two_s * sum_cosine, two_s * sum_sine)
    } else {
        (x * at.sine - sine_x, versine_x - at.versine)
    }
}

/// Returns 1 − d, where d is the free motion that starts at rest from displacement 1. If the decay a = ζxτ is below 1,
/// the result is e^{−a}[(e^a − 1 − a) + (1 − cos b) + a(1 − sin b/b)] with b = qxτ. All terms of this sum have the same
/// sign. For a larger decay the result is `direct`, in which no terms cancel.
#[inline]
pub(super) fn one_minus_d<S: Float>(
    decay: S,
    factor: S,
    direct: S,
    versine: S,
    sinc_defect: S,
) -> S {
    if decay < S::constant(1.0) {
        factor * (exp_m1_minus(decay) + versine + decay * sinc_defect)
    } else {
        direct
    }
}
