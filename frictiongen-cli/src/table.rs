//! Writes tables for people, with aligned columns and decimal points.

use crate::number::{Value, computed, decimals, given, word};
use std::io::{self, Write};

/// The format of a column's values.
#[derive(Clone, Copy, Debug)]
enum Style {
    /// Words, aligned left.
    Words,
    /// Numbers given by the user, with this number of decimals.
    Given(usize),
    /// Counts.
    Counts,
    /// Computed numbers.
    Computed,
}

/// A column with its title, format and width.
#[derive(Clone, Debug)]
pub struct Column {
    title: Vec<String>,
    style: Style,
    width: usize,
}

/// Width of most computed numbers, such as -1234.567891 or -1.23457e-10.
const COMPUTED_WIDTH: usize = 12;

impl Column {
    fn new(title: &[&str], style: Style, width: usize) -> Self {
        let title: Vec<String> = title.iter().map(|line| (*line).to_owned()).collect();
        let widest = title.iter().map(|line| line.chars().count()).max();
        Self {
            width: width.max(widest.unwrap_or(0)),
            title,
            style,
        }
    }

    /// Makes a column of words.
    pub fn words<'a>(title: &[&str], words: impl IntoIterator<Item = &'a str>) -> Self {
        let widest = words.into_iter().map(|word| word.chars().count()).max();
        Self::new(title, Style::Words, widest.unwrap_or(0))
    }

    /// Makes a column for the numbers of a grid.
    pub fn given(title: &[&str], grid: &[f64]) -> Self {
        let most = grid.iter().map(|value| decimals(*value)).max().unwrap_or(0);
        let widest = grid.iter().map(|value| given(*value, most).len()).max();
        Self::new(title, Style::Given(most), widest.unwrap_or(0))
    }

    /// Makes a column of counts.
    pub fn counts(title: &[&str]) -> Self {
        Self::new(title, Style::Counts, 1)
    }

    /// Makes a column of computed numbers.
    pub fn computed(title: &[&str]) -> Self {
        Self::new(title, Style::Computed, COMPUTED_WIDTH)
    }

    fn text(&self, value: &Value<'_>) -> String {
        match (value, self.style) {
            (Value::Number(value), Style::Given(decimals)) => given(*value, decimals),
            (Value::Number(value), _) => computed(*value),
            (Value::Count(value), _) => value.to_string(),
            (Value::Text(text), _) => (*text).to_owned(),
            (Value::Owned(text), _) => text.clone(),
            (Value::Flag(value), _) => word(*value).to_owned(),
            (Value::Missing, _) => String::new(),
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

/// Writes the column titles and a rule below them.
pub fn header(out: &mut dyn Write, columns: &[Column]) -> io::Result<()> {
    let lines = columns.iter().map(|column| column.title.len()).max();
    for line in 0..lines.unwrap_or(0) {
        let titles = columns
            .iter()
            .map(|column| column.pad(column.title.get(line).map_or("", String::as_str)));
        write_line(out, titles)?;
    }
    write_line(out, columns.iter().map(|column| "-".repeat(column.width)))
}

/// Writes a line of values.
pub fn row(out: &mut dyn Write, columns: &[Column], values: &[Value<'_>]) -> io::Result<()> {
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
