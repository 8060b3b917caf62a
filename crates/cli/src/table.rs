//! Writes printed tables. Columns are aligned at the decimal points.

use crate::number::{Cell, computed, decimals, given, within, word};
use frictiongen::study::columns::{self, ColumnKind};
use std::io::{self, Write};

/// The format of the values in a column of a printed table.
#[derive(Clone, Copy, Debug)]
enum Style {
    /// The column contains words, aligned left.
    Words,
    /// The column contains numbers that the user gave. The field is the number of decimals.
    Given(usize),
    /// The column contains counts, without decimals.
    Counts,
    /// The column contains computed numbers, with six decimals or six digits.
    Computed,
}

/// A column of a printed table, with its title, format and width.
#[derive(Clone, Debug)]
pub struct PrintedColumn {
    title: Vec<String>,
    style: Style,
    width: usize,
}

/// Width of most computed numbers in characters, such as -1234.567891 or -1.23457e-10.
const COMPUTED_WIDTH: usize = 12;

impl PrintedColumn {
    fn new(title: &[&str], style: Style, width: usize) -> Self {
        let title: Vec<String> = title.iter().map(|line| (*line).to_owned()).collect();
        let widest = title.iter().map(|line| line.chars().count()).max();
        Self {
            width: width.max(widest.unwrap_or(0)),
            title,
            style,
        }
    }

    /// Creates a column of words for a printed table.
    pub fn words<'a>(title: &[&str], words: impl IntoIterator<Item = &'a str>) -> Self {
        let widest = words.into_iter().map(|word| word.chars().count()).max();
        Self::new(title, Style::Words, widest.unwrap_or(0))
    }

    /// Returns a column for the numbers of a grid, which the user gave.
    pub fn given(title: &[&str], grid: &[f64]) -> Self {
        let most = grid.iter().map(|value| decimals(*value)).max().unwrap_or(0);
        let widest = grid.iter().map(|value| given(*value, most).len()).max();
        Self::new(title, Style::Given(most), widest.unwrap_or(0))
    }

    /// Creates a column of counts for a printed table.
    pub fn counts(title: &[&str]) -> Self {
        Self::new(title, Style::Counts, 1)
    }

    /// Creates a column of computed numbers for a printed table.
    pub fn computed(title: &[&str]) -> Self {
        Self::new(title, Style::Computed, COMPUTED_WIDTH)
    }

    /// Returns the printed column that shows a column of the library, with the heading `title`.
    pub fn of<R>(column: &columns::Column<'_, R>, title: &[&str]) -> Self {
        match column.kind {
            ColumnKind::Given(grid) => Self::given(title, grid),
            ColumnKind::Count => Self::counts(title),
            ColumnKind::Word(widest) => Self::new(title, Style::Words, widest),
            ColumnKind::Flag => Self::words(title, [word(false)]),
            ColumnKind::Number | ColumnKind::Complex | ColumnKind::Intervals => {
                Self::computed(title)
            }
        }
    }

    /// Returns the width of the column in characters.
    pub fn width(&self) -> usize {
        self.width
    }

    fn text(&self, value: &Cell<'_>) -> String {
        match (value, self.style) {
            (Cell::Number(value), Style::Given(decimals)) => given(*value, decimals),
            (Cell::Number(value), _) => computed(*value),
            (Cell::Within { value, width }, _) => within(*value, *width),
            (Cell::Count(value), _) => value.to_string(),
            (Cell::Word(text), _) => text.clone().into_owned(),
            (Cell::Flag(value), _) => word(*value).to_owned(),
            (Cell::Pairs(_) | Cell::Missing, _) => String::new(),
        }
    }

    fn pad(&self, text: &str) -> String {
        let width = self.width;
        match self.style {
            Style::Words => format!("{text:<width$}"),
            Style::Given(_) | Style::Counts | Style::Computed => format!("{text:>width$}"),
        }
    }
}

/// Writes the column titles and a rule under them.
pub fn header(out: &mut dyn Write, columns: &[PrintedColumn]) -> io::Result<()> {
    let lines = columns.iter().map(|column| column.title.len()).max();
    for line in 0..lines.unwrap_or(0) {
        let titles = columns
            .iter()
            .map(|column| column.pad(column.title.get(line).map_or("", String::as_str)));
        write_line(out, titles)?;
    }
    write_line(out, columns.iter().map(|column| "-".repeat(column.width)))
}

/// Writes one line of values of a printed table.
pub fn row(out: &mut dyn Write, columns: &[PrintedColumn], values: &[Cell<'_>]) -> io::Result<()> {
    let cells = columns.iter().zip(values);
    write_line(
        out,
        cells.map(|(column, value)| column.pad(&column.text(value))),
    )
}

fn write_line(out: &mut dyn Write, cells: impl Iterator<Item = String>) -> io::Result<()> {
    let line = cells.collect::<Vec<_>>().join("  ");
    writeln!(out, "{}", line.trim_end())
}
