//! Writes the cases as Rust: a file for each part of a group, and a module for each case.

use super::case::Case;
use super::{groups, write_or_compare};
use std::fmt::Write;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("refused/tests/messages")
}

/// A Rust file: its path, its text, and its cases with their lines.
type RustFile<'a> = (PathBuf, String, Vec<(usize, &'a Case)>);

/// Returns the files that the compiler reads, each with the line number of each case's macro call.
fn files(cases: &[Case]) -> Vec<RustFile<'_>> {
    let mut files = Vec::new();
    let parts = groups(cases).flat_map(|(group, cases)| group.of_files(&cases));
    for (file, cases) in parts {
        let mut text = String::from(
            "// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.\n#![allow(uncommon_codepoints)]\n",
        );
        let mut calls = Vec::new();
        for case in cases {
            if case.door.takes_tokens() {
                let module = case.name.replace('-', "_");
                let _ = write!(text, "\nmod case_{module} {{\n");
                calls.push((text.lines().count() + 1, case));
                let _ = write!(
                    text,
                    "frictiongen::friction_system! {{\n{}}}\n}}\n",
                    case.faulty
                );
            }
        }
        if !calls.is_empty() {
            text.push_str("\nfn main() {}\n");
            files.push((folder().join(format!("{file}.rs")), text, calls));
        }
    }
    files
}

/// Writes the files if that is requested, and otherwise fails if they are out of date.
pub fn write_or_check(cases: &[Case]) {
    for (path, text, _) in files(cases) {
        write_or_compare(&path, &text);
    }
}

/// Compares the recorded output of the compiler with the cases.
pub fn check_places(cases: &[Case]) {
    for (path, _, calls) in files(cases) {
        let mut expected: Vec<_> = calls
            .iter()
            .flat_map(|(call, case)| expected(*call, case))
            .collect();
        let output = path.with_extension("stderr");
        let output = std::fs::read_to_string(&output)
            .unwrap_or_else(|error| panic!("{}: {error}", output.display()));
        let mut found = found(&output);
        expected.sort();
        found.sort();
        assert_eq!(found, expected, "{}", path.display());
    }
}

/// Returns line, column and text of each message that the compiler should print for a case.
fn expected(call: usize, case: &Case) -> Vec<(usize, usize, String)> {
    let told = case.told_by_rustc.as_ref().unwrap_or(&case.told);
    told.iter()
        .map(|told| {
            let mut parts = told.splitn(3, ':');
            let mut number = || -> usize {
                let part = parts.next().expect("line and column");
                part.parse().expect("a number")
            };
            let (line, column) = (number(), number());
            (call + line, column, case.message(told).to_owned())
        })
        .collect()
}

/// Returns line, column and message of each error in the output of the compiler.
fn found(output: &str) -> Vec<(usize, usize, String)> {
    let mut found = Vec::new();
    let mut message = None;
    for line in output.lines() {
        if let Some(text) = line.strip_prefix("error: ") {
            message = Some(text.to_owned());
        } else if let Some(place) = line.trim_start().strip_prefix("--> ")
            && let Some(message) = message.take()
        {
            let mut parts = place.rsplitn(3, ':');
            let mut number = || -> usize {
                let part = parts.next().expect("line and column");
                part.parse().expect("a number")
            };
            let (column, line) = (number(), number());
            found.push((line, column, message));
        } else {
            assert!(
                !line.starts_with("error") && !line.starts_with("warning"),
                "{line}"
            );
        }
    }
    found
}
