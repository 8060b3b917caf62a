//! Regimes of the contact's motion, and the errors of solvers.

mod domain;
mod halt;

pub use domain::{Given, OutOfDomain, Ratio, Slice, Unsupported};
pub use halt::Halt;

use core::fmt;

/// Regime of the steady state: continuous motion, stick-slip, stuck or bistable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Regime {
    /// Continuous motion: β < β_lim and β < β*_lim. The contact slides all the time, and the closed form gives its
    /// motion. No stuck state exists. With μ = 1 the continuous motion is the only steady state. With μ > 1 stick-slip
    /// states may also exist.
    Continuous,
    /// Stick-slip: β_lim ≤ β < β*_lim. The contact alternately sticks and slides. No motion slides all the time, and no
    /// stuck state exists.
    StickSlip,
    /// Stuck: β ≥ β_lim and β ≥ β*_lim. A stuck state exists. With μ = 1 the motion from rest always ends in a stuck
    /// state. With μ > 1 the motion from rest may end in stick-slip instead.
    Stuck,
    /// Bistable: β*_lim ≤ β < β_lim, which requires μ > 1. A motion that slides all the time and a stuck state both
    /// exist.
    Bistable,
}

/// Reason why the scene has no continuous motion at an operating point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NotContinuous {
    /// The friction ratio β lies between the two limits: β_lim ≤ β < β*_lim. The contact alternately sticks and slides.
    StickSlip,
    /// The friction ratio β is at least β_lim and at least β*_lim. No motion slides all the time, and a stuck state
    /// exists.
    Stuck,
    /// The excitation is on an undamped resonance, with too little friction to bound the amplitude.
    Unbounded,
    /// The friction ratio β is NaN, negative or infinite.
    OutOfDomain,
}

/// Error: the excitation frequency is an undamped resonance of the chain with its contact stuck. No steady response
/// exists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StuckResonance;

/// Reason why the search for a steady state returns no steady state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NoOrbit {
    /// The frequency ratio r, the friction ratio β or the initial state is outside its domain.
    OutOfDomain(OutOfDomain),
    /// A cycle of the excitation has too many segments between events of the contact (stop, slip or reversal): more than
    /// 64 in emitted code, and more than 4096 in a run-time system.
    TooManyEvents,
    /// The excitation is on an undamped resonance, with too little friction to bound the amplitude.
    Unbounded,
    /// The load drives a mode, but neither damping nor the contact dissipates energy of this mode. The free vibration
    /// of the mode never decays. The number is the index of the mode, counted from 0 in ascending order of natural
    /// frequency.
    Undamped(usize),
    /// Every steady state that the search found is unstable, and the motion in time did not settle on another steady
    /// state.
    Unstable,
    /// The search found no motion that repeats after at most [`MAX_PERIOD`](crate::orbit::MAX_PERIOD) cycles. The
    /// search ends after [`MAX_CYCLES`](crate::orbit::MAX_CYCLES) cycles or [`MAX_STEPS`](crate::orbit::MAX_STEPS)
    /// steps.
    Unsettled,
}

/// Any error of a solver. A function that calls several solvers can use `?` on each of their results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Error {
    /// An argument is outside its domain. The field names the argument: see [`OutOfDomain`].
    OutOfDomain(OutOfDomain),
    /// No continuous motion exists. The field gives the reason: see [`NotContinuous`].
    NotContinuous(NotContinuous),
    /// The excitation is on an undamped resonance of the chain with its contact stuck: see [`StuckResonance`].
    StuckResonance(StuckResonance),
    /// The search for a steady state returns no steady state. The field gives the reason: see [`NoOrbit`].
    NoOrbit(NoOrbit),
}

impl fmt::Display for NotContinuous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StickSlip => f.write_str("no continuous motion: the friction ratio is between the continuous and the sliding limit, and the contact sticks and slips"),
            Self::Stuck => f.write_str("no continuous motion: the friction ratio is at or above both limits, where the contact can stay stuck"),
            Self::Unbounded => f.write_str("no steady motion: on an undamped resonance this friction ratio does not bound the amplitude"),
            Self::OutOfDomain => f.write_str("the friction ratio beta must be a finite number, not negative"),
        }
    }
}

impl fmt::Display for StuckResonance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "no steady response: this is an undamped resonance of the chain with its contact stuck",
        )
    }
}

impl fmt::Display for NoOrbit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(f),
            Self::TooManyEvents => f.write_str(
                "no steady state: a cycle has too many segments, more than 64 in emitted code or 4096 in a run-time system",
            ),
            Self::Unbounded => f.write_str("no steady state: on an undamped resonance this friction ratio does not bound the amplitude"),
            Self::Undamped(mode) => write!(
                f,
                "no steady state: the load drives mode {}, which has no damping and on which the contact does not act",
                mode.wrapping_add(1)
            ),
            Self::Unstable => f.write_str("no steady state: the one that was found is unstable, and the motion leaves it"),
            Self::Unsettled => f.write_str(
                "no steady state: the motion repeats neither after one cycle of the excitation nor after up to 64",
            ),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfDomain(error) => error.fmt(f),
            Self::NotContinuous(error) => error.fmt(f),
            Self::StuckResonance(error) => error.fmt(f),
            Self::NoOrbit(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for NotContinuous {}
impl core::error::Error for StuckResonance {}
impl core::error::Error for NoOrbit {}
impl core::error::Error for Error {}

impl From<OutOfDomain> for Error {
    fn from(error: OutOfDomain) -> Self {
        Self::OutOfDomain(error)
    }
}

impl From<NotContinuous> for Error {
    fn from(error: NotContinuous) -> Self {
        Self::NotContinuous(error)
    }
}

impl From<StuckResonance> for Error {
    fn from(error: StuckResonance) -> Self {
        Self::StuckResonance(error)
    }
}

impl From<OutOfDomain> for NoOrbit {
    fn from(error: OutOfDomain) -> Self {
        Self::OutOfDomain(error)
    }
}

impl From<NoOrbit> for Error {
    fn from(error: NoOrbit) -> Self {
        Self::NoOrbit(error)
    }
}
