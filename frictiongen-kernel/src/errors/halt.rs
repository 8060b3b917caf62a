//! Reasons why a motion of several contacts ends.

/// Reason why a solver of scenes with several contacts does not continue a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Halt {
    /// The friction force of a contact cannot have the value.
    Level,
    /// The load is not finite, or the load does not exist.
    Load,
    /// At one instant, the solver would try more patterns of sticking contacts than
    /// [`MAX_PATTERNS`](crate::joints::MAX_PATTERNS).
    Patterns,
    /// The motion has more events than the solver follows.
    Events,
    /// The motion needs more stretches of the power series than the solver follows.
    Stretches,
    /// Events follow each other without any time between them.
    Stalled,
    /// The motion exceeds the range of numbers.
    NotFinite,
}
