//! Tests docs/guide.md: its commands run and print the text of the page, its numbers and columns are right, and the
//! functions that it names exist. The last test checks the links of all pages.
//!
//! `UPDATE_DOCS=1 cargo test -p frictiongen-cli --test pages guide_page::` rewrites the output on the page.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{FRAME, cells, output};
use crate::start_page::{folder, page, printed, value};
use std::path::{Path, PathBuf};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
const FUNCTIONS: &str = "Which function answers which question";
const DAMPER: &str = "Size a friction damper";
const FEATURES: &str = "Features of a response";
const RECORDING: &str = "From a recording to a friction force";

/// Returns a part of the guide: the text from a heading of the second level to the next one.
fn part(title: &str) -> String {
    let page = page("guide.md");
    let (_, rest) = page.split_once(&format!("\n## {title}\n")).unwrap();
    rest.split("\n## ").next().unwrap().to_owned()
}

/// Splits a row of a table into its cells.
fn row(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}

/// Checks that every column in a table of the guide is a heading of the command above that table.
#[test]
fn the_columns() {
    let (mut headings, mut listed, mut columns) = (String::new(), false, 0);
    for line in part(DAMPER).lines() {
        if let Some(command) = line.strip_prefix("frictiongen ") {
            let words: Vec<&str> = command.split(' ').collect();
            if let [name @ ("limits" | "response"), _, rest @ ..] = &words[..] {
                let mut asked = vec![*name, FRAME];
                asked.extend(rest);
                let printed = output("", &asked);
                let printed = printed.lines().take_while(|line| !line.starts_with("---"));
                headings = printed.collect::<Vec<_>>().join("\n");
            }
            continue;
        }
        listed = (listed || line == "| column | meaning |") && line.starts_with('|');
        let first = row(line)[0];
        if !listed || first == "column" || first.starts_with("---") {
            continue;
        }
        for name in first.split(',').map(str::trim) {
            let name = name
                .replace('β', "beta")
                .replace("r\\*", "r*")
                .replace("\\*", "*");
            assert!(headings.contains(&name), "{name}:\n{headings}");
            columns += 1;
        }
    }
    println!("{columns} columns");
    assert!(columns >= 13, "{columns}");
}

/// Checks that the commands on a damper run that draw no picture. `scripts/pages pictures` runs the other commands.
#[test]
fn commands_on_a_damper_run() {
    let part = part(DAMPER);
    let folder = folder("damper");
    std::fs::copy(FRAME, folder.join("frame.friction")).unwrap();
    let lines = part.lines().filter(|line| line.starts_with("frictiongen "));
    let mut run = 0;
    // Commands with `--vary` and those of five storeys take minutes without optimisation. The test `the_tuned_frame`
    // runs the first. The files of `periodic` are the reader's own, and the tests of that command have files of their
    // own.
    let left_out = [".svg", "--vary", "five.friction", "frictiongen periodic"];
    for line in lines.filter(|line| !left_out.iter().any(|word| line.contains(word))) {
        let text = printed(line, &folder);
        assert!(!text.is_empty() || line.contains(" -o "), "{line}");
        run += 1;
    }
    assert!(folder.join("curve.csv").exists() && folder.join("curve.json").exists());
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(run, 11);
}

