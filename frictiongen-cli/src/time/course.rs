//! Frequency, friction and units of a motion over time.

use crate::asked::Part;
use crate::frequency::Frequency;
use crate::friction::Friction;
use crate::measure::Measure;

/// Frequency, friction, parts and units of a motion.
pub struct Course {
    /// Names of the frequency's cells, and the frequency.
    pub frequency: (&'static [&'static str], Frequency),
    /// Names of the friction's cells, and the friction.
    pub friction: (&'static [&'static str], Friction),
    /// The units of the answers.
    pub measure: Measure,
    /// The moving parts.
    pub parts: Vec<Part>,
    /// Angular frequency, rad/s.
    pub omega: f64,
    /// True if times are given in seconds too.
    pub in_seconds: bool,
}
