//! Section on tables of a declared accuracy. It compares them with exact results (by the present and by the earlier
//! searches), and with limits without search, which are closed formulas.

use super::table::{Table, Tally, cell, verdict};
use super::{of, shown};
use crate::measure::{By, Measure, Row};
use crate::methods::Method;
use crate::tabled::{Refused, USUAL};
use std::fmt::{Result as Written, Write};

/// Smallest ratios that are aimed for, of another time to the time of both limits from tables. The first is for the
/// earlier searches, the second for limits without search.
const LIMITS: [f64; 2] = [100.0, 3.0];
/// Smallest ratio that is aimed for in five damped masses, of the time of the earlier program to that of the
/// contact's amplitude from tables.
const CONTACT: f64 = 50.0;
/// Typical scenes, each with its name and its modal damping ratio ζ.
const TYPICAL: [(&str, f64); 4] = [
    ("Wall1", 0.02),
    ("Base2", 0.0),
    ("Pair5", 0.02),
    ("Wall10", 0.02),
];
const CHOICES: [u8; 5] = [2, 3, 4, 6, 9];

/// Writes the section on tables of a declared accuracy.
pub fn declared(measure: &Measure, text: &mut String) -> Written {
    let rows = &measure.rows;
    text.push_str("## Against declared accuracies\n\nIn this section the scenes have `accuracy` and `range: { r: 0.2..2.5 }`, so that piecewise polynomials replace the formulas.  The column `table` is the time from r to both limits, or to the contact's amplitude.  `before` is the time of the earlier searches, and `exact now` that of the present searches.  A ratio is the time to its left divided by the time of the table.  `bytes` is the size of pieces, buckets, zeros and poles.  `comparisons` is the number of comparisons that find a piece.  `error` is the largest difference from double-double at the points of the clock and the usual points.\n\n");
    at_usual(rows, text)?;
    contact(rows, text)?;
    typical(rows, text)?;
    others(rows, text)?;
    refused(&measure.refused, text)
}

fn exponent(row: &Row) -> Option<u8> {
    match row.by {
        By::Table(exponent) => Some(exponent),
        _ => None,
    }
}

/// Returns the rows of results from tables for one quantity. Each comes with the number n of its accuracy 10⁻ⁿ.
fn tables(rows: &[Row], method: Method) -> impl Iterator<Item = (&Row, u8)> {
    let of_method = rows.iter().filter(move |row| row.method == method);
    of_method.filter_map(|row| Some((row, exponent(row)?)))
}

/// Formats the largest error of a row. An error that exceeds the accuracy 10⁻ⁿ is marked, where n is `exponent`.
fn error(row: &Row, exponent: u8) -> String {
    let worst = row.error.worst();
    let within = worst <= 10_f64.powi(-i32::from(exponent));
    format!("{worst:.1e}{}", if within { "" } else { " **beyond**" })
}

fn size(row: &Row) -> String {
    let figures = row
        .table
        .map(|table| format!("{} | {} | {}", table.bytes, table.pieces, table.comparisons));
    figures.unwrap_or_else(|| " |  | ".to_owned())
}

/// Returns the median time of another method for the scene of a row, and its ratio to the time of the row.
fn over(rows: &[Row], row: &Row, by: By, method: Method) -> Option<(f64, f64)> {
    let other = of(rows, row, by, method)?;
    Some((other.time.median, other.time.median / row.time.median))
}

/// Formats a time and a ratio as two columns of a table. For `None` the two columns are empty.
fn columns(compared: Option<(f64, f64)>) -> String {
    compared.map_or_else(
        || " | ".to_owned(),
        |(time, ratio)| format!("{} | {ratio:.1}", shown(time)),
    )
}

fn at_usual(rows: &[Row], text: &mut String) -> Written {
    let mut aims = LIMITS.map(|_| Tally::default());
    let mut table = Table::of_scenes(
        "table | before | ratio | reached | exact now | ratio | without search | ratio | reached | bytes | pieces | comparisons | error",
    );
    for (row, exponent) in tables(rows, Method::Limits).filter(|(_, e)| *e == USUAL) {
        let before = over(rows, row, By::Before, Method::Limits);
        let now = over(rows, row, By::Double, Method::Limits);
        let without = over(rows, row, By::Double, Method::WithoutSearch);
        let mut judge = |place: usize, compared: Option<(f64, f64)>| {
            cell(compared.map(|(_, ratio)| aims[place].judge(ratio >= LIMITS[place])))
        };
        let reached = [judge(0, before), judge(1, without)];
        table.scene(
            &row.label,
            &[
                &shown(row.time.median),
                &columns(before),
                &reached[0],
                &columns(now),
                &columns(without),
                &reached[1],
                &size(row),
                &error(row, exponent),
            ],
        );
    }
    writeln!(
        text,
        "**Both limits to 1e-{USUAL}.** The aims are {} times the speed of the earlier searches, and {} times the speed of limits without search.  {} and {} rows miss these aims.\n\n{table}",
        LIMITS[0], LIMITS[1], aims[0], aims[1],
    )
}

