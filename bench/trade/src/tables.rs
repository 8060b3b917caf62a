//! Formats the measurements as CSV.

use crate::measure::Row;
use crate::tails::Tail;
use std::fmt::Write;

/// Returns every row of the measurement as a line of CSV.
pub fn calls(rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "scene,masses,zeta,by,answer,median ns,least ns,rounding p99,rounding worst,usual error p99,error p99,error worst,points,without answer,table bytes,pieces,comparisons\n",
    );
    for row in rows {
        writeln!(
            text,
            "{},{},{},{},\"{}\",{:.1},{:.1},{},{},{},{},{},{},{},{}",
            row.label.name,
            row.label.masses,
            row.label.zeta,
            row.by.name(),
            row.method.name(),
            row.time.median,
            row.time.least,
            figure(row.rounding.percentile()),
            figure(row.rounding.worst()),
            figure(row.usual.percentile()),
            figure(row.error.percentile()),
            figure(row.error.worst()),
            row.error.sorted.len() + row.error.none,
            row.error.none,
            row.table.map_or(",,".to_owned(), |table| format!(
                "{},{},{}",
                table.bytes, table.pieces, table.comparisons
            )),
        )?;
    }
    Ok(text)
}

/// Formats an error. Without an error (NaN) the text is empty.
fn figure(error: f64) -> String {
    if error.is_nan() {
        String::new()
    } else {
        format!("{error:.2e}")
    }
}

/// Returns the distribution of the times of single calls as CSV, one line for each scene.
pub fn slow(tails: &[Tail]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "scene,zeta,points,median ns,99 % ns,99.9 % ns,slowest ns,slowest r,most evaluations,searches at their bound\n",
    );
    for tail in tails {
        writeln!(
            text,
            "{},{},{},{:.0},{:.0},{:.0},{:.0},{:.4},{},{}",
            tail.label.name,
            tail.label.zeta,
            tail.points,
            tail.median,
            tail.hundredth,
            tail.thousandth,
            tail.slowest,
            tail.r,
            tail.evaluations,
            tail.exceeded,
        )?;
    }
    Ok(text)
}
