//! Tests that the corrections on the page `docs/thesis.md` and the tests of this folder agree.

use std::collections::BTreeSet;

const PAGE: &str = include_str!("../../../../docs/thesis.md");
const SOURCES: [&str; 6] = [
    include_str!("single.rs"),
    include_str!("chains.rs"),
    include_str!("oscillating.rs"),
    include_str!("stuck.rs"),
    include_str!("damped.rs"),
    include_str!("resonance.rs"),
];

/// The corrections, each as its position in the thesis and the name of its test.
const ROWS: [(&str, &str); 35] = [
    ("2.31, 6.8", "eq_2_31_and_6_8"),
    ("2.4, 2.9", "eq_2_4_and_2_9"),
    ("section 2.5.1", "section_2_5_1"),
    ("3.15", "eq_3_15"),
    ("3.33, 3.34", "eq_3_33_and_3_34"),
    ("sections 3.4.3, 3.6", "sections_3_4_3_and_3_6"),
    ("section 3.6.2", "section_3_6_2"),
    ("section 3.6.2, figure 3.14a", "section_3_6_2_stick_slip"),
    ("4.5", "eq_4_5"),
    ("section 4.4.2", "section_4_4_2"),
    ("5.28", "eq_5_28"),
    ("5.55, 5.56", "eq_5_55_and_5_56"),
    ("5.78", "eq_5_78"),
    ("5.79, 5.80", "eq_5_79_and_5_80"),
    ("6.6", "eq_6_6"),
    ("6.21, 6.30", "eq_6_21_and_6_30"),
    ("6.24", "eq_6_24"),
    ("6.27", "eq_6_27"),
    ("section 6.3.2", "section_6_3_2"),
    ("section 6.3.3", "section_6_3_3"),
    ("6.32", "eq_6_32"),
    ("section 6.5.2", "section_6_5_2"),
    ("section 6.5.3", "section_6_5_3"),
    (
        "7.7, 7.9 to 7.14, 7.24 to 7.27, 7.30, B.2 to B.14",
        "eq_7_7_and_others",
    ),
    ("7.22, 7.23, 7.28, B.15", "eq_7_22_7_23_7_28_and_b_15"),
    ("7.31", "eq_7_31"),
    ("7.33", "eq_7_33"),
    ("7.37", "eq_7_37"),
    ("7.38", "eq_7_38"),
    ("7.50", "eq_7_50"),
    ("section 7.4.3", "section_7_4_3"),
    ("7.58", "eq_7_58"),
    ("7.62", "eq_7_62"),
    ("A.11, A.20", "eq_a_11_and_a_20"),
    ("B.7", "eq_b_7"),
];

/// Returns the row of the page that belongs to a test.
fn row(test: &str) -> &'static str {
    let name = format!("`{test}`");
    let mut rows = PAGE.lines().filter(|line| line.contains(&name));
    let row = rows
        .next()
        .unwrap_or_else(|| panic!("{test} is on the page"));
    assert_eq!(rows.next(), None, "{test} is on the page once");
    row
}

/// Asserts that the row of this test on the page contains these numbers. Each number comes with its number of
/// decimals.
#[track_caller]
pub fn states(test: &str, numbers: &[(f64, usize)]) {
    let row = row(test);
    for (number, decimals) in numbers {
        let text = format!("{number:.decimals$}").replace('-', "−");
        let mut words = row.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '−'));
        assert!(
            words.any(|word| word.trim_end_matches('.') == text),
            "{text} is not in: {row}"
        );
    }
}

/// Returns the names of the functions with `#[test]` in a source text.
fn tests(source: &str) -> impl Iterator<Item = &str> {
    let after = source.split("#[test]\nfn ").skip(1);
    after.filter_map(|text| text.split_once('(').map(|(name, _)| name))
}

#[test]
fn every_row_has_its_test_and_every_test_its_row() {
    let written: Vec<&str> = SOURCES.into_iter().flat_map(tests).collect();
    let expected: BTreeSet<&str> = ROWS.iter().map(|(_, test)| *test).collect();
    assert_eq!(written.len(), ROWS.len());
    assert_eq!(written.into_iter().collect::<BTreeSet<_>>(), expected);
    for (place, test) in ROWS {
        let first = row(test).split('|').nth(1).expect("a row of a table");
        assert_eq!(first.trim(), place);
    }
    // The list must contain every row of the page.
    let (corrections, _) = PAGE
        .split_once("\n## Printed numbers\n")
        .expect("the numbers follow the corrections");
    let rows = corrections.lines().filter(|line| line.starts_with("| "));
    let rows = rows.filter(|line| !line.starts_with("| where"));
    assert_eq!(rows.count(), ROWS.len());
}
