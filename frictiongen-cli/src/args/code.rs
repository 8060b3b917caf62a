//! What the commands take that print code or look after a description.

use super::shared::FileArgument;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// In which form tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableFormat {
    /// Rust.
    Rust,
    /// C99.
    C,
    /// Data.
    Json,
}

/// Of `frictiongen compile`.
#[derive(Debug, Args)]
pub struct CompileArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// The largest relative error of an answer; of a phase in radians
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// In place of an accuracy, bytes: the best accuracy that fits
    #[arg(
        long,
        value_name = "BYTES",
        allow_hyphen_values = true,
        conflicts_with = "accuracy"
    )]
    pub budget: Option<String>,
    /// Frequency ratios from a to b
    #[arg(long, value_name = "a:b", allow_hyphen_values = true)]
    pub r: Option<String>,
    /// beta_lim never above, beta*_lim never below the exact one
    #[arg(long)]
    pub safe: bool,
    /// Print code or data instead of the figures
    #[arg(long, value_enum)]
    pub format: Option<TableFormat>,
    /// Names in C begin with this [default: the scene's name]. Two tables of one scene need two names
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Of `frictiongen expand`.
#[derive(Debug, Args)]
pub struct ExpandArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Of `frictiongen check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// The description.
    #[command(flatten)]
    pub file: FileArgument,
}

/// Of `frictiongen new`.
#[derive(Debug, Args)]
pub struct NewArguments {
    /// The file to write, which must not be there; standard output if it is - or left out
    pub file: Option<PathBuf>,
}

/// Of `frictiongen completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    pub shell: clap_complete::Shell,
}

/// Of `frictiongen man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Of this command [default: of all]
    pub command: Option<String>,
}
