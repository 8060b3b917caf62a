//! `frictiongen identify --decay`: finds friction in a free vibration.

use super::lines::ResultLines;
use super::read;
use crate::args::IdentifyArguments;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::measure::columns::decay_lines;

/// Identifies friction from the only recording, and returns the result as lines.
pub fn lines<'a>(
    arguments: &IdentifyArguments,
    system: &'a System,
) -> Result<ResultLines<'a>, Failure> {
    let files = &arguments.recordings;
    let recordings = files.recordings()?;
    let ([recording], [path]) = (recordings.as_slice(), files.recordings.as_slice()) else {
        return Err(Failure::new(
            "--decay: one recording of one free vibration is needed",
        ));
    };
    // The damping of the description counts as known, unless the user requests to fit it.
    let described = system.described_damping();
    let known = described.filter(|_| arguments.also.is_empty());
    let found = system
        .free_decay(recording, known)
        .map_err(|error| read::told(path, &error))?;
    Ok(ResultLines {
        system,
        lines: decay_lines(&found),
        said: Vec::new(),
        keys: Vec::new(),
    })
}
