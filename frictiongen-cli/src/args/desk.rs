//! Arguments of the commands for curves, maps, motions over time, derivatives, the best friction and features.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, LoadArguments, PointArguments,
};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The state from which the motion at each point of a curve starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StartFrom {
    /// Start from rest at every point.
    Rest,
    /// Raise the frequency, and start each point from the state of the previous one.
    Up,
    /// Lower the frequency, and start each point from the state of the previous one.
    Down,
}

/// The axes of a picture that are logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LogAxes {
    /// No axis.
    #[default]
    #[value(skip)]
    None,
    /// The frequency axis.
    X,
    /// The axes of amplitudes.
    Y,
    /// The frequency axis and the axes of amplitudes.
    Xy,
}

#[cfg(feature = "pictures")]
impl LogAxes {
    /// Returns true if the frequency axis is logarithmic.
    pub fn frequency(self) -> bool {
        matches!(self, Self::X | Self::Xy)
    }

    /// Returns true if the axes of amplitudes are logarithmic.
    pub fn amplitude(self) -> bool {
        matches!(self, Self::Y | Self::Xy)
    }
}

/// Arguments of `frictiongen curve`.
#[derive(Debug, Args)]
pub struct CurveArguments {
    /// The scene, the frequencies and the frictions.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print only this motion: a mass, `contact`, `roof-base`, `roof-first`, `spring(a-b)`, `shear`, `vel(roof)`,
    /// `accel(roof)`; may be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Largest deviation of the curve from straight lines between its points, relative to the curve [default: 5e-4]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// Print also the harmonics X_1, X_2, ... up to order N
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Print also velocities and accelerations
    #[arg(long)]
    pub rates: bool,
    /// Start each point from rest, or sweep the frequency up or down; several with commas [default: rest]
    #[arg(long, value_enum, value_delimiter = ',')]
    pub from: Vec<StartFrom>,
    /// Draw these axes of a picture logarithmically
    #[arg(long, value_enum)]
    pub log: Option<LogAxes>,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// The quantity that the colours of a map show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Shade {
    /// The regime, and the number of stops of the contact in a cycle.
    #[default]
    Regime,
    /// Fraction of the period during which the contact sticks.
    Stuck,
    /// Amplitude of the first motion that was asked for.
    Amplitude,
}

/// Arguments of `frictiongen map`.
#[derive(Debug, Args)]
pub struct MapArguments {
    /// The scene, the frequencies and the frictions.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print only the amplitude of this motion: a mass, `contact`, `roof-base`, `roof-first`, `spring(a-b)`, `shear`; may
    /// be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Print the boundaries between regions, to this many significant digits, instead of the points
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    pub boundaries: Option<String>,
    /// Quantity that the colours of a picture show
    #[arg(long, value_enum, default_value_t)]
    pub shade: Shade,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen time`.
#[derive(Debug, Args)]
pub struct TimeArguments {
    /// The scene, the frequency and the friction.
    #[command(flatten)]
    pub point: PointArguments,
    /// Number of cycles of the excitation to print [default: 10]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub cycles: Option<String>,
    /// Number of cycles to compute before the first printed one [default: 0]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub skip: Option<String>,
    /// Number of samples in a cycle, an even number [default: 200]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub samples: Option<String>,
    /// Start from this state instead of rest: displacements and velocities of all masses, x1,...;v1,...
    #[arg(long, value_name = "STATE", allow_hyphen_values = true)]
    pub from: Option<String>,
    /// Print one period of the steady state instead of a run
    #[arg(long, conflicts_with_all = ["cycles", "skip", "from"])]
    pub steady: bool,
    /// Print only this motion: a mass, `contact`, `roof-base`, `roof-first`, `spring(a-b)`, `shear`; may be given more
    /// than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Print the events of the contact instead of samples
    #[arg(long)]
    pub events: bool,
    /// Print the spectrum instead of samples
    #[arg(long, conflicts_with = "events")]
    pub spectrum: bool,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen sensitivity`.
#[derive(Debug, Args)]
pub struct SensitivityArguments {
    /// The scene, the frequencies and the frictions.
    #[command(flatten)]
    pub point: PointArguments,
    /// Motion whose derivatives are printed: a mass, `contact`, `roof-base`, `roof-first`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen optimum`.
#[derive(Debug, Args)]
pub struct OptimumArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency band a:b.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Quantity whose largest value is minimised: a mass, `contact`, `roof-base`, `roof-first`, `spring(a-b)`, `shear`,
    /// `vel(roof)`, `accel(roof)`, `slip(contact)`, `force(contact)`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// Optimise one number of the description too, between a and b, for example `k base - lower=a:b`
    #[arg(long, value_name = "NAME=a:b", allow_hyphen_values = true)]
    pub vary: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen features`.
#[derive(Debug, Args)]
pub struct FeaturesArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Range of frequency ratios r = omega sqrt(m1/k1), from a to b [default: around the resonances]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// Range of frequencies in Hz, instead of --r
    #[arg(
        long,
        value_name = "a:b",
        allow_hyphen_values = true,
        conflicts_with = "r"
    )]
    pub hz: Option<String>,
    /// Range of angular frequencies in rad/s, instead of --r
    #[arg(long, value_name = "a:b", allow_hyphen_values = true, conflicts_with_all = ["r", "hz"])]
    pub omega: Option<String>,
    /// Print also the features at these friction ratios beta = F/P, for base motion F/(k1 Y)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// Kinetic friction forces F in N, instead of --beta; needs --force or --base
    #[arg(
        long,
        value_name = "GRID",
        allow_hyphen_values = true,
        conflicts_with = "beta"
    )]
    pub friction: Option<String>,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Print only this motion: a mass, `contact`, `roof-base`, `roof-first`, `spring(a-b)`, `shear`, `vel(roof)`,
    /// `accel(roof)`; may be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}
