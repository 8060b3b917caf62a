//! What the names in a frequency stage mean, for who reads it without the derivation at hand.

use frictiongen_kernel::oscillator::mode::{Kind, Mode};

const SUMS: [&str; 2] = [
    " Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of",
    " (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).",
];
const EVERY: &str = " `frequency` is x = √λ/r, `detuning` x² − 1, `size` |x² − 1| + 2ζx; the smallest `size` of a mode that the contact drives is E, `scale`.";
const ALONE: &str = " `inverse_r` is x = 1/r, as √λ is 1; `detuning` is x² − 1, `size` |x² − 1| + 2ζx, which is E, `scale`.";
const PARTS: &str = " `u` is uR²; it, `g` and `reversal` come times `size`, then times E.";
const UNDAMPED: [&str; 2] = [
    " Undamped: u = x·tan(πx/2), g = 0.  `sine` and `cosine` are of πx/2; `…_off_pole` is a divisor, or the number next to 0",
    " where that is exactly 0.",
];
const DAMPED: &str = " `loss` is 2ζx.";
const LIGHT: [&str; 6] = [
    " Below critical damping: u = x·(2e/q) sin(πqx)/D, g = (1 − e² − (2ζe/q) sin(πqx))/D, D = 1 + 2e cos(πqx) + e².",
    " `decay_exponent` is πζx, `decay_factor` e = exp(−πζx), `half_decay_factor` its root, `decay_complement` 1 − e; `sine` and",
    " `cosine` are of πqx/2, formed as the difference of πx/2 and π(1 − q)x/2; `half_turns` is qx.  D is the squared modulus of",
    " `nearness`, (1 + e) cos(πqx/2) + i(1 − e) sin(πqx/2); `inverse_nearness` is 1/(|re| + |im|) of it, `unit_nearness` it times",
    " that, and `pole_weight` `size` times that over the squared modulus of `unit_nearness`.  `swing` is uR times `size`;",
    " `scaled_sinh_defect` and `one_minus_sinc_pi` keep the digits of g where its terms cancel.",
];
const CRITICAL: [&str; 2] = [
    " Critically damped: u = 2πx²e/D, g = (1 − e² − 2πxe)/D, D = (1 + e)², e = exp(−πx).  `decay_exponent` is πx, `pole_weight`",
    " `size` over D.",
];
const OVER: [&str; 3] = [
    " Overdamped: u = x·(2e/q) sinh(πqx)/D, g = (1 − e² − (2ζe/q) sinh(πqx))/D, D = (1 + exp(−fast))(1 + exp(−slow)), e = exp(−πζx).",
    " `fast_decay` and `slow_decay` are π(ζ ± q)x, `spread` their difference, `pole_weight` `size` over D, `swing` uR times",
    " `size`.",
];

/// The lines of documentation, by the kinds of damping that a scene has.
pub(super) fn lines(modes: &[Mode<f64>]) -> Vec<&'static str> {
    let any = |kinds: &[Kind]| modes.iter().any(|mode| kinds.contains(&mode.kind));
    let mut lines = SUMS.to_vec();
    if modes.iter().any(|mode| mode.resonance != 1.0) {
        lines.push(EVERY);
    } else {
        lines.push(ALONE);
    }
    lines.push(PARTS);
    if any(&[Kind::Undamped]) {
        lines.extend(UNDAMPED);
    }
    if modes.iter().any(|mode| mode.kind != Kind::Undamped) {
        lines.push(DAMPED);
    }
    if any(&[Kind::Light, Kind::Heavy]) {
        lines.extend(LIGHT);
    }
    if any(&[Kind::Critical]) {
        lines.extend(CRITICAL);
    }
    if any(&[Kind::Over]) {
        lines.extend(OVER);
    }
    lines
}
