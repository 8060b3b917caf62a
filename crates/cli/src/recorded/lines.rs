//! Table of a result, with one quantity in each line. The line contains the value with its interval, and the unit.

use crate::failure::Failure;
use crate::output::{ResultTable, Visitor};
use frictiongen::System;
use frictiongen::measure::columns::{QuantityLine, line_columns};
use frictiongen::study::columns::Column;
use serde_json::Value as Json;

/// The quantities of a result, and the texts that the output has before the quantities.
pub struct ResultLines<'a> {
    /// The system that the result describes.
    pub system: &'a System,
    /// The quantities of the result, one for each line.
    pub lines: Vec<QuantityLine>,
    /// Titles and texts of the lines before the quantities.
    pub said: Vec<(&'static str, String)>,
    /// Names and texts that only the JSON output contains, in addition to the titles and texts in `said`.
    pub keys: Vec<(&'static str, &'static str)>,
}

impl ResultTable for ResultLines<'_> {
    type Row = QuantityLine;

    fn len(&self) -> usize {
        self.lines.len()
    }

    fn each(&self, visit: Visitor<'_, QuantityLine>) -> Result<(), Failure> {
        self.lines.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, QuantityLine>> {
        line_columns(self.system, &self.lines)
    }

    fn head(&self) -> Vec<(String, Json)> {
        let said = self.said.iter();
        let said = said.map(|(title, text)| ((*title).to_owned(), Json::from(text.as_str())));
        let keys = self.keys.iter();
        let keys = keys.map(|(name, key)| ((*name).to_owned(), Json::from(*key)));
        said.chain(keys).collect()
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        self.said.clone()
    }
}
