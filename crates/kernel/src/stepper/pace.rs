//! Division of a step into sub-intervals.

use crate::number::scalar::Float;

/// Division of a step of a stepper into sub-intervals, and constants that depend on this division.
#[derive(Clone, Copy, Debug)]
pub struct Pace<S> {
    /// Time step of the stepper, in seconds.
    pub step: S,
    /// Number of sub-intervals in a step.
    pub parts: u32,
    /// Length of a sub-interval in the non-dimensional time t√(k₁/m₁).
    pub span: S,
    /// Phase advance of the fastest oscillator in a sub-interval, in rad, at most 1. The number is the largest Ω(1 +
    /// 2ζ), where Ω is the phase advance of an oscillator without damping, and ζ its damping ratio.
    pub rate: S,
    /// Number of terms of a power series over a sub-interval. The terms that the stepper neglects are smaller than the
    /// rounding error.
    pub terms: u32,
    /// wᵀK̄⁻¹w, the displacement of the contact caused by a steady unit force in the contact. w is the direction
    /// vector of the contact, and K̄ the stiffness matrix divided by k₁. For an elastic contact the number also
    /// contains the compliance of the contact's spring.
    pub receptance: S,
    /// Damping force in the contact under a unit velocity of the base to which the contact sticks, times the inverse
    /// effective mass m* of the contact. This number is the sum of 2ζc/σ over the modes, divided by `receptance`. c is
    /// (φᵀw)² with the mode shape φ, and σ is the natural frequency of the mode as a frequency ratio.
    pub drag: S,
}

impl<S: Float> Pace<S> {
    /// Returns a division whose numbers are all 0. The code uses it as the initial content of a field.
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
