//! Tests the steady states of docs/contacts.md, and of its tables in docs/data, by running `frictiongen orbit`.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{cells, output};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn page() -> String {
    let text = std::fs::read_to_string(format!("{ROOT}/docs/contacts.md"));
    text.expect("the page")
}

/// Returns the lines of a table in docs/data without its head.
fn table(name: &str) -> Vec<String> {
    let text = std::fs::read_to_string(format!("{ROOT}/docs/data/{name}.csv"));
    let text = text.expect("the table");
    text.lines().skip(1).map(str::to_owned).collect()
}

/// Returns the only point of `frictiongen orbit`, as a function from names of columns to values.
fn point(scene: &str, r: &str, beta: &str) -> impl Fn(&str) -> String + use<> {
    let file = format!("{ROOT}/crates/cli/scenes/{scene}.friction");
    let csv = output("", &["orbit", &file, "--r", r, "--beta", beta, "--csv"]);
    let lines: Vec<Vec<String>> = cells(&csv)
        .iter()
        .map(|line| line.iter().map(|cell| (*cell).to_owned()).collect())
        .collect();
    assert_eq!(lines.len(), 2, "{scene}, r = {r}, β = {beta}: one point");
    move |name| {
        let place = lines[0].iter().position(|cell| cell == name);
        lines[1][place.unwrap_or_else(|| panic!("no column {name}"))].clone()
    }
}

/// Compares a printed number with a value, up to the printed decimals.
fn same(printed: &str, value: &str, what: &str) {
    let decimals = printed.split_once('.').map_or(0, |(_, tail)| tail.len());
    let value: f64 = value.parse().unwrap();
    assert_eq!(printed, format!("{value:.decimals$}"), "{what}");
}

/// Splits a line of a table into its cells.
fn row(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}

#[test]
fn cases() {
    let page = page();
    let mut seen = 0;
    for line in table("stick-slip") {
        let cells: Vec<&str> = line.split(',').collect();
        let [
            scene,
            r,
            beta,
            by,
            _,
            stops,
            reversals,
            stuck,
            amplitude,
            state,
            multiplier,
        ] = cells.as_slice()
        else {
            panic!("{line}");
        };
        let cell = format!("| {amplitude} |");
        let on_page = page.lines().filter(|row| row.contains(&cell)).count();
        assert_eq!(on_page, 1, "{line}");
        if *by != "frictiongen" {
            continue;
        }
        let value = point(scene, r, beta);
        same(stops, &value("stops"), &line);
        same(reversals, &value("reversals"), &line);
        same(stuck, &value("stuck_fraction"), &line);
        same(amplitude, &value("contact.amplitude"), &line);
        assert_eq!(*state, value("state"), "{line}");
        same(multiplier, &value("largest_multiplier"), &line);
        seen += 1;
    }
    assert_eq!(seen, 5);
}

#[test]
fn multipliers_of_the_thesis_examples() {
    let table = table("multipliers");
    assert_eq!(table.len(), 30);
    for line in table {
        let cells: Vec<&str> = line.split(',').collect();
        let [scene, _, r, beta, stops, multiplier, cycles] = cells.as_slice() else {
            panic!("{line}");
        };
        let value = point(scene, r, beta);
        assert_eq!(value("regime"), "stick-slip", "{line}");
        assert_eq!(value("state"), "stable", "{line}");
        same(stops, &value("stops"), &line);
        same(multiplier, &value("largest_multiplier"), &line);
        // The number of cycles is ln 10/−ln m, rounded to two digits. m is the largest multiplier.
        let largest: f64 = value("largest_multiplier").parse().unwrap();
        let tenth = std::f64::consts::LN_10 / -largest.ln();
        let printed: f64 = cycles.parse().unwrap();
        assert!((printed / tenth - 1.0).abs() < 0.05, "{line}: {tenth}");
    }
}

/// Checks the table of coexisting states, which may be in any order.
#[test]
fn several_states() {
    let page = page();
    let command = page.lines().find(|line| line.ends_with(" --states"));
    let words: Vec<&str> = command.expect("the command").split(' ').skip(1).collect();
    let file = format!("{ROOT}/{}", words[1]);
    let asked: Vec<&str> = words
        .iter()
        .map(|word| if *word == words[1] { &file } else { *word })
        .chain(["--csv"])
        .collect();
    let csv = output("", &asked);
    let lines = cells(&csv);
    let place = |name: &str| lines[0].iter().position(|cell| *cell == name).expect(name);
    let printed: Vec<Vec<&str>> = page
        .lines()
        .skip_while(|line| !line.starts_with("| regime | state |"))
        .skip(2)
        .take_while(|line| line.starts_with('|'))
        .map(row)
        .collect();
    assert_eq!(printed.len(), lines.len() - 1);
    for printed in &printed {
        let found = lines.iter().skip(1);
        let found: Vec<_> = found
            .filter(|line| line[place("regime")] == printed[0])
            .collect();
        assert_eq!(found.len(), 1, "{printed:?}");
        for (name, printed) in ["regime", "state", "stops", "reversals"]
            .iter()
            .zip(printed)
        {
            assert_eq!(found[0][place(name)], *printed);
        }
        same(printed[4], found[0][place("contact.amplitude")], printed[0]);
    }
}
