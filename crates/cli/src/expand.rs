//! `frictiongen expand`: prints the Rust code that the macro emits. The output begins with comments that name the scene
//! description and the version of the program.

use crate::args::ExpandArguments;
use crate::compile::command;
use crate::failure::Failure;
use crate::file::write_file;
use frictiongen_codegen::standalone::Origin;
use frictiongen_codegen::{SizeLimits, pretty};
use std::io::Write;

/// Runs `frictiongen expand`.
pub fn run(arguments: &ExpandArguments, out: &mut dyn Write) -> Result<(), Failure> {
    // The command rejects every scene description that the macro rejects.
    let description = arguments.file.any(&SizeLimits::MACRO)?;
    let source = pretty(&description).map_err(|error| {
        Failure::new(format_args!(
            "a defect of frictiongen: the emitted code is not valid Rust: {error}"
        ))
    })?;
    let origin = Origin {
        description: &description.written,
        command: &format!(
            "frictiongen expand {}",
            command::description(&arguments.file)
        ),
    };
    let source = format!("{}\n{source}", origin.rust_head(&description.scene));
    match arguments.output.as_deref() {
        Some(path) => write_file(path, arguments.file.path(), &source),
        None => {
            out.write_all(source.as_bytes())?;
            Ok(out.flush()?)
        }
    }
}