fn contact(rows: &[Row], text: &mut String) -> Written {
    let mut table = Table::of_scenes(
        "table | before | ratio | reached | exact now | ratio | bytes | pieces | comparisons | error",
    );
    for (row, exponent) in tables(rows, Method::Contact) {
        let before = over(rows, row, By::Before, Method::Contact);
        let aimed = row.label.masses == 5 && row.label.zeta > 0.0;
        let reached = before.filter(|_| aimed);
        table.scene(
            &row.label,
            &[
                &shown(row.time.median),
                &columns(before),
                &cell(reached.map(|(_, ratio)| verdict(ratio >= CONTACT))),
                &columns(over(rows, row, By::Double, Method::Contact)),
                &size(row),
                &error(row, exponent),
            ],
        );
    }
    writeln!(
        text,
        "**The contact's amplitude to 1e-{USUAL}.** The times include the check that the motion is continuous.  The aim, for five damped masses only, is {CONTACT} times the speed of the earlier searches.\n\n{table}"
    )
}

fn typical(rows: &[Row], text: &mut String) -> Written {
    let chosen = |name: &str, zeta: f64| {
        let limits = tables(rows, Method::Limits);
        limits
            .filter(|(row, _)| row.label.name == name && row.label.zeta == zeta)
            .collect::<Vec<_>>()
    };
    let scenes: Vec<_> = TYPICAL
        .iter()
        .map(|(name, zeta)| (*name, *zeta, chosen(name, *zeta)))
        .filter(|(_, _, rows)| !rows.is_empty())
        .collect();
    let mut head = String::from("accuracy");
    for (name, zeta, _) in &scenes {
        let damping = if *zeta > 0.0 { "damped" } else { "undamped" };
        write!(head, " | {name} {damping}")?;
    }
    let mut table = Table::new(&head);
    for choice in CHOICES {
        let mut cells = vec![format!("1e-{choice}")];
        cells.extend(scenes.iter().map(|(_, _, rows)| {
            let found = rows.iter().find(|(_, exponent)| *exponent == choice);
            cell(found.and_then(|(row, exponent)| {
                let bytes = row.table?.bytes;
                let (time, error) = (shown(row.time.median), error(row, *exponent));
                Some(format!("{bytes} B, {time}, {error}"))
            }))
        }));
        table.row(&[&cells.join(" | ")]);
    }
    writeln!(
        text,
        "**Four typical scenes.** The table helps to choose an accuracy.  A cell has the bytes, the time of both limits and the largest error.\n\n{table}"
    )
}

fn others(rows: &[Row], text: &mut String) -> Written {
    let mut table = Table::of_scenes(
        "accuracy | table | before | ratio | exact now | ratio | bytes | pieces | comparisons | error",
    );
    for (row, exponent) in tables(rows, Method::Limits).filter(|(_, e)| *e != USUAL) {
        table.scene(
            &row.label,
            &[
                &format!("1e-{exponent}"),
                &shown(row.time.median),
                &columns(over(rows, row, By::Before, Method::Limits)),
                &columns(over(rows, row, By::Double, Method::Limits)),
                &size(row),
                &error(row, exponent),
            ],
        );
    }
    writeln!(
        text,
        "**The other accuracies.** The table is for both limits.  `System::compile` made the tables of 1e-12 at run time.  Some scenes have no table of this accuracy.\n\n{table}"
    )
}

fn refused(refused: &[Refused], text: &mut String) -> Written {
    if refused.is_empty() {
        return Ok(());
    }
    text.push_str("No table of 1e-12 exists, and the macro says so, in");
    for (place, scene) in refused.iter().enumerate() {
        let comma = if place > 0 { "," } else { "" };
        let reached = scene
            .reached
            .map_or(String::new(), |reached| format!("; {reached:e} can be had"));
        write!(
            text,
            "{comma} {} with ζ = {} (at r = {:.4}{reached})",
            scene.label.name, scene.label.zeta, scene.at,
        )?;
    }
    text.push_str(".\n\n");
    Ok(())
}
