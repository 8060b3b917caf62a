//! One mode of the chain: its constants, and its response and damping functions at a frequency.
//!
//! With x = √λ/r = 1/R every function of a single mode is written in x, which is rounded once, so
//! that the response v, and the half-period damping functions u and g (7.11, 7.12) stay consistent
//! beside their common pole x = 1.  Sums over modes are carried times the *scale* E, the smallest
//! |x² − 1 + 2iζx| of the chain: everything is then finite on a resonance as well as beside it.

use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// How a mode decays; it decides which closed form its functions take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// ζ = 0.
    Undamped,
    /// 0 < ζ < 1/2: 1 − q is kept beside q, so that the pole at small ζ loses nothing.
    Light,
    /// 1/2 ≤ ζ < 1.
    Heavy,
    /// ζ = 1.
    Critical,
    /// ζ > 1: no oscillation.
    Over,
}

/// The constants of one mode; they depend on the scene alone, not on r.
#[derive(Clone, Copy, Debug)]
pub struct Mode<S> {
    /// Which closed form applies.
    pub kind: Kind,
    /// Whether the contact drives the mode: φᵀw ≠ 0.
    pub in_contact: bool,
    /// √λ: the frequency ratio r at which the mode resonates.
    pub resonance: S,
    /// Modal damping ratio ζ.
    pub zeta: S,
    /// √|1 − ζ²|.
    pub q: S,
    /// 1 − q, to full relative accuracy (used for [`Kind::Light`]).
    pub q_defect: S,
    /// φᵀp: how strongly the load drives the mode.
    pub load: S,
    /// φᵀw: how strongly the contact drives the mode.
    pub contact: S,
    /// (φᵀw)(φᵀp), the residue load → contact times λ.
    pub residue: S,
    /// (φᵀw)²: the mode's part c of the inverse effective mass of the contact.
    pub inverse_mass: S,
    /// (φᵀw)(φᵀp)/λ, the static residue load → contact.
    pub static_residue: S,
}

/// The functions of one mode at one frequency, each free of the pole at x = 1.
#[derive(Clone, Copy, Debug)]
pub struct ModeResponse<S> {
    /// x = √λ/r = 1/R.
    pub x: S,
    /// x² − 1 + 2iζx = x²/v.
    pub denominator: Complex<S>,
    /// |Re| + |Im| of the denominator.
    pub size: S,
    /// (u R²) times `size`.
    pub u: S,
    /// g times `size`; 0 without damping.
    pub g: S,
    /// (g + 2ζRu) times `size`; 0 without damping.
    pub reversal: S,
}

impl<S: Scalar> ModeResponse<S> {
    /// All zero: what an array of modes starts from.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            x: zero,
            denominator: complex::real(zero),
            size: zero,
            u: zero,
            g: zero,
            reversal: zero,
        }
    }
}

impl<S: Scalar> Mode<S> {
    /// The functions of the mode at r = 1/`inverse_r`; `index` only names values in emitted code.
    #[inline]
    pub fn response(&self, inverse_r: S, index: usize) -> ModeResponse<S> {
        let at = Some(index);
        let x = (self.resonance * inverse_r).named("frequency", at);
        match self.kind {
            Kind::Undamped => undamped(x, at),
            Kind::Light | Kind::Heavy => self.oscillating(x, at),
            Kind::Critical => self.critical(x, at),
            Kind::Over => self.overdamped(x, at),
        }
    }

    /// x² − 1 + 2iζx and its size.
    #[inline]
    fn denominator(&self, x: S, at: Option<usize>) -> (Complex<S>, S) {
        let one = S::constant(1.0);
        let re = ((x - one) * (x + one)).named("detuning", at);
        let im = (S::constant(2.0) * self.zeta * x).named("loss", at);
        (Complex::new(re, im), (re.abs() + im).named("size", at))
    }

    /// 0 < ζ < 1, section 3 of `docs/derivation.md` with 1 + e^{−πx(ζ−iq)} written about its zeros:
    /// (1 + E)e^{−iθ/2} = (1 + e) cos(θ/2) − i m sin(θ/2), θ = πqx.
    #[inline]
    fn oscillating(&self, x: S, at: Option<usize>) -> ModeResponse<S> {
        let (one, half) = (S::constant(1.0), S::constant(0.5));
        let (denominator, size) = self.denominator(x, at);
        let decay = (S::pi() * self.zeta * x).named("decay_exponent", at);
        let (m, e) = complement_and_factor(decay, at);
        let turns = (self.q * x).named("half_turns", at);
        let (s, c) = if self.kind == Kind::Light {
            (x * half).sin_cos_pi_minus(x * (self.q_defect * half))
        } else {
            (turns * half).sin_cos_pi()
        };
        let (s, c) = (s.named("sine", at), c.named("cosine", at));
        let re = ((one + e).named("one_plus_factor", at) * c).named("nearness_re", at);
        let im = (m * s).named("nearness_im", at);
        let inverse = (one / (re.abs() + im.abs())).named("inverse_nearness", at);
        let re = (re * inverse).named("unit_nearness_re", at);
        let im = (im * inverse).named("unit_nearness_im", at);
        let k = (size * inverse / (re * re + im * im)).named("pole_weight", at);
        let b = (S::constant(4.0) * e * (s / self.q) * (c * inverse) * k).named("swing", at);
        let a = (one + e) * (m * inverse) * k;
        let defect =
            decay.scaled_sinh_defect() + S::constant(2.0) * e * decay * turns.one_minus_sinc_pi();
        ModeResponse {
            x,
            denominator,
            size,
            u: (b / x).named("u", at),
            g: (defect * inverse * k).named("g", at),
            reversal: (a + self.zeta * b).named("reversal", at),
        }
    }

