//! One mode of the chain: its constants, and its response and damping functions at a frequency.
//!
//! Every function of a single mode depends on x = √λ/r, the natural frequency of the mode divided by the excitation
//! frequency. The code rounds x once. The response v and the damping functions u and g (7.11, 7.12) therefore stay
//! consistent close to x = 1, where v and u of an undamped mode have a pole. The code multiplies sums over modes by
//! the *scale* E, the smallest |x² − 1 + 2iζx| of the chain. All sums are then finite on a resonance and close to it.

pub use super::values::ModeResponse;
use super::values::denominator;
use super::{critical, overdamped, undamped, underdamped};
use crate::number::complex;
use crate::number::scalar::Scalar;

/// Kind of damping of a mode. The kind selects the closed form with which the code evaluates the functions of the mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The mode has no damping, ζ = 0.
    Undamped,
    /// Light damping, 0 < ζ < 1/2. The mode stores 1 − q in addition to q = √(1 − ζ²), because 1 − q computed from q
    /// would lose digits for small ζ.
    Light,
    /// Heavy damping below the critical damping, 1/2 ≤ ζ < 1.
    Heavy,
    /// The mode has critical damping, ζ = 1.
    Critical,
    /// Damping above the critical damping, ζ > 1. The free motion does not oscillate.
    Over,
}

/// Constants of one mode of the chain. These constants depend on the scene, not on the frequency ratio r.
#[derive(Clone, Copy, Debug)]
pub struct Mode<S> {
    /// Kind of damping of the mode, which selects the closed form.
    pub kind: Kind,
    /// True if the contact drives the mode: φᵀw ≠ 0, where φ is the mode shape and w the contact direction.
    pub in_contact: bool,
    /// Natural frequency √λ of the mode, as a frequency ratio: the mode resonates at r = √λ.
    pub resonance: S,
    /// Damping ratio ζ of the mode.
    pub zeta: S,
    /// q = √|1 − ζ²|. Below critical damping, q is the damped natural frequency of the mode divided by the undamped
    /// natural frequency.
    pub q: S,
    /// 1 − q, with full relative accuracy, where q = √(1 − ζ²). Only modes of [`Kind::Light`] use this number.
    pub q_defect: S,
    /// Product φᵀp of the mode shape φ and the load vector p. The load drives the mode in proportion to this product.
    pub load: S,
    /// Product φᵀw of the mode shape φ and the contact direction w. The contact drives the mode in proportion to this
    /// product.
    pub contact: S,
    /// Residue (φᵀw)(φᵀp) of the mode in the response of the contact to the load. φ is the mode shape, w the contact
    /// direction and p the load vector. The residue is the static residue times the squared frequency ratio λ of the
    /// mode.
    pub residue: S,
    /// Square (φᵀw)² of the product of the mode shape φ and the contact direction w. The square is the term of this
    /// mode in the inverse effective mass m* of the contact.
    pub contact_squared: S,
    /// Static residue (φᵀw)(φᵀp)/λ of the mode, with the mode shape φ, the contact direction w, the load vector p and
    /// the squared frequency ratio λ. The static residue is the term of this mode in the static displacement of the
    /// contact under the load.
    pub static_residue: S,
}

impl<S: Scalar> ModeResponse<S> {
    /// Creates a mode response whose numbers are all 0. The code uses it as the initial content of an array.
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
    /// Evaluates the response and damping functions of the mode at the frequency ratio r = 1/`inverse_r`. `index` only
    /// names variables in emitted code.
    #[inline]
    pub fn response(&self, inverse_r: S, index: usize) -> ModeResponse<S> {
        self.functions_of(self.kind, inverse_r, true, index)
    }

    /// Evaluates the response and damping functions of the mode at the frequency ratio r = 1/`inverse_r`. If `with_g`
    /// is false, g is 0 in the result, which halves the work. The limits of continuous and stuck motion do not need g.
    #[inline(always)]
    pub(crate) fn functions(&self, inverse_r: S, with_g: bool) -> ModeResponse<S> {
        self.functions_of(self.kind, inverse_r, with_g, 0)
    }

    /// Evaluates the response and damping functions of the mode with the closed form of the given `kind`. `index` only
    /// names variables in emitted code.
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
        let x = (self.resonance * inverse_r).named("x", "x = √λ/r = 1/R", at);
        match kind {
            Kind::Undamped => undamped::response(x, at),
            Kind::Light => underdamped::response(x, zeta, q, Some(self.q_defect), with_g, at),
            Kind::Heavy => underdamped::response(x, zeta, q, None, with_g, at),
            Kind::Critical => critical::response(x, zeta, with_g, at),
            Kind::Over => overdamped::response(x, zeta, q, with_g, at),
        }
    }

    /// Evaluates the response v and the functions u and g of an undamped mode, where g is 0. x = √λ/r is the natural
    /// frequency of the mode divided by the excitation frequency.
    #[inline(always)]
    pub(crate) fn undamped(x: S) -> ModeResponse<S> {
        undamped::response(x, None)
    }

    /// Returns |x² − 1| + 2ζx of the mode at the frequency ratio r = 1/`inverse_r`, where x = √λ/r. The field `size` of
    /// [`response`](Self::response) is the same number.
    #[inline]
    pub(crate) fn size(&self, inverse_r: S) -> S {
        let x = self.resonance * inverse_r;
        match self.kind {
            Kind::Undamped => undamped::detuning(x).abs(),
            _ => denominator(x, self.zeta, None).1,
        }
    }

    /// Returns |x² − 1| + 2ζx of a mode whose kind of damping the caller knows, where x = √λ/r. For an undamped mode
    /// at its resonance the result is exactly 0, unlike the tiny number that [`size`](Self::size) returns.
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
