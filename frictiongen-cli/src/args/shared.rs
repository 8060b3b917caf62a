//! Arguments that several commands share: the description, the output format, frequencies, frictions and the load.

use clap::Args;
use std::path::PathBuf;

/// The description to read.
#[derive(Debug, Args)]
pub struct FileArgument {
    /// File with the description. Without FILE, or with `-`, the command reads standard input
    pub file: Option<PathBuf>,
}

/// The format in which the command prints numbers. The default is a table.
#[derive(Debug, Args)]
pub struct FormatArguments {
    /// Print JSON; infinity is the string "inf"
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print CSV with all digits of every number
    #[arg(long)]
    pub csv: bool,
    /// In CSV, print the units of the columns in a second line
    #[arg(long, conflicts_with = "json")]
    pub unit_row: bool,
    /// In CSV, print comment lines (#) first: the scene, its natural frequencies, the load
    #[arg(long, conflicts_with = "json")]
    pub comments: bool,
    /// Print the columns r and beta in addition to Hz and N. Without this option, a table with a limited
    /// width (--width) omits r and beta
    #[arg(long)]
    pub groups: bool,
    /// Largest width of a printed table in characters; 0 for any width [default: 100 on a terminal, otherwise 0]
    #[arg(long, value_name = "N")]
    pub width: Option<u16>,
}

/// The frequency of the excitation, as a ratio, in Hz or in rad/s.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrequencyArguments {
    /// Frequency ratios r = omega sqrt(m1/k1)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// Frequencies in Hz, instead of --r
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// Angular frequencies in rad/s, instead of --r
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub omega: Option<String>,
}

/// The friction, as a ratio or as a force in N.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrictionArguments {
    /// Friction ratios beta = F/P, for base motion F/(k1 Y)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// Kinetic friction forces F in N, instead of --beta; needs --force or --base
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub friction: Option<String>,
}

/// The amplitude of the load. With a load, results are in N and m.
#[derive(Debug, Args)]
pub struct LoadArguments {
    /// Amplitude P of the force in N, if a force on a mass drives the scene
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Amplitude Y of the base motion in m, if the base drives the scene. With a unit, a velocity or an acceleration
    /// that is the same at every frequency: `0.1 m/s`, `2 m/s2`, `0.2g`
    #[arg(long, value_name = "Y", allow_hyphen_values = true)]
    pub base: Option<String>,
    /// Unbalance m e of a rotor in kg m, instead of --force. The force is m e omega^2
    #[arg(
        long,
        value_name = "ME",
        allow_hyphen_values = true,
        conflicts_with = "force"
    )]
    pub unbalance: Option<String>,
}

/// A scene, the frequencies and the frictions.
#[derive(Debug, Args)]
pub struct PointArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The friction.
    #[command(flatten)]
    pub friction: FrictionArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
}
