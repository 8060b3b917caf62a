//! Functions that run the command line.
#![allow(dead_code, reason = "each test uses its own part")]
#![allow(clippy::expect_used, reason = "a test may fail")]

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Path of the two-storey frame's description.
pub const FRAME: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/frame.friction");

/// Description of one undamped mass that rubs on a wall.
pub const BLOCK: &str = "struct Block {
    masses: { block: 1 },
    springs: { base - block: 1 },
    contact: block - wall,
    excitation: block,
}";

/// Output of a run.
#[derive(Debug)]
pub struct Run {
    /// Text on standard output.
    pub out: String,
    /// Text on standard error.
    pub err: String,
    /// Exit status.
    pub status: Option<i32>,
}

/// Splits a command line at its spaces.
pub fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// Writes a file into a folder of its own, because tests run in parallel, and returns its path.
pub fn file(name: &str, text: &str) -> String {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{number}"));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a file");
    path.to_str().expect("UTF-8").to_owned()
}

/// Runs the command line with a text on its standard input.
pub fn run_with(input: impl AsRef<[u8]>, arguments: &[&str]) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    let mut stdin = child.stdin.take().expect("its standard input");
    // A run that fails before it reads closes the pipe, so writing may fail.
    let _ = stdin.write_all(input.as_ref());
    drop(stdin);
    let Output {
        status,
        stdout,
        stderr,
    } = child.wait_with_output().expect("the binary ends");
    Run {
        out: String::from_utf8(stdout).expect("UTF-8"),
        err: String::from_utf8(stderr).expect("UTF-8"),
        status: status.code(),
    }
}

/// Returns the standard output of a run that must succeed.
pub fn output(input: &str, arguments: &[&str]) -> String {
    let run = run_with(input, arguments);
    assert_eq!(
        (run.status, run.err.as_str()),
        (Some(0), ""),
        "{arguments:?}"
    );
    // Emitted code may contain the word NaN.
    let numbers = arguments.first() != Some(&"expand");
    assert!(!(numbers && run.out.contains("NaN")), "{}", run.out);
    run.out
}

/// Returns the lines on standard error of a run that must fail, with nothing on standard output.
pub fn failure(input: impl AsRef<[u8]>, arguments: &[&str]) -> Vec<String> {
    let run = run_with(input, arguments);
    assert_eq!(
        (run.status, run.out.as_str()),
        (Some(2), ""),
        "{arguments:?}"
    );
    run.err.lines().map(str::to_owned).collect()
}

/// Splits a CSV into its cells, line by line.
pub fn cells(csv: &str) -> Vec<Vec<&str>> {
    csv.lines().map(|line| line.split(',').collect()).collect()
}

/// Returns the texts of a column of a CSV.
pub fn texts<'a>(csv: &'a str, name: &str) -> Vec<&'a str> {
    let cells = cells(csv);
    let (head, rows) = cells.split_first().expect("a head");
    let place = head.iter().position(|cell| *cell == name);
    assert!(place.is_some(), "no column {name}: {head:?}");
    let place = place.expect("seen");
    let cell = |row: &Vec<&'a str>| *row.get(place).expect("a cell");
    rows.iter().map(cell).collect()
}

/// Returns the numbers of a column of a CSV. Every cell must contain one.
pub fn column(csv: &str, name: &str) -> Vec<f64> {
    let numbers = texts(csv, name).into_iter();
    numbers
        .map(|text| text.parse().expect("a number"))
        .collect()
}

/// Returns the numbers of a column of a CSV. A cell without a number gives NaN.
pub fn column_with_gaps(csv: &str, name: &str) -> Vec<f64> {
    let numbers = texts(csv, name).into_iter();
    numbers
        .map(|text| text.parse().unwrap_or(f64::NAN))
        .collect()
}

/// Parses a JSON text.
pub fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).expect("JSON")
}
