//! The request of an optimum.

use crate::Of;
use crate::study::error::{InvalidScene, UnknownMass};
use crate::study::units::{Load, LoadError};

/// A band of frequencies, in frequency ratios or in Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrequencyBand {
    /// Frequency ratios r of the scene as it is described.
    Ratio(f64, f64),
    /// Frequencies in Hz.
    Hertz(f64, f64),
}

/// The motion, band and load of an optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumRequest {
    /// The motion whose amplitude is kept small.
    pub of: Of,
    /// The band of frequencies, both ends included, above 0 and finite.
    pub band: FrequencyBand,
    /// The load, if forces in N and lengths in m are wanted.
    pub load: Option<Load>,
}

/// The reason why there is no optimum.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OptimumError {
    /// A bound of the band is not above 0 and finite.
    Band,
    /// The band has no width, or its upper bound is below its lower bound.
    Width,
    /// There is no such mass.
    UnknownMass(UnknownMass),
    /// The load does not fit the scene.
    Load(LoadError),
    /// Nothing damps this mode, counted from 0. The contact does not touch it, and the load drives it.
    Undamped(usize),
    /// A resonance within the band is unbounded at every friction.
    Unbounded,
    /// The motion does not depend on friction and is at rest.
    AtRest,
    /// The bound on the work of [`System::optimum`](crate::study::System::optimum) was met before any friction was
    /// found that bounds the amplitude.
    TooLong,
    /// The interval of a tuned number is not finite, has no width, or its upper bound is below its lower bound.
    Interval,
    /// The scene is invalid with a tuned number at a bound of its interval.
    Scene(InvalidScene),
}

impl std::fmt::Display for OptimumError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Band => "both bounds of the band must be above 0 and finite",
            Self::Width => "the end of the band must be above its start",
            Self::UnknownMass(error) => return error.fmt(f),
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
