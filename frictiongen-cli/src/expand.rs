//! `frictiongen expand`: the Rust that the macro emits.

use crate::args::ExpandArguments;
use crate::destination::is_same;
use crate::failure::{Failure, reason};
use frictiongen_codegen::{Limits, pretty};
use std::fs;
use std::io::Write;
use std::path::Path;

/// Runs the command.
pub fn run(arguments: &ExpandArguments, out: &mut dyn Write) -> Result<(), Failure> {
    // What a macro would refuse is refused here too.
    let description = arguments.file.description(&Limits::MACRO)?;
    let source = pretty(&description).map_err(|error| {
        Failure::new(format_args!(
            "a defect of frictiongen: it emitted what is not Rust: {error}"
        ))
    })?;
    match arguments.output.as_deref() {
        Some(path) => write_file(path, arguments.file.path(), &source),
        None => {
            out.write_all(source.as_bytes())?;
            Ok(out.flush()?)
        }
    }
}

/// Writes the source to a file, which must not be the description.
pub fn write_file(path: &Path, description: Option<&Path>, source: &str) -> Result<(), Failure> {
    let shown = path.display();
    if description.is_some_and(|description| is_same(description, path)) {
        return Err(Failure::new(format_args!(
            "cannot write {shown}: it is the description itself"
        )));
    }
    fs::write(path, source)
        .map_err(|error| Failure::new(format_args!("cannot write {shown}: {}", reason(&error))))
}
