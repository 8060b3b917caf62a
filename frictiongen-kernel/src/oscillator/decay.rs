//! The free motion of one mode in time, in closed forms that meet where their neighbours end.
//!
//! With p = e^{−ζxτ}·sin(qxτ)/(qx), the free displacement that starts from rest with unit speed,
//! everything that a mode does in a half period is made of p, its slope, and three differences
//! that vanish together with it or at the mode's resonance, and are formed without cancellation.

use crate::number::scalar::Float;
use crate::number::special::{exp_m1_minus, versine_beside};
use crate::oscillator::mode::{Kind, Mode};

/// An instant of the half period: τ = πt.
#[derive(Clone, Copy, Debug)]
pub struct Instant<S> {
    /// t = τ/π.
    pub t: S,
    /// τ.
    pub tau: S,
    /// sin τ.
    pub sine: S,
    /// cos τ.
    pub cosine: S,
    /// 1 − cos τ.
    pub versine: S,
}

impl<S: Float> Instant<S> {
    /// The instant τ = πt.
    #[inline]
    pub fn new(t: S) -> Self {
        let (sine, cosine) = t.sin_cos_pi();
        Self {
            t,
            tau: t * S::pi(),
            sine,
            cosine,
            versine: versine_beside(t, cosine),
        }
    }
}

/// One mode's functions at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Basis<S> {
    /// p = e^{−ζxτ} sin(qxτ)/(qx).
    pub free: S,
    /// p′.
    pub slope: S,
    /// sin τ − p.
    pub swing: S,
    /// cos τ − p′.
    pub swing_slope: S,
    /// (1 − d)/x², d = p′ + 2ζx·p: the return from rest at distance 1.
    pub rise: S,
}

/// How the modes of a scene decay: a type, so that undamped scenes carry no exponentials.
pub trait Decay<S: Float>: Copy {
    /// Taken from a mode's constants.
    fn of(mode: &Mode<S>) -> Self;
    /// Which closed form applies.
    fn kind(&self) -> Kind;
    /// ζ.
    fn zeta(&self) -> S;
    /// The mode's functions at one instant, with x = 1/R.
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S>;
}

/// No damping.
#[derive(Clone, Copy, Debug, Default)]
pub struct Undamped;

/// Any damping, none included.
#[derive(Clone, Copy, Debug)]
pub struct Damped<S> {
    kind: Kind,
    zeta: S,
    q: S,
    q_defect: S,
}

