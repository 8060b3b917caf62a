//! Reads scene descriptions from files and standard input.

use crate::args::FileArgument;
use crate::failure::{Failure, reason};
use frictiongen::System;
use frictiongen::study::scene::{FrictionLaw, Provide};
use frictiongen_codegen::{Description, Diagnostics, SizeLimits, parse_text};

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Largest size of a scene description in bytes. The command rejects a larger file.
const MOST_BYTES: usize = 16 << 20;

impl FileArgument {
    /// Returns the path of the file with the scene description, or `None` for standard input.
    pub fn path(&self) -> Option<&Path> {
        self.file.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// Returns the name of the scene description, which messages to the user contain.
    pub fn name(&self) -> String {
        self.path()
            .map_or_else(|| "<stdin>".to_owned(), |path| path.display().to_string())
    }

    /// Reads the text of the scene description from the file or from standard input.
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
                "{name} is not a description: it is longer than 16 MiB"
            )));
        }
        String::from_utf8(bytes).map_err(|error| {
            let place = error.utf8_error().valid_up_to();
            Failure::new(format_args!(
                "{name} is not a description: it is not UTF-8 text (byte {place})"
            ))
        })
    }

    /// Reads and parses the scene description. Fails for a scene with several contacts or dashpots.
    pub fn description(&self, limits: &SizeLimits) -> Result<Description, Failure> {
        self.single(self.parsed(&self.text()?, limits)?)
    }

    /// Reads and parses the description of a scene that may have several contacts and dashpots.
    pub fn any(&self, limits: &SizeLimits) -> Result<Description, Failure> {
        self.parsed(&self.text()?, limits)
    }

    /// Reads the system of a scene that may have several contacts and dashpots, and may lack an excitation.
    pub fn maybe_unloaded(&self) -> Result<System, Failure> {
        let system = self.text()?.parse();
        system.map_err(|diagnostics| self.told(diagnostics))
    }

    /// Returns the scene description unchanged. Fails if it has the field `contacts` or the field `dampers`.
    pub fn single(&self, description: Description) -> Result<Description, Failure> {
        if !description.scene.is_joined() {
            return Ok(description);
        }
        Err(Failure::new(format_args!(
            "{}: this command needs a single `contact` without dashpots, but this scene has several `contacts`, a `share`, `dampers` or a mass that no spring holds; use `frictiongen orbit`, `response`, `curve`, `map`, `time`, `drive`, `optimum` or `sensitivity`",
            self.name()
        )))
    }

    fn parsed(&self, text: &str, limits: &SizeLimits) -> Result<Description, Failure> {
        parse_text(text, limits).map_err(|diagnostics| self.told(diagnostics))
    }

    /// Returns the errors of a description with the name of its file.
    fn told(&self, diagnostics: Diagnostics) -> Failure {
        let name = self.name();
        let lines = diagnostics.list.into_iter();
        Failure::Lines(lines.map(|line| format!("{name}:{line}")).collect())
    }

    /// Fails if the contact of the scene description is elastic.
    pub fn check_rigid(&self, description: &Description) -> Result<(), Failure> {
        if description.scene.stiffness.is_none() {
            return Ok(());
        }
        Err(Failure::new(format_args!(
            "{}: this command needs a rigid contact, but this scene has `stiffness`; use `frictiongen orbit`, `response`, `curve` or `time`, or leave `stiffness` out",
            self.name()
        )))
    }

    /// Reads and parses a scene description for a command that requires constant kinetic friction, and returns it with
    /// its text. Fails for any other friction law, and for a scene with several contacts or dashpots.
    pub fn constant_level_with_text(
        &self,
        limits: &SizeLimits,
    ) -> Result<(Description, String), Failure> {
        let text = self.text()?;
        let description = self.single(self.parsed(&text, limits)?)?;
        self.check_constant(&description)?;
        Ok((description, text))
    }

    /// Reads and parses a scene description, and returns it with its text. Fails for a scene with several contacts or
    /// dashpots that provides more than a stepper.
    pub fn exported(&self, limits: &SizeLimits) -> Result<(Description, String), Failure> {
        let text = self.text()?;
        let description = self.parsed(&text, limits)?;
        let scene = &description.scene;
        if scene.is_joined() && scene.provide != [Provide::Stepper] {
            return Err(Failure::new(format_args!(
                "{}: an export of several contacts, dashpots or a free mass has only a stepper; write `provide: [stepper]`",
                self.name()
            )));
        }
        Ok((description, text))
    }

    /// Fails unless the kinetic friction is independent of the sliding speed.
    pub fn check_constant(&self, description: &Description) -> Result<(), Failure> {
        if description.scene.friction == FrictionLaw::Coulomb {
            return Ok(());
        }
        Err(Failure::new(format_args!(
            "{}: the exact response needs a constant kinetic level, but this scene has `friction: stribeck`; use `frictiongen orbit`, `curve`, `map` or `time`, or write `friction: coulomb`",
            self.name()
        )))
    }
}

/// Reads from a source at most one byte more than the largest permitted size.
fn read(source: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
