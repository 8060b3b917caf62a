//! Writes the command line of a call, for the head of the emitted file. With this command line a user can emit the file
//! again.

use crate::args::{CompileArguments, FileArgument, TableFormat};
use std::path::Path;

/// Returns the command line of `frictiongen compile` with the options of this call. It contains file names without
/// folders, so that the emitted file has the same bytes on every machine.
pub(super) fn written(arguments: &CompileArguments) -> String {
    let mut words = vec!["frictiongen".to_owned(), "compile".to_owned()];
    words.push(description(&arguments.file));
    let mut option = |name: &str, value: Option<&str>| {
        if let Some(value) = value {
            words.extend([name.to_owned(), quoted(value)]);
        }
    };
    option("--accuracy", arguments.accuracy.as_deref());
    option("--budget", arguments.budget.as_deref());
    option("--r", arguments.r.as_deref());
    option("--hz", arguments.hz.as_deref());
    option("--omega", arguments.omega.as_deref());
    option("--name", arguments.name.as_deref());
    let format = arguments.format.map(|format| match format {
        TableFormat::Rust => "rust",
        TableFormat::C => "c",
        TableFormat::Json => "json",
    });
    option("--format", format);
    for (flag, given) in [("--safe", arguments.safe), ("--prove", arguments.prove)] {
        if given {
            words.push(flag.to_owned());
        }
    }
    if let Some(path) = &arguments.output {
        words.extend(["-o".to_owned(), name(path)]);
    }
    words.join(" ")
}

/// Returns the command-line argument for the scene description.
pub fn description(file: &FileArgument) -> String {
    file.path().map_or_else(|| "-".to_owned(), name)
}

fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    quoted(&name.to_string_lossy())
}

/// Returns a word of the command. If a shell would split or change the word, the result is in quotes.
fn quoted(word: &str) -> String {
    let plain = |letter: char| letter.is_alphanumeric() || "-_.:,+=".contains(letter);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}
