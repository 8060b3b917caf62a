//! What the commands of the desk take: curves, maps, motions over time, derivatives, the best friction, features.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, LoadArguments, PointArguments,
};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Where the motion of each point of a curve starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StartFrom {
    /// From rest at every point.
    Rest,
    /// From the state of the point before, with ascending frequency.
    Up,
    /// From the state of the point before, with descending frequency.
    Down,
}

/// Of `frictiongen curve`.
#[derive(Debug, Args)]
pub struct CurveArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// Only this mass, or `contact`; may be given more than once [default: all]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// How far a straight line between neighbours may stray, relative to the curve [default: 5e-4]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// Also the harmonics X_1, X_2, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Also velocities and accelerations
    #[arg(long)]
    pub rates: bool,
    /// Start the motion of each point from rest, or sweep the frequency up or down; several with commas [default: rest]
    #[arg(long, value_enum, value_delimiter = ',')]
    pub from: Vec<StartFrom>,
    /// Write to this file; its ending decides: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// What the colours of a map tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Shade {
    /// What the contact does: regimes, and how often it stops.
    #[default]
    Regime,
    /// The part of the period for which the contact sticks.
    Stuck,
    /// The amplitude of the first motion asked for.
    Amplitude,
}

/// Of `frictiongen map`.
#[derive(Debug, Args)]
pub struct MapArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// Only the amplitude of this mass, or `contact`; may be given more than once [default: all]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// In place of the points, the boundaries between them, to this many significant digits
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    pub boundaries: Option<String>,
    /// What the colours of a picture tell
    #[arg(long, value_enum, default_value_t)]
    pub shade: Shade,
    /// Write to this file; its ending decides: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen time`.
#[derive(Debug, Args)]
pub struct TimeArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// How many cycles of the excitation are written [default: 10]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub cycles: Option<String>,
    /// How many cycles are passed before [default: 0]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub skip: Option<String>,
    /// How many samples a cycle has, an even number [default: 200]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub samples: Option<String>,
    /// From this state instead of rest: x1,...;v1,...
    #[arg(long, value_name = "STATE", allow_hyphen_values = true)]
    pub from: Option<String>,
    /// One period of the steady state instead of a run
    #[arg(long, conflicts_with_all = ["cycles", "skip", "from"])]
    pub steady: bool,
    /// Only this mass, or `contact`; may be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// The events of the contact instead of samples
    #[arg(long)]
    pub events: bool,
    /// The spectrum instead of samples
    #[arg(long, conflicts_with = "events")]
    pub spectrum: bool,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; its ending decides: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Of `frictiongen sensitivity`.
#[derive(Debug, Args)]
pub struct SensitivityArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// Of this mass, or of `contact`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen optimum`.
#[derive(Debug, Args)]
pub struct OptimumArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The band a:b.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// The amplitude of this mass, or of `contact`
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// Also the best value of one number of the description, between a and b: `k base - lower=a:b`
    #[arg(long, value_name = "NAME=a:b", allow_hyphen_values = true)]
    pub vary: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen features`.
#[derive(Debug, Args)]
pub struct FeaturesArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Frequency ratios r = omega sqrt(m1/k1) from a to b [default: about the resonances]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// In place of --r, frequencies in Hz
    #[arg(
        long,
        value_name = "a:b",
        allow_hyphen_values = true,
        conflicts_with = "r"
    )]
    pub hz: Option<String>,
    /// In place of --r, angular frequencies in rad/s
    #[arg(long, value_name = "a:b", allow_hyphen_values = true, conflicts_with_all = ["r", "hz"])]
    pub omega: Option<String>,
    /// Also the features at these friction ratios beta = F/P, for base motion F/(k1 Y)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// In place of --beta, kinetic friction forces F in N; needs --force or --base
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
    /// Only of this mass, or of `contact`; may be given more than once [default: all]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Write to this file; its ending decides: .csv, .json, .svg; .png with the feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}
