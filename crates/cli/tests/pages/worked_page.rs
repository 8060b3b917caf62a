//! Tests docs/worked.md: its commands print the text of the page, and its numbers are those of the closed forms.
//!
//! `UPDATE_DOCS=1 cargo test -p frictiongen-cli --test pages worked_page::` rewrites the output on the page.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::start_page::{folder, page, printed};
use std::f64::consts::TAU;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Runs the commands of the page on its descriptions. Returns the page with their output, and the output of each command.
fn run() -> (String, Vec<String>) {
    let folder = folder("worked");
    let (mut made, mut outputs) = (String::new(), Vec::new());
    let (mut scene, mut commands, mut skipping) = (None, Vec::new(), false);
    let mut descriptions = Vec::new();
    for line in page("worked.md").lines() {
        if skipping && line != "```" {
            continue;
        }
        skipping = false;
        made.push_str(line);
        made.push('\n');
        match (line, &mut scene) {
            ("```friction", _) => scene = Some(String::new()),
            ("```", Some(text)) => {
                descriptions.push(std::mem::take(text));
                scene = None;
            }
            (line, Some(text)) => *text += &format!("{line}\n"),
            _ => {}
        }
        if line.starts_with("frictiongen ") {
            let file = line.split(' ').nth(2).unwrap();
            std::fs::write(folder.join(file), descriptions.last().unwrap()).unwrap();
            commands.push(line.to_owned());
        }
        if line == "```text" {
            for command in commands.drain(..) {
                let text = printed(&command, &folder);
                // The page shows the table, and not the description above it.
                let (_, table) = text.rsplit_once("\n\n").unwrap_or(("", &text));
                made.push_str(table);
                outputs.push(table.to_owned());
            }
            skipping = true;
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    (made, outputs)
}

/// Returns the number in a column, counted from 0, of the first line that has a word.
fn number(text: &str, word: &str, place: usize) -> f64 {
    let line = text.lines().find(|line| line.contains(word));
    let line = line.unwrap_or_else(|| panic!("no {word}: {text}"));
    line.split_whitespace().nth(place).unwrap().parse().unwrap()
}

/// Compares a printed number, which has six decimals, with a closed form.
fn same(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 3e-6, "{found}, {expected}");
}

#[test]
fn the_page_is_what_the_commands_print() {
    let (made, outputs) = run();
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(format!("{ROOT}/docs/worked.md"), &made).unwrap();
    }
    assert!(made == page("worked.md"), "the page differs: UPDATE_DOCS=1");
    let [isolator, limits, backlash, valve] = outputs.as_slice() else {
        panic!("{} commands", outputs.len());
    };
    let bearing = number(isolator, "deck-base", 2).abs();
    same(bearing, 2.0 * (1.0 - 0.5884) * 2.5 / 9.80665);
    same(
        number(isolator, "accel(deck)", 2),
        0.5884 + 2.0 * (1.0 - 0.5884),
    );

    let omega = 9.0 * TAU;
    let locked = 10.0 / (4e5 - 105.0 * omega * omega);
    let stuck = 5.0 * omega * omega * locked;
    let found = limits.lines().last().unwrap().split_whitespace();
    let found = found.filter_map(|cell| cell.parse::<f64>().ok());
    assert!(
        found
            .map(|cell| (cell / stuck - 1.0).abs())
            .any(|gap| gap < 1e-6),
        "{limits}"
    );

    // The impacts follow each other in half the time of the one before.
    let first = (2.0 * 0.002 / 4.0_f64).sqrt();
    let impacts: Vec<f64> = backlash
        .lines()
        .filter(|line| line.contains("impact"))
        .map(|line| line.split_whitespace().next().unwrap().parse().unwrap())
        .collect();
    for (index, impact) in impacts.iter().enumerate() {
        let halves = (0..index).map(|index| 0.5_f64.powi(index as i32));
        let expected = first * (1.0 + halves.sum::<f64>());
        assert!((impact - expected).abs() < 1e-6, "{impact}, {expected}");
    }
    assert!(impacts.len() > 5 && first * 3.0 - impacts.last().unwrap() < 1e-3);

    let net = 19.0_f64;
    same(
        number(valve, "force(seat)", 2),
        net + (net * net + 2.0 * 1e6 * net * 0.004).sqrt(),
    );
    same(
        number(valve, "vel(poppet)", 2),
        (2.0 * net * 0.004 / 0.05 + net * net / 0.05 / 1e6).sqrt(),
    );
}
