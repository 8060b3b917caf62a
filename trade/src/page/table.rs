//! Tables in Markdown.

use crate::scenes::Label;
use std::fmt::{self, Display};

/// A Markdown table.
pub struct Table(String);

impl Table {
    /// Creates a Markdown table without rows. `columns` gives the names of the columns, separated by bars.
    pub fn new(columns: &str) -> Self {
        let rule = "|---".repeat(1 + columns.matches('|').count());
        Self(format!("| {columns} |\n{rule}|\n"))
    }

    /// Creates a Markdown table whose rows begin with the name and the damping of a scene. `columns` gives the names
    /// of the other columns.
    pub fn of_scenes(columns: &str) -> Self {
        Self::new(&format!("scene | ζ | {columns}"))
    }

    /// Adds a row to the table. A bar within a cell splits it into two cells.
    pub fn row(&mut self, cells: &[&dyn Display]) {
        self.0.extend(cells.iter().map(|cell| format!("| {cell} ")));
        self.0.push_str("|\n");
    }

    /// Adds a row to the table that begins with the name and the damping of a scene.
    pub fn scene(&mut self, label: &Label, cells: &[&dyn Display]) {
        let scene: [&dyn Display; 2] = [&label.name, &label.zeta];
        self.row(&[&scene, cells].concat());
    }
}

impl Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Counts the results that have an aim, and those that missed their aim.
#[derive(Default)]
pub struct Tally {
    all: usize,
    missed: usize,
}

impl Tally {
    /// Counts a result, and returns the text that says whether it reached its aim.
    pub fn judge(&mut self, reached: bool) -> &'static str {
        self.all += 1;
        self.missed += usize::from(!reached);
        verdict(reached)
    }
}

impl Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.missed, self.all)
    }
}

/// Returns the text that says whether an aim is reached.
pub fn verdict(reached: bool) -> &'static str {
    if reached { "yes" } else { "**missed**" }
}

/// Formats a number, or an empty cell for `None`.
pub fn cell(value: Option<impl Display>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::{Table, Tally};

    #[test]
    fn rows_and_misses() {
        let mut table = Table::new("a | b");
        let mut tally = Tally::default();
        table.row(&[&1.5, &tally.judge(true)]);
        table.row(&[&"x", &tally.judge(false)]);
        let rows = "| a | b |\n|---|---|\n| 1.5 | yes |\n| x | **missed** |\n";
        assert_eq!(table.to_string(), rows);
        assert_eq!(tally.to_string(), "1 of 2");
    }
}
