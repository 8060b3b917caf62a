//! Formulas of an overdamped mode, with the damping ratio ζ > 1 and q = √(ζ² − 1). The free motion of the mode is the
//! sum of two decaying exponentials.

use super::values::{Basis, Instant, ModeResponse, Turn, denominator};
use crate::number::scalar::{Float, Scalar};
use crate::number::special::exp_m1_minus;

/// Evaluates the response and damping functions of a mode with the damping ratio ζ > 1. The function combines the
/// exponentials e^{−πx(ζ∓q)} in a form in which neither exponential can overflow. x is the natural frequency divided by
/// the excitation frequency, and q = √(ζ² − 1).
#[inline]
pub(super) fn response<S: Scalar>(
    x: S,
    zeta: S,
    q: S,
    with_g: bool,
    at: Option<usize>,
) -> ModeResponse<S> {
    let one = S::constant(1.0);
    let pi = S::pi();
    let (denominator, size) = denominator(x, zeta, at);
    let fast = (pi * (zeta + q) * x).named(
        "fast_decay",
        "π(ζ + q)x, the exponent of the fast decay in half a period",
        at,
    );
    let slow = (pi / (zeta + q) * x).named(
        "slow_decay",
        "π(ζ − q)x = πx/(ζ + q), the exponent of the slow decay",
        at,
    );
    let fading = (-slow).named("slow_exponent", "−slow_decay", at);
    let spread =
        (S::constant(2.0) * pi * q * x).named("spread", "2πqx = fast_decay − slow_decay", at);
    let (e_slow, e_fast) = (
        fading
            .exp()
            .named("slow_decay_factor", "exp(−slow_decay)", at),
        (-fast).exp(),
    );
    let k = (size / ((one + e_slow) * (one + e_fast))).named(
        "pole_weight",
        "size/D with D = (1 + exp(−slow_decay))(1 + exp(−fast_decay))",
        at,
    );
    let b = (-(-spread).exp_m1() * e_slow / q * k).named(
        "u_times_r",
        "uR·size = (2e/q) sinh(πqx)·size/D with e = exp(−πζx) (7.11)",
        at,
    );
    let a = -(-(S::constant(2.0) * pi * zeta * x)).exp_m1() * k;
    // `defect` is 1 − e^{−2πζx} − (ζ/q)(e^{−slow} − e^{−fast}). The code computes `defect` from terms of the third
    // order in x, so that no larger terms cancel. The subtracted term is at most two thirds of the sum of the other
    // terms.
    let defect = if with_g {
        let half = S::constant(0.5);
        let minus_one =
            (-(fast * half))
                .exp_m1()
                .named("decay_minus_one", "exp(−fast_decay/2) − 1", at);
        let both = minus_one * minus_one * -fading.exp_m1();
        let small = S::constant(2.0) * (one + minus_one) * (slow * half).scaled_sinh_defect();
        let excess = e_slow * (pi * q * x).scaled_sinh_defect();
        both + small - excess / ((zeta + q) * q)
    } else {
        S::constant(0.0)
    };
    ModeResponse {
        x,
        denominator,
        size,
        u: (b / x).named("u", "uR²·size", at),
        g: (defect * k).named(
            "g",
            "g·size = (1 − e² − (2ζe/q) sinh(πqx))·size/D (7.12), in terms of third order in x",
            at,
        ),
        reversal: (a + zeta * b).named(
            "reversal",
            "(g + 2ζRu)·size, the term of H_c (5.63, 7.47)",
            at,
        ),
    }
}

/// Evaluates the functions of time [`Basis`] of an overdamped mode at one instant.
pub(super) fn basis<S: Float>(x: S, zeta: S, q: S, at: &Instant<S>) -> Basis<S> {
    let (one, half) = (S::constant(1.0), S::constant(0.5));
    let sum = zeta + q;
    let time = x * at.tau;
    let slow = (-(time / sum)).exp();
    let fast = (-(time * sum)).exp();
    let spread = (q + q) * time;
    let sinh = -(-spread).exp_m1() * slow * half / q;
    let cosh = (slow + fast) * half;
    let (free, slope) = (sinh / x, cosh - zeta * sinh);
    let decay = zeta * time;
    let one_minus_d = if S::constant(2.0) < sum && time < sum {
        // For both exponentials e^a, the code computes e^a − 1 − a, which contains only terms of second and higher
        // order in a. In the formulas of the other branches, the terms would cancel to a fraction 1/ζ² of their size.
        let (slow, fast) = (exp_m1_minus(-(time / sum)), exp_m1_minus(-(time * sum)));
        (fast / sum - slow * sum) * half / q
    } else if decay < half {
        // 1 − d is e^{−a}(e^a − cosh b − (a/b) sinh b) with a = ζxτ and b = qxτ. In this branch all terms are of second
        // or higher order in a and b.
        let b = q * time;
        let (plus, minus) = (exp_m1_minus(b), exp_m1_minus(-b));
        let sinh_ratio = if b > S::constant(0.0) {
            (plus - minus) * half / b
        } else {
            b
        };
        (-decay).exp() * (exp_m1_minus(decay) - (plus + minus) * half - decay * sinh_ratio)
    } else {
        one - cosh - zeta * sinh
    };
    Basis::damped(x, zeta, free, slope, one_minus_d, at)
}

/// Returns the free motion of an overdamped mode during the time τ, in rad of the excitation.
#[inline]
pub(super) fn turn<S: Float>(x: S, zeta: S, q: S, tau: S) -> Turn<S> {
    let half = S::constant(0.5);
    let time = x * tau;
    let sum = zeta + q;
    let slow = (-(time / sum)).exp();
    let fast = (-(time * sum)).exp();
    let spread = (q + q) * time;
    Turn {
        c: (slow + fast) * half,
        s: -(-spread).exp_m1() * slow * half / q,
        decay_factor: S::constant(1.0),
    }
}