/// Checks the best frictions of five storeys.
#[test]
#[ignore = "three optima without optimisation: ten seconds"]
fn the_five_storeys() {
    let folder = folder("storeys");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/five.friction");
    std::fs::copy(scene, folder.join("five.friction")).unwrap();
    let part = part(DAMPER);
    let mut compared = 0;
    for (quantity, factor) in [("f2-f1", 1e3), ("accel(f5)", 1.0), ("f5-base", 1e3)] {
        let line = part
            .lines()
            .find(|line| line.contains(&format!(", `{quantity}` |")));
        let cells = row(line.unwrap());
        let [_, friction, amplitude] = cells[..] else {
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

/// Checks the numbers of the tuned frame.
#[test]
#[ignore = "minutes without optimisation"]
fn the_tuned_frame() {
    let part = part(DAMPER);
    let mut lines = part
        .lines()
        .filter(|line| line.starts_with("frictiongen optimum "));
    let line = lines.find(|line| line.contains("--vary")).unwrap();
    let (command, vary) = line.split_once(" --vary ").unwrap();
    let words = command.split(' ').skip(3);
    let arguments: Vec<&str> = ["optimum", FRAME]
        .into_iter()
        .chain(words)
        .chain(["--csv", "--vary", vary.trim_matches('"')])
        .collect();
    let text = output("", &arguments);
    let rows = cells(&text);
    let number = |name: &str| -> f64 {
        let row = rows.iter().find(|row| row[0] == name).unwrap();
        row[1].parse().unwrap()
    };
    assert_eq!(number("k lower - upper"), 2600.0);
    let [force, length] = ["friction", "largest amplitude of lower"].map(number);
    let told = format!("with {force:.2} N and {:.2} mm", 1e3 * length);
    assert!(part.replace('\n', " ").contains(&told), "{told}");
}

/// Checks that every command on features runs, and that its output contains the numbers of the tables.
#[test]
fn the_features() {
    let upper = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/thesis/two_m2.friction");
    let storeys = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/storeys.friction");
    let (mut commands, mut numbers) = (0, 0);
    let mut last = String::new();
    for line in part(FEATURES).lines() {
        if let Some(rest) = line.strip_prefix("frictiongen features ") {
            let rest = rest
                .replace("frame.friction", FRAME)
                .replace("two_m2.friction", upper)
                .replace("crates/cli/scenes/storeys.friction", storeys);
            let (rest, drawn) = match rest.split_once(" -o ") {
                Some((rest, _)) => (rest.to_owned(), true),
                None => (rest, false),
            };
            last = output(
                "",
                &[&["features"], &rest.split(' ').collect::<Vec<_>>()[..]].concat(),
            );
            assert!(!drawn || last.contains("invariant point"));
            commands += 1;
        }
        // A row of a printed table has a number, and the words of its line.
        if let [number, words, _] = row(line).as_slice()
            && let Some(printed) = number
                .strip_prefix('`')
                .and_then(|text| text.strip_suffix('`'))
        {
            let words: Vec<&str> = words.trim_matches('`').split(" … ").collect();
            let found = last
                .lines()
                .any(|line| line.contains(printed) && words.iter().all(|word| line.contains(word)));
            assert!(found, "{printed}, {words:?}:\n{last}");
            numbers += 1;
        }
    }
    println!("{commands} commands, {numbers} numbers");
    assert!(commands == 4 && numbers >= 12, "{commands} {numbers}");
}

/// Folder of the recordings.
fn recordings() -> PathBuf {
    Path::new(ROOT).join("docs/measure")
}

/// Checks that the commands on recordings print what the page shows.
#[test]
fn commands_on_recordings_print_the_page() {
    let page = page("guide.md");
    let mut made = String::new();
    let (mut here, mut command, mut skipping, mut commands) = (false, None, false, 0);
    for line in page.lines() {
        if skipping {
            if line != "```" {
                continue;
            }
            skipping = false;
        }
        made.push_str(line);
        made.push('\n');
        if let Some(title) = line.strip_prefix("## ") {
            here = title == RECORDING;
        }
        if here && line.starts_with("frictiongen ") {
            command = Some(line);
        }
        if here
            && line == "```text"
            && let Some(command) = command.take()
        {
            made.push_str(&printed(command, &recordings()));
            skipping = true;
            commands += 1;
        }
    }
    assert_eq!(commands, 4);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(format!("{ROOT}/docs/guide.md"), &made).unwrap();
    }
    assert!(
        made == self::page("guide.md"),
        "the page differs: UPDATE_DOCS=1"
    );
}

/// Parses a line of the CSV: value, lower bound, upper bound.
fn bounds(csv: &str, name: &str) -> [f64; 3] {
    let line = csv
        .lines()
        .find(|line| line.starts_with(&format!("{name},")))
        .unwrap();
    let cells: Vec<f64> = line
        .split(',')
        .skip(1)
        .take(3)
        .map(|cell| cell.parse().unwrap())
        .collect();
    cells.try_into().unwrap()
}

/// Compares results from the recordings with the values from which the recordings were made.
#[test]
fn results_from_recordings_are_true() {
    let output = |line: &str| printed(line, &recordings());
    // The true force is F = βkY.
    let truth = 0.4 * 2.0 * (std::f64::consts::TAU * 3.086_f64).powi(2) * 1.75e-3;
    for arguments in [
        "below.csv above.csv fast.csv",
        "above.csv --by phase",
        "slow.csv",
        "decay.csv --decay",
    ] {
        let csv = output(&format!(
            "frictiongen identify plate.friction {arguments} --csv"
        ));
        assert!(!csv.contains("NaN"), "{csv}");
        let [value, from, to] = bounds(&csv, "friction force");
        assert!(
            (value / truth - 1.0).abs() < 0.02,
            "{arguments}: {value} for {truth}"
        );
        // The description has stiffness 751.9 N/m instead of 751.937 N/m, which changes the force by a relative 5e-5.
        assert!(
            from * 0.9999 <= truth && truth <= to * 1.0001,
            "{arguments}: {csv}"
        );
    }
    let csv = output("frictiongen identify plate.friction slow.csv --by amplitude --csv");
    assert!(csv.contains("friction force is,several levels,"), "{csv}");
    let levels = [1, 2].map(|level| bounds(&csv, &format!("friction force {level}"))[0]);
    let told = format!("{:.3} N and {:.3} N", levels[0], levels[1]);
    let part = part(RECORDING).replace('\n', " ");
    assert!(part.contains(&told), "{told}");
    let csv = output("frictiongen fit storeys.friction storeys.csv --csv");
    for (name, truth) in [
        ("r per Hz", 0.3419),
        ("gamma m2", 0.9772),
        ("kappa m1 - m2", 1.1119),
    ] {
        let [value, from, to] = bounds(&csv, name);
        assert!(
            (value / truth - 1.0).abs() < 1e-3 && from < truth && truth < to,
            "{name}: {csv}"
        );
    }
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

/// Checks that the functions exist that the guide names for each question.
#[test]
fn the_functions_exist() {
    let commands = output("", &["--help"]);
    let python = sources(Path::new(&format!(
        "{ROOT}/bindings/python/package/frictiongen"
    )));
    let rust = sources(Path::new(&format!("{ROOT}/frictiongen/src")))
        + &sources(Path::new(&format!("{ROOT}/crates/kernel/src")));
    let part = part(FUNCTIONS);
    let (mut heads, mut counts) = (Vec::new(), [0; 3]);
    for line in part.lines() {
        if !line.starts_with('|') {
            heads.clear();
            continue;
        }
        let cells = row(line);
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

/// Checks that files to which the pages link exist.
#[test]
fn links_have_their_files() {
    let mut links = 0;
    for folder in ["", "docs", "docs/decisions"] {
        let folder = Path::new(ROOT).join(folder);
        let entries = std::fs::read_dir(&folder).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        for page in paths.filter(|path| path.extension().is_some_and(|ending| ending == "md")) {
            let text = std::fs::read_to_string(&page).unwrap();
            for link in text.split("](").skip(1) {
                let target = link.split([')', '#']).next().unwrap();
                if target.is_empty() || target.contains("://") {
                    continue;
                }
                assert!(folder.join(target).exists(), "{}: {target}", page.display());
                links += 1;
            }
        }
    }
    assert!(links > 60, "{links}");
}
