//! Reads and writes the budgets in `docs/data/accuracy.csv`.

use crate::budgets::cases::Case;
use crate::budgets::measure::Arguments;
use frictiongen_kernel::number::dd::Dd;
use std::fmt::Write;

pub const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/data/accuracy.csv");
const HEAD: &str = "function,result,scalar,unit,budget,worst,x,y,z,domain";

/// A row of the table: one result of one function with one scalar type.
#[derive(Clone, Debug)]
pub struct Row {
    pub function: String,
    pub result: String,
    pub scalar: String,
    pub unit: String,
    /// Largest error that the tests allow.
    pub budget: f64,
    /// Largest measured error. `place` has the arguments at which it occurred.
    pub worst: f64,
    pub place: Arguments,
    pub domain: String,
}

fn argument(text: &str) -> Dd {
    let mut parts = text.split(' ').map(|part| part.parse().expect("a number"));
    let hi = parts.next().expect("a number");
    Dd::new(hi, parts.next().unwrap_or(0.0))
}

fn written(x: Dd) -> String {
    if x.lo == 0.0 {
        format!("{:e}", x.hi)
    } else {
        format!("{:e} {:e}", x.hi, x.lo)
    }
}

pub fn read() -> Vec<Row> {
    let text = std::fs::read_to_string(PATH).unwrap_or_default();
    let mut lines = text.lines();
    assert!(matches!(lines.next(), None | Some(HEAD)), "another head");
    lines
        .map(|line| {
            let fields: Vec<&str> = line.splitn(10, ',').collect();
            let [
                function,
                result,
                scalar,
                unit,
                budget,
                worst,
                x,
                y,
                z,
                domain,
            ] = fields[..]
            else {
                panic!("not ten fields: {line}");
            };
            Row {
                function: function.replace(';', ","),
                result: result.into(),
                scalar: scalar.into(),
                unit: unit.into(),
                budget: budget.parse().expect("a budget"),
                worst: worst.parse().expect("an error"),
                place: [x, y, z].map(argument),
                domain: domain.trim_matches('"').into(),
            }
        })
        .collect()
}

pub fn write(rows: &[Row]) {
    let mut text = format!("{HEAD}\n");
    for row in rows {
        let [x, y, z] = row.place.map(written);
        let Row {
            result,
            scalar,
            unit,
            budget,
            worst,
            domain,
            ..
        } = row;
        let function = row.function.replace(',', ";");
        writeln!(
            text,
            "{function},{result},{scalar},{unit},{budget},{worst},{x},{y},{z},\"{domain}\""
        )
        .expect("a string");
    }
    std::fs::write(PATH, text).expect("the table is written");
}

/// Returns the rows of a case, in the order of its results. Returns `None` if a row is missing or has another unit or
/// domain.
pub fn rows_of(table: &[Row], case: &Case) -> Option<Vec<Row>> {
    case.fields
        .iter()
        .map(|field| {
            table
                .iter()
                .find(|row| {
                    row.function == case.function
                        && row.result == *field
                        && row.scalar == case.scalar
                })
                .filter(|row| row.unit == case.unit.name() && row.domain == case.domain.text)
                .cloned()
        })
        .collect()
}

/// Returns a budget for a new row: the smallest of a few round numbers that leaves a margin of a tenth. Later changes
/// of the budget are made by hand only.
pub fn first_budget(worst: f64) -> f64 {
    const STEPS: [f64; 15] = [
        0.0, 0.5, 0.75, 1.0, 1.1, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0,
    ];
    let rounded_once = (worst - 0.5).abs() < 1e-3;
    let needed = if rounded_once { 0.5 } else { worst * 1.1 };
    STEPS
        .into_iter()
        .find(|step| needed <= *step)
        .unwrap_or(f64::INFINITY)
}
