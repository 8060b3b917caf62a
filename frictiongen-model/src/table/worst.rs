//! The largest error that a check has found, with its frequency ratio.

/// The largest error that a check has found, with the frequency ratio at which it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The error, in the unit that the containing field or function states.
    pub error: f64,
    /// The frequency ratio r at which the error occurs.
    pub at: f64,
}
