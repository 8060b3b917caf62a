//! Prints completion scripts for shells and the manual page. The crates `clap_complete` and `clap_mangen` generate them
//! from the definition of the arguments.

use crate::args::{Arguments, CompletionsArguments, ManArguments};
use crate::failure::Failure;
use clap::CommandFactory;
use std::io::Write;

/// Prints the completion script of a shell.
pub fn completions(arguments: &CompletionsArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let mut script = Vec::new();
    let mut command = Arguments::command();
    clap_complete::generate(arguments.shell, &mut command, "frictiongen", &mut script);
    out.write_all(&script)?;
    Ok(out.flush()?)
}

/// Prints the manual page of the program or of one command.
pub fn man(arguments: &ManArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    if let Some(name) = arguments.command.as_deref() {
        let part = command.find_subcommand(name).cloned();
        command = part.ok_or_else(|| {
            Failure::new(format_args!(
                "there is no command {name}: see frictiongen --help"
            ))
        })?;
    }
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page)?;
    out.write_all(&page)?;
    Ok(out.flush()?)
}
