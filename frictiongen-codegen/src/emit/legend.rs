//! Documents the names of an emitted frequency stage, for readers without the derivation at hand.

use frictiongen_kernel::oscillator::mode::{Kind, Mode};

const SUMS: [&str; 2] = [
    " Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of",
    " (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).",
];
const SUMS_ON_BASE: [&str; 3] = [
    " Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: H, U, G and r²H_c of (φᵀw)² times `response`,",
    " uR², gR² and g + 2ζRu (`reversal`).  V is the motion relative to the base, r² times the sum of `static_residue`·(1 − 2iζx)·",
    " `response`, and of `on_moving_base`·E, the static part.",
];
/// Additional lines where damping acts on velocities relative to the moving base.
pub(super) const FROM_BASE: [&str; 3] = [
    " Damping acts relative to the base: to residue·`response` in V comes i(φᵀw)·2ζλΓ/x·`response` with Γ = φᵀΓ1, and on a moving",
    " base `static_residue` − 2iζx·wall takes the place of `static_residue`·(1 − 2iζx), wall being `static_residue` − (φᵀw)Γ.",
    " `QUADRATURES` has 2ζλΓ and wall of each mode.",
];
const AT_SCALE: &str =
    " `at_scale` has `response`, u and g of a mode times E: the last two times E over `size`.";
const ON_CONTACT: &str = " The load acts on the mass that rubs: a residue is (φᵀw)², and V = H.";
const EVERY: &str = " `x` is √λ/r = 1/R, `detuning` x² − 1, `size` |x² − 1| + 2ζx; E, `scale`, is the least of the modes in contact.";
const ALONE: &str = " `inverse_r` is x = 1/r, as √λ is 1; `detuning` is x² − 1, `size` |x² − 1| + 2ζx, which is E, `scale`.";
const PARTS: &str = " `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.";
const UNDAMPED: [&str; 2] = [
    " Undamped: u = x·tan(πx/2), g = 0.  `sine` and `cosine` are of πx/2; `…_off_pole` takes the place of an exact 0, so that no",
    " quotient is 0/0.",
];
const PARTS_DAMPED: &str = " `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.  `loss` is 2ζx.";
const BELOW: [&str; 2] = [
    " Below critical damping: u = x·(2e/q) sin(πqx)/D, g = (1 − e² − (2ζe/q) sin(πqx))/D, D = 1 + 2e cos(πqx) + e².",
    " `decay_exponent` is πζx, `decay_factor` e = exp(−πζx), `half_decay_factor` its root, `decay_complement` 1 − e; `sine` and",
];
const LIGHT: &str = " `cosine` are of πqx/2, the difference of πx/2 and π(1 − q)x/2, and sin(πqx) is twice their product; `half_turns` is qx.  D is";
const HEAVY: &str =
    " `cosine` are of πqx/2, and sin(πqx) is twice their product; `half_turns` is qx.  D is";
const NEARNESS: [&str; 4] = [
    " |`nearness`|², of (1 + e) cos(πqx/2) + i(1 − e) sin(πqx/2); `inverse_nearness` is 1/(|re| + |im|), `pole_weight` `size` times that",
    " over |`unit_nearness`|²: their product is `size`/D, in two factors, so that neither overflows beside a resonance.  `u_times_r` is",
    " uR times `size`.  g·D is (1 − e² − 2ae) + 2ae(1 − sin(πqx)/(πqx)) with a = πζx: `scaled_sinh_defect` of a is the first bracket,",
    " `one_minus_sinc_pi` of qx the second, without cancellation.  `reversal`, g + 2ζRu, is (1 − e²)/D + ζuR.",
];
const CRITICAL: [&str; 2] = [
    " Critically damped: u = 2πx²e/D, g = (1 − e² − 2πxe)/D, D = (1 + e)², e = exp(−πx).  `decay_exponent` is πx, `pole_weight`",
    " `size` over D.",
];
const OVER: [&str; 4] = [
    " Overdamped: u = x·(2e/q) sinh(πqx)/D, g = (1 − e² − (2ζe/q) sinh(πqx))/D, D = (1 + exp(−fast))(1 + exp(−slow)), e = exp(−πζx).",
    " `fast_decay` and `slow_decay` are π(ζ ± q)x, `spread` their difference, `slow_decay_factor` exp(−slow), `decay_minus_one`",
    " exp(−fast/2) − 1; `pole_weight` is `size` over D, `u_times_r` uR times `size`.  g comes in three parts of the third order in x,",
    " of which the one subtracted is at most two thirds of the others.",
];

/// Returns the legend of a frequency stage in which each mode has its own function.
pub(super) fn sums(on_base: bool) -> Vec<&'static str> {
    if on_base {
        SUMS_ON_BASE.to_vec()
    } else {
        SUMS.to_vec()
    }
}

/// Returns the legend of a straight-line frequency stage. `on_contact` is true if the load acts on the mass that rubs.
pub(super) fn lines(on_base: bool, on_contact: bool) -> Vec<&'static str> {
    let mut lines = sums(on_base);
    lines.push(AT_SCALE);
    lines.extend(on_contact.then_some(ON_CONTACT));
    lines
}

/// Returns the legend of the function of a mode with this damping kind.
pub(super) fn mode(kind: Kind) -> Vec<&'static str> {
    let mut lines = vec![EVERY];
    lines.extend(of(kind));
    lines
}

/// Returns the legend of a frequency stage with one mode.
pub(super) fn single(mode: &Mode<f64>, on_base: bool) -> Vec<&'static str> {
    let mut lines = sums(on_base);
    if mode.resonance == 1.0 {
        lines.push(ALONE);
    } else {
        lines.push(EVERY);
    }
    lines.extend(of(mode.kind));
    lines
}

fn of(kind: Kind) -> Vec<&'static str> {
    let lines: &[&[&str]] = match kind {
        Kind::Undamped => &[&[PARTS], &UNDAMPED],
        Kind::Light => &[&[PARTS_DAMPED], &BELOW, &[LIGHT], &NEARNESS],
        Kind::Heavy => &[&[PARTS_DAMPED], &BELOW, &[HEAVY], &NEARNESS],
        Kind::Critical => &[&[PARTS_DAMPED], &CRITICAL],
        Kind::Over => &[&[PARTS_DAMPED], &OVER],
    };
    lines.concat()
}
