//! Reasons why a command ends early, with the messages for the user.

use frictiongen::study::joined::JoinedError;
use std::io;

/// The reason why a command ends early.
#[derive(Debug)]
pub enum Failure {
    /// Lines of an error message, ready for printing.
    Lines(Vec<String>),
    /// The program that reads the output of the command has closed the output.
    Closed,
}

impl Failure {
    /// Creates a failure whose message has one line.
    pub fn new(message: impl std::fmt::Display) -> Self {
        Self::Lines(vec![format!("frictiongen: {message}")])
    }

    /// Returns the failure for an error that occurred while the program wrote to standard output.
    pub fn output(error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::Closed
        } else {
            Self::new(format_args!("cannot write the output: {}", reason(error)))
        }
    }
}

/// Returns the reason why the program cannot read or write a file, in words. For the most common reasons, the words are
/// the same on every operating system.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission is denied".to_owned(),
        io::ErrorKind::StorageFull => "no space is left".to_owned(),
        _ => error.to_string(),
    }
}

impl From<JoinedError> for Failure {
    fn from(error: JoinedError) -> Self {
        Self::new(error)
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::output(&error)
    }
}
