//! What several commands take: a description, a format, frequencies, frictions, a load.

use clap::Args;
use std::path::PathBuf;

/// Which description.
#[derive(Debug, Args)]
pub struct FileArgument {
    /// The description; standard input if it is - or left out
    pub file: Option<PathBuf>,
}

/// In which format numbers are printed; a table unless one is chosen.
#[derive(Debug, Args)]
pub struct FormatArguments {
    /// Print JSON; infinity is the string "inf"
    #[arg(long, conflicts_with = "csv")]
    pub json: bool,
    /// Print CSV, every number with all its digits
    #[arg(long)]
    pub csv: bool,
    /// In CSV, a second line with the units of the columns
    #[arg(long, conflicts_with = "json")]
    pub unit_row: bool,
    /// In CSV, lines that begin with # first: the scene, its natural frequencies, the load
    #[arg(long, conflicts_with = "json")]
    pub comments: bool,
}

/// The frequency of the excitation, in one of three ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrequencyArguments {
    /// Frequency ratios r = omega sqrt(m1/k1)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// In place of --r, frequencies in Hz
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub hz: Option<String>,
    /// In place of --r, angular frequencies in rad/s
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub omega: Option<String>,
}

/// The friction, in one of two ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct FrictionArguments {
    /// Friction ratios beta = F/P, for base motion F/(k1 Y)
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub beta: Option<String>,
    /// In place of --beta, kinetic friction forces F in N; needs --force or --base
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub friction: Option<String>,
}

/// The amplitude of the load, where answers are wanted in N and m.
#[derive(Debug, Args)]
pub struct LoadArguments {
    /// Amplitude P of the force in N, where a force on a mass drives the scene
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Amplitude Y of the base motion in m, where the base drives the scene
    #[arg(long, value_name = "Y", allow_hyphen_values = true)]
    pub base: Option<String>,
}

/// A scene at frequencies and frictions.
#[derive(Debug, Args)]
pub struct PointArguments {
    /// The description.
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
