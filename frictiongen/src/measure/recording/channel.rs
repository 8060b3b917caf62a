//! One measured signal of a recording.

use super::unit::Unit;

/// One channel of a recording: a signal with its name, its unit and its samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the signal: `base`, `force` or the name of a mass.
    pub name: String,
    /// The unit of the samples.
    pub unit: Unit,
    /// The samples, in the channel's unit.
    pub samples: Vec<f64>,
}