/// x·sin τ − sin xτ and cos τ − cos xτ.  Beside x = 1 both are differences of nearly equal terms,
/// multiplied by the large damping functions of a resonance: there they are written as products.
/// The second is divided by sin τ in the velocity constraint, so it keeps its digits at τ → 0.
#[inline]
fn differences<S: Float>(x: S, sine_x: S, versine_x: S, at: &Instant<S>) -> (S, S) {
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

impl<S: Float> Decay<S> for Undamped {
    #[inline(always)]
    fn of(_: &Mode<S>) -> Self {
        Self
    }
    #[inline(always)]
    fn kind(&self) -> Kind {
        Kind::Undamped
    }
    #[inline(always)]
    fn zeta(&self) -> S {
        S::constant(0.0)
    }
    #[inline]
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S> {
        let half_turns = x * at.t;
        let (sine, cosine) = half_turns.sin_cos_pi();
        let versine = versine_beside(half_turns, cosine);
        let (swing, swing_slope) = differences(x, sine, versine, at);
        Basis {
            free: sine / x,
            slope: cosine,
            swing: swing / x,
            swing_slope,
            rise: versine / (x * x),
        }
    }
}

impl<S: Float> Decay<S> for Damped<S> {
    #[inline(always)]
    fn of(mode: &Mode<S>) -> Self {
        Self {
            kind: mode.kind,
            zeta: mode.zeta,
            q: mode.q,
            q_defect: mode.q_defect,
        }
    }
    #[inline(always)]
    fn kind(&self) -> Kind {
        self.kind
    }
    #[inline(always)]
    fn zeta(&self) -> S {
        self.zeta
    }
    #[inline]
    fn basis(&self, x: S, at: &Instant<S>) -> Basis<S> {
        match self.kind {
            Kind::Undamped => Undamped.basis(x, at),
            Kind::Light => self.light(x, at),
            Kind::Heavy => self.heavy(x, at),
            Kind::Critical => self.critical(x, at),
            Kind::Over => self.overdamped(x, at),
        }
    }
}

/// 1 − d from its parts, all of one sign: e^{−a}[(e^a − 1 − a) + (1 − cos b) + a(1 − sin b/b)].
#[inline]
fn one_minus_d<S: Float>(decay: S, kept: S, direct: S, versine: S, sinc_defect: S) -> S {
    if decay < S::constant(1.0) {
        kept * (exp_m1_minus(decay) + versine + decay * sinc_defect)
    } else {
        direct
    }
}

impl<S: Float> Basis<S> {
    /// All functions from p, p′ and 1 − d = 1 − p′ − 2ζx·p.  cos τ − p′ comes from 1 − d, whose
    /// digits it keeps at τ → 0, where the velocity constraint divides by sin τ.
    #[inline]
    fn damped(x: S, zeta: S, free: S, slope: S, one_minus_d: S, at: &Instant<S>) -> Self {
        Self {
            free,
            slope,
            swing: at.sine - free,
            swing_slope: one_minus_d + (zeta + zeta) * x * free - at.versine,
            rise: one_minus_d / (x * x),
        }
    }
}

impl<S: Float> Damped<S> {
    /// From ζ, √|1 − ζ²| and the kind that goes with them.
    pub(crate) fn new(kind: Kind, zeta: S, q: S) -> Self {
        Self {
            kind,
            zeta,
            q,
            q_defect: zeta * zeta / (S::constant(1.0) + q),
        }
    }

    fn light(&self, x: S, at: &Instant<S>) -> Basis<S> {
        let (one, half) = (S::constant(1.0), S::constant(0.5));
        let decay = self.zeta * x * at.tau;
        let lost = -(-decay).exp_m1();
        let kept = one - lost;
        let turns = x * at.t;
        let defect = turns * self.q_defect;
        let (s, c) = turns.sin_cos_pi_minus(defect);
        let (sq, zq) = (s / self.q, self.zeta / self.q * s);
        let damped_turns = turns * self.q;
        let direct = one - kept * (c + zq);
        let (free, slope) = (kept * sq / x, kept * (c - zq));
        let versine = versine_beside(damped_turns, c);
        let sinc_defect = damped_turns.one_minus_sinc_pi();
        let one_minus_d = one_minus_d(decay, kept, direct, versine, sinc_defect);
        let mut basis = Basis::damped(x, self.zeta, free, slope, one_minus_d, at);
        if (x - one).abs() < half {
            // The undamped differences plus what damping changes, each without cancellation.
            let (s0, c0) = turns.sin_cos_pi();
            let (swing, swing_slope) = differences(x, s0, versine_beside(turns, c0), at);
            let (half_s, _) = (defect * half).sin_cos_pi();
            let (mid_s, mid_c) = turns.sin_cos_pi_minus(defect * half);
            let two = S::constant(2.0);
            let sine_change = (two * mid_c * half_s - self.q_defect * s0) / self.q;
            let cosine_change = -(two * mid_s * half_s);
            basis.swing = (swing + lost * s0 + kept * sine_change) / x;
            basis.swing_slope = swing_slope + lost * c0 + kept * (cosine_change + zq);
        }
        basis
    }

    fn heavy(&self, x: S, at: &Instant<S>) -> Basis<S> {
        let one = S::constant(1.0);
        let decay = self.zeta * x * at.tau;
        let kept = (-decay).exp();
        let turns = self.q * x * at.t;
        let (s, c) = turns.sin_cos_pi();
        let (sq, zq) = (s / self.q, self.zeta / self.q * s);
        let (free, slope) = (kept * sq / x, kept * (c - zq));
        let direct = one - kept * (c + zq);
        let (versine, sinc_defect) = (versine_beside(turns, c), turns.one_minus_sinc_pi());
        let one_minus_d = one_minus_d(decay, kept, direct, versine, sinc_defect);
        Basis::damped(x, self.zeta, free, slope, one_minus_d, at)
    }

    /// To first order in q² = 1 − ζ², whose value is 0, for derivatives with respect to ζ.
    fn critical(&self, x: S, at: &Instant<S>) -> Basis<S> {
        let one = S::constant(1.0);
        let time = x * at.tau;
        let decay = self.zeta * time;
        let kept = (-decay).exp();
        let square = time * time * ((one - self.zeta) * (one + self.zeta));
        let versine = square * S::constant(0.5);
        let sinc_defect = square / S::constant(6.0);
        let (cosine, sinc) = (one - versine, one - sinc_defect);
        let (free, slope) = (kept * (at.tau * sinc), kept * (cosine - decay * sinc));
        let direct = one - kept * (cosine + decay * sinc);
        let one_minus_d = one_minus_d(decay, kept, direct, versine, sinc_defect);
        Basis::damped(x, self.zeta, free, slope, one_minus_d, at)
    }

    fn overdamped(&self, x: S, at: &Instant<S>) -> Basis<S> {
        let (one, half) = (S::constant(1.0), S::constant(0.5));
        let sum = self.zeta + self.q;
        let time = x * at.tau;
        let slow = (-(time / sum)).exp();
        let fast = (-(time * sum)).exp();
        let spread = (self.q + self.q) * time;
        let sinh = -(-spread).exp_m1() * slow * half / self.q;
        let cosh = (slow + fast) * half;
        let (free, slope) = (sinh / x, cosh - self.zeta * sinh);
        let decay = self.zeta * time;
        let one_minus_d = if S::constant(2.0) < sum && time < sum {
            // Both decays from their second order on; the parts below would cancel to 1/ζ².
            let (slow, fast) = (exp_m1_minus(-(time / sum)), exp_m1_minus(-(time * sum)));
            (fast / sum - slow * sum) * half / self.q
        } else if decay < half {
            // e^a − cosh b − (a/b) sinh b, by parts that start at the second order.
            let b = self.q * time;
            let (plus, minus) = (exp_m1_minus(b), exp_m1_minus(-b));
            let sinh_ratio = if b > S::constant(0.0) {
                (plus - minus) * half / b
            } else {
                b
            };
            (-decay).exp() * (exp_m1_minus(decay) - (plus + minus) * half - decay * sinh_ratio)
        } else {
            one - cosh - self.zeta * sinh
        };
        Basis::damped(x, self.zeta, free, slope, one_minus_d, at)
    }
}
