//! The request for a search for the best friction.

use super::number::Tunable;
use crate::Of;
use crate::study::error::{InvalidScene, UnknownMass, no_such_motion};
use crate::study::joined::JoinedError;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::{Load, LoadError};

/// A band of frequencies, given as frequency ratios or in Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrequencyBand {
    /// The band is given by its lowest and its highest frequency ratio r, with m₁ and k₁ of the scene description.
    Ratio(f64, f64),
    /// The band is given by its lowest and its highest frequency in Hz.
    Hertz(f64, f64),
}

/// The quantity, the band and the load of a search for the best friction.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumRequest {
    /// The motion whose quantity is minimised.
    pub of: Of,
    /// The quantity of the motion: its displacement, velocity or acceleration, or the force or the energy of the
    /// contact.
    pub size: MotionQuantity,
    /// The band of frequencies. It includes both bounds, which must be above 0 and finite.
    pub band: FrequencyBand,
    /// Load of the scene. Results in N and m require a load.
    pub load: Option<Load>,
}

/// A quantity with a value: the upper bound of a bounded quantity, or the divisor of a minimised quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuantityValue {
    /// The motion to which the quantity belongs.
    pub of: Of,
    /// The quantity of the motion: displacement, velocity, acceleration, or a quantity of the contact.
    pub size: MotionQuantity,
    /// The bound or the divisor, in the same unit as [`Optimum::amplitude`](super::Optimum::amplitude) has for this
    /// quantity.
    pub value: f64,
}

/// A number of the scene description that the search varies together with the friction, and the interval of its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The varied number of the scene description.
    pub of: Tunable,
    /// Lower bound of the interval, in the unit of the varied number.
    pub from: f64,
    /// Upper bound of the interval, in the unit of the varied number.
    pub to: f64,
}

impl QuantityValue {
    /// Returns the request that minimises this quantity instead of the quantity of `request`.
    pub(super) fn request(&self, request: &OptimumRequest) -> OptimumRequest {
        OptimumRequest {
            of: self.of,
            size: self.size,
            ..request.clone()
        }
    }
}

impl Tuning {
    /// Returns an error if the interval is invalid, or if the scene is invalid at one of its bounds.
    pub(super) fn check(&self, system: &System) -> Result<(), OptimumError> {
        let Self { of, from, to } = *self;
        if !(from.is_finite() && to.is_finite() && from < to) {
            return Err(OptimumError::Interval);
        }
        for end in [from, to] {
            system.with_value(of, end).map_err(OptimumError::Scene)?;
        }
        Ok(())
    }
}

/// Further conditions of a search for the best friction. The default has no conditions.
#[derive(Clone, Copy, Default)]
pub struct OptimumOptions<'a> {
    /// Upper bounds of other quantities. The search takes only frictions with which no quantity exceeds its bound over
    /// the band.
    pub kept: &'a [QuantityValue],
    /// Several quantities, each with a divisor above 0. The search minimises the largest quotient of a quantity and its
    /// divisor, and ignores the quantity of the request. It then accepts neither bounds nor varied numbers.
    pub weighted: &'a [QuantityValue],
    /// Numbers of the scene description that the search varies together with the friction: one number, or the shares
    /// of several contacts.
    pub vary: &'a [Tuning],
    /// Bound on the work of one search over all frictions, in units of about 10 µs of computing time. `None` stands for
    /// the default.
    pub work: Option<usize>,
    /// A function that the search calls after each evaluation, from several threads if a number varies. If it returns
    /// false once, it must return false from then on. The search then ends with the best friction so far.
    pub watch: Option<&'a (dyn Fn() -> bool + Sync)>,
}

