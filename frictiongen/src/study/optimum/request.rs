//! The request of a search for the best friction.

use crate::Of;
use crate::study::error::{InvalidScene, UnknownMass};
use crate::study::response::Size;
use crate::study::units::{Load, LoadError};
use crate::study::words;

/// A band of frequencies, in frequency ratios or in Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrequencyBand {
    /// Lowest and highest frequency ratio r of the scene as it is described.
    Ratio(f64, f64),
    /// Lowest and highest frequency in Hz.
    Hertz(f64, f64),
}

/// The quantity, band and load for which the best friction is wanted, and bounds on other quantities.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumRequest {
    /// The motion whose quantity is kept small.
    pub of: Of,
    /// The quantity of the motion: its displacement, velocity or acceleration, or the force of the contact.
    pub size: Size,
    /// The band of frequencies, both bounds included, above 0 and finite.
    pub band: FrequencyBand,
    /// The load. It is needed for forces in N and lengths in m.
    pub load: Option<Load>,
    /// Bounds that the friction must keep: a motion, its quantity, and the largest value allowed over the band. With a
    /// load the value is in SI units, otherwise in the unit of [`Optimum::amplitude`](super::Optimum::amplitude).
    pub keep: Vec<(Of, Size, f64)>,
}

/// The reason why no best friction is found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OptimumError {
    /// A bound of the band is not above 0 and finite.
    Band,
    /// The band has no width, or its upper bound is below its lower bound.
    Width,
    /// The scene has no mass with the requested name.
    UnknownMass(UnknownMass),
    /// The scene lacks the mass or the spring of the requested motion.
    NoSuchMotion(Of),
    /// The load does not fit the scene.
    Load(LoadError),
    /// The mode with this index, counted from 0, is driven by the load, and neither damping nor the contact acts on
    /// it.
    Undamped(usize),
    /// A resonance within the band is unbounded at every friction.
    Unbounded,
    /// The requested motion does not depend on friction and is at rest.
    AtRest,
    /// The bound on the work of [`System::optimum`](crate::study::System::optimum) was met before the search found any
    /// friction that bounds the amplitude.
    TooLong,
    /// The interval of a tuned number is invalid: not finite, without width, or with an upper bound below the lower
    /// bound.
    Interval,
    /// The scene is invalid with a tuned number at a bound of its interval.
    Scene(InvalidScene),
    /// The requested size is not one of the motion: only the contact has a contact force and an energy, and a force has
    /// neither a velocity nor an acceleration.
    Size,
    /// The largest value that a bound allows is not above 0 and finite.
    BoundValue,
    /// A number of the description is tuned, which the search does not combine with bounds.
    BoundWithTuning,
    /// No friction keeps the bounds. The text has the smallest values that can be reached.
    Bounds(String),
}

impl std::fmt::Display for OptimumError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Band => "both bounds of the band must be above 0 and finite",
            Self::Width => "the end of the band must be above its start",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::NoSuchMotion(of) => return words::no_such_motion(f, *of),
            Self::Load(error) => return error.fmt(f),
            Self::Undamped(mode) => {
                return write!(
                    f,
                    "no friction bounds the motion: the load drives mode {}, which has no damping and on which the contact does not act",
                    mode + 1
                );
            }
            Self::Unbounded => {
                "no friction bounds the amplitude over this band: it contains an undamped resonance"
            }
            Self::AtRest => "this motion is zero over the whole band",
            Self::TooLong => {
                "the search reached its limit of work before it found a friction that bounds the amplitude; give a narrower band"
            }
            Self::Interval => "both bounds of an interval must be finite, the second above the first",
            Self::Scene(error) => return error.fmt(f),
            Self::Size => {
                "only the contact has a contact force and an energy, and a force has neither a velocity nor an acceleration"
            }
            Self::BoundValue => "the value of a bound must be above 0 and finite",
            Self::BoundWithTuning => {
                "bounds cannot be combined with a number of the description that is chosen too; fix that number, and search with the bounds"
            }
            Self::Bounds(text) => text,
        })
    }
}

impl std::error::Error for OptimumError {}

impl From<UnknownMass> for OptimumError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<LoadError> for OptimumError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}
