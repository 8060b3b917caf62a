//! Reasons why a solver of scenes with several contacts cannot continue a motion.

use core::fmt;

/// Reason why a solver of scenes with several contacts cannot continue a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Halt {
    /// The caller gave a friction force that the contact cannot have. The friction force is negative or not finite, or
    /// it is a harmonic at an elastic contact.
    Level,
    /// The load that the caller gave is not finite, or no load has the given index.
    Load,
    /// At one instant, the solver would try more than [`MAX_PATTERNS`](crate::joints::MAX_PATTERNS) patterns. A pattern
    /// says which contacts stick.
    Patterns,
    /// The motion has more events (such as stops and reversals of a contact) than the solver permits.
    Events,
    /// The motion needs more stretches than the solver permits. A stretch is a time interval in which the solver uses
    /// one power series.
    Stretches,
    /// The solver finds one event after the other without any time between them.
    Stalled,
    /// A displacement, velocity or force exceeds the range of the number type.
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
