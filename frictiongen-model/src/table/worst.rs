//! The largest error of a table.

/// An error and its frequency ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The error, in the unit that the containing field or function states.
    pub error: f64,
    /// The frequency ratio r of the error.
    pub at: f64,
}
