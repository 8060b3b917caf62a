//! What a motion over time is of.

use crate::asked::Part;
use crate::frequency::Frequency;
use crate::friction::Friction;
use crate::measure::Measure;

/// Where a motion is followed, whose, and what it is counted in.
pub struct Course {
    /// The names of the frequency's cells, and the frequency.
    pub frequency: (&'static [&'static str], Frequency),
    /// The names of the friction's cells, and the friction.
    pub friction: (&'static [&'static str], Friction),
    /// In which units.
    pub measure: Measure,
    /// Whose motions.
    pub parts: Vec<Part>,
    /// rad/s.
    pub omega: f64,
    /// Whether times are given in seconds too.
    pub in_seconds: bool,
}
