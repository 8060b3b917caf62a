//! Amplitude and phase of the contact at one friction ratio, and the coefficients of a motion.

use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// Amplitude and phase of the contact's relative motion at one friction ratio, with intermediate results of the
/// calculation.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S> {
    /// Friction ratio β = F/P of this motion.
    pub beta: S,
    /// In-phase term Q = √(|V|² − (βU)²) of the contact's relative motion. V is the response of the contact to the
    /// load, and βU the part of its velocity that friction causes. Q is multiplied by r² and by the scale E of
    /// [`ContactAt`](crate::contact::sums::ContactAt).
    pub root: S,
    /// Amplitude Z of the contact's relative motion, in units of P/k₁ (of Y for base motion).
    pub amplitude: S,
    /// Lag φ of the contact's relative motion behind the excitation, in rad, in (−π, π].
    pub phase: S,
    /// Factor 1/(r²E) that turns sums over the modes into displacements. E is the scale of
    /// [`ContactAt`](crate::contact::sums::ContactAt).
    pub unscale: S,
}

/// Coefficients of cos τ and sin τ in the closed form of a motion. The closed form also contains one term for each
/// mode.
#[derive(Clone, Copy, Debug)]
pub struct Fundamental<S> {
    /// Coefficient of cos τ in the closed form of the displacement.
    pub cosine: S,
    /// Coefficient of sin τ in the closed form of the displacement.
    pub sine: S,
    /// Complex response V_k of mass k to the load in the chain without friction.
    pub response: Complex<S>,
}

impl<S: Scalar> Fundamental<S> {
    /// Returns coefficients that are all 0, for a mass that does not move.
    #[inline]
    #[must_use]
    pub fn at_rest() -> Self {
        let zero = S::constant(0.0);
        Self {
            cosine: zero,
            sine: zero,
            response: complex::real(zero),
        }
    }
}

/// Coefficients of one mode's functions of time in a motion. The functions contain d and q̃, the free vibrations of the
/// mode after a unit displacement and after a unit velocity.
#[derive(Clone, Copy, Debug)]
pub struct ModalCoefficients<S> {
    /// Coefficient of the term (1 − d)/x², the response of the mode from rest to a constant force. d is the free
    /// vibration of the mode after a unit displacement. x = 1/R is the natural frequency of the mode divided by the
    /// excitation frequency.
    pub rise: S,
    /// Coefficient of the term cos τ − d, which comes from the damping function g of the mode. d is the free vibration
    /// of the mode after a unit displacement. [`Fundamental::cosine`] contains the same cos τ with the opposite sign.
    /// Without damping the coefficient is 0.
    pub fall: S,
    /// Coefficient of the term sin τ − R q̃, which comes from the damping function u of the mode. q̃ is the free
    /// vibration of the mode after a unit velocity. R is the excitation frequency divided by the natural frequency of
    /// the mode.
    pub forced: S,
    /// φ_k(φᵀw)/r², the residue of the mode in the response of mass k to a force in the contact. φ is the mode shape
    /// and w the contact direction. Only the harmonics need this residue.
    pub harmonic: S,
}
