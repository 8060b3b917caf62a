//! Writes `docs/accuracy.md` from `table.csv` and `costs.csv`.

use crate::budgets::asked_to_write;
use crate::budgets::table::{self, Row};
use std::fmt::Write;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/accuracy.md");
const COSTS: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/tables/budgets/costs.csv"
);

const HEAD: &str = include_str!("page_head.md");
const TAIL: &str = include_str!("page_costs.md");
const SCALARS: [&str; 3] = ["f32", "f64", "Dd"];

/// Returns an error as text with two decimals, rounded up.
fn shown(error: f64) -> String {
    let up = (error * 100.0 - 1e-5).ceil().max(0.0) / 100.0;
    format!("{up:.2}")
}

fn cell(rows: &[Row], like: &Row, scalar: &str) -> String {
    let found = rows.iter().find(|row| {
        row.function == like.function && row.result == like.result && row.scalar == scalar
    });
    found.map_or(String::new(), |row| {
        format!("{} ({})", row.budget, shown(row.worst))
    })
}

fn accuracy(rows: &[Row]) -> String {
    let mut text = String::from(
        "| function | result | unit | f32 | f64 | double-double | arguments |\n\
         |---|---|---|---|---|---|---|\n",
    );
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in rows {
        if seen.contains(&(&row.function, &row.result)) {
            continue;
        }
        seen.push((&row.function, &row.result));
        let [single, double, better] = SCALARS.map(|scalar| cell(rows, row, scalar));
        let Row {
            function,
            result,
            unit,
            domain,
            ..
        } = row;
        let domain = domain.replace('|', "\\|");
        writeln!(
            text,
            "| {function} | {result} | {unit} | {single} | {double} | {better} | {domain} |"
        )
        .expect("a string");
    }
    text
}

fn costs() -> String {
    let mut text = String::from(
        "| form | stable, ns | as printed, ns | ratio | the printed form breaks at | its error there | the stable one's |\n\
         |---|---|---|---|---|---|---|\n",
    );
    let costs = std::fs::read_to_string(COSTS).expect("costs.csv");
    for line in costs.lines().skip(1) {
        let line = line.replace('|', "\\|");
        let fields: Vec<&str> = line.split(';').collect();
        let [form, stable, naive, place, wrong, right] = fields[..] else {
            panic!("not six fields: {line}");
        };
        let [fast, slow] = [stable, naive].map(|ns| ns.parse::<f64>().expect("ns"));
        writeln!(
            text,
            "| {form} | {stable} | {naive} | {:.1} | {place} | {wrong} | {right} |",
            fast / slow
        )
        .expect("a string");
    }
    text
}

#[test]
fn page_says_what_the_data_say() {
    let page = format!("{HEAD}\n{}\n{TAIL}\n{}", accuracy(&table::read()), costs());
    if asked_to_write() {
        std::fs::write(PAGE, &page).expect("the page is written");
    }
    let stored = std::fs::read_to_string(PAGE).expect("docs/accuracy.md");
    assert!(
        stored == page,
        "docs/accuracy.md differs from table.csv and costs.csv: \
         UPDATE_ACCURACY=1 cargo test -p generated-tests --test tables page"
    );
}
