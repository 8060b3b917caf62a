//! Reasons why a motion of several contacts ends.

use core::fmt;

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

impl fmt::Display for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Level => "the friction force of a contact must be finite and not negative",
            Self::Load => "a force must be finite",
            Self::Patterns => {
                "the decision which contacts stick needs more patterns than the solver tries"
            }
            Self::Events => "the motion has more events than the solver follows",
            Self::Stretches => "the motion needs more stretches than the solver follows",
            Self::Stalled => "events follow each other without any time between them",
            Self::NotFinite => "the motion exceeds the range of numbers",
        })
    }
}

impl core::error::Error for Halt {}