    /// ζ = 1: the limit q → 0 of both neighbours, to first order in q² = 1 − ζ²: its value is 0, but a
    /// derivative with respect to ζ moves it.
    #[inline]
    fn critical(&self, x: S, at: Option<usize>) -> ModeResponse<S> {
        let one = S::constant(1.0);
        let (denominator, size) = self.denominator(x, at);
        let decay = (S::pi() * self.zeta * x).named("decay_exponent", at);
        let (m, e) = complement_and_factor(decay, at);
        // θ², θ = πqx.
        let angle = S::pi() * x;
        let square = angle * angle * ((one - self.zeta) * (one + self.zeta));
        let sinc_defect = square / S::constant(6.0);
        let k = (size / ((one + e) * (one + e) - e * square)).named("pole_weight", at);
        let b_over_x = (S::pi() + S::pi()) * e * (k - k * sinc_defect);
        let defect = decay.scaled_sinh_defect() + S::constant(2.0) * e * decay * sinc_defect;
        ModeResponse {
            x,
            denominator,
            size,
            u: b_over_x.named("u", at),
            g: (defect * k).named("g", at),
            reversal: ((one + e) * m * k + self.zeta * b_over_x * x).named("reversal", at),
        }
    }

    /// ζ > 1: two real decays, e^{−πx(ζ∓q)}, combined before they can overflow.
    #[inline]
    fn overdamped(&self, x: S, at: Option<usize>) -> ModeResponse<S> {
        let one = S::constant(1.0);
        let pi = S::pi();
        let (denominator, size) = self.denominator(x, at);
        let fast = (pi * (self.zeta + self.q) * x).named("fast_decay", at);
        let slow = (pi / (self.zeta + self.q) * x).named("slow_decay", at);
        let fading = (-slow).named("slow_exponent", at);
        let spread = (S::constant(2.0) * pi * self.q * x).named("spread", at);
        let (e_slow, e_fast) = (fading.exp().named("slow_decay_factor", at), (-fast).exp());
        let k = (size / ((one + e_slow) * (one + e_fast))).named("pole_weight", at);
        let b = (-(-spread).exp_m1() * e_slow / self.q * k).named("swing", at);
        let a = -(-(S::constant(2.0) * pi * self.zeta * x)).exp_m1() * k;
        // 1 − e^{−2πζx} − (ζ/q)(e^{−slow} − e^{−fast}) from parts of the third order in x, of which
        // the one subtracted is never more than two thirds of the others.
        let half = S::constant(0.5);
        let lost = (-(fast * half)).exp_m1().named("decay_minus_one", at);
        let both = lost * lost * -fading.exp_m1();
        let small = S::constant(2.0) * (one + lost) * (slow * half).scaled_sinh_defect();
        let excess = e_slow * (pi * self.q * x).scaled_sinh_defect();
        let defect = both + small - excess / ((self.zeta + self.q) * self.q);
        ModeResponse {
            x,
            denominator,
            size,
            u: (b / x).named("u", at),
            g: (defect * k).named("g", at),
            reversal: (a + self.zeta * b).named("reversal", at),
        }
    }
}

/// 1 − e^{−decay} and e^{−decay}, each to its own digits: the second is not what rounding leaves of the first.
#[inline]
fn complement_and_factor<S: Scalar>(decay: S, at: Option<usize>) -> (S, S) {
    let lost = (decay * S::constant(-0.5)).exp_m1();
    let lost = lost.named("half_decay_minus_one", at);
    let kept = (S::constant(1.0) + lost).named("half_decay_factor", at);
    let (m, e) = (-(lost * (S::constant(1.0) + kept)), kept * kept);
    (m.named("decay_complement", at), e.named("decay_factor", at))
}

/// ζ = 0: v = x²/(x² − 1), u = x·tan(πx/2), g = 0.  The exact zeros of both divisors (x = 1, where v and u share the
/// pole, and the odd x, where u has one of its own) are replaced, so that no quotient is 0/0.
#[inline]
fn undamped<S: Scalar>(x: S, at: Option<usize>) -> ModeResponse<S> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let (s, c) = (x * S::constant(0.5)).sin_cos_pi();
    let s = s.named("sine", at);
    let re = ((x - one) * (x + one))
        .detuning_off_pole()
        .named("detuning", at);
    let c = c.named("plain_cosine", at);
    let c = c.cosine_off_pole().named("cosine", at);
    let size = re.abs().named("size", at);
    ModeResponse {
        x,
        denominator: complex::real(re),
        size,
        u: (s * size / (x * c)).named("u", at),
        g: zero,
        reversal: zero,
    }
}
