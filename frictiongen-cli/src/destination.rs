//! Where a command's answer goes, and in which form: the ending of a file decides.

use crate::args::FormatArguments;
use crate::failure::{Failure, reason};
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

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
    /// To which file; otherwise to standard output.
    path: Option<&'a Path>,
}

impl<'a> Destination<'a> {
    /// As the options say; `draws` if the command does.
    pub fn of(
        path: Option<&'a Path>,
        description: Option<&Path>,
        format: &FormatArguments,
        draws: bool,
    ) -> Result<Self, Failure> {
        let asked = format.form();
        let Some(path) = path else {
            return Ok(Self {
                form: asked,
                path: None,
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
                    "--output {shown}: the file's name ends in {endings}"
                )));
            }
        };
        if asked != Form::Table && asked != form {
            return Err(Failure::new(format_args!(
                "--output {shown}: its ending says another format than the option"
            )));
        }
        if description.is_some_and(|description| is_same(description, path)) {
            return Err(Failure::new(format_args!(
                "cannot write {shown}: it is the description itself"
            )));
        }
        // Said before a long computation, not after it.
        let folder = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        if folder.is_some_and(|folder| !folder.is_dir()) {
            return Err(Failure::new(format_args!(
                "cannot write {shown}: there is no such folder"
            )));
        }
        if path.is_dir() {
            return Err(Failure::new(format_args!(
                "cannot write {shown}: it is a folder"
            )));
        }
        Ok(Self {
            form,
            path: Some(path),
        })
    }

    /// Writes the answer: to a file beside the asked one, which takes its place when all is written.
    pub fn write(
        &self,
        out: &mut dyn Write,
        answer: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Some(path) = self.path else {
            return answer(out);
        };
        let part = beside(path);
        let failed = |error: &std::io::Error| {
            Failure::new(format_args!(
                "cannot write {}: {}",
                path.display(),
                reason(error)
            ))
        };
        let written = fs::File::create(&part)
            .map_err(|error| failed(&error))
            .and_then(|mut file| {
                // Standard output is not what could not be written.
                let mut watched = Watched {
                    file: &mut file,
                    error: None,
                };
                let answered = answer(&mut watched);
                match watched.error {
                    Some(error) => Err(failed(&error)),
                    None => answered,
                }?;
                file.sync_all().map_err(|error| failed(&error))
            });
        let moved = written.and_then(|()| fs::rename(&part, path).map_err(|error| failed(&error)));
        if moved.is_err() {
            // What is left of it helps nobody.
            let _ = fs::remove_file(&part);
        }
        moved
    }
}

/// A name beside a file's that no other run takes.
fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

/// A file whose first error is kept, for a message that names it.
struct Watched<'a> {
    file: &'a mut fs::File,
    error: Option<std::io::Error>,
}

impl Watched<'_> {
    fn noted<T>(&mut self, result: std::io::Result<T>) -> std::io::Result<T> {
        result.map_err(|error| {
            let kind = error.kind();
            self.error.get_or_insert(error);
            kind.into()
        })
    }
}

impl Write for Watched<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let written = self.file.write(bytes);
        self.noted(written)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        let flushed = self.file.flush();
        self.noted(flushed)
    }
}

/// Whether two paths are the same file.
pub fn is_same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}