/// The reason why a search for the best friction fails.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum OptimumError {
    /// A bound of the band is 0, negative, infinite or NaN.
    Band,
    /// The band has no width, or its upper bound is below its lower bound.
    Width,
    /// The scene has no mass with the requested name.
    UnknownMass(UnknownMass),
    /// The scene does not have the mass or the spring of the requested motion.
    NoSuchMotion(Of),
    /// The load does not fit the scene. The field gives the reason.
    Load(LoadError),
    /// The load drives the mode with this index, counted from 0, but neither damping nor the contact acts on this mode.
    Undamped(usize),
    /// The amplitude at a resonance within the band is unbounded at every friction.
    Unbounded,
    /// Without friction, the requested quantity is zero over the whole band. The search then has nothing to minimise.
    AtRest,
    /// [`System::optimum`](crate::study::System::optimum) reached its bound on work before it found any friction that
    /// bounds the amplitude.
    TooLong,
    /// The caller stopped the search before it found a valid friction. A valid friction bounds the amplitude, and
    /// keeps other quantities within the bounds of the request.
    Stopped,
    /// The interval in which a number of the scene description may vary is invalid: not finite, without width, or with
    /// an upper bound below its lower bound.
    Interval,
    /// At a bound of its interval, the varied number of the scene description makes the scene invalid.
    Scene(InvalidScene),
    /// The search cannot minimise the requested quantity. Only the contact has a contact force and an energy. A force
    /// has neither a velocity nor an acceleration. The equivalent damping ratio is best where it is largest, but the
    /// search finds the smallest value.
    Size,
    /// The request contains several quantities. The value by which the search divides one of the quantities is
    /// missing, 0, negative, infinite or NaN.
    Weight,
    /// The request contains several quantities together with bounds or varied numbers.
    SingleQuantity,
    /// The request varies several numbers that are not all shares of contacts, or the same number twice.
    Several,
    /// The solver for several contacts does not support the scene or the request.
    Joined(JoinedError),
    /// No friction satisfies this bound together with all earlier bounds in the request. If the request varies a number
    /// of the scene description, this is true for every value of the number in its interval.
    Unreachable {
        /// Index of the bound in the request.
        index: usize,
        /// Smallest value that the bounded quantity can have while all earlier bounds are satisfied, in the unit of
        /// the bound. The value of a quantity is its largest value over the band.
        least: f64,
        /// Friction ratio β at which the bounded quantity is smallest.
        beta: f64,
        /// Value of the varied number at which the bounded quantity is smallest. `None` if no number varies.
        value: Option<f64>,
    },
}

impl std::fmt::Display for OptimumError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Band => "both bounds of the band must be above 0 and finite",
            Self::Width => "the end of the band must be above its start",
            Self::UnknownMass(error) => return error.fmt(f),
            Self::NoSuchMotion(of) => return no_such_motion(f, *of),
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
            Self::Stopped => "the search was stopped before it found a valid friction",
            Self::Interval => "both bounds of an interval must be finite, the second above the first",
            Self::Scene(error) => return error.fmt(f),
            Self::Joined(error) => return error.fmt(f),
            Self::Weight => "each of several quantities needs a value above 0 to divide it by",
            Self::SingleQuantity => "bounds and varied numbers need a single minimised quantity",
            Self::Several => "the search varies one number of the description, or several shares of contacts",
            Self::Unreachable {
                index,
                least,
                beta,
                value,
            } => {
                write!(
                    f,
                    "bound {} cannot hold together with those before it: the least value is {least}, with the friction ratio {beta}",
                    index + 1
                )?;
                return match value {
                    Some(value) => write!(f, " and the value {value} of the varied number"),
                    None => Ok(()),
                };
            }
            Self::Size => {
                "the search minimises displacements, velocities, accelerations and forces, and of the contact also force and energy; a force has neither a velocity nor an acceleration, and `zeta_eq` is best where it is large"
            }
        })
    }
}

impl std::error::Error for OptimumError {}

impl From<UnknownMass> for OptimumError {
    fn from(error: UnknownMass) -> Self {
        Self::UnknownMass(error)
    }
}

impl From<JoinedError> for OptimumError {
    fn from(error: JoinedError) -> Self {
        Self::Joined(error)
    }
}

impl From<LoadError> for OptimumError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}
