//! Entry point of the program. The library of this crate does the work.

use frictiongen_cli::{Ended, run};
use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let lines = match run(std::env::args_os(), &mut io::stdout().lock()) {
        Ok(()) | Err(Ended::Closed) => return ExitCode::SUCCESS,
        Err(Ended::Usage(error)) => {
            // If this output fails, the program has no way left to report the error.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
        Err(Ended::Lines(lines)) => lines,
    };
    let mut stderr = io::stderr().lock();
    for line in lines {
        let _ = writeln!(stderr, "{line}");
    }
    ExitCode::from(2)
}
