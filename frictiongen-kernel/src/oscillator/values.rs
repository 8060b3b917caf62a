//! Values that every kind of damping returns, and steps that several kinds share.

use crate::number::complex::Complex;
use crate::number::scalar::{Float, Scalar};
use crate::number::special::exp_m1_minus;

/// Functions of one mode at one frequency, each free of the pole at x = 1.
#[derive(Clone, Copy, Debug)]
pub struct ModeResponse<S> {
    /// Resonance of the mode over the excitation, x = √λ/r = 1/R.
    pub x: S,
    /// Denominator of the response, x² − 1 + 2iζx = x²/v.
    pub denominator: Complex<S>,
    /// Size of the denominator, |Re| + |Im|.
    pub size: S,
    /// Half-period function of the velocity, u R² times `size`.
    pub u: S,
    /// Half-period function of the displacement, g times `size`; 0 without damping.
    pub g: S,
    /// Contribution of damping to a reversal, (g + 2ζRu) times `size`; 0 without damping.
    pub reversal: S,
}

/// An instant of the half period: τ = πt.
#[derive(Clone, Copy, Debug)]
pub struct Instant<S> {
    /// Time in half-turns, t = τ/π.
    pub t: S,
    /// Time τ, rad.
    pub tau: S,
    /// sin τ.
    pub sine: S,
    /// cos τ.
    pub cosine: S,
    /// 1 − cos τ.
    pub versine: S,
}

/// Functions of one mode at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Basis<S> {
    /// Free displacement p = e^{−ζxτ} sin(qxτ)/(qx).
    pub free: S,
    /// Slope p′ of the free displacement.
    pub slope: S,
    /// sin τ − p.
    pub forced: S,
    /// cos τ − p′.
    pub forced_slope: S,
    /// (1 − d)/x² with d = p′ + 2ζx·p, the return from rest at distance 1.
    pub rise: S,
}

impl<S: Float> Basis<S> {
    /// Computes all functions from p, p′ and 1 − d = 1 − p′ − 2ζx·p. It takes cos τ − p′ from 1 − d, and so keeps the
    /// digits at τ → 0, where the velocity constraint divides by sin τ.
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

/// Free motion over a time: c = e^{−ζxτ}cos(qxτ) and s = e^{−ζxτ}sin(qxτ)/q, both entire in q².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn<S> {
    pub c: S,
    pub s: S,
    /// e^{−ζxτ}, the factor by which an oscillation has decayed. It is 1 where c and s contain no oscillation.
    pub decay_factor: S,
}

impl<S: Float> Turn<S> {
    /// Advances a free displacement y and a scaled velocity u = y′/x over the time.
    #[inline]
    pub(crate) fn moved(&self, zeta: S, [y, u]: [S; 2]) -> [S; 2] {
        let drag = zeta * self.s;
        [
            y * (self.c + drag) + u * self.s,
            u * (self.c - drag) - y * self.s,
        ]
    }
}

/// Returns x² − 1 + 2iζx and its size |Re| + |Im|.
#[inline]
pub(super) fn denominator<S: Scalar>(x: S, zeta: S, at: Option<usize>) -> (Complex<S>, S) {
    let one = S::constant(1.0);
    let re = ((x - one) * (x + one)).named("detuning", at);
    let im = (S::constant(2.0) * zeta * x).named("loss", at);
    (Complex::new(re, im), (re.abs() + im).named("size", at))
}

/// Returns 1 − e^{−decay} and e^{−decay}, each with its own digits. Subtracting one from 1 to get the other would lose
/// digits where the result is small.
#[inline]
pub(super) fn complement_and_factor<S: Scalar>(decay: S, at: Option<usize>) -> (S, S) {
    let half = (decay * S::constant(-0.5)).exp_m1();
    let half = half.named("half_decay_minus_one", at);
    let factor = (S::constant(1.0) + half).named("half_decay_factor", at);
    let (m, e) = (-(half * (S::constant(1.0) + factor)), factor * factor);
    (m.named("decay_complement", at), e.named("decay_factor", at))
}

/// Returns x·sin τ − sin xτ and cos τ − cos xτ. Close to x = 1 both are differences of nearly equal terms, and the
/// large damping functions of a resonance multiply them. Products replace the differences there. The velocity
/// constraint divides the second by sin τ, so that it must keep its digits at τ → 0.
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

/// Returns 1 − d as a sum of terms of one sign, e^{−a}[(e^a − 1 − a) + (1 − cos b) + a(1 − sin b/b)]. For a decay a of
/// at least 1 it returns `direct`.
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
