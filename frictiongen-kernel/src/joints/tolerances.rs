//! Numbers of the search for a steady state that depend on the precision.

use crate::Float;

/// Numbers that depend on the precision.
pub(super) struct Tolerances<S> {
    /// Relative difference after a period that counts as none.
    pub(super) same: S,
    /// Step of the differences, relative to the size of the unknowns.
    pub(super) step: S,
    /// Singular values below which a direction counts as neutral.
    pub(super) rank: S,
    /// Largest distance from 1 of a multiplier of a neutral direction.
    pub(super) split: S,
    /// Difference that is believed at once.
    pub(super) close: S,
}

impl<S: Float> Tolerances<S> {
    pub(super) fn new() -> Self {
        let [same, step, rank, split, close] = if S::EPSILON < 1e-10 {
            [2e-13, 1e-6, 1e-7, 1e-3, 1e-9]
        } else {
            // A cycle has a rounding error of some 1e-6, which the differences divide by their step.
            [2e-6, 2e-3, 2e-3, 0.1, 1e-4]
        };
        Self {
            same: S::constant(same),
            step: S::constant(step),
            rank: S::constant(rank),
            split: S::constant(split),
            close: S::constant(close),
        }
    }
}
