//! What the commands take that answer at points: limits, responses, steady states.

use super::shared::{
    FileArgument, FormatArguments, FrequencyArguments, LoadArguments, PointArguments,
};
use clap::Args;

/// Of `frictiongen limits`.
#[derive(Debug, Args)]
pub struct LimitsArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The frequency.
    #[command(flatten)]
    pub frequency: FrequencyArguments,
    /// The load.
    #[command(flatten)]
    pub load: LoadArguments,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen response`.
#[derive(Debug, Args)]
pub struct ResponseArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// Only this mass; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Also the harmonics X_1, X_3, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

/// Of `frictiongen orbit`.
#[derive(Debug, Args)]
pub struct OrbitArguments {
    /// What is asked about.
    #[command(flatten)]
    pub point: PointArguments,
    /// Only this mass; may be given more than once [default: every mass]
    #[arg(long, value_name = "NAME")]
    pub mass: Vec<String>,
    /// Also the harmonics X_0, X_1, ... up to this one
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub harmonics: Option<String>,
    /// Every steady state that is found, not only that from rest
    #[arg(long)]
    pub states: bool,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}
