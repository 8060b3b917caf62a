//! What is asked of an optimum.

use crate::Of;
use crate::study::error::{InvalidScene, UnknownMass};
use crate::study::units::{Load, LoadError};

/// A band of frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrequencyBand {
    /// Frequency ratios r of the scene as it is described.
    Ratio(f64, f64),
    /// Hz.
    Hertz(f64, f64),
}

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumRequest {
    /// Whose amplitude.
    pub of: Of,
    /// Over which frequencies, both ends included; above 0 and finite.
    pub band: FrequencyBand,
    /// The load, where forces in N and lengths in m are wanted.
    pub load: Option<Load>,
}

/// Why there is no optimum.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OptimumError {
    /// An end of the band is not above 0 and finite.
    Band,
    /// The band has no width, or its end is below its start.
    Width,
    /// There is no such mass.
    UnknownMass(UnknownMass),
    /// The load does not fit.
    Load(LoadError),
    /// Nothing damps this mode, counted from 0: the contact does not touch it, and the load drives it.
    Undamped(usize),
    /// At every friction a resonance within the band is unbounded.
    Unbounded,
    /// The motion does not depend on friction and is at rest.
    AtRest,
    /// The work that [`System::optimum`](crate::study::System::optimum) may take was done before any friction was found that
    /// bounds the amplitude.
    TooLong,
    /// The interval of a tuned number is not finite, has no width, or its end is below its start.
    Interval,
    /// With a tuned number at an end of its interval the scene makes no sense.
    Scene(InvalidScene),
}

impl std::fmt::Display for OptimumError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Band => "the ends of the band are above 0 and finite",
            Self::Width => "the end of the band is above its start",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::Load(error) => return error.fmt(f),
            Self::Undamped(mode) => {
                return write!(
                    f,
                    "no friction bounds the motion: nothing damps mode {}, which the load drives and the contact does not touch",
                    mode + 1
                );
            }
            Self::Unbounded => {
                "no friction bounds the amplitude over this band: it contains an undamped resonance"
            }
            Self::AtRest => "it does not move over this band",
            Self::TooLong => {
                "no friction that bounds the amplitude was found in the work of one search; a narrower band needs less"
            }
            Self::Interval => "the ends of an interval are finite, the second above the first",
            Self::Scene(error) => return error.fmt(f),
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
