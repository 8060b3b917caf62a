//! Writes a whole file or nothing. The program first writes a file under a temporary name, and then renames it.

use crate::failure::{Failure, reason};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a text to a file. The file must not be `description`, the file that describes the scene.
pub fn write_file(path: &Path, description: Option<&Path>, text: &str) -> Result<(), Failure> {
    write_with(path, description, |out| Ok(out.write_all(text.as_bytes())?))
}

/// Writes a file by the function `write`. The file must not be `description`, the file that describes the scene. After
/// a failure, an existing file is unchanged.
pub fn write_with(
    path: &Path,
    description: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
) -> Result<(), Failure> {
    check(path, description)?;
    let refused = |error: &io::Error| refusal(path, error);
    let place = OutputPath::of(path);
    let file = place.open().map_err(|error| refused(&error))?;
    let mut out = Noting { file, error: None };
    let written = match write(&mut out) {
        // If a write has stored an error of the operating system, this error is the reason of the failure.
        Err(failure) => Err(out.error.as_ref().map_or(failure, refused)),
        Ok(()) => place.keep().map_err(|error| refused(&error)),
    };
    if written.is_err() {
        place.discard();
    }
    written
}

/// Writes a web page to the file `path`, or to `out` without a path. The file must not be `description`, the file that
/// describes the scene.
pub fn write_page(
    (path, description): (Option<&Path>, Option<&Path>),
    html: &str,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    if let Some(path) = path {
        return write_file(path, description, html);
    }
    out.write_all(html.as_bytes())?;
    Ok(out.flush()?)
}

/// Fails if the program cannot write a file at this path, or if the file is the scene description.
pub fn check(path: &Path, description: Option<&Path>) -> Result<(), Failure> {
    if description.is_some_and(|description| is_same(description, path)) {
        return Err(Failure::new(format_args!(
            "cannot write {}: it is the description itself",
            path.display()
        )));
    }
    let is_folder = fs::metadata(folder(path)).map(|folder| folder.is_dir());
    let kind = match (is_folder, path.is_dir()) {
        (Err(error), _) => error.kind(),
        (Ok(false), _) => io::ErrorKind::NotFound,
        (Ok(true), true) => io::ErrorKind::IsADirectory,
        (Ok(true), false) => return Ok(()),
    };
    Err(refusal(path, &kind.into()))
}

/// Fails unless the file's name has the extension of a web page. A browser would show any other file as text.
pub fn check_page(path: &Path, what: &str) -> Result<(), Failure> {
    let shown = path.display();
    let ending = path
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    let instead = match ending.as_deref() {
        Some("html" | "htm") => return Ok(()),
        Some("svg" | "png") => "; for a picture, use `frictiongen curve` or `frictiongen map`",
        Some("csv" | "json") => "; for numbers, use `frictiongen curve` or `frictiongen features`",
        Some("pdf") => "; a browser prints the page as PDF",
        _ => "",
    };
    Err(Failure::new(format_args!(
        "--output `{shown}`: {what} is a web page, so that the name of the file must end in .html{instead}"
    )))
}

fn refusal(path: &Path, error: &io::Error) -> Failure {
    Failure::new(format_args!(
        "cannot write {}: {}",
        path.display(),
        reason(error)
    ))
}

/// Returns the folder that contains a file.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

fn is_same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}

/// The final path of a file, and a temporary path for its contents. The temporary path is missing if the final path is
/// not a regular file but, for example, a device.
struct OutputPath {
    last: PathBuf,
    first: Option<PathBuf>,
}

impl OutputPath {
    fn of(path: &Path) -> Self {
        // If the path is a symbolic link, the command replaces the target of the link, and keeps the link.
        let last = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let is_file = fs::metadata(&last).map_or(true, |found| found.is_file());
        let beside = last.file_name().map(|name| {
            let name = name.to_string_lossy();
            folder(&last).join(format!(".{name}.{}.part", std::process::id()))
        });
        Self {
            first: beside.filter(|_| is_file),
            last,
        }
    }

    fn open(&self) -> io::Result<File> {
        let Some(first) = &self.first else {
            return OpenOptions::new().write(true).open(&self.last);
        };
        if let Ok(found) = fs::metadata(&self.last) {
            // The command rejects a file without write permission before it writes the temporary file.
            OpenOptions::new().write(true).open(&self.last)?;
            let file = File::create(first)?;
            fs::set_permissions(first, found.permissions())?;
            return Ok(file);
        }
        File::create(first)
    }

    fn keep(&self) -> io::Result<()> {
        match &self.first {
            Some(first) => fs::rename(first, &self.last),
            None => Ok(()),
        }
    }

    fn discard(&self) {
        if let Some(first) = &self.first {
            // The code ignores an error, because the temporary file may not exist.
            let _ = fs::remove_file(first);
        }
    }
}

/// A file that stores the error of a failed write.
struct Noting {
    file: File,
    error: Option<io::Error>,
}

impl Noting {
    fn noted<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        result.inspect_err(|error| {
            // The kind of the error contains the reason, so the code stores only the kind.
            self.error = Some(error.kind().into());
        })
    }
}

impl Write for Noting {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes);
        self.noted(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let flushed = self.file.flush();
        self.noted(flushed)
    }
}
