//! Tests docs/start.md: its commands print the text of the page, and its statements are right.
//!
//! `UPDATE_DOCS=1 cargo test -p frictiongen-cli --test pages start_page::` rewrites the output on docs/start.md.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use frictiongen::System;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Returns the text of a page in docs.
pub(crate) fn page(name: &str) -> String {
    std::fs::read_to_string(format!("{ROOT}/docs/{name}")).unwrap()
}

/// Creates a folder for this test.
pub(crate) fn folder(name: &str) -> PathBuf {
    let id = std::process::id();
    let folder = std::env::temp_dir().join(format!("frictiongen-docs-{id}-{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Splits a command line into words. Double quotes enclose a word that contains spaces.
fn words(line: &str) -> Vec<String> {
    let quoted = line.split('"').enumerate();
    let parts = quoted.flat_map(|(index, part)| match index % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    parts.collect()
}

/// Returns the output of a command line that the page shows.
pub(crate) fn printed(line: &str, folder: &Path) -> String {
    let run = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
        .args(words(line).iter().skip(1))
        .current_dir(folder)
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{line}: {told}");
    let text = String::from_utf8(run.stdout).unwrap();
    let lines = text.lines().map(|line| format!("{}\n", line.trim_end()));
    lines.collect()
}

/// Returns the first number in a line of printed text that follows `name`.
pub(crate) fn value(printed: &str, name: &str) -> f64 {
    let mut lines = printed.lines().filter_map(|line| line.strip_prefix(name));
    let line = lines.next().unwrap_or_else(|| panic!("{name}: {printed}"));
    line.split_whitespace().next().unwrap().parse().unwrap()
}

/// Checks that a reader of the front page and of docs/start.md can install the command from its folder.
#[test]
fn the_folder_of_the_command_exists() {
    for page in ["README.md", "docs/start.md"] {
        let text = std::fs::read_to_string(format!("{ROOT}/{page}")).unwrap();
        let folders: Vec<&str> = text
            .split("cargo install --path ")
            .skip(1)
            .filter_map(|rest| rest.split(['`', ' ', '\n']).next())
            .collect();
        assert!(!folders.is_empty(), "{page}");
        for folder in folders {
            let manifest = format!("{ROOT}/{folder}/Cargo.toml");
            let manifest = std::fs::read_to_string(&manifest).unwrap_or_default();
            assert!(
                manifest.contains("name = \"frictiongen-cli\""),
                "{page}: {folder}"
            );
        }
    }
}

#[test]
fn start_has_what_its_commands_print() {
    let page = page("start.md");
    let folder = folder("start");
    let mut made = String::new();
    let (mut last, mut skipping) = (String::new(), false);
    let (mut commands, mut shown, mut best) = (0, 0, Vec::new());
    for line in page.lines() {
        if skipping {
            if line != "```" {
                continue;
            }
            skipping = false;
        }
        made.push_str(line);
        made.push('\n');
        if line.starts_with("frictiongen ") {
            last = printed(line, &folder);
            commands += 1;
            if line.starts_with("frictiongen optimum ") {
                best.push(last.clone());
            }
        }
        if line == "```text" {
            made.push_str(&last);
            (skipping, shown) = (true, shown + 1);
        }
    }
    for written in ["frame.friction", "curve.svg", "report.html"] {
        assert!(folder.join(written).exists(), "{written}");
    }
    let scene = std::fs::read_to_string(folder.join("frame.friction")).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!((commands, shown), (6, 2));
    what_start_says_is_true(&page, &best);
    the_three_ways_agree(&page, &scene, &best[0]);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(format!("{ROOT}/docs/start.md"), &made).unwrap();
    }
    assert!(
        made == self::page("start.md"),
        "the page differs: UPDATE_DOCS=1"
    );
}

/// Checks that the descriptions for Python, Rust and the macro are the scene of the command, and that Python and Rust
/// print its digits. `test_docs.py` and the documentation tests of `generated-tests` run the code itself.
fn the_three_ways_agree(text: &str, scene: &str, printed: &str) {
    let scene: System = scene.parse().unwrap();
    let shown = text.split("struct Frame {").skip(1);
    let descriptions: Vec<String> = shown
        .map(|rest| {
            let lines = rest
                .lines()
                .map(|line| line.trim_start_matches("...").trim());
            let fields: Vec<&str> = lines.take_while(|line| !line.starts_with('}')).collect();
            format!("struct Frame {{ {} }}", fields.join("\n"))
        })
        .collect();
    assert_eq!(descriptions.len(), 3);
    for description in descriptions {
        let own: System = description.parse().unwrap();
        assert_eq!(own.scene(), scene.scene(), "{description}");
    }
    let (force, height) = ("friction ", "largest amplitude of lower");
    let said = format!(
        "{:.2} N, at most {:.2} mm",
        value(printed, force),
        1e3 * value(printed, height)
    );
    assert_eq!(text.matches(&said).count(), 2, "{said}");
}

/// Checks the numbers in the text of docs/start.md against the output of its commands for the best friction: with a
/// load, and with twice that load.
fn what_start_says_is_true(text: &str, printed: &[String]) {
    let [one, two] = printed else {
        panic!("{}", printed.len());
    };
    let force = value(one, "friction ");
    let millimetres = |name: &str| 1e3 * value(one, name);
    for said in [
        format!("**{force:.2} N** is the friction to choose"),
        format!(
            "moves by {:.1} mm at most",
            millimetres("largest amplitude of lower")
        ),
        format!(
            "The peak would be {:.1} mm",
            millimetres("largest amplitude without friction")
        ),
        format!(
            "slides, the peak would be {:.1} mm",
            millimetres("largest amplitude with the contact stuck")
        ),
        format!(
            "anything from {:.2} N to {:.2} N costs 5 %",
            value(one, "5 % above the best: friction from"),
            value(one, "5 % above the best: friction to")
        ),
        format!("1.54 N/0.3 = {:.1} N", force / 0.3),
    ] {
        assert!(text.contains(&said), "{said}");
    }
    for name in ["friction ", "largest amplitude of lower"] {
        let ratio = value(two, name) / value(one, name);
        // The values are printed to six decimals.
        assert!((ratio - 2.0).abs() < 1e-5, "{name}: {ratio}");
    }
}
