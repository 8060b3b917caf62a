//! Regimes, and what a question outside its domain is answered with.

use core::fmt;

/// How the contact moves in the steady state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Regime {
    /// β < β_lim and β < β*_lim: the closed form exists, and no stuck state.  With μ = 1 it is the only state; with μ > 1
    /// stick-slip may exist beside it.
    Continuous,
    /// β_lim ≤ β < β*_lim: neither the closed form nor a stuck state exists.  The contact stops and slides in turn.
    StickSlip,
    /// β ≥ β_lim and β ≥ β*_lim: a stuck state exists.  With μ = 1 motion from rest always ends in one; with μ > 1 it may
    /// end in stick-slip instead.
    Stuck,
    /// β*_lim ≤ β < β_lim, only with μ > 1: the closed form and a stuck state both exist.
    Bistable,
}

/// An argument that is NaN or negative, or infinite where that has no meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutOfDomain {
    /// Which argument: "r", "beta", "state", "reach"; or a slice that is too short or too long, "parts",
    /// "numbers", "multipliers", "continuous", "sliding"; of a stepper "dt", "force", "forces",
    /// "base", "friction", "stiction", "steps", "saved", "work"; of a map "mass"; of a run in time "amplitude" and "steepness"; or
    /// "stribeck" where the friction law has no constant kinetic level, which a stepper and `simulation_under` do without.
    pub argument: &'static str,
}

/// Why there is no continuous motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NotContinuous {
    /// β lies between the limits: the contact stops and slides in turn.
    StickSlip,
    /// β is at or above both limits: no motion slides all the time, and a stuck state exists.
    Stuck,
    /// On an undamped resonance, with too little friction to bound the amplitude.
    Unbounded,
    /// β is NaN, negative or infinite.
    OutOfDomain,
}

/// On an undamped resonance of the chain whose contact is stuck.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StuckResonance;

/// Why there is no steady state to report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum NoOrbit {
    /// r, β or the state to start from.
    OutOfDomain(OutOfDomain),
    /// A cycle has more than 64 segments.
    TooManyEvents,
    /// On an undamped resonance, with too little friction to bound the amplitude.
    Unbounded,
    /// Nothing damps this mode, counted from 0 in the order of the natural frequencies: the contact
    /// does not touch it, the load drives it, and its free vibration never dies.
    Undamped(usize),
    /// Every steady state that was found is unstable, and the motion did not come to rest on another.
    Unstable,
    /// The motion repeats neither after one cycle nor after up to [`MAX_PERIOD`](crate::orbit::MAX_PERIOD), within
    /// [`MAX_CYCLES`](crate::orbit::MAX_CYCLES) and [`MAX_STEPS`](crate::orbit::MAX_STEPS).
    Unsettled,
}

/// Any error of a solver, so that one function can use `?` on all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Error {
    /// See [`OutOfDomain`].
    OutOfDomain(OutOfDomain),
    /// See [`NotContinuous`].
    NotContinuous(NotContinuous),
    /// See [`StuckResonance`].
    StuckResonance(StuckResonance),
    /// See [`NoOrbit`].
    NoOrbit(NoOrbit),
}

impl fmt::Display for OutOfDomain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.argument == "stribeck" {
            return f.write_str(
                "the exact continuous response needs a constant kinetic level, and this scene has `friction: stribeck`; ask its stepper, or `simulation_under` with the load's amplitude",
            );
        }
        let needed = match self.argument {
            "r" => {
                "it must be a number, not negative and not NaN; a motion in time needs it clear of 0 and infinity too"
            }
            "state" => "it must have a finite displacement and velocity for each mass",
            "continuous" | "sliding" => "the slice must have one place for each r",
            "parts" | "numbers" | "multipliers" | "tables" => {
                "the room for the answer has another size"
            }
            "dt" => {
                "a step must be greater than zero, and so short that no oscillator turns by more than 1024 rad in it"
            }
            "force" | "base" => "it must be finite, and its square within the range of the scalar",
            "forces" => {
                "there must be one force for each mass that may be loaded, and for no other"
            }
            "stiction" => "it must be a finite number, 1 or more",
            "damping" => {
                "with so many modes at or beyond critical damping, held and free modes cannot be told apart in this scalar: less than half of the digits would be left"
            }
            "steps" => "the input at the start is said before the first step",
            "amplitude" => {
                "it must be positive and finite, and so large that the friction law's speeds, over the load's, stay apart"
            }
            "steepness" => {
                "with this load the kinetic level changes the motion more than 4096 times as fast as the fastest mode does"
            }
            "saved" => "it belongs to another scene or step",
            "work" => {
                "another step could take the work beyond the range of the scalar: reduce the force, or begin anew"
            }
            "mass" => "the scene has no mass of this place; places are counted from 0",
            _ => "it must be a finite number, not negative",
        };
        write!(f, "{} is outside the domain: {needed}", self.argument)
    }
}

impl fmt::Display for NotContinuous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StickSlip => f.write_str("no continuous motion: the friction ratio is between the continuous and the sliding limit, and the contact sticks and slips"),
            Self::Stuck => f.write_str("no continuous motion: the friction ratio is at or above both limits, where the contact can stay stuck"),
            Self::Unbounded => f.write_str("no steady motion: on an undamped resonance this friction ratio does not bound the amplitude"),
            Self::OutOfDomain => OutOfDomain { argument: "beta" }.fmt(f),
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
            Self::TooManyEvents => {
                f.write_str("no steady state: a cycle has more than 64 segments")
            }
            Self::Unbounded => f.write_str("no steady state: on an undamped resonance this friction ratio does not bound the amplitude"),
            Self::Undamped(mode) => write!(
                f,
                "no steady state: nothing damps mode {}, which the load drives and the contact does not touch",
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

impl core::error::Error for OutOfDomain {}
impl core::error::Error for NotContinuous {}
impl core::error::Error for StuckResonance {}
impl core::error::Error for NoOrbit {}
impl core::error::Error for Error {}

impl From<OutOfDomain> for Error {
    fn from(error: OutOfDomain) -> Self {
        Self::OutOfDomain(error)
    }
}

impl From<OutOfDomain> for NotContinuous {
    fn from(_: OutOfDomain) -> Self {
        Self::OutOfDomain
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
