//! The largest error that a check has found, with its frequency ratio.

use frictiongen_kernel::Float;

/// The largest error that a check has found, with the frequency ratio at which it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The error, in the unit that the field or function with this value states.
    pub error: f64,
    /// The frequency ratio r at which the error occurs.
    pub at: f64,
}

impl Worst {
    /// Returns the frequency ratio as text, with as few digits as the scalar type S of the tables needs.
    #[must_use]
    pub fn place<S: Float>(&self) -> String {
        shown::<S>(self.at)
    }
}

/// Returns the shortest text of a number of the scalar type S.
pub(super) fn shown<S: Float>(value: f64) -> String {
    #[allow(clippy::cast_possible_truncation, reason = "the scalar type is f32")]
    if S::EPSILON > f64::EPSILON {
        format!("{}", value as f32)
    } else {
        format!("{value}")
    }
}
