//! Where a command's answer goes, and in which form: the ending of a file decides.

use crate::args::FormatArguments;
use crate::failure::Failure;
use crate::file;
use std::io::Write;
use std::path::Path;

/// In which form an answer is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A table for people.
    Table,
    /// Comma-separated values.
    Csv,
    /// One JSON object.
    Json,
    /// A picture in vectors.
    Svg,
    /// A picture in pixels.
    Png,
}

impl FormatArguments {
    /// The form that the options say.
    pub fn form(&self) -> Form {
        match (self.json, self.csv) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            _ => Form::Table,
        }
    }
}

/// Where an answer goes.
#[derive(Debug)]
pub struct Destination<'a> {
    /// In which form.
    pub form: Form,
    /// To which file, which must not be the description; otherwise to standard output.
    file: Option<(&'a Path, Option<&'a Path>)>,
}

impl<'a> Destination<'a> {
    /// As the options say; `draws` if the command does.
    pub fn of(
        path: Option<&'a Path>,
        description: Option<&'a Path>,
        format: &FormatArguments,
        draws: bool,
    ) -> Result<Self, Failure> {
        let asked = format.form();
        let Some(path) = path else {
            return Ok(Self {
                form: asked,
                file: None,
            });
        };
        let shown = path.display();
        let ending = path
            .extension()
            .map(|ending| ending.to_string_lossy().to_lowercase());
        let pictures = draws && cfg!(feature = "pictures");
        let form = match ending.as_deref() {
            Some("csv") => Form::Csv,
            Some("json") => Form::Json,
            Some("svg") if pictures => Form::Svg,
            Some("png") if pictures => Form::Png,
            _ => {
                let endings = if pictures {
                    ".csv, .json, .svg or .png"
                } else {
                    ".csv or .json"
                };
                return Err(Failure::new(format_args!(
                    "--output `{shown}`: the name of a file ends in {endings}"
                )));
            }
        };
        if asked != Form::Table && asked != form {
            let option = if asked == Form::Csv {
                "--csv"
            } else {
                "--json"
            };
            return Err(Failure::new(format_args!(
                "--output `{shown}`: its name says {}, and {option} is given",
                ending.unwrap_or_default().to_uppercase()
            )));
        }
        // Said before a long computation, not after it.
        file::check(path, description)?;
        Ok(Self {
            form,
            file: Some((path, description)),
        })
    }

    /// Writes the answer.
    pub fn write(
        &self,
        out: &mut dyn Write,
        answer: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        match self.file {
            Some((path, description)) => file::write_with(path, description, answer),
            None => answer(out),
        }
    }
}
