//! Formulas of an underdamped mode, with the damping ratio 0 < ζ < 1 and q = √(1 − ζ²). The free motion of the mode is
//! a decaying oscillation.

use super::values::{
    Basis, Instant, ModeResponse, Turn, complement_and_factor, denominator, differences,
    one_minus_d,
};
use crate::number::scalar::{Float, Scalar};
use crate::number::special::versine_beside;

/// Evaluates the response and damping functions of a mode with the damping ratio 0 < ζ < 1 (section 3 of
/// `docs/derivation.md`). The formulas have the denominator 1 + E with E = e^{−πx(ζ−iq)}, which is nearly 0 at some x.
/// The code uses (1 + E)e^{−iθ/2} = (1 + e) cos(θ/2) − i m sin(θ/2) instead, with θ = πqx, e = |E| and m = 1 − e. This
/// form keeps its digits where the denominator is small.
#[inline(always)]
pub(super) fn response<S: Scalar>(
    x: S,
    zeta: S,
    q: S,
    near: Option<S>,
    with_g: bool,
    at: Option<usize>,
) -> ModeResponse<S> {
    let (one, half) = (S::constant(1.0), S::constant(0.5));
    let (denominator, size) = denominator(x, zeta, at);
    let decay = (S::pi() * zeta * x).named("decay_exponent", "a = πζx", at);
    let (m, e) = complement_and_factor(decay, at);
    let turns = (q * x).named(
        "half_turns",
        "qx, the half-turns of the free motion in half a period",
        at,
    );
    let (s, c) = if let Some(q_defect) = near {
        (x * half).sin_cos_pi_minus(x * (q_defect * half))
    } else {
        (turns * half).sin_cos_pi()
    };
    let (s, c) = (
        s.named("sine", "sin(πqx/2)", at),
        c.named("cosine", "cos(πqx/2)", at),
    );
    let re = ((one + e).named("one_plus_factor", "1 + e", at) * c).named(
        "nearness_re",
        "(1 + e) cos(πqx/2), whose square plus that of `nearness_im` is D = 1 + 2e cos(πqx) + e²",
        at,
    );
    let im = (m * s).named("nearness_im", "(1 − e) sin(πqx/2)", at);
    let inverse = (one / (re.abs() + im.abs())).named(
        "inverse_nearness",
        "1/(|nearness_re| + |nearness_im|): with little damping D itself could underflow beside a resonance",
        at,
    );
    let re = (re * inverse).named("unit_nearness_re", "nearness_re·inverse_nearness", at);
    let im = (im * inverse).named("unit_nearness_im", "nearness_im·inverse_nearness", at);
    let k = (size * inverse / (re * re + im * im)).named(
        "pole_weight",
        "size/(D·inverse_nearness)",
        at,
    );
    // The division 4/q comes first, because 4/q is a constant of the scene. The compiler of the emitted code then
    // evaluates it at compile time.
    let b = (S::constant(4.0) / q * s * e * (c * inverse) * k).named(
        "u_times_r",
        "uR·size = (2e/q) sin(πqx)·size/D (7.11)",
        at,
    );
    let a = (one + e) * (m * inverse) * k;
    let defect = if with_g {
        decay.scaled_sinh_defect() + S::constant(2.0) * e * decay * turns.one_minus_sinc_pi()
    } else {
        S::constant(0.0)
    };
    ModeResponse {
        x,
        denominator,
        size,
        u: (b / x).named("u", "uR²·size", at),
        g: (defect * inverse * k).named(
            "g",
            "g·size = (1 − e² − (2ζe/q) sin(πqx))·size/D (7.12)",
            at,
        ),
        reversal: (a + zeta * b).named(
            "reversal",
            "(g + 2ζRu)·size = ((1 − e²)/D + ζuR)·size, the term of H_c (5.63, 7.47)",
            at,
        ),
    }
}

/// Evaluates the functions of time [`Basis`] of a mode at one instant, for a damping ratio 0 < ζ < 1/2. The formulas
/// have no cancellation close to the resonance x = 1.
pub(super) fn light<S: Float>(x: S, zeta: S, q: S, q_defect: S, at: &Instant<S>) -> Basis<S> {
    let (one, half) = (S::constant(1.0), S::constant(0.5));
    let decay = zeta * x * at.tau;
    let complement = -(-decay).exp_m1();
    let decay_factor = one - complement;
    let turns = x * at.t;
    let defect = turns * q_defect;
    let (s, c) = turns.sin_cos_pi_minus(defect);
    let (sq, zq) = (s / q, zeta / q * s);
    let damped_turns = turns * q;
    let direct = one - decay_factor * (c + zq);
    let (free, slope) = (decay_factor * sq / x, decay_factor * (c - zq));
    let versine = versine_beside(damped_turns, c);
    let sinc_defect = damped_turns.one_minus_sinc_pi();
    let one_minus_d = one_minus_d(decay, decay_factor, direct, versine, sinc_defect);
    let mut basis = Basis::damped(x, zeta, free, slope, one_minus_d, at);
    if (x - one).abs() < half {
        // Each difference is the undamped difference plus a change due to damping. The code computes both parts without
        // cancellation.
        let (s0, c0) = turns.sin_cos_pi();
        let (forced, forced_slope) = differences(x, s0, versine_beside(turns, c0), at);
        let (half_s, _) = (defect * half).sin_cos_pi();
        let (mid_s, mid_c) = turns.sin_cos_pi_minus(defect * half);
        let two = S::constant(2.0);
        let sine_change = (two * mid_c * half_s - q_defect * s0) / q;
        let cosine_change = -(two * mid_s * half_s);
        basis.forced = (forced + complement * s0 + decay_factor * sine_change) / x;
        basis.forced_slope = forced_slope + complement * c0 + decay_factor * (cosine_change + zq);
    }
    basis
}

/// Evaluates the functions of time [`Basis`] of a mode at one instant, for a damping ratio 1/2 ≤ ζ < 1.
pub(super) fn heavy<S: Float>(x: S, zeta: S, q: S, at: &Instant<S>) -> Basis<S> {
    let one = S::constant(1.0);
    let decay = zeta * x * at.tau;
    let decay_factor = (-decay).exp();
    let turns = q * x * at.t;
    let (s, c) = turns.sin_cos_pi();
    let (sq, zq) = (s / q, zeta / q * s);
    let (free, slope) = (decay_factor * sq / x, decay_factor * (c - zq));
    let direct = one - decay_factor * (c + zq);
    let (versine, sinc_defect) = (versine_beside(turns, c), turns.one_minus_sinc_pi());
    let one_minus_d = one_minus_d(decay, decay_factor, direct, versine, sinc_defect);
    Basis::damped(x, zeta, free, slope, one_minus_d, at)
}

/// Returns the free motion of an underdamped mode during the time τ = πt, in rad of the excitation.
#[inline]
pub(super) fn turn<S: Float>(x: S, zeta: S, q: S, t: S, tau: S) -> Turn<S> {
    let decay_factor = (-(zeta * x * tau)).exp();
    let (s, c) = (q * x * t).sin_cos_pi();
    Turn {
        c: decay_factor * c,
        s: decay_factor * s / q,
        decay_factor,
    }
}
