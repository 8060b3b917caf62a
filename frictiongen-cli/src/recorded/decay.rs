//! `frictiongen identify --decay`: finds friction in a free vibration.

use super::lines::Lines;
use super::read;
use crate::args::IdentifyArguments;
use crate::failure::Failure;
use frictiongen::System;

/// Returns the result for the only recording.
pub fn lines(arguments: &IdentifyArguments, system: &System) -> Result<Lines, Failure> {
    let files = &arguments.recordings;
    let recordings = files.recordings()?;
    let ([recording], [path]) = (recordings.as_slice(), files.recordings.as_slice()) else {
        return Err(Failure::new(
            "--decay: one recording of one free vibration is needed",
        ));
    };
    // Damping of the description counts as known, unless the user asks for it.
    let described = system.described_damping();
    let known = described.filter(|_| arguments.also.is_empty());
    let found = system
        .free_decay(recording, known)
        .map_err(|error| read::told(path, &error))?;
    let mut lines = Lines::default();
    lines.estimate("friction force", found.friction, 1.0, "N");
    lines.estimate("F/k", found.length, 1.0, "m");
    lines.number("F/k by the linear decrement", found.linear_decrement, "m");
    lines.estimate("natural frequency", found.hertz, 1.0, "Hz");
    lines.estimate("zeta", found.damping, 1.0, "");
    lines.number("extremes used", found.extremes.len() as f64, "");
    lines.number("misfit (1 is noise)", found.misfit, "");
    Ok(lines)
}
