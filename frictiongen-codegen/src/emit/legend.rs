//! What the names in a frequency stage mean, for who reads it without the derivation at hand.

use frictiongen_kernel::oscillator::mode::{Kind, Mode};

const EVERY: [&str; 2] = [
    " `frequency` is x = √λ/r = 1/R of a mode, `detuning` x² − 1, `size` |x² − 1| + 2ζx; the smallest `size` is E, `scale`.",
    " `u` is uR² and `reversal` g + 2ζRu; both and `g` come times `size`, then times E, as does `response`, 1/(x² − 1 + 2iζx).",
];
const UNDAMPED: &str = " Undamped: `sine` and `cosine` are of πx/2, and where a divisor is exactly 0 `…_off_pole` has another next to it.";
const DAMPED: &str = " `loss` is 2ζx.";
const LIGHT: [&str; 4] = [
    " Below critical damping: `decay_factor` e = exp(−πζx), `half_decay_factor` its root, `decay_complement` 1 − e; `sine` and",
    " `cosine` are of πqx/2, `half_turns` is qx.  1 + 2e cos πqx + e², by which u and g are divided, is the squared modulus of",
    " `nearness`, (1 + e) cos(πqx/2) + i(1 − e) sin(πqx/2); `unit_nearness` is that over |re| + |im|, and `pole_weight` `size`",
    " over the same and the squared modulus of `unit_nearness`.  `swing` is uR times `size`.",
];
const CRITICAL: &str =
    " Critically damped: `decay_exponent` is πx, `pole_weight` `size` over (1 + exp(−πx))².";
const OVER: [&str; 2] = [
    " Overdamped: `fast_decay` and `slow_decay` are π(ζ ± q)x, `spread` their difference, `pole_weight` `size` over",
    " (1 + exp(−fast))(1 + exp(−slow)), `swing` uR times `size`.",
];

/// The lines of documentation, by the kinds of damping that a scene has.
pub(super) fn lines(modes: &[Mode<f64>]) -> Vec<&'static str> {
    let any = |kinds: &[Kind]| modes.iter().any(|mode| kinds.contains(&mode.kind));
    let mut lines = EVERY.to_vec();
    if any(&[Kind::Undamped]) {
        lines.push(UNDAMPED);
    }
    if modes.iter().any(|mode| mode.kind != Kind::Undamped) {
        lines.push(DAMPED);
    }
    if any(&[Kind::Light, Kind::Heavy]) {
        lines.extend(LIGHT);
    }
    if any(&[Kind::Critical]) {
        lines.push(CRITICAL);
    }
    if any(&[Kind::Over]) {
        lines.extend(OVER);
    }
    lines
}
