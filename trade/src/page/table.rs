//! Tables in Markdown.

use crate::scenes::Label;
use std::fmt::{self, Display};

/// A table.
pub struct Table(String);

impl Table {
    /// A table without rows; bars stand between the names of its columns.
    pub fn new(columns: &str) -> Self {
        let rule = "|---".repeat(1 + columns.matches('|').count());
        Self(format!("| {columns} |\n{rule}|\n"))
    }

    /// A table whose rows begin with a scene's name and damping.
    pub fn of_scenes(columns: &str) -> Self {
        Self::new(&format!("scene | ζ | {columns}"))
    }

    /// Adds a row; a bar within parts a cell in two.
    pub fn row(&mut self, cells: &[&dyn Display]) {
        self.0.extend(cells.iter().map(|cell| format!("| {cell} ")));
        self.0.push_str("|\n");
    }

    /// Adds a row of a scene.
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

/// How many were held to an aim, and how many of them missed it.
#[derive(Default)]
pub struct Tally {
    all: usize,
    missed: usize,
}

impl Tally {
    /// Counts one, and says whether the aim is reached.
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

/// Whether an aim is reached, as the tables say it.
pub fn verdict(reached: bool) -> &'static str {
    if reached { "yes" } else { "**missed**" }
}

/// A number, or an empty cell.
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
