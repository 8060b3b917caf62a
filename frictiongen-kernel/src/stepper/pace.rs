//! Division of a step into sub-intervals.

use crate::number::scalar::Float;

/// Division of a step into sub-intervals, and constants that depend on this division.
#[derive(Clone, Copy, Debug)]
pub struct Pace<S> {
    /// Time step of the stepper, in seconds.
    pub step: S,
    /// Number of sub-intervals in a step.
    pub parts: u32,
    /// Length of a sub-interval in the non-dimensional time t√(k₁/m₁).
    pub span: S,
    /// Angle by which the fastest oscillator advances in a sub-interval, in rad. The angle includes the effect of
    /// damping. It is at most 1.
    pub rate: S,
    /// Number of terms of a power series over a sub-interval. The neglected terms are smaller than the rounding error.
    pub terms: u32,
    /// wᵀK̄⁻¹w, the displacement of the contact per unit of steady contact force, with the contact's direction vector w
    /// and the stiffness matrix K̄ divided by k₁.
    pub receptance: S,
    /// Σ 2ζc/σ over the receptance: damping force per unit of velocity of the stuck contact, times the inverse
    /// effective mass m*.
    pub drag: S,
}

impl<S: Float> Pace<S> {
    /// Returns a division whose numbers are all 0, as the initial content of a field.
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
