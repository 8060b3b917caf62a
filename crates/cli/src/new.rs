//! `frictiongen new`: writes a scene description as a starting point.

use crate::args::NewArguments;
use crate::failure::{Failure, reason};
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

/// Description of a frame of two storeys, with comments on every field.
const SCENE: &str = include_str!("new.friction");

/// Runs `frictiongen new`.
pub fn run(arguments: &NewArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let path = arguments.file.as_deref();
    let Some(path) = path.filter(|path| *path != Path::new("-")) else {
        out.write_all(SCENE.as_bytes())?;
        return Ok(out.flush()?);
    };
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    let written = file.and_then(|mut file| file.write_all(SCENE.as_bytes()));
    written.map_err(|error| {
        let why = match error.kind() {
            std::io::ErrorKind::AlreadyExists => "it already exists".to_owned(),
            _ => reason(&error),
        };
        Failure::new(format_args!("cannot write {}: {why}", path.display()))
    })
}
