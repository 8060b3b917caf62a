//! Tests that the commands of `docs/measure.md` print the text of the page, and that their results are right.
//!
//! `UPDATE_DOCS=1 cargo test -p frictiongen-cli --test pages measure_page::` rewrites the page.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;
use std::process::Command;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/measure.md");

fn output(line: &str) -> String {
    let words: Vec<&str> = line.split_whitespace().skip(1).collect();
    let run = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
        .args(&words)
        .current_dir(Path::new(PAGE).with_extension(""))
        .output()
        .unwrap();
    assert!(
        run.status.success(),
        "{line}: {}",
        String::from_utf8_lossy(&run.stderr)
    );
    let text = String::from_utf8(run.stdout).unwrap();
    assert!(!text.contains("NaN"), "{text}");
    text.lines()
        .map(|line| format!("{}\n", line.trim_end()))
        .collect()
}

#[test]
fn the_page_has_what_its_commands_print() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let mut made = String::new();
    let (mut command, mut skipping, mut commands) = (None, false, 0);
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
            command = Some(line.to_owned());
        }
        if line == "```text"
            && let Some(command) = command.take()
        {
            made.push_str(&output(&command));
            skipping = true;
            commands += 1;
        }
    }
    assert_eq!(commands, 9);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(PAGE, &made).unwrap();
    }
    assert!(
        made == std::fs::read_to_string(PAGE).unwrap(),
        "the page differs: UPDATE_DOCS=1"
    );
}

/// Parses a line of the CSV: value, lower bound, upper bound.
fn line(csv: &str, name: &str) -> [f64; 3] {
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

#[test]
fn what_the_commands_say_is_true() {
    // The true force is F = βkY, with the values from which the recordings were made.
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
        let [value, from, to] = line(&csv, "friction force");
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
    let csv = output("frictiongen fit storeys.friction storeys.csv --csv");
    for (name, truth) in [
        ("r per Hz", 0.3419),
        ("gamma m2", 0.9772),
        ("kappa m1 - m2", 1.1119),
    ] {
        let [value, from, to] = line(&csv, name);
        assert!(
            (value / truth - 1.0).abs() < 1e-3 && from < truth && truth < to,
            "{name}: {csv}"
        );
    }
}
