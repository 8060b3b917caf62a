//! Why a command ends early, and what its user is told.

use std::io;

/// Why a command ends early.
#[derive(Debug)]
pub enum Failure {
    /// Lines that say what is wrong, as they are to be printed.
    Lines(Vec<String>),
    /// Whoever reads the output has enough.
    Closed,
}

impl Failure {
    /// One line that says what is wrong.
    pub fn new(message: impl std::fmt::Display) -> Self {
        Self::Lines(vec![format!("frictiongen: {message}")])
    }

    /// Of writing to standard output.
    pub fn output(error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::Closed
        } else {
            Self::new(format_args!("cannot write the output: {}", reason(error)))
        }
    }
}

/// Why a file cannot be read or written, the commonest reasons in the same words everywhere.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission is denied".to_owned(),
        io::ErrorKind::StorageFull => "no space is left".to_owned(),
        _ => error.to_string(),
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::output(&error)
    }
}
