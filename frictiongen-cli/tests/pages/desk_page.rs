//! Compares the columns that docs/desk.md lists with those of the commands.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{FRAME, output};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/desk.md");

/// Checks that every column in a table of docs/desk.md is a heading of the command above that table.
#[test]
fn the_columns() {
    let page = std::fs::read_to_string(PAGE).unwrap();
    let (mut headings, mut listed, mut columns) = (String::new(), false, 0);
    for line in page.lines() {
        if let Some(command) = line.strip_prefix("frictiongen ") {
            let words: Vec<&str> = command.split(' ').collect();
            if matches!(words[..], ["limits" | "response", ..]) && !command.contains(" -o ") {
                let [name, _, rest @ ..] = &words[..] else {
                    continue;
                };
                let printed = output("", &[&[*name, FRAME], rest].concat());
                let printed = printed.lines().take_while(|line| !line.starts_with("---"));
                headings = printed.collect::<Vec<_>>().join("\n");
            }
            continue;
        }
        listed = (listed || line == "| column | meaning |") && line.starts_with('|');
        let first = line.trim_matches('|').split('|').next().unwrap_or_default();
        if !listed
            || ["column ", "---"]
                .iter()
                .any(|begin| first.trim_start().starts_with(begin))
        {
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
