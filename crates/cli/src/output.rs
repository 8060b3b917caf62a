//! Writes the results of a command in the requested format, point by point.

use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::fit::TableLayout;
use crate::layout::Layout;
use crate::number::{Cell, Lossless as _};
use crate::progress::Progress;
use crate::summary::Summary;
use crate::{json, table};
use frictiongen::study::columns::Column;
use std::borrow::Cow;
use std::io::{self, BufWriter, Write};

/// Largest number of notes below a printed table.
const MOST_NOTES: usize = 3;

/// Function that receives the rows of a table, one after the other.
pub type Visitor<'a, P> = &'a mut dyn FnMut(&P) -> Result<(), Failure>;

/// A table of results: its rows and columns, and their layout.
pub trait ResultTable {
    /// Type of a row in the table.
    type Row;

    /// Returns the number of rows in the table.
    fn len(&self) -> usize;
    /// Computes the rows in order, and passes each to `visit` until `visit` fails.
    fn each(&self, visit: Visitor<'_, Self::Row>) -> Result<(), Failure>;
    /// Returns the columns of the table, from left to right.
    fn columns(&self) -> Vec<Column<'_, Self::Row>>;
    /// Returns the layout, which arranges the motions of the contact and masses in text and in JSON.
    fn layout(&self) -> Layout {
        Layout::Flat
    }
    /// Returns true if the JSON object of this row contains motions of the contact and masses, and lists.
    fn has_motions(&self, _row: &Self::Row) -> bool {
        true
    }
    /// Returns the fields, by name, that the JSON output contains once, after the fields of the scene.
    fn head(&self) -> Vec<(String, serde_json::Value)> {
        Vec::new()
    }
    /// Returns the lines of a printed table that come after the lines of the scene and before the rows. Each line has a
    /// title and a text.
    fn preamble(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }
    /// Returns the name and the value of an additional JSON field for a row, or `None`.
    fn more(&self, _row: &Self::Row) -> Option<(&'static str, serde_json::Value)> {
        None
    }
    /// Returns the name of the list of rows in JSON.
    fn list(&self) -> &'static str {
        "points"
    }
    /// Returns the name and the text of a remark that follows the rows in JSON and in a printed table.
    fn tail(&self) -> Option<(&'static str, String)> {
        None
    }
    /// Returns a note on a row, which a printed table contains below its rows, or `None`.
    fn note(&self, _row: &Self::Row) -> Option<String> {
        None
    }
    /// Returns the lines of the printed table for one row.
    fn lines<'r>(
        &self,
        columns: &'r [Column<'_, Self::Row>],
        row: &'r Self::Row,
    ) -> Vec<Vec<Cell<'r>>> {
        self.layout().lines(columns, row)
    }
}

/// Writes a table of results in the requested format.
pub fn write<T: ResultTable>(
    report: &T,
    summary: &Summary,
    form: OutputFormat,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    let mut progress = Progress::new(report.len(), "points");
    let (columns, layout) = (report.columns(), report.layout());
    if form == OutputFormat::Json {
        let mut writer =
            json::JsonWriter::begin(&mut out, summary, (&report.head(), report.list()))?;
        report.each(&mut |row| {
            progress.step();
            let motions = report.has_motions(row);
            let mut point = layout.json(&columns, row, motions);
            if let (Some((name, value)), Some(fields)) = (report.more(row), point.as_object_mut()) {
                fields.insert(name.to_owned(), value);
            }
            Ok(writer.point(&point)?)
        })?;
        writer.end(report.tail())?;
    } else if let OutputFormat::Csv(extras) = form {
        if extras.comments {
            summary.comment(&mut out, &report.preamble())?;
        }
        let shown = || columns.iter().filter(|column| column.is_in_csv());
        let names: Vec<String> = shown().map(Column::key).collect();
        csv_line(&mut out, names.iter().map(|name| name.into()))?;
        if extras.unit_row {
            csv_line(&mut out, shown().map(|column| column.unit.into()))?;
        }
        report.each(&mut |row| {
            progress.step();
            let cells = shown().map(|column| column.read(row));
            let cells: Vec<Cell<'_>> = cells.collect();
            Ok(csv_line(&mut out, cells.iter().map(Cell::exact))?)
        })?;
    } else {
        let fit = match form {
            OutputFormat::Table(fit) => fit,
            _ => TableLayout::of_output(false),
        };
        let mut head = Vec::new();
        summary.write(&mut head, &report.preamble())?;
        fit.wrapped(&String::from_utf8_lossy(&head), &mut out)?;
        let (columns, left) = fit.chosen(columns, layout);
        let titles = layout.titles(&columns);
        table::header(&mut out, &titles)?;
        let (mut notes, mut more) = (Vec::new(), 0);
        report.each(&mut |row| {
            progress.step();
            for line in report.lines(&columns, row) {
                table::row(&mut out, &titles, &line)?;
            }
            match report.note(row) {
                Some(note) if notes.len() < MOST_NOTES => notes.push(note),
                note => more += usize::from(note.is_some()),
            }
            Ok(())
        })?;
        if more > 0 {
            notes.push(format!("{more} more lines have a note of this kind."));
        }
        notes.extend(report.tail().map(|(_, text)| text));
        for note in notes {
            fit.wrapped(&format!("\n{note}\n"), &mut out)?;
        }
        fit.note(&left, &mut out)?;
    }
    drop(progress);
    Ok(out.flush()?)
}

/// Writes one line of a CSV table. Commas separate its cells. The words in the cells are regimes, kinds of results and
/// Rust identifiers, so no cell contains a comma or a quote.
fn csv_line<'a>(out: &mut dyn Write, cells: impl Iterator<Item = Cow<'a, str>>) -> io::Result<()> {
    for (index, cell) in cells.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}{cell}")?;
    }
    writeln!(out)
}
