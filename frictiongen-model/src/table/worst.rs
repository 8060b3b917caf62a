//! The largest error of a table.

/// An error and its frequency ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The error.
    pub error: f64,
    /// The frequency ratio.
    pub at: f64,
}
