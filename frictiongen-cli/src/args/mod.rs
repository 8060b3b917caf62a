//! What can be typed.

mod help;
mod recorded;
#[cfg(feature = "report")]
mod report;

use clap::{Args, Parser, Subcommand, ValueEnum};
use help::{
    CURVES, FEATURES, GRIDS, GRIDS_IN_TIME, LIMITS, MAPS, ONE_POINT, OPTIMA, ORBITS, RANGES,
    RESPONSES, SENSITIVITIES, TABLES, TIMES, UNITS,
};
pub use recorded::{
    Also, By, DriveArguments, FitArguments, IdentifyArguments, RecordingArguments,
    TransmissibilityArguments,
};
use recorded::{DRIVES, FITS, IDENTIFICATIONS, RECORDINGS};
#[cfg(feature = "report")]
pub use report::ReportArguments;
use std::path::PathBuf;

/// Exact solutions of mass-spring chains with one Coulomb friction contact.
#[derive(Debug, Parser)]
#[command(name = "frictiongen", version)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// The limits of continuous motion and of sliding over frequency
    #[command(after_help = format!("{LIMITS}{UNITS}{GRIDS}"))]
    Limits(LimitsArguments),
    /// Regime, amplitudes, phases and harmonics over frequency and friction
    #[command(after_help = format!("{RESPONSES}{UNITS}{GRIDS}"))]
    Response(ResponseArguments),
    /// The steady state from rest over frequency and friction, stops included
    #[command(after_help = format!("{ORBITS}{UNITS}{GRIDS_IN_TIME}"))]
    Orbit(OrbitArguments),
    /// Responses along frequency in every regime, refined where they bend
    #[command(after_help = format!("{CURVES}{UNITS}{RANGES}"))]
    Curve(CurveArguments),
    /// What the contact does over frequency and friction
    #[command(after_help = format!("{MAPS}{UNITS}{GRIDS}"))]
    Map(MapArguments),
    /// Displacements, velocities, the friction force and events over time, and spectra
    #[command(after_help = format!("{TIMES}{UNITS}{ONE_POINT}"))]
    Time(TimeArguments),
    /// The friction that keeps the largest amplitude over a band of frequencies smallest
    #[command(after_help = format!("{OPTIMA}{UNITS}"))]
    Optimum(OptimumArguments),
    /// Resonances, thresholds, invariant points, sliding ranges, regimes and peaks of a scene
    #[command(after_help = format!("{FEATURES}{UNITS}"))]
    Features(FeaturesArguments),
    /// Everything about a description on one page: HTML that needs no network
    #[cfg(feature = "report")]
    #[command(after_help = format!("{}{UNITS}{}", report::REPORTS, report::RANGES))]
    Report(ReportArguments),
    /// The derivatives of amplitude, phase and limits with respect to every parameter, in any regime
    #[command(after_help = format!("{SENSITIVITIES}{UNITS}{GRIDS_IN_TIME}"))]
    Sensitivity(SensitivityArguments),
    /// Driving frequency, transmissibility and phase of recordings
    #[command(after_help = RECORDINGS)]
    Transmissibility(TransmissibilityArguments),
    /// The friction force from recordings, with its interval
    #[command(after_help = format!("{IDENTIFICATIONS}{RECORDINGS}"))]
    Identify(IdentifyArguments),
    /// Frequencies, mass and stiffness ratios from a sweep without friction
    #[command(after_help = FITS)]
    Fit(FitArguments),
    /// The motion under a recorded force or motion of the base, step by step
    #[command(after_help = DRIVES)]
    Drive(DriveArguments),
    /// Tables of the limits and of the contact's motion, to a declared accuracy
    #[command(after_help = TABLES)]
    Compile(CompileArguments),
    /// The Rust that the macro emits for a description
    Expand(ExpandArguments),
    /// Every error of a description, each with the line that it is on
    Check(CheckArguments),
    /// A commented description to start from
    New(NewArguments),
    /// A script that completes this command's words in a shell
    Completions(CompletionsArguments),
    /// The manual page, in roff
    Man(ManArguments),
}

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
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
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
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
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
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
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
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
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
    /// Write to this file; its ending decides: .csv, .json, .svg, .png
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// The format.
    #[command(flatten)]
    pub format: FormatArguments,
}

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
