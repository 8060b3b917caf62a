//! What can be typed.

mod code;
mod desk;
mod help;
mod points;
mod recorded;
#[cfg(feature = "report")]
mod report;
mod shared;

use clap::{Parser, Subcommand};
pub use code::{
    CheckArguments, CompileArguments, CompletionsArguments, ExpandArguments, ManArguments,
    NewArguments, TableFormat,
};
#[cfg(feature = "pictures")]
pub use desk::Shade;
pub use desk::{
    CurveArguments, FeaturesArguments, MapArguments, OptimumArguments, SensitivityArguments,
    StartFrom, TimeArguments,
};
use help::{
    CURVES, FEATURES, GRIDS, GRIDS_IN_TIME, LIMITS, MAPS, ONE_POINT, OPTIMA, ORBITS, RANGES,
    RESPONSES, SENSITIVITIES, STATES, TABLES, TIMES, UNITS,
};
pub use points::{LimitsArguments, OrbitArguments, ResponseArguments};
pub use recorded::{
    Also, By, DriveArguments, FitArguments, IdentifyArguments, RecordingArguments,
    TransmissibilityArguments,
};
use recorded::{DRIVES, FITS, IDENTIFICATIONS, RECORDINGS};
#[cfg(feature = "report")]
pub use report::ReportArguments;
pub use shared::{
    FileArgument, FormatArguments, FrequencyArguments, FrictionArguments, LoadArguments,
};

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
    #[command(after_help = format!("{ORBITS}{STATES}{UNITS}{GRIDS_IN_TIME}"))]
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
    /// Tables of the limits, the contact's motion and stuck responses, to a declared accuracy
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
