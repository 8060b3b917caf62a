//! The friction that keeps the largest amplitude over a band of frequencies smallest, over all regimes.

mod amplitude;
mod flat;
mod line;
pub(in crate::study) mod peaks;
mod problem;
mod scan;
mod search;
mod tuned;

use super::error::{InvalidScene, UnknownMass};
use super::parameter::Parameter;
use super::system::System;
use super::units::Load;
use crate::{Of, Regime};
pub(in crate::study) use amplitude::Friction;
use problem::Problem;
pub use tuned::{Tunable, TunedOptimum, TunedPoint, Tuning, UnknownTunable};

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
    Load(super::LoadError),
    /// Nothing damps this mode, counted from 0: the contact does not touch it, and the load drives it.
    Undamped(usize),
    /// At every friction a resonance within the band is unbounded.
    Unbounded,
    /// The motion does not depend on friction and is at rest.
    AtRest,
    /// It takes more amplitudes than [`System::optimum`] computes.
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
                "250000 amplitudes do not suffice, of which one that does not settle counts as 100 for each mass; a narrower \
                 band needs fewer"
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

impl From<super::LoadError> for OptimumError {
    fn from(error: super::LoadError) -> Self {
        Self::Load(error)
    }
}

/// What limits the amplitude at the optimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptimumKind {
    /// Peaks of the same height: with more friction one rises, with less another.
    EqualPeaks,
    /// One peak at its own minimum.
    SinglePeak,
    /// Any friction makes it worse.
    NoFriction,
    /// The contact is best stuck: more friction changes nothing.
    Stuck,
}

/// A frequency at which the largest amplitude is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumPeak {
    /// r.
    pub r: f64,
    /// Over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What the contact does there.
    pub regime: Regime,
    /// Whether it is an end of the band.
    pub at_end: bool,
    /// dX/dβ of this peak; none where it is stuck or has no derivative.
    pub slope: Option<f64>,
}

/// How far friction may be from the optimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// By which share the largest amplitude is above the best at most.
    pub excess: f64,
    /// β from here,
    pub from: f64,
    /// to here; infinite where more friction never does harm.
    pub to: f64,
}

/// The friction that keeps the largest amplitude smallest.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// β.
    pub beta: f64,
    /// The largest amplitude of the band over P/k₁, for base motion over Y.
    pub amplitude: f64,
    /// What limits it.
    pub kind: OptimumKind,
    /// Where it is reached.
    pub peaks: Vec<OptimumPeak>,
    /// Up to this β the amplitude at an undamped resonance of the band is unbounded; 0 where there is none.
    pub unbounded_to: f64,
    /// Up to this β nothing sticks anywhere in the band.
    pub free_of_sticking: f64,
    /// From this β on the contact is stuck all over the band; infinite if nothing holds it on a resonance of the stuck
    /// chain.
    pub locked: f64,
    /// The largest amplitude without friction; infinite on an undamped resonance.
    pub without_friction: f64,
    /// The largest amplitude with the contact stuck all over the band.
    pub with_contact_locked: f64,
    /// How flat the optimum is: 1, 5 and 10 per cent above the best.
    pub tolerances: Vec<Tolerance>,
    /// d ln X/d ln p of the amplitude at the optimum, which friction follows: for each parameter but friction and frequency.
    /// Empty without a load and where there are no derivatives.
    pub sensitivities: Vec<(Parameter, f64)>,
    /// How many amplitudes were computed.
    pub evaluations: usize,
    /// How many of them had no answer: a motion with too many stops in a cycle, or none that was found.
    pub unanswered: usize,
}

impl System {
    /// The friction that keeps the largest amplitude of a motion over a band of frequencies smallest, over all regimes: the
    /// closed form where the contact slides all the time, steady states where it stops, the stuck response.
    ///
    /// The largest amplitude over the band is looked for about every resonance, of the chain and of the chain with its
    /// contact stuck, their sub-harmonics, on both sides of changes of regime and on a grid between, the least over friction by
    /// a scan between none and so much that nothing slides.
    ///
    /// It computes at most 250000 amplitudes and stops with [`OptimumError::TooLong`] beyond; one whose motion does not settle,
    /// or that has no answer, takes longer and counts as 100 for each mass.  For two masses it takes about 30000.
    ///
    /// ```
    /// use frictiongen::study::{FrequencyBand, Load, OptimumKind, OptimumRequest, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { lower: 3.27, upper: 3.25 },                     // kg
    ///     springs: { base - lower: 1190.0, lower - upper: 1323.0 }, // N/m
    ///     contact: upper - wall,
    ///     excitation: base,
    ///     damping: modal[0.010, 0.012],
    /// }"
    /// .parse()?;
    /// let request = OptimumRequest {
    ///     of: frame.motion_named("upper")?,
    ///     band: FrequencyBand::Hertz(1.5, 3.0),
    ///     load: Some(Load::Base(0.003)), // m
    /// };
    /// let optimum = frame.optimum(&request)?;
    /// assert!(optimum.amplitude < 0.5 * optimum.without_friction);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OptimumError`]: for a band, a motion, a load or a quantity that makes no sense, and where no friction bounds the
    /// amplitude.
    pub fn optimum(&self, request: &OptimumRequest) -> Result<Optimum, OptimumError> {
        Problem::new(self, request)?.solved()
    }
}
