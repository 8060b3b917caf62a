//! Tests the commands of docs/features.md, and the numbers that the page quotes from their output.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{FRAME, output};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/features.md");
const UPPER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/thesis/two_m2.friction");

/// Checks that every command of docs/features.md runs, and that its output contains the numbers of the page.
#[test]
fn the_page() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let (mut commands, mut numbers) = (0, 0);
    let mut last = String::new();
    for line in page.lines() {
        if let Some(rest) = line.strip_prefix("frictiongen features ") {
            let rest = rest
                .replace("frame.friction", FRAME)
                .replace("two_m2.friction", UPPER);
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
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        if let [number, words, _] = cells.as_slice()
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
    assert!(commands == 3 && numbers >= 9, "{commands} {numbers}");
}
