//! Formulas of a critically damped mode, whose damping ratio ζ is 1.

use super::values::{
    Basis, Instant, ModeResponse, Turn, complement_and_factor, denominator, one_minus_d,
};
use crate::number::scalar::{Float, Scalar};

/// Evaluates the response and damping functions of a mode at the damping ratio ζ = 1. The formulas include terms of
/// first order in q² = 1 − ζ². The value of q² is 0, but for a dual number q² may have a derivative with respect to ζ.
#[inline]
pub(super) fn response<S: Scalar>(
    x: S,
    zeta: S,
    with_g: bool,
    at: Option<usize>,
) -> ModeResponse<S> {
    let one = S::constant(1.0);
    let (denominator, size) = denominator(x, zeta, at);
    let decay = (S::pi() * zeta * x).named("decay_exponent", "a = πζx with ζ = 1", at);
    let (m, e) = complement_and_factor(decay, at);
    // `square` is θ² with θ = πqx. x is the natural frequency divided by the excitation frequency.
    let angle = S::pi() * x;
    let square = angle * angle * ((one - zeta) * (one + zeta));
    let sinc_defect = square / S::constant(6.0);
    let k = (size / ((one + e) * (one + e) - e * square)).named(
        "pole_weight",
        "size/D with D = (1 + e)²",
        at,
    );
    let b_over_x = (S::pi() + S::pi()) * e * (k - k * sinc_defect);
    let defect = if with_g {
        decay.scaled_sinh_defect() + S::constant(2.0) * e * decay * sinc_defect
    } else {
        S::constant(0.0)
    };
    ModeResponse {
        x,
        denominator,
        size,
        u: b_over_x.named("u", "uR²·size = 2πe·size/D (7.11)", at),
        g: (defect * k).named("g", "g·size = (1 − e² − 2ae)·size/D (7.12)", at),
        reversal: ((one + e) * m * k + zeta * b_over_x * x).named(
            "reversal",
            "(g + 2ζRu)·size, the term of H_c (5.63, 7.47)",
            at,
        ),
    }
}

/// Evaluates the functions of time [`Basis`] of a mode with ζ = 1 at one instant. The formulas include terms of first
/// order in q² = 1 − ζ². The value of q² is 0, but derivatives with respect to ζ need the first order.
pub(super) fn basis<S: Float>(x: S, zeta: S, at: &Instant<S>) -> Basis<S> {
    let one = S::constant(1.0);
    let time = x * at.tau;
    let decay = zeta * time;
    let decay_factor = (-decay).exp();
    let square = time * time * ((one - zeta) * (one + zeta));
    let versine = square * S::constant(0.5);
    let sinc_defect = square / S::constant(6.0);
    let (cosine, sinc) = (one - versine, one - sinc_defect);
    let (free, slope) = (
        decay_factor * (at.tau * sinc),
        decay_factor * (cosine - decay * sinc),
    );
    let direct = one - decay_factor * (cosine + decay * sinc);
    let one_minus_d = one_minus_d(decay, decay_factor, direct, versine, sinc_defect);
    Basis::damped(x, zeta, free, slope, one_minus_d, at)
}

/// Returns the free motion of a critically damped mode during the time τ, in rad of the excitation.
#[inline]
pub(super) fn turn<S: Float>(x: S, tau: S) -> Turn<S> {
    let decay_factor = (-(x * tau)).exp();
    Turn {
        c: decay_factor,
        s: decay_factor * x * tau,
        decay_factor: S::constant(1.0),
    }
}
