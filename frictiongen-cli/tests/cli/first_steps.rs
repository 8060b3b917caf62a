//! Tests `frictiongen new`, `check`, `completions` and `man`, the first commands that a user types.
#![allow(clippy::unwrap_used, reason = "a test fails by it")]

use crate::common::{failure, output};
use std::{fs, process};

/// Returns the path of a file for this test.
fn temporary(name: &str) -> std::path::PathBuf {
    std::env::temp_dir().join(format!("frictiongen-steps-{}-{name}", process::id()))
}

#[test]
fn what_new_writes_has_no_errors() {
    let scene = output("", &["new"]);
    let checked = output(&scene, &["check"]);
    assert_eq!(
        checked,
        "<stdin>: no errors; 2 masses, 2 springs\n\
         damping acts on velocities relative to the base (damping_from: base)\n"
    );
    let at_rest = scene.replace("damping_from: base", "damping_from: rest");
    let checked = output(&at_rest, &["check"]);
    assert!(checked.ends_with("damping acts on absolute velocities (damping_from: rest)\n"));
    let undamped = at_rest.replace("modal[0.010, 0.012]", "none");
    assert!(!output(&undamped, &["check"]).contains("damping acts"));
    assert!(output(&scene, &["limits", "--r", "0.9"]).contains("0.9"));
}

#[test]
fn new_does_not_write_over_a_file() {
    let path = temporary("new.friction");
    let shown = path.to_str().unwrap();
    assert_eq!(output("", &["new", shown]), "");
    let written = fs::read_to_string(&path).unwrap();
    let lines = failure("", &["new", shown]);
    fs::remove_file(&path).unwrap();
    assert_eq!(written, output("", &["new"]));
    assert_eq!(
        lines,
        [format!(
            "frictiongen: cannot write {shown}: it already exists"
        )]
    );
}

#[test]
fn check_marks_each_error() {
    let scene = "pub struct A {\n  masses: { a: -1.5, ü: 2 },\n  springs: { base - nowhere: 3.0 },\n  contact: a - wall,\n  excitation: a,\n}\n";
    let lines = failure(scene, &["check"]);
    let text = lines.join("\n");
    for marked in [
        "2 |   masses: { a: -1.5, ü: 2 },\n  |                ^^^^",
        "3 |   springs: { base - nowhere: 3.0 },\n  |                     ^^^^^^^",
    ] {
        assert!(text.contains(marked), "{text}");
    }
    // The first text has an error at its end, and the second text is empty.
    assert!(!failure("pub struct A {", &["check"]).is_empty());
    assert!(!failure("", &["check"]).is_empty());
}

#[test]
fn every_shell_has_its_completions() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = output("", &["completions", shell]);
        assert!(script.contains("sensitivity"), "{shell}");
    }
}

#[test]
fn the_manual_has_a_page_for_each_command() {
    assert!(output("", &["man"]).contains("frictiongen\\-curve(1)"));
    assert!(output("", &["man", "curve"]).contains(".TH frictiongen-curve"));
    let lines = failure("", &["man", "nothing"]);
    assert_eq!(
        lines,
        ["frictiongen: there is no command nothing: see frictiongen --help"]
    );
}
