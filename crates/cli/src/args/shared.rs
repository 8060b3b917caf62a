//! Arguments that several commands share: the description, the output format, frequencies, frictions and the load.

use clap::Args;
use std::path::PathBuf;

/// The argument for the file with the description.
#[derive(Debug, Args)]
pub struct FileArgument {
    /// File with the description. Without FILE, or with `-`, the command reads standard input
    pub file: Option<PathBuf>,
}

/// Options for the format of the output. The default is a printed table.
#[derive(Debug, Args)]
pub struct FormatArguments {
    /// Print JSON, in which infinity is the string "inf"
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print CSV with all digits of every number
    #[arg(long)]
    pub csv: bool,
    /// Print the units of the columns in the second line of a CSV table
    #[arg(long, conflicts_with = "json")]
    pub unit_row: bool,
    /// Print comment lines (#) before a CSV table: the scene, its natural frequencies and the load
    #[arg(long, conflicts_with = "json")]
    pub comments: bool,
    /// Print the columns r and beta in addition to Hz and N. By default, a table with a limited width (--width) omits r
    /// and beta
    #[arg(long)]
    pub groups: bool,
    /// Largest width of a printed table in characters; 0 for any width [default: 100 on a terminal, otherwise 0]
    #[arg(long, value_name = "N")]
    pub width: Option<u16>,
}

/// Options for the frequency of the excitation, as a ratio, in Hz or in rad/s.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrequencyArguments {
    /// Frequency ratios r = omega sqrt(m1/k1), with the first mass m1 and the first spring k1; for example 0.9 or
    /// 0.2:0.01:2.5
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// Frequencies of the excitation in Hz, instead of --r; for example 5 or 1:0.1:10
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// Angular frequencies omega of the excitation in rad/s, instead of --r; for example 30 or 10:0.5:60
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub omega: Option<String>,
}

/// Options for the friction, as a ratio or as a force in N.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrictionArguments {
    /// Friction ratios: beta = F/P for the force amplitude P, beta = F/(k1 Y) for the base amplitude Y; for example 0.5
    /// or 0.1:0.1:0.9
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// Kinetic friction forces F in N, instead of --beta; needs --force or --base
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub friction: Option<String>,
}

/// Options for the amplitude of the load. With a load, results are in N and m.
#[derive(Debug, Args)]
pub struct LoadArguments {
    /// Amplitude P of the force in N, if a force on a mass drives the scene
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Amplitude Y of the base motion, if the base drives the scene, in m or with a unit: `0.001`, `1mm`. With the unit
    /// of a velocity or an acceleration, its amplitude is the same at every frequency: `0.1 m/s`, `2 m/s2`, `0.2g`
    #[arg(long, value_name = "Y", allow_hyphen_values = true)]
    pub base: Option<String>,
    /// Unbalance m e of a rotor in kg m, instead of --force. The amplitude of the force is m e omega^2
    #[arg(
        long,
        value_name = "ME",
        allow_hyphen_values = true,
        conflicts_with = "force"
    )]
    pub unbalance: Option<String>,
}

/// Option for the initial state of the motions to a steady state.
#[derive(Debug, Args)]
pub struct FromArguments {
    /// Answer with the steady state that motion reaches from rest (`rest`) or from displacements and velocities of all
    /// masses (x1,...;v1,..., in m and m/s under a load), with the contact where that motion leaves it
    #[arg(long, value_name = "STATE", allow_hyphen_values = true)]
    pub from: Option<String>,
}

/// Options for the scene, the frequencies, the frictions and the load.
#[derive(Debug, Args)]
pub struct PointArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Options for the frequencies.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// Options for the frictions.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// Options for the amplitude of the load.
    #[command(flatten)]
    pub load: LoadArguments,
}
