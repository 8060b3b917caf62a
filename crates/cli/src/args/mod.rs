//! Command-line arguments: the commands and their options.

mod code;
mod desk;
mod help;
mod periodic;
mod points;
mod recorded;
#[cfg(feature = "report")]
mod report;
mod shared;

use clap::{Parser, Subcommand};
pub use code::{
    CheckArguments, CompileArguments, CompletionsArguments, DiffArguments, ExpandArguments,
    ExportArguments, ExportTarget, ManArguments, NewArguments, PlayArguments, SetupArguments,
    TableFormat,
};
pub use desk::{
    CurveArguments, FeaturesArguments, MapArguments, OptimumArguments, SensitivityArguments,
    TimeArguments,
};
#[cfg(feature = "pictures")]
pub use desk::{LogAxes, ShadeArgument};
use help::{
    BRANCHES, CURVES, CYCLES, DIFFERENCES, EXPORTS, FEATURES, FROM, GRIDS, GRIDS_IN_TIME, LIMITS,
    MAPS, ONE_POINT, OPTIMA, ORBITS, RANGES, RESPONSES, SENSITIVITIES, STATES, TABLES, TIMES,
    UNITS,
};
use periodic::PERIODICS;
pub use periodic::PeriodicArguments;
pub use points::{
    BranchArguments, LimitCycleArguments, LimitsArguments, OrbitArguments, ResponseArguments,
};
pub use recorded::{
    Also, By, DriveArguments, FitArguments, IdentifyArguments, RecordingArguments,
    TransmissibilityArguments,
};
use recorded::{DRIVES, FITS, IDENTIFICATIONS, RECORDINGS};
#[cfg(feature = "report")]
pub use report::ReportArguments;
pub use shared::{
    FileArgument, FormatArguments, FrequencyArguments, FrictionArguments, FromArguments,
    LoadArguments, PointArguments,
};

/// Exact solutions of mass-spring chains with Coulomb friction contacts.
#[derive(Debug, Parser)]
#[command(name = "frictiongen", version)]
pub struct Arguments {
    /// The command to run.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print the limits of continuous motion (beta_lim) and of sliding (beta*_lim) over frequency
    #[command(after_help = format!("{LIMITS}{UNITS}{GRIDS}"))]
    Limits(LimitsArguments),
    /// Print regime, amplitude, phase and harmonics of the response over frequency and friction
    #[command(after_help = format!("{RESPONSES}{FROM}{UNITS}{GRIDS}"))]
    Response(ResponseArguments),
    /// Print the steady state at each frequency and friction, in every regime
    #[command(after_help = format!("{ORBITS}{STATES}{FROM}{UNITS}{GRIDS_IN_TIME}"))]
    Orbit(OrbitArguments),
    /// Print the periodic motion that a moving surface keeps up without a load (stick-slip on a belt)
    #[command(after_help = CYCLES)]
    LimitCycle(LimitCycleArguments),
    /// Follow steady states, stable or not, along a parameter through folds, with every bifurcation
    #[command(after_help = format!("{BRANCHES}{UNITS}"))]
    Branch(BranchArguments),
    /// Print the steady state under any periodic load, given as a table of one period or as harmonics
    #[command(after_help = PERIODICS)]
    Periodic(PeriodicArguments),
    /// Draw or print responses over frequency in every regime, with more points where a curve bends
    #[command(after_help = format!("{CURVES}{FROM}{UNITS}{RANGES}"))]
    Curve(CurveArguments),
    /// Draw or print a map of the regimes over frequency and friction
    #[command(after_help = format!("{MAPS}{FROM}{UNITS}{GRIDS}"))]
    Map(MapArguments),
    /// Draw or print displacements, velocities, the friction force and events over time, and spectra
    #[command(after_help = format!("{TIMES}{FROM}{UNITS}{ONE_POINT}"))]
    Time(TimeArguments),
    /// Find the friction with which the largest amplitude over a frequency band is smallest
    #[command(after_help = format!("{OPTIMA}{FROM}{UNITS}"))]
    Optimum(OptimumArguments),
    /// List resonances, thresholds, invariant points, sliding ranges, regimes and peaks of a scene
    #[command(after_help = format!("{FEATURES}{UNITS}"))]
    Features(FeaturesArguments),
    /// Write one HTML page about a description, which a browser shows without a network
    #[cfg(feature = "report")]
    #[command(after_help = format!("{}{UNITS}{}", report::REPORTS, report::RANGES))]
    Report(ReportArguments),
    /// Write an interactive page that computes in a browser: its reader changes the description and sees new results
    Play(PlayArguments),
    /// Print derivatives of amplitude, phase and limits with respect to every parameter, in every regime
    #[command(after_help = format!("{SENSITIVITIES}{UNITS}{GRIDS_IN_TIME}"))]
    Sensitivity(SensitivityArguments),
    /// Find the excitation frequency, the transmissibility and the phase in recordings
    #[command(after_help = RECORDINGS)]
    Transmissibility(TransmissibilityArguments),
    /// Find the friction force from recordings, with its 95 % interval
    #[command(after_help = format!("{IDENTIFICATIONS}{RECORDINGS}"))]
    Identify(IdentifyArguments),
    /// Fit natural frequencies, mass ratios and stiffness ratios to a sweep without friction
    #[command(after_help = FITS)]
    Fit(FitArguments),
    /// Compute the motion under a recorded force or base motion, or under an input in closed form, step by step
    #[command(after_help = DRIVES, mut_arg("recordings", |recordings| {
        recordings.required(false).required_unless_present("input")
    }))]
    Drive(DriveArguments),
    /// Write tables of the limits, the contact motion and stuck responses, to a declared accuracy
    #[command(after_help = TABLES)]
    Compile(CompileArguments),
    /// Print the Rust code that the macro with the feature `proof` emits for a description
    Expand(ExpandArguments),
    /// Write a library with a C header, which contains everything that the description provides, or an FMU
    #[command(after_help = EXPORTS)]
    Export(ExportArguments),
    /// List the differences between two descriptions: parameters, natural frequencies, answers and emitted code
    #[command(after_help = DIFFERENCES)]
    Diff(DiffArguments),
    /// List every error of a description with its line. For a valid description, list frequencies, damping and mass
    Check(CheckArguments),
    /// Write a commented description as a starting point
    New(NewArguments),
    /// Print a script that completes the commands and options of this program in a shell
    Completions(CompletionsArguments),
    /// Print the manual page, in roff
    Man(ManArguments),
    /// Install completion scripts and manual pages in the folders where the shells and `man` of this user look for them
    Setup(SetupArguments),
}
