//! Tests `frictiongen expand`.

use crate::common::{BLOCK, FRAME, failure, output};
use std::path::PathBuf;
use std::{fs, process};

/// Returns the path of a file for this test.
fn temporary(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("frictiongen-cli-{}-{name}", process::id()))
}

#[test]
fn prints_the_library_s_own_text() {
    let text = output("", &["expand", FRAME]);
    let source = fs::read_to_string(FRAME).unwrap();
    let limits = frictiongen_codegen::SizeLimits::MACRO;
    let description = frictiongen_codegen::parse_text(&source, &limits).unwrap();
    let code = frictiongen_codegen::pretty(&description).unwrap();
    let (head, rest) = text.split_once("\n\n").unwrap();
    assert_eq!(rest, code);
    let head: Vec<&str> = head.lines().collect();
    let [notice, command, scene] = head.as_slice() else {
        panic!("{head:?}");
    };
    assert!(notice.ends_with(": generated: change the description, not this file."));
    assert_eq!(*command, "// Command: frictiongen expand frame.friction");
    let hash = frictiongen_codegen::standalone::scene_hash(&description.scene);
    assert_eq!(
        *scene,
        format!("// Scene Frame with the hash {hash}, which emitted Rust calls `SCENE_HASH`.")
    );
    // The documentation of the type has the description as it was written.
    let written = source
        .trim()
        .lines()
        .filter(|line| !line.starts_with("///"));
    let written: Vec<String> = written
        .map(|line| format!("/// {line}").trim_end().to_owned())
        .collect();
    assert!(code.contains(&written.join("\n")), "{code}");
}

#[test]
fn reads_standard_input_and_writes_a_file() {
    let path = temporary("block.rs");
    let shown = path.to_str().unwrap();
    assert_eq!(output(BLOCK, &["expand", "-o", shown]), "");
    let written = fs::read_to_string(&path).unwrap();
    fs::remove_file(&path).unwrap();
    assert_eq!(written, output(BLOCK, &["expand", "-"]));
}

#[test]
fn does_not_overwrite_the_description() {
    let path = temporary("same.friction");
    let shown = path.to_str().unwrap();
    fs::write(&path, BLOCK).unwrap();
    let lines = failure("", &["expand", shown, "--output", shown]);
    let kept = fs::read_to_string(&path).unwrap();
    fs::remove_file(&path).unwrap();
    let message = format!("frictiongen: cannot write {shown}: it is the description itself");
    assert_eq!(lines, [message]);
    assert_eq!(kept, BLOCK);
}

#[test]
fn refuses_what_a_macro_would() {
    let masses: Vec<String> = (0..65).map(|index| format!("m{index}: 1")).collect();
    let springs: Vec<String> = (0..65).map(|index| format!("base - m{index}: 1")).collect();
    let scene = format!(
        "struct Comb {{ masses: {{ {} }}, springs: {{ {} }}, contact: m0 - wall, excitation: m0 }}",
        masses.join(", "),
        springs.join(", ")
    );
    let lines = failure(&scene, &["expand"]);
    assert!(lines[0].starts_with("<stdin>:1:"), "{lines:?}");
    assert!(lines[0].contains("65 masses, but at most 64"), "{lines:?}");
    output(&scene, &["limits", "--r", "0.5"]);
}

#[test]
fn a_folder_that_is_not_there() {
    let path = temporary("no-folder").join("block.rs");
    let shown = path.to_str().unwrap();
    let message = format!("frictiongen: cannot write {shown}: there is no such file or folder");
    assert_eq!(failure(BLOCK, &["expand", "-o", shown]), [message]);
}
