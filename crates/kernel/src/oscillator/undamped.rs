//! Formulas of an undamped mode, whose damping ratio ζ is 0.

use super::values::{Basis, Instant, ModeResponse, Turn, differences};
use crate::number::complex;
use crate::number::scalar::{Float, Scalar};
use crate::number::special::versine_beside;

/// Returns x² − 1 of an undamped mode, where x is the natural frequency divided by the excitation frequency. If x² − 1
/// is exactly 0, the result is a tiny number, so that it can be a divisor.
#[inline]
pub(super) fn detuning<S: Scalar>(x: S) -> S {
    let one = S::constant(1.0);
    ((x - one) * (x + one)).detuning_off_pole()
}

/// Evaluates the response and damping functions of an undamped mode: v = x²/(x² − 1), u = x·tan(πx/2), g = 0. x is the
/// natural frequency divided by the excitation frequency. Both v and u have a pole at x = 1. The function u also has
/// poles at x = 3, 5, 7 and all further odd x. The code replaces exact zeros of the two divisors by tiny numbers, so
/// that no quotient is 0/0.
#[inline(always)]
pub(super) fn response<S: Scalar>(x: S, at: Option<usize>) -> ModeResponse<S> {
    let zero = S::constant(0.0);
    let (s, c) = (x * S::constant(0.5)).sin_cos_pi();
    let s = s.named("sine", "sin(πx/2)", at);
    let re = detuning(x).named(
        "detuning",
        "x² − 1; a tiny number in place of an exact 0",
        at,
    );
    let c = c.named("plain_cosine", "cos(πx/2)", at);
    let c = c.cosine_off_pole().named(
        "cosine",
        "cos(πx/2); a tiny number in place of an exact 0",
        at,
    );
    let size = re.abs().named("size", "|x² − 1|", at);
    ModeResponse {
        x,
        denominator: complex::real(re),
        size,
        u: (s * size / (x * c)).named("u", "uR²·size = tan(πx/2)/x·size (5.20, 5.34)", at),
        g: zero,
        reversal: zero,
    }
}

/// Evaluates the functions of time [`Basis`] of an undamped mode at one instant.
#[inline]
pub(super) fn basis<S: Float>(x: S, at: &Instant<S>) -> Basis<S> {
    let half_turns = x * at.t;
    let (sine, cosine) = half_turns.sin_cos_pi();
    let versine = versine_beside(half_turns, cosine);
    let (forced, forced_slope) = differences(x, sine, versine, at);
    Basis {
        free: sine / x,
        slope: cosine,
        forced: forced / x,
        forced_slope,
        rise: versine / (x * x),
    }
}

/// Returns the free motion of an undamped mode during the time τ = πt, in rad of the excitation.
#[inline]
pub(super) fn turn<S: Float>(x: S, t: S) -> Turn<S> {
    let (s, c) = (x * t).sin_cos_pi();
    let decay_factor = S::constant(1.0);
    Turn { c, s, decay_factor }
}
