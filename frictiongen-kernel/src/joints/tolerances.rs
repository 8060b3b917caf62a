//! Tolerances of the search for a steady state, which depend on the precision of the number type.

use crate::Float;

/// Tolerances of the search for a steady state in one number type.
pub(super) struct Tolerances<S> {
    /// Two states count as equal if their relative difference is below this value.
    pub(super) same: S,
    /// Step of the finite differences, relative to the size of the unknowns.
    pub(super) step: S,
    /// A direction counts as neutral (without any effect on forces) if its singular value is below this value.
    pub(super) rank: S,
    /// A multiplier may belong to a neutral direction if its distance from 1 is at most this value.
    pub(super) split: S,
    /// The search accepts a periodic motion at once if the distance of the motion from it is below this value.
    pub(super) close: S,
    /// A multiplier belongs to an attracting state if its modulus is below 1 by more than this value, which is far above
    /// the error of a multiplier.
    pub(super) attracts: S,
}

impl<S: Float> Tolerances<S> {
    pub(super) fn new() -> Self {
        let [same, step, rank, split, close, attracts] = if S::EPSILON < 1e-10 {
            [2e-13, 1e-6, 1e-7, 1e-3, 1e-9, 1e-3]
        } else {
            // A cycle has a rounding error of some 1e-6, which the differences divide by their step.
            [2e-6, 2e-3, 2e-3, 0.1, 1e-4, 2e-2]
        };
        Self {
            same: S::constant(same),
            step: S::constant(step),
            rank: S::constant(rank),
            split: S::constant(split),
            close: S::constant(close),
            attracts: S::constant(attracts),
        }
    }
}
