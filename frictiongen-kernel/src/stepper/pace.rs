//! How a step is cut.

use crate::number::scalar::Float;

/// How a step is cut, and what the scene adds to that.
#[derive(Clone, Copy, Debug)]
pub struct Pace<S> {
    /// The step, in seconds.
    pub step: S,
    /// Into how many parts it is cut.
    pub parts: u32,
    /// A part in the time t√(k₁/m₁).
    pub span: S,
    /// By how much the fastest oscillator turns in a part, its damping included; at most 1.
    pub rate: S,
    /// How many terms of a power series reach the end of a part.
    pub terms: u32,
    /// wᵀK̄⁻¹w: how far a steady unit force moves the contact.
    pub receptance: S,
    /// What the velocity of the held contact adds to the force in it: Σ 2ζc/σ over that.
    pub drag: S,
}

impl<S: Float> Pace<S> {
    /// What is filled.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            step: zero,
            parts: 1,
            span: zero,
            rate: zero,
            terms: 0,
            receptance: zero,
            drag: zero,
        }
    }
}
