//! The figures as text.

use crate::measure::Row;
use std::fmt::Write;

/// Every row.
pub fn csv(rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "scene,masses,zeta,by,answer,median ns,least ns,operations,rounding p99,rounding worst,error p99,error worst,points,without answer\n",
    );
    for row in rows {
        writeln!(
            text,
            "{},{},{},{},\"{}\",{:.1},{:.1},{},{:.2e},{:.2e},{:.2e},{:.2e},{},{}",
            row.label.name,
            row.label.masses,
            row.label.zeta,
            row.by.name(),
            row.method.name(),
            row.time.median,
            row.time.least,
            row.operations.map_or(String::new(), |count| count.to_string()),
            row.rounding.percentile(),
            row.rounding.worst(),
            row.error.percentile(),
            row.error.worst(),
            row.error.sorted.len() + row.error.none,
            row.error.none,
        )?;
    }
    Ok(text)
}
