//! Tests `frictiongen new`, `check`, `completions`, `man` and `setup`, the first commands that a user types.
#![allow(clippy::unwrap_used, reason = "a test fails by it")]

use crate::common::{failure, json, output, run_with};
use std::{fs, process};

/// Returns the path of a file for this test.
fn temporary(name: &str) -> std::path::PathBuf {
    std::env::temp_dir().join(format!("frictiongen-steps-{}-{name}", process::id()))
}

#[test]
fn what_new_writes_has_no_errors() {
    let scene = output("", &["new"]);
    let checked = output(&scene, &["check"]);
    assert!(
        checked.starts_with(
            "<stdin>: no errors; 2 masses, 2 springs\n\
             damping acts on velocities relative to the base (damping_from: base)\n\
             natural frequencies (Hz)"
        ),
        "{checked}"
    );
    let at_rest = scene.replace("damping_from: base", "damping_from: rest");
    let checked = output(&at_rest, &["check"]);
    assert!(
        checked
            .contains("\ndamping acts on absolute velocities (damping_from: rest, the default)\n")
    );
    let undamped = at_rest.replace("modal[0.010, 0.012]", "none");
    assert!(!output(&undamped, &["check"]).contains("damping acts"));
    assert!(output(&scene, &["limits", "--r", "0.9"]).contains("0.9"));
}

/// `check --json` has the same numbers with all their digits. Errors have their line and column.
#[test]
fn check_in_json() {
    let scene = "struct Two { masses: { low: 2000, high: 2000 },
        springs: { base - low: 1.5e6, low - high: 1.5e6 },
        contact: high - wall, excitation: high, damping: modal[0.01, 0.02] }";
    let found = json(&output(scene, &["check", "--json"]));
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let golden: f64 = 0.5 * (3.0 - 5.0_f64.sqrt());
    let first = (1.5e6_f64 / 2000.0).sqrt() / std::f64::consts::TAU * golden.sqrt();
    assert!((number(&found["natural_frequencies_Hz"][0]) / first - 1.0).abs() < 1e-14);
    assert_eq!(number(&found["damping_ratios"][1]), 0.02);
    assert_eq!(number(&found["total_mass_kg"]), 4000.0);
    let placed = number(&found["static_displacements_m"]["high"]);
    assert!((placed * 1.5e6 / 2.0 - 1.0).abs() < 1e-14, "{placed}");
    assert_eq!(found["errors"], serde_json::json!([]));
    let wrong = scene.replace("modal[0.01, 0.02]", "modal[0.01]");
    let run = run_with(&wrong, &["check", "--json"]);
    assert_eq!(run.status, Some(2));
    let found = json(&run.out);
    assert_eq!(found["errors"][0]["line"], 3);
    assert!(
        found["errors"][0]["message"]
            .as_str()
            .unwrap()
            .contains("damping")
    );
}

/// Two equal masses and springs have the natural frequencies √((3 ∓ √5)/2) √(k/m). A force on the outer mass displaces
/// the inner one by P/k and the outer one by 2P/k. With the stiffness typed in kN/m, the frequencies are √1000 lower.
#[test]
fn check_prints_frequencies_damping_mass_and_static_displacement() {
    let golden: f64 = 0.5 * (3.0 - 5.0_f64.sqrt());
    for stiffness in [1.5e6_f64, 1.5e3] {
        let scene = format!(
            "struct Two {{ masses: {{ low: 2000, high: 2000 }},
              springs: {{ base - low: {stiffness:?}, low - high: {stiffness:?} }},
              contact: high - wall, excitation: high, damping: modal[0.01, 0.02] }}"
        );
        let checked = output(&scene, &["check"]);
        let numbers = |title: &str| -> Vec<f64> {
            let line = checked.lines().find(|line| line.starts_with(title));
            let words = line.unwrap().split([' ', ',', ';']);
            words.filter_map(|word| word.parse().ok()).collect()
        };
        let unit = (stiffness / 2000.0).sqrt() / std::f64::consts::TAU;
        for (title, expected) in [
            (
                "natural frequencies (Hz)",
                vec![unit * golden.sqrt(), unit / golden.sqrt()],
            ),
            ("modal damping ratios", vec![0.01, 0.02]),
            ("total mass (kg)", vec![4000.0]),
            (
                "static displacement (mm)",
                vec![1e3 / stiffness, 2e3 / stiffness, 1.0],
            ),
        ] {
            let found = numbers(title);
            assert_eq!(found.len(), expected.len(), "{checked}");
            for (found, expected) in found.iter().zip(expected) {
                // A printed number has six decimals or six digits.
                let error = (found - expected).abs();
                assert!(error < 5.1e-7_f64.max(5e-6 * expected), "{checked}");
            }
        }
    }
    // The base takes all masses with it, if no spring leads to the wall.
    let checked = output(&output("", &["new"]), &["check"]);
    let line = checked.lines().last().unwrap();
    assert!(
        line.contains(" 1.000000, ")
            && line.ends_with("; under 1 mm of the base, without friction"),
        "{line}"
    );
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

#[test]
fn setup_places_completions_and_pages() {
    let share = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("setup");
    let _ = std::fs::remove_dir_all(&share);
    let told = output("", &["setup", "--share", share.to_str().unwrap()]);
    // bash-completion loads the file with the program's name, zsh one with an underscore before it.
    for (file, words) in [
        (
            "bash-completion/completions/frictiongen.bash",
            "complete -F",
        ),
        ("zsh/site-functions/_frictiongen", "#compdef frictiongen"),
        (
            "fish/vendor_completions.d/frictiongen.fish",
            "complete -c frictiongen",
        ),
        ("man/man1/frictiongen.1", ".TH frictiongen 1"),
        ("man/man1/frictiongen-curve.1", ".TH frictiongen-curve 1"),
    ] {
        let text = std::fs::read_to_string(share.join(file)).unwrap();
        assert!(text.contains(words), "{file}");
        assert!(file.starts_with("man") || told.contains(file), "{told}");
    }
    // A second run replaces the files.
    assert_eq!(
        output("", &["setup", "--share", share.to_str().unwrap()]),
        told
    );
    let file = share.join("man/man1/frictiongen.1");
    let lines = failure("", &["setup", "--share", file.to_str().unwrap()]);
    assert_eq!(lines.len(), 1);
    assert!(
        lines[0].contains("give another folder by --share"),
        "{lines:?}"
    );
}
