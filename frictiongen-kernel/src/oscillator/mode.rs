//! One mode of the chain, with its constants, and its response and damping functions at a frequency.
//!
//! Every function of a single mode depends on x = √λ/r = 1/R, which is rounded once. The response v and the half-period
//! damping functions u and g (7.11, 7.12) therefore stay consistent close to their common pole x = 1. Sums over modes
//! are multiplied by the *scale* E, the smallest |x² − 1 + 2iζx| of the chain. All sums are then finite on a resonance
//! and close to it.

pub use super::values::ModeResponse;
use super::values::denominator;
use super::{critical, overdamped, undamped, underdamped};
use crate::number::complex;
use crate::number::scalar::Scalar;

/// Kind of decay of a mode, which selects the closed form of its functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// No damping, ζ = 0.
    Undamped,
    /// Light damping, 0 < ζ < 1/2. The mode stores 1 − q as well as q, so that no digits are lost at the pole for small
    /// ζ.
    Light,
    /// Heavy damping, 1/2 ≤ ζ < 1.
    Heavy,
    /// Critical damping, ζ = 1.
    Critical,
    /// Overdamped, ζ > 1, without oscillation.
    Over,
}

/// Constants of one mode. They depend on the scene alone, not on r.
#[derive(Clone, Copy, Debug)]
pub struct Mode<S> {
    /// Kind of decay, which selects the closed form.
    pub kind: Kind,
    /// True if the contact drives the mode, φᵀw ≠ 0.
    pub in_contact: bool,
    /// √λ, the frequency ratio r at which the mode resonates.
    pub resonance: S,
    /// Modal damping ratio ζ.
    pub zeta: S,
    /// √|1 − ζ²|.
    pub q: S,
    /// 1 − q, to full relative accuracy (used for [`Kind::Light`]).
    pub q_defect: S,
    /// φᵀp, the strength with which the load drives the mode.
    pub load: S,
    /// φᵀw, the strength with which the contact drives the mode.
    pub contact: S,
    /// (φᵀw)(φᵀp), the residue load → contact times λ.
    pub residue: S,
    /// (φᵀw)², the mode's term c of the inverse effective mass of the contact.
    pub inverse_mass: S,
    /// (φᵀw)(φᵀp)/λ, the static residue load → contact.
    pub static_residue: S,
}

impl<S: Scalar> ModeResponse<S> {
    /// Creates a response of zeros, as the initial value of an array of modes.
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
    /// Returns the mode's functions of the frequency at r = 1/`inverse_r`. `index` only names values in emitted code.
    #[inline]
    pub fn response(&self, inverse_r: S, index: usize) -> ModeResponse<S> {
        self.functions_of(self.kind, inverse_r, true, index)
    }

    /// Returns the mode's functions of the frequency, with g = 0 unless `with_g`. The limits do not need g, which is
    /// half of the work.
    #[inline(always)]
    pub(crate) fn functions(&self, inverse_r: S, with_g: bool) -> ModeResponse<S> {
        self.functions_of(self.kind, inverse_r, with_g, 0)
    }

    /// Returns the mode's functions of the frequency for the given kind of damping.
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

    /// Returns the functions of the frequency of an undamped mode at x = √λ/r.
    #[inline(always)]
    pub(crate) fn undamped(x: S) -> ModeResponse<S> {
        undamped::response(x, None)
    }

    /// Returns only the `size` of the mode's [`response`](Self::response).
    #[inline]
    pub(crate) fn size(&self, inverse_r: S) -> S {
        let x = self.resonance * inverse_r;
        match self.kind {
            Kind::Undamped => undamped::detuning(x).abs(),
            _ => denominator(x, self.zeta, None).1,
        }
    }

    /// Returns the `size` of a mode whose kind is known. An exact zero of an undamped mode is not replaced.
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
