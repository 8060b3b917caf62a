//! Arguments of the commands that print code, check a description or write a new one.

use super::shared::FileArgument;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Output format of `frictiongen compile`: Rust, C or JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableFormat {
    /// Print the tables as Rust code.
    Rust,
    /// Print the tables as C99 code.
    C,
    /// Print the tables as JSON data.
    Json,
}

/// Arguments of `frictiongen compile`.
#[derive(Debug, Args)]
pub struct CompileArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Largest error of a result from the tables: relative, or in rad for a phase; for example 1e-4 [default: as in
    /// the description]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub accuracy: Option<String>,
    /// Largest size of the tables in bytes, for example 4096, instead of --accuracy; the command then chooses the best
    /// accuracy that fits
    #[arg(
        long,
        value_name = "BYTES",
        allow_hyphen_values = true,
        conflicts_with = "accuracy"
    )]
    pub budget: Option<String>,
    /// Range of frequency ratios r = omega sqrt(m1/k1), with the first mass m1 and the first spring k1, from a to b
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
    /// Keep limits on the safe side: beta_lim never above its exact value, beta*_lim never below its exact value
    #[arg(long)]
    pub safe: bool,
    /// Prove the accuracy at every r, which may take some seconds. By default the command only compares the tables with
    /// exact values at many points
    #[arg(long)]
    pub prove: bool,
    /// Print code or data in this format [default: a summary of the tables]
    #[arg(long, value_enum)]
    pub format: Option<TableFormat>,
    /// Prefix of all names in C [default: the scene's name]. Two tables of one scene in the same program need different
    /// prefixes
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen expand`.
#[derive(Debug, Args)]
pub struct ExpandArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Language or format of `frictiongen export`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ExportTarget {
    /// A static library with a header of C99.
    C,
    /// A functional mock-up unit (FMU) of FMI 3.0, for co-simulation.
    Fmu,
}

/// Arguments of `frictiongen export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Write a C library, or a functional mock-up unit (FMU)
    #[arg(long, value_enum)]
    pub to: ExportTarget,
    /// Folder for the C library, which the command creates if necessary; for an FMU, the file to write, whose name ends
    /// in .fmu
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// Prefix of all names in C and name of the header, or model identifier of the FMU [default: the scene's name]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// Folder with the crate `frictiongen` that the exported code uses [default: this version from the crate registry]
    #[arg(long, value_name = "PATH")]
    pub library: Option<PathBuf>,
}

/// Arguments of `frictiongen diff`.
#[derive(Debug, Args)]
pub struct DiffArguments {
    /// File with the old description; standard input if it is -
    pub old: PathBuf,
    /// File with the new description; standard input if it is -
    pub new: PathBuf,
    /// Print the differences as JSON
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `frictiongen check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// Print JSON: errors and warnings with line and column, and the numbers of a valid description
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `frictiongen new`.
#[derive(Debug, Args)]
pub struct NewArguments {
    /// File to write, which must not exist yet. Without FILE, or with `-`, the command writes to standard output
    pub file: Option<PathBuf>,
}

/// Arguments of `frictiongen play`.
#[derive(Debug, Args)]
pub struct PlayArguments {
    /// Argument for the scene description.
    #[command(flatten)]
    pub file: FileArgument,
    /// File with the playground, an interactive page that scripts/playground creates [default: playground.html in the
    /// folder of this program]
    #[arg(long, value_name = "PAGE")]
    pub page: Option<PathBuf>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `frictiongen setup`.
#[derive(Debug, Args)]
pub struct SetupArguments {
    /// Folder below which the command installs the completion scripts and manual pages [default: XDG_DATA_HOME, else
    /// .local/share in HOME]
    #[arg(long, value_name = "FOLDER")]
    pub share: Option<PathBuf>,
}

/// Arguments of `frictiongen completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// Shell for which the command prints the script
    pub shell: clap_complete::Shell,
}

/// Arguments of `frictiongen man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Command whose manual page to print [default: the page of the whole program]
    pub command: Option<String>,
}
