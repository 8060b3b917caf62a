//! Tolerances of the search for a steady state. They depend on the precision of the number type.

use crate::Float;

/// Tolerances of the search for a steady state in one number type.
pub(super) struct Tolerances<S> {
    /// Relative difference of two states below which the search treats the states as equal.
    pub(super) same: S,
    /// Error of a Floquet multiplier, up to which a multiplier above 1 in absolute value may belong to a motion that does
    /// not grow.
    pub(super) noise: S,
    /// Singular value below which a direction is neutral. A deviation in a neutral direction changes no force.
    pub(super) rank: S,
    /// Largest distance of a Floquet multiplier from 1 at which the multiplier may belong to a neutral direction.
    pub(super) split: S,
    /// Distance of the motion from a periodic motion below which the search accepts the periodic motion at once.
    pub(super) close: S,
    /// A steady state attracts neighbouring motions with certainty if every Floquet multiplier is smaller in absolute
    /// value than 1 minus this number. The number is far larger than the error of a multiplier.
    pub(super) attracts: S,
}

impl<S: Float> Tolerances<S> {
    pub(super) fn new() -> Self {
        let [same, noise, rank, split, close, attracts] = if S::EPSILON < 1e-10 {
            [2e-13, 1e-6, 1e-7, 1e-3, 1e-9, 1e-3]
        } else {
            // In `f32` a cycle has a rounding error of about 1e-6.
            [2e-6, 2e-3, 2e-3, 0.1, 1e-4, 2e-2]
        };
        Self {
            same: S::constant(same),
            noise: S::constant(noise),
            rank: S::constant(rank),
            split: S::constant(split),
            close: S::constant(close),
            attracts: S::constant(attracts),
        }
    }
}
