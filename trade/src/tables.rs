//! Formats the rows of the measurement as text.

use crate::measure::{By, Row};
use crate::methods::Method;
use crate::points::Errors;
use std::fmt::Write;

/// Returns every row of the measurement as a line of CSV.
pub fn csv(rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "scene,masses,zeta,by,answer,median ns,least ns,operations,rounding p99,rounding worst,usual error p99,error p99,error worst,points,without answer,table bytes,pieces,comparisons\n",
    );
    for row in rows {
        writeln!(
            text,
            "{},{},{},{},\"{}\",{:.1},{:.1},{},{},{},{},{},{},{},{},{}",
            row.label.name,
            row.label.masses,
            row.label.zeta,
            row.by.name(),
            row.method.name(),
            row.time.median,
            row.time.least,
            row.operations
                .map_or(String::new(), |count| count.total.to_string()),
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

/// Rows of the measurement with the same method, quantity and number of masses, combined.
pub struct Pool {
    /// Number of masses.
    pub masses: usize,
    /// Method that computes the quantity.
    pub by: By,
    /// Quantity that is computed.
    pub method: Method,
    /// Median over the scenes of their median times, in ns.
    pub time: f64,
    /// Relative errors of all scenes against the exact value, at usual points.
    pub usual: Errors,
    /// Relative errors of all scenes against the exact value, at all points.
    pub error: Errors,
    /// Smallest and largest number of operations over the scenes. `None` if it is not known.
    pub operations: Option<(usize, usize)>,
}

/// Combines the rows of the measurement into pools. The rows of the earlier searches have no errors and are left out.
pub fn pools(rows: &[Row]) -> Vec<Pool> {
    let key = |row: &Row| (row.label.masses, row.method, row.by);
    let judged = rows.iter().filter(|row| row.by != By::Before);
    let mut keys: Vec<_> = judged.map(key).collect();
    keys.sort();
    keys.dedup();
    let pool = |wanted: (usize, Method, By)| {
        let same: Vec<&Row> = rows.iter().filter(|row| key(row) == wanted).collect();
        let mut times: Vec<f64> = same.iter().map(|row| row.time.median).collect();
        times.sort_by(f64::total_cmp);
        let (mut usual, mut error) = (Errors::default(), Errors::default());
        for row in &same {
            usual.and(&row.usual);
            error.and(&row.error);
        }
        let counts = || same.iter().filter_map(|row| Some(row.operations?.total));
        Pool {
            masses: wanted.0,
            method: wanted.1,
            by: wanted.2,
            time: times[times.len() / 2],
            usual,
            error,
            operations: counts().min().zip(counts().max()),
        }
    };
    keys.into_iter().map(pool).collect()
}
