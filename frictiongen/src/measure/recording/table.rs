//! A table of numbers from a file, and the information for reading it that the file does not contain.

use super::unit::Unit;

/// Information for reading a CSV file that the file itself does not contain, such as the sampling rate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CsvRequest {
    /// Sampling rate, in samples per second. It is necessary if no column contains the time.
    pub rate: Option<f64>,
    /// The columns to read, with their meaning. If the list is empty, the reader takes every column, with its name in
    /// the file.
    pub columns: Vec<CsvColumn>,
}

/// A column to read, and the signal that the column contains.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvColumn {
    /// Name of the signal: `base`, `force`, the name of a mass, or `time`.
    pub name: String,
    /// Name of the column in the file, or its number from 1.
    pub column: String,
    /// Unit of the column. If it is `None`, the column's name in the file must contain the unit.
    pub unit: Option<Unit>,
}

/// A table of numbers from a file, with a name for each column.
#[derive(Debug)]
pub(crate) struct CsvTable {
    pub(crate) names: Vec<String>,
    /// Line number of each row in the file, counted from 1.
    pub(crate) lines: Vec<usize>,
    /// Cells of each row of the file. An empty cell is `None`.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
}

/// Parses a finite number. If `comma` is true, the number may have a decimal comma.
pub(super) fn number(cell: &str, comma: bool) -> Option<f64> {
    let point = || cell.replacen(',', ".", 1);
    let parsed = cell.parse().ok();
    let parsed = parsed.or_else(|| comma.then(point)?.parse().ok());
    parsed.filter(|value: &f64| value.is_finite())
}
