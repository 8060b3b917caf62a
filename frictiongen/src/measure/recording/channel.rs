//! One measured signal.

use super::unit::Unit;

/// One channel of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the signal: `base`, `force` or the name of a mass.
    pub name: String,
    /// The unit of its samples.
    pub unit: Unit,
    /// The samples, in `unit`.
    pub samples: Vec<f64>,
}
