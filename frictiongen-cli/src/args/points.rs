//! Arguments of the commands that compute at each point of a grid: limits, responses and steady states.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, LoadArguments, PointArguments,
};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `frictiongen limits`.
#[derive(Debug, Args)]
pub struct LimitsArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen response`.
#[derive(Debug, Args)]
pub struct ResponseArguments {
    /// The scene, the frequencies and the frictions.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print this motion instead of every mass; the contact is always printed. Names are those of `curve`; may be given
    /// more than once
    #[arg(long, visible_alias = "mass", value_name = "NAME")]
    pub of: Vec<String>,
    /// Print also the harmonics X_1, X_3, ... up to order N
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Arguments of `frictiongen orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    /// The scene, the frequencies and the frictions.
    #[command(flatten)]
    pub point: PointArguments,
    /// Print this motion instead of every mass; the contact is always printed. Names are those of `curve`; may be given
    /// more than once
    #[arg(long, visible_alias = "mass", value_name = "NAME")]
    pub of: Vec<String>,
    /// Print also the harmonics X_0, X_1, ... up to order N
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Print every steady state that the search finds. Without this option, only the state that motion from rest
    /// reaches
    #[arg(long)]
    pub states: bool,
    /// Arguments for the format of the output.
    #[command(flatten)]
    pub format: FormatArguments,
    /// Write to this file; the file extension sets the format: .csv, .json, .svg; .png with the feature png. A picture
    /// shows one period
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}
