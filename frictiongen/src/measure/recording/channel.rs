//! One measured signal of a recording.

use super::unit::Unit;

/// One channel of a recording: a signal with its name, its unit and its samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the signal: `base`, `force` or the name of a mass.
    pub name: String,
    /// Unit of the channel's samples.
    pub unit: Unit,
    /// Samples of the channel, in the unit `unit`.
    pub samples: Vec<f64>,
}
