//! Tests random command lines and files. Each input must give a result or a reason, never a panic. The long form is
//! `.ci/nightly fuzz`.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_cli::{Ended, run};
use fuzzing::Mutator;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;

const WORDS: &[&str] = &[
    "limits",
    "response",
    "orbit",
    "time",
    "expand",
    "FILE",
    "--",
    "--r",
    "--hz",
    "--omega",
    "--beta",
    "--friction",
    "--force",
    "--base",
    "--mass",
    "--harmonics",
    "--cycles",
    "--skip",
    "--samples",
    "--from",
    "--steady",
    "--of",
    "--events",
    "--spectrum",
    "--json",
    "--csv",
    "--help",
    "-h",
    "--version",
    "--r=",
    ":",
    ",",
    "0",
    "-0",
    "1",
    "1e-300",
    "1e308",
    "inf",
    "-inf",
    "NaN",
    "0.1:1e-320:1",
    "0:1e-7:1",
    "::",
    ":::",
    "1:1:1",
    "5:-1:0",
    "∞",
    "\"",
];

/// An input: the words of a command line, and the bytes of its file.
type Input = (String, Vec<u8>);

/// A writer that closes its pipe after some output, because a long grid would take hours.
struct Patience {
    left: usize,
    said: Vec<u8>,
}

impl Write for Patience {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.left < bytes.len() {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        self.left -= bytes.len();
        self.said.extend(bytes);
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Runs a command line, and returns an error if the command did not handle the input properly.
fn taken(input: &Input, file: &Path) -> Result<(), String> {
    let (line, bytes) = input;
    std::fs::write(file, bytes).map_err(|error| error.to_string())?;
    let words: Vec<&str> = line.split_whitespace().collect();
    // The test must not read standard input, or read or write a file that a mutated word names. It also skips dense
    // grids, which would compute for minutes before the buffered output reaches the writer.
    let dense = |word: &str| word.contains(':') || word.matches(',').count() > 8;
    if !words.contains(&"FILE")
        || words
            .iter()
            .any(|word| word.starts_with("-o") || word.starts_with("--o"))
    {
        return Ok(());
    }
    if words.iter().any(|word| dense(word)) && words.first() != Some(&"limits") {
        return Ok(());
    }
    // A run of many cycles would take long.
    let many = |word: &&str| word.bytes().filter(u8::is_ascii_digit).count() > 4;
    if words.first() == Some(&"time") && words.iter().any(many) {
        return Ok(());
    }
    let named = words.iter().map(|word| match *word {
        "FILE" => file.as_os_str().to_owned(),
        word => word.into(),
    });
    let arguments = std::iter::once(OsString::from("frictiongen")).chain(named);
    let mut out = Patience {
        left: 1 << 14,
        said: Vec::new(),
    };
    match run(arguments, &mut out) {
        Ok(()) if out.said.is_empty() => Err("said nothing".to_owned()),
        Ok(()) | Err(Ended::Closed) => {
            let numbers = words.first() != Some(&"expand");
            let said = String::from_utf8_lossy(&out.said);
            if numbers && said.contains("NaN") {
                return Err(format!("answered by NaN: {said}"));
            }
            Ok(())
        }
        Err(Ended::Usage(error)) if !error.to_string().is_empty() => Ok(()),
        Err(Ended::Lines(lines))
            if !lines.is_empty() && lines.iter().all(|line| !line.is_empty()) =>
        {
            Ok(())
        }
        Err(ended) => Err(format!("refused with {ended:?}")),
    }
}

fn fuzz(count: u64, seed: u64) {
    let lines = fuzzing::corpus("arguments").expect("the corpus");
    let scenes = fuzzing::corpus("scenes").expect("the corpus");
    let mut lines = Mutator::new(lines, WORDS, seed);
    let mut scenes = Mutator::new(scenes, WORDS, seed + 1);
    let folder =
        std::env::temp_dir().join(format!("frictiongen-fuzz-{}-{seed}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("scene.friction");
    let next = || {
        (
            String::from_utf8_lossy(&lines.input()).into_owned(),
            scenes.input(),
        )
    };
    let outcome = fuzzing::run(count, next, |input: &Input| taken(input, &file));
    std::fs::remove_dir_all(&folder).expect("the folder");
    assert!(
        outcome.findings.is_empty(),
        "{}",
        outcome.findings.join("\n")
    );
    println!(
        "command lines and files: {} inputs, nothing found",
        outcome.count
    );
    // A grid of ten million points takes 80 MB.
    if let Some(most) = fuzzing::most_memory() {
        assert!(most < 1 << 30, "{most} bytes were held");
    }
}

#[test]
fn command_lines_are_taken_or_refused() {
    fuzz(2_000, 11);
}

#[test]
#[ignore = "a million command lines: minutes"]
fn a_million_command_lines() {
    let count = std::env::var("COUNT").ok();
    let count = count.map_or(1_000_000, |count| count.parse().expect("COUNT is a number"));
    fuzz(count, 13);
}
