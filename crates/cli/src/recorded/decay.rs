//! `frictiongen identify --decay`: finds the friction force from a free vibration.

use super::lines::ResultLines;
use super::read;
use crate::args::IdentifyArguments;
use crate::failure::Failure;
use frictiongen::System;
use frictiongen::measure::columns::decay_lines;

/// Finds the friction force from the recording of a free vibration, and returns the result as lines.
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
    // The fit takes the damping of the scene description as known, unless the user requests a fit of the damping.
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
