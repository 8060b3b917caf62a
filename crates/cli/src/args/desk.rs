//! Arguments of the commands for curves, maps, motions over time, derivatives, the best friction and features.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, FromArguments, LoadArguments, PointArguments,
};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The axes of a picture that are logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum LogAxes {
    /// No axis is logarithmic.
    #[default]
    #[value(skip)]
    None,
    /// The frequency axis is logarithmic.
    X,
    /// The axes of amplitudes are logarithmic.
    Y,
    /// The frequency axis and the axes of amplitudes are logarithmic.
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
    /// Options for the scene, the frequencies, the frictions and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print only this quantity: a mass, `contact`, a difference of two masses such as `roof-first`, a spring force
    /// `spring(a-b)`, the base shear `shear`, `vel(roof)`, `accel(roof)`, `force(contact)`, `energy(contact)`, the
    /// equivalent damping ratio `zeta_eq`; may be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Largest deviation between the curve and the straight lines through its points, relative to the value of the
    /// curve [default: 5e-4]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// Print also the harmonics X_1, X_2, ... of each motion up to order N, for example 5
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Print also the largest velocity and the largest acceleration of each motion
    #[arg(long)]
    pub rates: bool,
    /// Initial state at each point: rest, displacements and velocities of all masses (x1,...;v1,...), or the state at
    /// the previous point while the frequency rises (up) or falls (down); rest,up,down draws several curves
    #[arg(long, value_name = "STATE", allow_hyphen_values = true)]
    pub from: Vec<String>,
    /// Use logarithmic axes in a picture: the frequency axis (x), the amplitude axes (y) or both (xy)
    #[arg(long, value_enum)]
    pub log: Option<LogAxes>,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// The quantity that the colours of a map show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ShadeArgument {
    /// The regime, and the number of stops of the contact in a cycle.
    #[default]
    Regime,
    /// Fraction of the period during which the contact sticks.
    Stuck,
    /// Amplitude of the first requested motion.
    Amplitude,
}

