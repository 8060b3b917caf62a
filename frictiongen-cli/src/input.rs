//! Reads descriptions.

use crate::args::FileArgument;
use crate::failure::{Failure, reason};
use frictiongen::study::scene::FrictionLaw;
use frictiongen_codegen::{Description, Limits, parse_text};

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Far more than any description needs; what is longer is some other file.
const MOST_BYTES: usize = 16 << 20;

impl FileArgument {
    /// The file, unless standard input is meant.
    pub fn path(&self) -> Option<&Path> {
        self.file.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// What the description is called in messages.
    pub fn name(&self) -> String {
        self.path()
            .map_or_else(|| "<stdin>".to_owned(), |path| path.display().to_string())
    }

    /// The text of the description.
    pub fn text(&self) -> Result<String, Failure> {
        let bytes = match self.path() {
            Some(path) => File::open(path).and_then(read),
            None => read(io::stdin().lock()),
        };
        let name = self.name();
        let bytes = bytes.map_err(|error| {
            Failure::new(format_args!("cannot read {name}: {}", reason(&error)))
        })?;
        if bytes.len() > MOST_BYTES {
            return Err(Failure::new(format_args!(
                "{name} is no description: it is longer than 16 MiB"
            )));
        }
        String::from_utf8(bytes).map_err(|error| {
            let place = error.utf8_error().valid_up_to();
            Failure::new(format_args!(
                "{name} is no description: it is not UTF-8 text (byte {place})"
            ))
        })
    }

    /// The description.
    pub fn description(&self, limits: &Limits) -> Result<Description, Failure> {
        parse_text(&self.text()?, limits).map_err(|diagnostics| {
            let name = self.name();
            let lines = diagnostics.list.into_iter();
            Failure::Lines(lines.map(|line| format!("{name}:{line}")).collect())
        })
    }

    /// The description, of which the exact response is asked: it needs a constant kinetic level.
    pub fn constant_level(&self, limits: &Limits) -> Result<Description, Failure> {
        let description = self.description(limits)?;
        if description.scene.friction == FrictionLaw::Coulomb {
            return Ok(description);
        }
        Err(Failure::new(format_args!(
            "{}: the exact response needs a constant kinetic level, and this scene has `friction: stribeck`: write `friction: coulomb`, drive its stepper, or follow a run by `frictiongen time`",
            self.name()
        )))
    }
}

/// Everything, or one byte more than is taken.
fn read(source: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
