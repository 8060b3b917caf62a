//! Errors of measurements.

use crate::study::{InvalidScene, units::LoadError};
use crate::{Error, OutOfDomain};

/// Reason why a measurement gives no result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeasureError {
    /// A cell of a recording's file is not a finite number.
    NotANumber {
        /// Number of the faulty line in the file, counted from 1.
        line: usize,
        /// Name of the recording's channel that causes the error.
        channel: String,
        /// Text of the cell that is no finite number.
        text: String,
    },
    /// A file is neither a table of numbers nor a UFF58 file (Universal File Format, data set 58).
    Format {
        /// Number of the faulty line in the file, counted from 1.
        line: usize,
        /// Description of the mistake, as text for the message.
        what: String,
    },
    /// A channel has no unit. The field has the name of the channel.
    NoUnit(String),
    /// A recording or a request names a unit that is unknown.
    UnknownUnit(String),
    /// Two channels have the same name, which is the field.
    Twice(String),
    /// The sampling rate of a recording is not known.
    NoRate,
    /// The samples are not evenly spaced in time.
    MixedRates {
        /// Position at which the time step of the recording changes. It is a line of the file, or a channel.
        place: String,
        /// Time step before the change of the sampling rate, in s.
        before: f64,
        /// Time step after the change of the sampling rate, in s.
        after: f64,
    },
    /// Two channels have different numbers of samples. The field has the name of one of the two channels.
    Lengths(String),
    /// The recording is too short to find the frequency of the excitation.
    TooShort {
        /// Length of the recording, as text for the message.
        found: String,
        /// Necessary length of the recording, as text for the message.
        needed: &'static str,
    },
    /// A sample is not a finite number.
    NotFinite {
        /// Name of the recording's channel that causes the error.
        channel: String,
        /// Index of the faulty sample, counted from 0.
        sample: usize,
    },
    /// All samples of a channel are equal. The field is the name of the channel.
    Constant(String),
    /// A channel is clipped: it stays at its largest or smallest value, although it moves fast just before.
    Clipped {
        /// Name of the recording's channel that causes the error.
        channel: String,
        /// Value at which the clipped channel stays, in the unit of the channel.
        value: f64,
        /// Fraction of the channel's samples that have the clipped value.
        share: f64,
    },
    /// The name of a channel is not the name of the excitation, and not the name of a mass.
    NoSuchPlace {
        /// Name of the recording's channel that causes the error.
        channel: String,
        /// Names that a channel can have in this scene.
        known: Vec<String>,
    },
    /// The excitation was not recorded. The field is the name of the missing channel.
    NoDrive(&'static str),
    /// The friction force was neither given nor recorded.
    NoFriction,
    /// The caller gave the friction force, although the recording contains it.
    TwoFrictions,
    /// No channel of the recording is the motion of a mass.
    NoMass,
    /// The unit of a channel does not fit the quantity of the channel.
    WrongDimension {
        /// Name of the recording's channel that causes the error.
        channel: String,
        /// Unit of the channel that causes the error.
        unit: &'static str,
        /// Necessary quantity of the channel, as text for the message.
        needed: &'static str,
    },
    /// The excitation does not exceed the noise of its channel. The field has the name of the channel.
    Silent(String),
    /// The frequency of the excitation is not constant.
    Drifts {
        /// Frequency of the excitation at the start of the recording, in Hz.
        from: f64,
        /// Frequency of the excitation at the end of the recording, in Hz.
        to: f64,
    },
    /// The amplitude of the excitation is not constant during the recording. The number is the largest relative
    /// deviation from the mean amplitude.
    Swells(f64),
    /// The motion in a channel is never steady. The field is the name of the channel.
    NotSteady(String),
    /// The sampling rate is too low for the driving frequency: a cycle has too few samples.
    TooSlow {
        /// Sampling rate of the recording, in samples per second.
        rate: f64,
        /// Driving frequency of the recording, in Hz.
        hertz: f64,
    },
    /// No observation contains the quantities that the request requires.
    NoObservation,
    /// The measured amplitude of a mass is 1000 or a million times too large or too small for the scene at any
    /// friction force. A unit is therefore wrong.
    WrongUnit {
        /// Number by which the code must divide the measured amplitude so that the scene explains it. It is 1000, a
        /// million, or the inverse of one of these.
        factor: f64,
        /// Name of the mass whose measured motion causes the error.
        mass: String,
    },
    /// The scene does not have the measured amplitude of a mass at any friction force.
    NotExplained {
        /// Name of the mass whose measured motion causes the error.
        mass: String,
        /// Measured amplitude |x̄| of the mass.
        measured: f64,
        /// The amplitude |x̄| of the scene that is nearest to the measured amplitude.
        nearest: f64,
    },
    /// The scene does not have the measured phase of a mass at any friction force.
    PhaseNotExplained {
        /// Name of the mass whose measured motion causes the error.
        mass: String,
        /// Measured lag of the mass behind the excitation, in degrees.
        measured: f64,
        /// Lag of the mass behind the excitation in the scene with the best-fitting friction force, in degrees.
        nearest: f64,
    },
    /// The number of measured values is smaller than the number of unknowns.
    TooFewData {
        /// Number of measured values that the fit compares.
        data: usize,
        /// Number of unknowns that the fit has to find.
        unknowns: usize,
    },
    /// The least-squares fit does not converge.
    NoFit,
    /// The request does not apply to this scene, or one of its arguments is out of range.
    Asked(&'static str),
    /// The text of a signal is wrong, or the scene cannot have the signal.
    Signal {
        /// Text of the signal. It is empty if the message is about several signals.
        text: String,
        /// Description of the mistake, as text for the message.
        what: String,
    },
    /// A free decay has too few peaks above the noise. The field is the number of peaks found.
    FewPeaks(usize),
    /// The peaks of a free decay do not decrease.
    NoDecay,
    /// A row of a sweep cannot be used.
    Sweep {
        /// Number of the faulty line in the file, counted from 1.
        line: usize,
        /// Description of the mistake, as text for the message.
        what: String,
    },
    /// The fitted numbers do not form a valid scene.
    Scene(InvalidScene),
    /// A load does not fit the scene. The field gives the reason.
    Load(LoadError),
    /// A solver of the library returned an error.
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
            Self::NoUnit(channel) => {
                let unit = unit_of(channel);
                // A word after the last `_` may be meant as a unit, as in `force_lbf` and `base_yd/s2`.
                match channel.rsplit_once('_') {
                    Some((name, word)) if word.contains('/') => {
                        let unit = if word.contains(['2', '²']) { "m/s2" } else { "m/s" };
                        write!(
                            f,
                            "the channel `{channel}` has no known unit; convert the numbers from {word} to {unit} and write `{name}_{unit}`; the units are {}",
                            super::Unit::known()
                        )
                    }
                    Some((name, word)) if word.chars().all(char::is_alphabetic) => write!(
                        f,
                        "the channel `{channel}` has no known unit; if `{word}` is its unit, convert the numbers to {unit} and write `{name}_{unit}`, otherwise write `{channel}_{unit}`; the units are {}",
                        super::Unit::known()
                    ),
                    _ => write!(
                        f,
                        "the channel `{channel}` has no unit; add the unit to its name (`{channel}_{unit}`), or give --channel {channel}=COLUMN:{unit}"
                    ),
                }
            }
            Self::UnknownUnit(unit) => write!(
                f,
                "`{unit}` is not a known unit; the units are {}",
                super::Unit::known()
            ),
            Self::Twice(channel) => write!(f, "the channel `{channel}` is given twice"),
            Self::NoRate => write!(
                f,
                "the sampling rate is unknown; give a column `time_s`, or --rate"
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
                write!(f, "the channel `{channel}` does not have the same number of samples as the others")
            }
            Self::TooShort { found, needed } => {
                write!(
                    f,
                    "the recording is too short: {found}, but {needed} are needed"
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
                "the channel `{channel}` is clipped at {value} in {:.1} % of its samples",
                100.0 * share
            ),
            Self::NoSuchPlace { channel, known } => write!(
                f,
                "the channel `{channel}` does not belong to this scene, which has {}",
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
            Self::NoMass => write!(f, "no motion of a mass was recorded"),
            Self::WrongDimension {
                channel,
                unit,
                needed,
            } => write!(
                f,
                "the channel `{channel}` is in {unit}, but here it must be {needed}"
            ),
            Self::Silent(channel) => write!(
                f,
                "no frequency exceeds the noise of the channel `{channel}`"
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
                "{rate} samples a second are too few for {hertz:.4} Hz: five samples a cycle are needed"
            ),
            Self::NoObservation => write!(f, "none of the requested quantities was observed"),
            Self::WrongUnit { factor, mass } => write!(
                f,
                "`{mass}` moves {factor:.0e} times as far as it can in the scene at any friction: a unit is wrong by this factor"
            ),
            Self::NotExplained {
                mass,
                measured,
                nearest,
            } => write!(
                f,
                "no friction explains the motion of `{mass}`: its measured amplitude over the excitation is {measured:.4}, but the nearest amplitude of the scene is {nearest:.4}; check the column and the scene"
            ),
            Self::PhaseNotExplained {
                mass,
                measured,
                nearest,
            } => write!(
                f,
                "no friction explains the phase of `{mass}`: its measured lag is {measured:.1} degrees, but the nearest lag of the scene is {nearest:.1}; check the sign of the channel, the mass and the scene"
            ),
            Self::TooFewData { data, unknowns } => write!(
                f,
                "{data} measured numbers are too few to find {unknowns} unknowns"
            ),
            Self::NoFit => write!(f, "the least-squares fit does not converge"),
            Self::Asked(what) => f.write_str(what),
            Self::Signal { text, what } if text.is_empty() => f.write_str(what),
            Self::Signal { text, what } => write!(f, "`{text}`: {what}"),
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

/// Returns an example of a unit that fits the quantity in a channel of this name.
#[must_use]
pub fn unit_of(channel: &str) -> &'static str {
    let name = channel.split('_').next().unwrap_or(channel);
    match name.to_lowercase().as_str() {
        "time" | "t" => "s",
        "force" | "friction" => "N",
        _ => "mm",
    }
}

/// Rounds a number to seven significant digits, so that it prints without trailing zeros.
fn short(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

impl From<LoadError> for MeasureError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}