/// Arguments of `frictiongen map`.
#[derive(Debug, Args)]
pub struct MapArguments {
    /// Options for the scene, the frequencies, the frictions and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print only the amplitude of this quantity: a mass, `contact`, a difference of two masses such as `roof-first`,
    /// a spring force `spring(a-b)`, the base shear `shear`; may be given more than once [default: contact and every
    /// mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Print, instead of the points, the frictions at the boundaries between the regions of the map (such as
    /// continuous and stuck), with this many significant digits, from 1 to 12
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    pub boundaries: Option<String>,
    /// Quantity that the colours of a picture show
    #[arg(long, value_enum, default_value_t)]
    pub shade: ShadeArgument,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Option for the initial state.
    #[command(flatten)]
    pub start: FromArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen time`.
#[derive(Debug, Args)]
pub struct TimeArguments {
    /// Options for the scene, the frequency, the friction and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Number of cycles of the excitation to print [default: 10]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub cycles: Option<String>,
    /// Number of cycles of the excitation to compute before the first printed cycle [default: 0]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub skip: Option<String>,
    /// Number of samples in each cycle of the excitation, an even number [default: 200]; with --until, number of samples
    /// in all [default: 1000]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub samples: Option<String>,
    /// Initial state of the run, or of the steady state: `rest`, or displacements and velocities of all masses,
    /// x1,...;v1,... in m and m/s under a load and with --until, otherwise non-dimensional
    #[arg(long, value_name = "STATE", allow_hyphen_values = true)]
    pub from: Option<String>,
    /// Print the motion until this time in s, in N and m: the free vibration from the state --from, or the motion under
    /// --input. The description needs no `excitation`
    #[arg(
        long,
        value_name = "S",
        allow_hyphen_values = true,
        group = "FrequencyArguments",
        conflicts_with_all = ["beta", "force", "base", "unbalance", "cycles", "skip", "steady", "spectrum"]
    )]
    pub until: Option<String>,
    /// Input over time, instead of a harmonic load, for example "step 5 N from 0.5 s" or "sine 0.2 g at 2 Hz for 3 s"; may
    /// be given more than once
    #[arg(long, value_name = "TEXT", requires = "until")]
    pub input: Vec<String>,
    /// Print one period of the steady state instead of a run from the initial state
    #[arg(long, conflicts_with_all = ["cycles", "skip"])]
    pub steady: bool,
    /// Print only this quantity: a mass, `contact`, a difference of two masses such as `roof-first`, a spring force
    /// `spring(a-b)`, the base shear `shear`; may be given more than once [default: contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Print the events of the contact (stops, break-aways, reversals) instead of samples
    #[arg(long)]
    pub events: bool,
    /// Print the spectrum of each motion instead of samples over time
    #[arg(long, conflicts_with = "events")]
    pub spectrum: bool,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen sensitivity`.
#[derive(Debug, Args)]
pub struct SensitivityArguments {
    /// Options for the scene, the frequency, the friction and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Motion whose derivatives the command prints: a mass, `contact`, or a difference such as `roof-base` or
    /// `roof-first`. With several contacts: a mass, or a contact for its energy, force, slip, displacement and stuck
    /// fraction
    #[arg(long, value_name = "NAME")]
    pub of: String,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen optimum`.
#[derive(Debug, Args)]
pub struct OptimumArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Options for the frequency band a:b.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Quantity whose largest value the command minimises: a mass, `contact`, a difference such as `roof-base`, a
    /// spring force `spring(a-b)`, the base shear `shear`, `vel(roof)`, `accel(roof)`, `slip(contact)`,
    /// `force(contact)`. Given more than once, each with a value as in `roof/5mm`, the command minimises the largest
    /// quotient of a quantity and its value
    #[arg(long, value_name = "NAME", required = true)]
    pub of: Vec<String>,
    /// Keep the largest value of another quantity within a bound, for example `roof-base <= 5mm`; may be given more than
    /// once
    #[arg(long, value_name = "NAME<=BOUND")]
    pub keep: Vec<String>,
    /// Find also the best value, between a and b, of one number of the description. For example, `k base - lower=a:b`
    /// varies the stiffness of the spring between base and lower, `c base - lower` that of the dashpot, and `mu pads`
    /// that of one of several contacts. `share` varies the shares of all contacts but the first
    #[arg(long, value_name = "NAME=a:b", allow_hyphen_values = true)]
    pub vary: Option<String>,
    /// Option for the initial state.
    #[command(flatten)]
    pub start: FromArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen features`.
#[derive(Debug, Args)]
pub struct FeaturesArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Range of frequency ratios r = omega sqrt(m1/k1), with the first mass m1 and the first spring k1, from a to b
    /// [default: around the resonances]
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// Range of frequencies in Hz, from a to b, instead of --r
    #[arg(
        long,
        value_name = "a:b",
        allow_hyphen_values = true,
        conflicts_with = "r"
    )]
    pub hz: Option<String>,
    /// Range of angular frequencies omega in rad/s, from a to b, instead of --r
    #[arg(long, value_name = "a:b", allow_hyphen_values = true, conflicts_with_all = ["r", "hz"])]
    pub omega: Option<String>,
    /// Friction ratios beta for which to print features as well: beta = F/P for the force amplitude P, beta = F/(k1 Y)
    /// for the base amplitude Y
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// Kinetic friction forces F in N for which to print features, instead of --beta; needs --force or --base
    #[arg(
        long,
        value_name = "GRID",
        allow_hyphen_values = true,
        conflicts_with = "beta"
    )]
    pub friction: Option<String>,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Print only this quantity: a mass, `contact`, a difference of two masses such as `roof-first`, a spring force
    /// `spring(a-b)`, the base shear `shear`, `vel(roof)`, `accel(roof)`; may be given more than once [default:
    /// contact and every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}
