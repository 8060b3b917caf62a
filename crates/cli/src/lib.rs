//! Command line of frictiongen: limits, responses, steady states, motions over time and emitted solvers of friction
//! scenes.
//!
//! Every command reads one scene description, computes with [`frictiongen::System`] and writes a table, CSV or JSON.
//! The program's exit status is 0, or 2 with the reason on standard error.

mod args;
mod asked;
mod branch;
mod check;
mod compile;
mod curve;
mod decimal;
mod destination;
mod diff;
mod emitted;
mod expand;
mod export;
mod failure;
mod features;
mod file;
mod fit;
mod frequency;
mod friction;
mod from;
mod grid;
mod grids;
mod hint;
mod input;
mod interrupt;
mod joined;
mod json;
mod layout;
mod limit_cycle;
mod limits;
mod map;
mod measure;
mod modes;
mod new;
mod number;
mod optimum;
mod orbit;
mod output;
mod periodic;
#[cfg(feature = "pictures")]
mod picture;
mod play;
mod progress;
mod recorded;
#[cfg(feature = "report")]
mod report;
mod response;
mod sensitivity;
mod shell;
mod summary;
mod table;
mod time;
mod vary;

use args::{Arguments, Command};
use clap::Parser;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use failure::Failure;
use std::ffi::OsString;
use std::io::Write;

/// The reason why a command ended without a whole result.
#[derive(Debug)]
pub enum Ended {
    /// The command line is not valid, or requests help.
    Usage(clap::Error),
    /// The command failed. The field contains the lines of a message for the user.
    Lines(Vec<String>),
    /// The program that reads the output of the command has closed the output.
    Closed,
}

impl From<Failure> for Ended {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Lines(lines) => Self::Lines(lines),
            Failure::Closed => Self::Closed,
        }
    }
}

/// Returns the error of an invalid command line. If a command does not know --from, the message names those that do.
fn refused(error: clap::Error) -> Ended {
    match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(option))
            if error.kind() == ErrorKind::UnknownArgument && option == "--from" =>
        {
            Failure::new(
                "--from: only `orbit`, `response`, `curve`, `map`, `time`, `optimum`, `branch` and `limit-cycle` take an initial state; leave it out of this command",
            )
            .into()
        }
        _ => Ended::Usage(error),
    }
}

/// Runs a command line, whose first word is the name of the program. The command writes its results to `out`.
///
/// # Errors
/// [`Ended`] contains the message for the user.
pub fn run(
    arguments: impl IntoIterator<Item = OsString>,
    out: &mut dyn Write,
) -> Result<(), Ended> {
    let arguments = Arguments::try_parse_from(arguments).map_err(refused)?;
    Ok(match &arguments.command {
        Command::Limits(arguments) => limits::run(arguments, out),
        Command::LimitCycle(arguments) => limit_cycle::run(arguments, out),
        Command::Response(arguments) => response::run(arguments, out),
        Command::Orbit(arguments) => orbit::run(arguments, out),
        Command::Branch(arguments) => branch::run(arguments, out),
        Command::Periodic(arguments) => periodic::run(arguments, out),
        Command::Sensitivity(arguments) => sensitivity::run(arguments, out),
        Command::Curve(arguments) => curve::run(arguments, out),
        Command::Map(arguments) => map::run(arguments, out),
        Command::Time(arguments) => time::run(arguments, out),
        Command::Optimum(arguments) => optimum::run(arguments, out),
        Command::Transmissibility(arguments) => recorded::transmissibility(arguments, out),
        Command::Identify(arguments) => recorded::identify(arguments, out),
        Command::Fit(arguments) => recorded::fit(arguments, out),
        Command::Drive(arguments) => recorded::drive(arguments, out),
        Command::Features(arguments) => features::run(arguments, out),
        #[cfg(feature = "report")]
        Command::Report(arguments) => report::run(arguments, out),
        Command::Play(arguments) => play::run(arguments, out),
        Command::Compile(arguments) => compile::run(arguments, out),
        Command::Expand(arguments) => expand::run(arguments, out),
        Command::Export(arguments) => export::run(arguments, out),
        Command::Diff(arguments) => diff::run(arguments, out),
        Command::Check(arguments) => check::run(arguments, out),
        Command::New(arguments) => new::run(arguments, out),
        Command::Completions(arguments) => shell::completions(arguments, out),
        Command::Man(arguments) => shell::man(arguments, out),
        Command::Setup(arguments) => shell::setup(arguments, out),
    }?)
}
