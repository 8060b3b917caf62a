//! Gives faulty descriptions to the compiler, in a crate of its own that depends on `frictiongen` alone.

use super::case::Case;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// Returns what the compiler prints about `source`, which it refuses.
pub fn output(crate_name: &str, source: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("refused");
    let own = folder.join(crate_name);
    let manifest = format!(
        "[package]\nname = {crate_name:?}\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n\
         frictiongen = {{ path = {:?}, default-features = false }}\n\n[workspace]\n",
        root.join("frictiongen").display().to_string(),
    );
    std::fs::create_dir_all(own.join("src")).expect("a folder");
    std::fs::write(own.join("Cargo.toml"), manifest).expect("a manifest");
    std::fs::write(own.join("src/main.rs"), source).expect("a source file");
    // The project's lock file, so that nothing has to be downloaded.
    std::fs::copy(root.join("Cargo.lock"), own.join("Cargo.lock")).expect("a lock file");
    let output = Command::new(env!("CARGO"))
        .args(["check", "--offline", "--quiet", "--color", "never"])
        .current_dir(&own)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    assert!(
        !output.status.success(),
        "the compiler accepts {crate_name}"
    );
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Checks that the compiler reports the messages of each case at the right tokens, and nothing else.
pub fn check_places(cases: &[Case]) {
    let mut source = String::from("#![allow(uncommon_codepoints)]\n");
    let mut expected = Vec::new();
    for case in cases.iter().filter(|case| case.door.takes_tokens()) {
        let module = case.name.replace('-', "_");
        let _ = write!(source, "\nmod case_{module} {{\n");
        expected.extend(messages(source.lines().count() + 1, case));
        let call = &case.faulty;
        let _ = write!(source, "frictiongen::friction_system! {{\n{call}}}\n}}\n");
    }
    source.push_str("\nfn main() {}\n");
    let mut found = found(&output("faulty-descriptions", &source));
    expected.sort();
    found.sort();
    assert_eq!(found, expected);
}

/// Returns line, column and text of each message that the compiler should print for a case.
fn messages(call: usize, case: &Case) -> Vec<(usize, usize, String)> {
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

/// Checks that a call of a method that the scene does not provide gives one error, which names the item to add to
/// `provide`.
pub fn check_missing_methods() {
    let told = output("missing-methods", include_str!("missing_methods.rs"));
    for (item, count) in [
        ("motion", 1),
        ("orbit", 2),
        ("simulation", 2),
        ("stepper", 2),
        ("limits", 1),
        ("self_check", 1),
    ] {
        let label = format!("add `{item}` to the scene's `provide: [...]`");
        assert_eq!(told.matches(&label).count(), count, "{item}");
    }
    for name in ["AddStuckToProvide", "AddMassToMotion"] {
        assert!(told.contains(name), "{name}");
    }
    let errors = told.lines().filter(|line| line.starts_with("error["));
    assert_eq!(errors.count(), 11, "{told}");
}
