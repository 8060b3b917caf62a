//! Tests the table of printed numbers. Every row is present, and its numbers and its verdict are the expected ones.
//! `docs/data/thesis.csv` is the output of the program, and `docs/thesis.md` quotes it.
//!
//! ```text
//! UPDATE_FACTS=1 cargo test -p frictiongen-examples --test examples facts::   # writes docs/data/thesis.csv
//! ```

use frictiongen_examples::facts::row::{
    Row, Verdict, claim, formula, formula_at, number, printed_number,
};
use frictiongen_examples::facts::rows;
use frictiongen_examples::facts::table::table;
use std::sync::LazyLock;

mod expected;
mod typed;

use expected::{Expected, ROWS};

static COMPUTED: LazyLock<Vec<Row>> = LazyLock::new(rows);

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/data/thesis.csv");
const PAGE: &str = include_str!("../../../../docs/thesis.md");

/// Asserts that `got` differs from `want` by at most `tolerance`.
#[track_caller]
fn close(got: f64, want: f64, tolerance: f64) {
    assert!(
        (got - want).abs() <= tolerance,
        "{got} instead of {want}, which is stated to {tolerance}"
    );
}

#[test]
fn every_row_is_there_once_and_in_order() {
    let ids: Vec<&str> = COMPUTED.iter().map(|row| row.id).collect();
    let all: Vec<String> = (1..=37).map(|i| format!("F{i:02}")).collect();
    assert_eq!(ids, all);
    let expected: Vec<&str> = ROWS.iter().map(|row| row.id).collect();
    assert_eq!(expected, all);
}

#[test]
fn every_number_comes_out_as_stated() {
    for (row, Expected { id, values, .. }) in COMPUTED.iter().zip(ROWS) {
        let found = row.values();
        assert_eq!(found.len(), values.len(), "{id}: {found:?}");
        for (got, want) in found.into_iter().zip(*values) {
            let (value, half) = printed_number(want).expect(want);
            assert!((got - value).abs() <= half, "{id}: {got} instead of {want}");
        }
    }
}

#[test]
fn every_verdict_is_the_expected_one() {
    for (row, Expected { id, wrong, .. }) in COMPUTED.iter().zip(ROWS) {
        let agrees: Vec<bool> = row.entries.iter().map(|entry| entry.agrees).collect();
        let found: Vec<usize> = (0..agrees.len()).filter(|i| !agrees[*i]).collect();
        assert_eq!(&found[..], *wrong, "{id}: {:?}", row.entries);
        match row.verdict() {
            Verdict::Agrees => assert!(wrong.is_empty() && row.reason.is_empty(), "{id}"),
            Verdict::Corrected(_) => assert!(!wrong.is_empty(), "{id}"),
            Verdict::Unexplained => panic!("{id} differs without a reason"),
        }
    }
}

/// Checks the comparison itself: a number close to half a unit on either side, NaN, and no printed number.
#[test]
fn a_wrong_number_does_not_agree() {
    assert!(number("", "0.537", 0.53749, 6).agrees && number("", "0.537", 0.53651, 6).agrees);
    assert!(!number("", "0.537", 0.53751, 6).agrees && !number("", "0.537", 0.53649, 6).agrees);
    assert!(number("", "about 1.2", 1.24, 6).agrees && !number("", "about 1.2", 1.26, 6).agrees);
    assert!(!number("", "0.537", f64::NAN, 6).agrees && !number("", "", 0.537, 6).agrees);
    assert!(!formula("", ("1", 1.0), 1.0 + 2e-12, 1e-12, 6).agrees);
    assert!(!formula("", ("1", 1.0), f64::NAN, 1e-12, 6).agrees);
    assert!(!formula_at("", "1", &[], 1e-12, 6).agrees);
    assert!(!formula_at("", "1", &[(1.0, 1.0), (1.0, 1.1)], 1e-12, 6).agrees);
    let row = |agrees, reason| Row {
        id: "",
        claim: "",
        place: "",
        entries: vec![claim("", "", 1.0, 6, true), claim("", "", 1.0, 6, agrees)],
        reason,
    };
    assert_eq!(row(true, "").verdict(), Verdict::Agrees);
    assert_eq!(row(true, "why").verdict(), Verdict::Agrees);
    assert_eq!(row(false, "why").verdict(), Verdict::Corrected("why"));
    assert_eq!(row(false, "").verdict(), Verdict::Unexplained);
}

#[test]
fn table_is_what_the_program_prints() {
    let table = table(&COMPUTED);
    if std::env::var_os("UPDATE_FACTS").is_some() {
        std::fs::write(TABLE, &table).expect("the table is written");
    }
    let stored = std::fs::read_to_string(TABLE).expect("docs/data/thesis.csv");
    assert!(
        stored == table,
        "docs/data/thesis.csv differs from what the program prints: \
         UPDATE_FACTS=1 cargo test -p frictiongen-examples --test examples facts::"
    );
}

/// Checks that docs/thesis.md has each printed number that differs, with the computed number of the table.
#[test]
fn page_has_the_numbers_that_differ() {
    let rows = COMPUTED.iter().flat_map(|row| {
        let wrong = row.entries.iter().filter(|entry| !entry.agrees);
        wrong.map(move |entry| (row.id, &*entry.printed, &*entry.computed))
    });
    let stated = PAGE.lines().filter(|line| line.starts_with("| F"));
    let stated = stated.map(|line| {
        let mut cells = line.split('|').map(str::trim).skip(1);
        let (id, _, printed) = (cells.next(), cells.next(), cells.next());
        (
            id.expect(line),
            printed.expect(line),
            cells.next().expect(line),
        )
    });
    assert_eq!(stated.collect::<Vec<_>>(), rows.collect::<Vec<_>>());
}
