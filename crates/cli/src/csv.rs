//! Writes tables as CSV. The words in the cells are regimes, kinds of results and Rust identifiers, so no cell contains
//! a comma or a quote.

use std::borrow::Cow;
use std::io::{self, Write};

/// Writes one line of a CSV table. Commas separate its cells.
pub fn line<'a>(out: &mut dyn Write, cells: impl Iterator<Item = Cow<'a, str>>) -> io::Result<()> {
    for (index, cell) in cells.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}{cell}")?;
    }
    writeln!(out)
}
