//! Tests three pages. The commands of docs/start.md print the text of the page, and its statements are right.
//! docs/which.md names existing items. The commands of docs/desk.md that draw no picture run.
//!
//! `UPDATE_DOCS=1 cargo test -p frictiongen-cli --test pages start_page::` rewrites the output on docs/start.md.
#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{FRAME, output};
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn page(name: &str) -> String {
    std::fs::read_to_string(format!("{ROOT}/docs/{name}")).unwrap()
}

/// Creates a folder for this test.
fn folder(name: &str) -> PathBuf {
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
fn printed(line: &str, folder: &Path) -> String {
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
fn value(printed: &str, name: &str) -> f64 {
    let mut lines = printed.lines().filter_map(|line| line.strip_prefix(name));
    let line = lines.next().unwrap_or_else(|| panic!("{name}: {printed}"));
    line.split_whitespace().next().unwrap().parse().unwrap()
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
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!((commands, shown), (6, 2));
    what_start_says_is_true(&page, &best);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(format!("{ROOT}/docs/start.md"), &made).unwrap();
    }
    assert!(
        made == self::page("start.md"),
        "the page differs: UPDATE_DOCS=1"
    );
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

/// Checks that the commands of docs/desk.md that draw no picture run. `scripts/desk` runs the other commands.
#[test]
fn commands_of_desk_run() {
    let page = page("desk.md");
    let folder = folder("desk");
    std::fs::copy(FRAME, folder.join("frame.friction")).unwrap();
    let lines = page.lines().filter(|line| line.starts_with("frictiongen "));
    let mut run = 0;
    // Commands with `--vary` and those of five storeys take minutes without optimisation. The test `the_tuned_frame_of_desk` runs the
    // first. The files of `periodic` are the reader's own, and the tests of that command have files of their own.
    let left_out = [".svg", "--vary", "five.friction", "frictiongen periodic"];
    for line in lines.filter(|line| !left_out.iter().any(|word| line.contains(word))) {
        let text = printed(line, &folder);
        assert!(!text.is_empty() || line.contains(" -o "), "{line}");
        run += 1;
    }
    assert!(folder.join("curve.csv").exists() && folder.join("curve.json").exists());
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(run, 8);
}

/// Checks that the best frictions of five storeys on docs/desk.md are right.
#[test]
#[ignore = "three optima without optimisation: ten seconds"]
fn the_five_storeys_of_desk() {
    let folder = folder("storeys");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/five.friction");
    std::fs::copy(scene, folder.join("five.friction")).unwrap();
    let page = page("desk.md");
    let mut compared = 0;
    for (quantity, factor) in [("f2-f1", 1e3), ("accel(f5)", 1.0), ("shear", 1e-3)] {
        let row = page
            .lines()
            .find(|line| line.contains(&format!(", `{quantity}` |")));
        let cells: Vec<&str> = row.unwrap().split('|').map(str::trim).collect();
        let [_, _, friction, amplitude, _] = cells[..] else {
            panic!("{cells:?}");
        };
        let command =
            format!("frictiongen optimum five.friction --hz 0.5:4 --base 0.2g --of {quantity}");
        let found = printed(&command, &folder);
        // The page has whole newtons, and two decimals of the amplitude.
        let name = format!("largest amplitude of {quantity} ");
        let rounded = [
            format!("{:.0}", value(&found, "friction ")),
            format!("{:.2}", factor * value(&found, &name)),
        ];
        let said = [friction, amplitude].map(|cell| cell.split(' ').next().unwrap());
        assert_eq!(rounded, said, "{found}");
        compared += 2;
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(compared, 6);
}

/// Checks that the numbers of the tuned frame on docs/desk.md are right.
#[test]
#[ignore = "minutes without optimisation"]
fn the_tuned_frame_of_desk() {
    let page = page("desk.md");
    let mut lines = page.lines();
    let line = lines.find(|line| line.contains("--vary")).unwrap();
    let (command, vary) = line.split_once(" --vary ").unwrap();
    let words = command.split(' ').skip(3);
    let arguments: Vec<&str> = ["optimum", FRAME]
        .into_iter()
        .chain(words)
        .chain(["--csv", "--vary", vary.trim_matches('"')])
        .collect();
    let text = crate::common::output("", &arguments);
    let rows = crate::common::cells(&text);
    let number = |name: &str| -> f64 {
        let row = rows.iter().find(|row| row[0] == name).unwrap();
        row[1].parse().unwrap()
    };
    assert_eq!(number("k lower - upper"), 2600.0);
    let [force, length] = ["friction", "largest amplitude of lower"].map(number);
    let told = format!("with {force:.2} N and {:.2} mm", 1e3 * length);
    assert!(page.contains(&told), "{told}");
}

/// Returns the names in the code marks of a cell. Each is cut at the first character that cannot be part of a name.
fn names(cell: &str) -> Vec<&str> {
    let quoted = cell.split('`').skip(1).step_by(2);
    quoted
        .map(|name| {
            let end = name.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            &name[..end.unwrap_or(name.len())]
        })
        .collect()
}

#[test]
fn which_names_what_there_is() {
    let page = page("which.md");
    let commands = output("", &["--help"]);
    let python = sources(Path::new(&format!("{ROOT}/python/package/frictiongen")));
    let rust = sources(Path::new(&format!("{ROOT}/frictiongen/src")))
        + &sources(Path::new(&format!("{ROOT}/frictiongen-kernel/src")));
    let (mut heads, mut counts) = (Vec::new(), [0; 3]);
    for line in page.lines() {
        if !line.starts_with('|') {
            heads.clear();
            continue;
        }
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        if heads.is_empty() {
            heads = cells;
            continue;
        }
        for (head, cell) in heads.iter().zip(cells) {
            let first = names(cell).into_iter().next();
            match (*head, first) {
                ("command", Some(name)) => {
                    assert!(commands.contains(&format!("\n  {name} ")), "{name}");
                    counts[0] += 1;
                }
                ("Python", Some(name)) => {
                    assert!(python.contains(&format!("def {name}(")), "{name}");
                    counts[1] += 1;
                }
                (head, Some(_)) if head.starts_with("Rust") => {
                    for name in names(cell) {
                        let known = ["fn", "struct", "trait"]
                            .iter()
                            .any(|kind| rust.contains(&format!("{kind} {name}")));
                        assert!(known, "{name}");
                        counts[2] += 1;
                    }
                }
                _ => {}
            }
        }
    }
    println!("{counts:?} names of commands, of Python and of Rust");
    assert!(
        counts[0] >= 16 && counts[1] >= 10 && counts[2] >= 25,
        "{counts:?}"
    );
    // Files to which the pages link must exist.
    let mut links = 0;
    for name in ["start.md", "which.md", "desk.md"] {
        let text = self::page(name);
        for link in text.split("](").skip(1) {
            let target = link.split([')', '#']).next().unwrap();
            if target.is_empty() || target.contains("://") {
                continue;
            }
            assert!(
                Path::new(&format!("{ROOT}/docs/{target}")).exists(),
                "{name}: {target}"
            );
            links += 1;
        }
    }
    assert!(links > 20, "{links}");
}

/// Returns the text of all files below a folder.
fn sources(folder: &Path) -> String {
    let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
    let texts = entries.map(|entry| {
        let path = entry.path();
        if path.is_dir() {
            sources(&path)
        } else {
            std::fs::read_to_string(&path).unwrap_or_default()
        }
    });
    texts.collect()
}
