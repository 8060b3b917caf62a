//! Amplitude and phase of the contact at one friction ratio, and the coefficients of a motion.

use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;

/// Amplitude and phase of the contact's relative motion at one friction ratio, with intermediate results.
#[derive(Clone, Copy, Debug)]
pub struct Friction<S> {
    /// Friction ratio β = F/P.
    pub beta: S,
    /// In-phase term Q = √(|V|² − (βU)²) of the contact's relative motion. V is the response of the contact to the
    /// load, and βU the velocity that friction contributes. Q is multiplied by r² and by the scale E of
    /// [`ContactAt`](crate::contact::sums::ContactAt).
    pub root: S,
    /// Amplitude Z of the contact's relative motion, in units of P/k₁ (of Y for base motion).
    pub amplitude: S,
    /// Lag φ of the contact's relative motion behind the excitation, in rad, in (−π, π].
    pub phase: S,
    /// Factor 1/(r²E) that turns sums over the modes into displacements. E is the scale of [`ContactAt`](crate::contact::sums::ContactAt).
    pub unscale: S,
}

/// Fundamental component of a motion, at the frequency of the excitation, as coefficients of cos τ and sin τ.
#[derive(Clone, Copy, Debug)]
pub struct Fundamental<S> {
    /// Coefficient of cos τ in the displacement.
    pub cosine: S,
    /// Coefficient of sin τ in the displacement.
    pub sine: S,
    /// Complex response V_k of mass k to the load, without friction.
    pub response: Complex<S>,
}

impl<S: Scalar> Fundamental<S> {
    /// Returns zero coefficients, for a mass that does not move.
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

/// Coefficients of one mode's functions of τ in a motion. The functions contain d and q̃, the free vibrations of the
/// mode after a unit displacement and after a unit velocity.
#[derive(Clone, Copy, Debug)]
pub struct ModalCoefficients<S> {
    /// Coefficient of the term (1 − d)/x², the mode's response from rest to a constant force. Here x = 1/R is the
    /// natural frequency of the mode divided by the frequency of the excitation.
    pub rise: S,
    /// Coefficient of the term (cos τ − d), the lag of the mode's static displacement behind the excitation. The
    /// fundamental component contains the same cos τ with the opposite sign. The coefficient is 0 without damping.
    pub fall: S,
    /// Coefficient of the term (sin τ − R q̃), the lag of the mode behind the excitation. R is the frequency of the
    /// excitation divided by the natural frequency of the mode.
    pub forced: S,
    /// φ_k(φᵀw)/r², the residue of the mode in the response of mass k to a force in the contact. Only the harmonics
    /// need this residue.
    pub harmonic: S,
}
