//! What can be wrong with a measurement.

use crate::study::{InvalidScene, LoadError};
use crate::{Error, OutOfDomain};

/// Why a measurement tells nothing.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeasureError {
    /// A cell of a file is not a finite number.
    NotANumber {
        /// The line, from 1.
        line: usize,
        /// The channel.
        channel: String,
        /// What stands there.
        text: String,
    },
    /// A file that is no table of numbers, or no UFF58: the line and what is wrong.
    Format {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// A channel without a unit.
    NoUnit(String),
    /// A unit that is not known.
    UnknownUnit(String),
    /// A channel that is there twice.
    Twice(String),
    /// Nothing says how many samples a second has.
    NoRate,
    /// The samples are not evenly spaced in time.
    MixedRates {
        /// Where it changes: a line of the file, or a channel.
        place: String,
        /// The first step, s.
        before: f64,
        /// The other step, s.
        after: f64,
    },
    /// Channels with different numbers of samples.
    Lengths(String),
    /// Too little to tell a frequency.
    TooShort {
        /// What there is.
        found: String,
        /// What is needed.
        needed: &'static str,
    },
    /// A value that is not finite.
    NotFinite {
        /// The channel.
        channel: String,
        /// The sample, from 0.
        sample: usize,
    },
    /// A channel that never changes.
    Constant(String),
    /// A channel that stays at its largest or smallest value although it moves fast there.
    Clipped {
        /// The channel.
        channel: String,
        /// The value, in the channel's unit.
        value: f64,
        /// The part of the samples.
        share: f64,
    },
    /// A channel that is neither the excitation nor a mass.
    NoSuchPlace {
        /// The channel.
        channel: String,
        /// What there is.
        known: Vec<String>,
    },
    /// The excitation was not recorded.
    NoDrive(&'static str),
    /// No friction force was given.
    NoFriction,
    /// The friction force was given, and recorded too.
    TwoFrictions,
    /// No mass was recorded.
    NoMass,
    /// A channel whose unit does not fit what it is of.
    WrongDimension {
        /// The channel.
        channel: String,
        /// Its unit.
        unit: &'static str,
    },
    /// The excitation does not stand out of its noise.
    Silent(String),
    /// The frequency of the excitation changes.
    Drifts {
        /// Hz at the start.
        from: f64,
        /// Hz at the end.
        to: f64,
    },
    /// The amplitude of the excitation changes by this part.
    Swells(f64),
    /// No part of the recording is steady.
    NotSteady(String),
    /// The samples are too far apart for the driving frequency.
    TooSlow {
        /// Samples a second.
        rate: f64,
        /// The frequency, Hz.
        hertz: f64,
    },
    /// Nothing was observed of what is asked.
    NoObservation,
    /// The measured size is a power of 1000 from what the scene can do: a unit is wrong.
    WrongUnit {
        /// The measured amplitude over the nearest that the scene has, rounded to a power of 1000.
        factor: f64,
        /// The mass.
        mass: String,
    },
    /// No friction makes the scene move like that.
    NotExplained {
        /// The mass.
        mass: String,
        /// Measured |x̄|.
        measured: f64,
        /// The nearest of the scene.
        nearest: f64,
    },
    /// No friction gives the motion of the scene such a phase.
    PhaseNotExplained {
        /// The mass.
        mass: String,
        /// The measured lag behind the excitation, degrees.
        measured: f64,
        /// The lag of the scene where it fits best.
        nearest: f64,
    },
    /// There are fewer data than unknowns.
    TooFewData {
        /// How many numbers were measured.
        data: usize,
        /// How many are asked.
        unknowns: usize,
    },
    /// The fit does not settle.
    NoFit,
    /// What is asked cannot be asked of this scene.
    Asked(&'static str),
    /// A free decay with too few peaks.
    FewPeaks(usize),
    /// The peaks of a free decay do not fall.
    NoDecay,
    /// A row of a sweep that cannot be used: its line and why.
    Sweep {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// Numbers that make no scene.
    Scene(InvalidScene),
    /// A load that does not fit the scene.
    Load(LoadError),
    /// What a solver refuses.
    Solver(Error),
}

impl std::fmt::Display for MeasureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotANumber {
                line,
                channel,
                text,
            } => write!(
                f,
                "line {line}: `{text}` of `{channel}` is not a finite number"
            ),
            Self::Format { line, what } | Self::Sweep { line, what } => {
                write!(f, "line {line}: {what}")
            }
            Self::NoUnit(channel) => write!(
                f,
                "the channel `{channel}` has no unit: end its name in one (`{channel}_mm`), or give --channel {channel}=COLUMN:UNIT"
            ),
            Self::UnknownUnit(unit) => write!(
                f,
                "`{unit}` is not a unit that is known: {}",
                super::Unit::known()
            ),
            Self::Twice(channel) => write!(f, "the channel `{channel}` is there twice"),
            Self::NoRate => write!(
                f,
                "nothing says how many samples a second has: a column `time_s`, or --rate"
            ),
            Self::MixedRates {
                place,
                before,
                after,
            } => write!(
                f,
                "the samples are not evenly spaced: the time step changes from {} s to {} s at {place}",
                short(*before),
                short(*after)
            ),
            Self::Lengths(channel) => {
                write!(f, "the channel `{channel}` has another number of samples")
            }
            Self::TooShort { found, needed } => {
                write!(
                    f,
                    "the recording is too short: {found}, and {needed} are needed"
                )
            }
            Self::NotFinite { channel, sample } => {
                write!(f, "sample {sample} of `{channel}` is not a finite number")
            }
            Self::Constant(channel) => write!(f, "the channel `{channel}` never changes"),
            Self::Clipped {
                channel,
                value,
                share,
            } => write!(
                f,
                "the channel `{channel}` is clipped at {value}: {:.1} % of its samples",
                100.0 * share
            ),
            Self::NoSuchPlace { channel, known } => write!(
                f,
                "the channel `{channel}` is nothing of this scene, which has {}",
                known.join(", ")
            ),
            Self::NoDrive(name) => write!(
                f,
                "the excitation was not recorded: a channel `{name}` is needed for frequency and phase"
            ),
            Self::NoFriction => {
                f.write_str("no friction force is given: give one, or a channel `friction` in N")
            }
            Self::TwoFrictions => f.write_str(
                "the friction force is given as a number and as the channel `friction`: leave one of the two out",
            ),
            Self::NoMass => write!(f, "the motion of no mass was recorded"),
            Self::WrongDimension { channel, unit } => {
                write!(f, "the channel `{channel}` cannot be in {unit}")
            }
            Self::Silent(channel) => write!(
                f,
                "no frequency stands out of the noise of the channel `{channel}`"
            ),
            Self::Drifts { from, to } => write!(
                f,
                "the frequency of the excitation drifts from {from:.5} Hz to {to:.5} Hz"
            ),
            Self::Swells(part) => write!(
                f,
                "the amplitude of the excitation changes by {:.1} %",
                100.0 * part
            ),
            Self::NotSteady(channel) => {
                write!(
                    f,
                    "no part of the recording is steady: the channel `{channel}` goes on changing"
                )
            }
            Self::TooSlow { rate, hertz } => write!(
                f,
                "{rate} samples a second are too few for {hertz:.4} Hz: five a cycle are needed"
            ),
            Self::NoObservation => write!(f, "nothing was observed of what is asked"),
            Self::WrongUnit { factor, mass } => write!(
                f,
                "`{mass}` moves {factor:.0e} times what the scene can do at any friction: a unit is wrong by this factor"
            ),
            Self::NotExplained {
                mass,
                measured,
                nearest,
            } => write!(
                f,
                "no friction explains the motion of `{mass}`: {measured:.4} of the excitation was measured, and the nearest that the scene has is {nearest:.4}; is the column another one, or the scene?"
            ),
            Self::PhaseNotExplained {
                mass,
                measured,
                nearest,
            } => write!(
                f,
                "no friction explains the phase of `{mass}`: a lag of {measured:.1} degrees was measured, and the nearest that the scene has is {nearest:.1}; is its sign turned round, or is it another mass, or another scene?"
            ),
            Self::TooFewData { data, unknowns } => write!(
                f,
                "{data} measured numbers cannot tell {unknowns} unknown ones"
            ),
            Self::NoFit => write!(f, "the least-squares fit does not settle"),
            Self::Asked(what) => f.write_str(what),
            Self::FewPeaks(count) => write!(
                f,
                "the free decay has {count} peaks above its noise: at least 4 are needed"
            ),
            Self::NoDecay => write!(f, "the peaks of the free vibration do not fall"),
            Self::Scene(error) => error.fmt(f),
            Self::Load(error) => error.fmt(f),
            Self::Solver(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for MeasureError {}

impl From<Error> for MeasureError {
    fn from(error: Error) -> Self {
        Self::Solver(error)
    }
}

impl From<OutOfDomain> for MeasureError {
    fn from(error: OutOfDomain) -> Self {
        Self::Solver(error.into())
    }
}

impl From<InvalidScene> for MeasureError {
    fn from(error: InvalidScene) -> Self {
        Self::Scene(error)
    }
}

/// Seven digits of a number, without needless noughts.
fn short(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

impl From<LoadError> for MeasureError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}
