//! Arguments of the commands that compute at each point of a grid: limits, responses and steady states.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, FrictionArguments, FromArguments,
    LoadArguments, PointArguments,
};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `frictiongen limits`.
#[derive(Debug, Args)]
pub struct LimitsArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Options for the frequencies.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen limit-cycle`.
#[derive(Debug, Args)]
pub struct LimitCycleArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Options for the frictions.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// Option for the initial state.
    #[command(flatten)]
    pub from: FromArguments,
    /// Print this motion: a mass, a difference of two masses such as `roof-first`, accel(...), vel(...), spring(a-b),
    /// shear; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv or .json
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen branch`.
#[derive(Debug, Args)]
pub struct BranchArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The parameter that varies, and its first and last value; for example hz 1:7, friction 0.1:2, mu.pads 1:1.5,
    /// k.base-lower 1000:1400
    #[arg(long, num_args = 2, value_names = ["PARAMETER", "A:B"], required = true, allow_hyphen_values = true)]
    pub along: Vec<String>,
    /// Frequency ratio r, unless the frequency varies
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// Frequency in Hz, instead of --r
    #[arg(long, value_name = "HZ", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// Angular frequency in rad/s, instead of --r
    #[arg(long, value_name = "OMEGA", allow_hyphen_values = true)]
    pub omega: Option<String>,
    /// Friction ratio, unless the friction varies
    #[arg(long, value_name = "BETA", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// Kinetic friction force F in N, instead of --beta; needs --force or --base
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: Option<String>,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Start a branch at every steady state that `orbit --states` finds at the first value. Without this option, only
    /// at the one that motion from rest reaches
    #[arg(long)]
    pub states: bool,
    /// Follow also the branches that begin at bifurcations, and those on them, to this depth
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub switch: usize,
    /// Largest number of points on a branch
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub points: usize,
    /// Print this motion: a mass, a difference of two masses such as `roof-first`, accel(...), vel(...), spring(a-b),
    /// shear; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub of: Vec<String>,
    /// Option for the initial state.
    #[command(flatten)]
    pub start: FromArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png. A picture shows the amplitudes over the parameter
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen response`.
#[derive(Debug, Args)]
pub struct ResponseArguments {
    /// Options for the scene, the frequencies, the frictions and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print this quantity instead of every mass: a mass, a difference such as `roof-first`, or another quantity that
    /// `curve --of` accepts; may be given more than once. The contact is always printed
    #[arg(long, visible_alias = "mass", value_name = "NAME")]
    pub of: Vec<String>,
    /// Print also the odd harmonics X_1, X_3, ... of each motion up to order N, for example 5
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Option for the initial state.
    #[command(flatten)]
    pub start: FromArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    /// Options for the scene, the frequencies, the frictions and the load.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print this quantity instead of every mass: a mass, a difference such as `roof-first`, or another quantity that
    /// `curve --of` accepts; may be given more than once. The contact is always printed
    #[arg(long, visible_alias = "mass", value_name = "NAME")]
    pub of: Vec<String>,
    /// Print also the mean value X_0 and the harmonics X_1, X_2, ... of each motion up to order N, for example 5
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Print every steady state that the search finds. Without this option, only the state that motion from rest
    /// reaches
    #[arg(long)]
    pub states: bool,
    /// Option for the initial state.
    #[command(flatten)]
    pub start: FromArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file. The file extension sets the format: .csv, .json, .svg, or .png if the program has the
    /// feature png. A picture shows one period
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}
