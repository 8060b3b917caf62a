//! Writes `docs/messages.md` from the cases.

use super::case::{Case, Door};
use super::{groups, write_or_compare};
use std::fmt::Write;
use std::path::Path;

const OPENING: &str = "\
# What is told of a faulty description, and what to write instead

Every error of a description is told at once, each with the place of the token that it is about:
on the token in a macro call, with `line:column:` at run time and on the command line, with
`file:line:column:` on the path of a file that a macro reads.  Below, each message stands under its
cause, then the lines that cause it (`-`) and the same lines cured (`+`).

This page is made from the cases in `generated-tests/tests/messages/` by
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
        Door::Text => "In a macro call the compiler itself refuses this.\n\n",
        Door::Macro => "In a macro call only.\n\n",
    };
    page.push_str(note);
    let told = case.told.join("\n").replace("{folder}", "…");
    let _ = write!(page, "```text\n{told}\n```\n\n");
    let changes = changes(&case.faulty, &case.cured);
    let _ = write!(page, "```diff\n{changes}```\n");
}

/// Returns the lines that differ.
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
