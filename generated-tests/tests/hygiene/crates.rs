//! Crates that are created for a test, with their own lints and edition.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Editions that a user's crate may have.
const EDITIONS: [&str; 3] = ["2018", "2021", "2024"];

/// Checks crates that compile and run in one workspace, so that their dependencies are built once.
///
/// * For each edition a crate without the standard library, with the facade renamed and every item documented.
/// * A crate with constants, statics, unit structs and types that have the names of emitted items, a scene with the
///   name of a type that emitted code uses, `#[deprecated]`, and masses with capitals.
#[test]
fn every_edition_and_names_that_clash() {
    let mut members: Vec<_> = EDITIONS
        .iter()
        .map(|edition| Member {
            name: format!("edition-{edition}"),
            edition,
            source: "edition.rs",
        })
        .collect();
    members.push(Member {
        name: "clashes".to_owned(),
        edition: "2024",
        source: "clashes.rs",
    });
    check("crates", &members);
}

/// A crate that consists of one of the sources in this folder.
struct Member<'a> {
    name: String,
    edition: &'a str,
    source: &'a str,
}

/// Writes a workspace of the members and runs its tests.
fn check(workspace: &str, members: &[Member<'_>]) {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hygiene");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(workspace);
    let write = |path: PathBuf, text: &str| {
        let parent = path.parent().expect("a folder");
        std::fs::create_dir_all(parent).expect("the folder can be made");
        // Cargo compares modification times, so an unchanged file is not written again.
        if std::fs::read_to_string(&path).ok().as_deref() != Some(text) {
            std::fs::write(path, text).expect("the file can be written");
        }
    };
    let names: Vec<_> = members
        .iter()
        .map(|member| format!("{:?}", member.name))
        .collect();
    let manifest = format!(
        "[workspace]\nresolver = \"2\"\nmembers = [{}]\n",
        names.join(", ")
    );
    write(folder.join("Cargo.toml"), &manifest);
    for Member {
        name,
        edition,
        source,
    } in members
    {
        let manifest = format!(
            "[package]\nname = {name:?}\nversion = \"0.0.0\"\nedition = {edition:?}\n\n[lib]\npath = {:?}\n\n[dependencies]\nfriction = {{ package = \"frictiongen\", path = {:?}, default-features = false }}\n",
            tests.join(source).display().to_string(),
            root.join("frictiongen").display().to_string(),
        );
        write(folder.join(name).join("Cargo.toml"), &manifest);
    }
    // The workspace gets the project's lock file, so that nothing has to be downloaded.
    let lock = std::fs::read_to_string(root.join("Cargo.lock")).expect("a lock file");
    if !folder.join("Cargo.lock").exists() {
        write(folder.join("Cargo.lock"), &lock);
    }
    let output = Command::new(env!("CARGO"))
        .args(["test", "--workspace", "--offline", "--quiet"])
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    assert!(
        output.status.success(),
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}
