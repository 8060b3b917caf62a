//! Writes CSV. No value holds a comma or a quote: words are regimes, answers and Rust identifiers.

use crate::number::Value;
use std::io::{self, Write};

/// The line that names the columns.
pub fn header(out: &mut dyn Write, names: &[String]) -> io::Result<()> {
    writeln!(out, "{}", names.join(","))
}

/// A line of values.
pub fn row(out: &mut dyn Write, values: &[Value<'_>]) -> io::Result<()> {
    for (index, value) in values.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}{}", value.exact())?;
    }
    writeln!(out)
}
