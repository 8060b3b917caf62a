//! The largest error that a check has found, with its frequency ratio.

/// The largest error that a check has found, with the frequency ratio at which it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The error. Its unit is stated by the field or function that contains this value.
    pub error: f64,
    /// The frequency ratio r at which the error occurs.
    pub at: f64,
}
