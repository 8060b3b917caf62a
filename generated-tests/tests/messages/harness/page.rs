//! Writes `docs/messages.md` from the cases.

use super::case::{Case, Door};
use super::{groups, write_or_compare};
use std::fmt::Write;
use std::path::Path;

const OPENING: &str = "\
# Messages about faulty descriptions

A faulty description gets one message for each error, all at once. Each message marks a token. A macro
call marks the token itself. At run time and on the command line the message begins with `line:column:`.
If a macro reads a file, the message begins with `file:line:column:` and marks the path of the file.
Below, each message follows its cause. The lines that cause the message (`-`) and the corrected lines
(`+`) follow the message.

The cases are in `generated-tests/tests/messages/`. This page is renewed by
`UPDATE_DOCS=1 cargo test -p generated-tests --test messages`.
";

/// Writes the page if that is requested, and otherwise fails if it is out of date.
pub fn write_or_check(cases: &[Case]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/messages.md");
    write_or_compare(&path, &page(cases));
}

fn page(cases: &[Case]) -> String {
    let mut page = OPENING.to_owned();
    for (group, cases) in groups(cases) {
        let _ = write!(page, "\n## {}\n", group.title);
        for case in cases {
            show(case, &mut page);
        }
    }
    page
}

fn show(case: &Case, page: &mut String) {
    let heading = case.cause.trim_end_matches('.');
    let _ = write!(page, "\n### {heading}\n\n");
    let note = match case.door {
        Door::Every | Door::Code | Door::File => "",
        Door::Text => {
            "In a macro call the compiler itself reports this error, in its own words.\n\n"
        }
        Door::Macro => "Only a macro call gives this message.\n\n",
    };
    page.push_str(note);
    let told = case.told.join("\n").replace("{folder}", "…");
    let _ = write!(page, "```text\n{told}\n```\n\n");
    let changes = changes(&case.faulty, &case.cured);
    let _ = write!(page, "```diff\n{changes}```\n");
}

/// Returns the lines in which the faulty and the corrected description differ.
fn changes(faulty: &str, cured: &str) -> String {
    let (faulty, cured): (Vec<_>, Vec<_>) = (faulty.lines().collect(), cured.lines().collect());
    // kept[i][j] is the number of lines that the remainders from i and from j have in common.
    let mut kept = vec![vec![0; cured.len() + 1]; faulty.len() + 1];
    for i in (0..faulty.len()).rev() {
        for j in (0..cured.len()).rev() {
            kept[i][j] = if faulty[i] == cured[j] {
                kept[i + 1][j + 1] + 1
            } else {
                kept[i + 1][j].max(kept[i][j + 1])
            };
        }
    }
    // The page shows characters that are invisible in an editor.
    let shown = |line: &str| line.replace('\u{200b}', "\\u{200b}");
    let mut text = String::new();
    let (mut i, mut j) = (0, 0);
    while i < faulty.len() || j < cured.len() {
        if i < faulty.len() && j < cured.len() && faulty[i] == cured[j] {
            (i, j) = (i + 1, j + 1);
        } else if i < faulty.len() && (j == cured.len() || kept[i + 1][j] >= kept[i][j + 1]) {
            let _ = writeln!(text, "-{}", shown(faulty[i]));
            i += 1;
        } else {
            let _ = writeln!(text, "+{}", shown(cured[j]));
            j += 1;
        }
    }
    text
}
