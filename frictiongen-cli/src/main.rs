//! Limits, responses and emitted solvers of friction scenes, on the command line.
//!
//! Every command reads one description, computes with [`frictiongen::System`] and writes a table,
//! CSV or JSON to standard output. The exit status is 0, or 2 with the reason on standard error.

mod args;
mod asked;
mod csv;
mod expand;
mod failure;
mod grid;
mod input;
mod json;
mod limits;
mod number;
mod orbit;
mod output;
mod progress;
mod response;
mod summary;
mod table;

use args::{Arguments, Command};
use clap::Parser;
use failure::Failure;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Nowhere is left to report to if this fails.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    match run(&arguments.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Limits(arguments) => limits::run(arguments),
        Command::Response(arguments) => response::run(arguments),
        Command::Orbit(arguments) => orbit::run(arguments),
        Command::Expand(arguments) => expand::run(arguments),
    }
}
