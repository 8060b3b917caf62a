//! One mode of the chain: its constants, and its response and damping functions at a frequency.
//!
//! With x = √λ/r = 1/R every function of a single mode is written in x, which is rounded once, so
//! that the response v, and the half-period damping functions u and g (7.11, 7.12) stay consistent
//! beside their common pole x = 1.  Sums over modes are carried times the *scale* E, the smallest
//! |x² − 1 + 2iζx| of the chain: everything is then finite on a resonance as well as beside it.

pub use super::values::ModeResponse;
use super::values::denominator;
use super::{critical, overdamped, undamped, underdamped};
use crate::number::complex;
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
        self.functions_of(self.kind, inverse_r, true, index)
    }

    /// The same with 0 for g unless `with_g`: the limits do without, and it is half of the work.
    #[inline(always)]
    pub(crate) fn functions(&self, inverse_r: S, with_g: bool) -> ModeResponse<S> {
        self.functions_of(self.kind, inverse_r, with_g, 0)
    }

    /// The same of a mode that is known to be of this kind.
    #[inline(always)]
    pub(crate) fn functions_of(
        &self,
        kind: Kind,
        inverse_r: S,
        with_g: bool,
        index: usize,
    ) -> ModeResponse<S> {
        let at = Some(index);
        let (zeta, q) = (self.zeta, self.q);
        let x = (self.resonance * inverse_r).named("x", at);
        match kind {
            Kind::Undamped => undamped::response(x, at),
            Kind::Light => underdamped::response(x, zeta, q, Some(self.q_defect), with_g, at),
            Kind::Heavy => underdamped::response(x, zeta, q, None, with_g, at),
            Kind::Critical => critical::response(x, zeta, with_g, at),
            Kind::Over => overdamped::response(x, zeta, q, with_g, at),
        }
    }

    /// The functions of an undamped mode at x = √λ/r.
    #[inline(always)]
    pub(crate) fn undamped(x: S) -> ModeResponse<S> {
        undamped::response(x, None)
    }

    /// The `size` of its [`response`](Self::response) alone.
    #[inline]
    pub(crate) fn size(&self, inverse_r: S) -> S {
        let x = self.resonance * inverse_r;
        match self.kind {
            Kind::Undamped => undamped::detuning(x).abs(),
            _ => denominator(x, self.zeta, None).1,
        }
    }

    /// The same of a mode that is known to be of this kind, where the exact zero of an undamped mode stays.
    #[inline(always)]
    pub(crate) fn size_but_zero(&self, kind: Kind, inverse_r: S) -> S {
        let x = self.resonance * inverse_r;
        let one = S::constant(1.0);
        match kind {
            Kind::Undamped => ((x - one) * (x + one)).abs(),
            _ => denominator(x, self.zeta, None).1,
        }
    }
}
