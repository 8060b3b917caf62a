//! Writes the results of a command, point by point, in the requested format.

use crate::destination::Form;
use crate::failure::Failure;
use crate::layout::Layout;
use crate::number::{Cell, Exact as _};
use crate::progress::Progress;
use crate::summary::Summary;
use crate::table::Column;
use crate::{csv, json, table};
use frictiongen::study::columns;
use std::io::{BufWriter, Write};

/// Results of a command, and the way a point is written.
pub trait Report {
    /// The type of a point.
    type Point;

    /// Returns the number of points.
    fn len(&self) -> usize;
    /// Computes the points in order until the visitor fails.
    fn each(&self, visit: Visitor<'_, Self::Point>) -> Result<(), Failure>;
    /// Returns the columns of the table.
    fn columns(&self) -> Vec<Column>;
    /// Returns the lines of a point in the table.
    fn rows<'a>(&'a self, point: &'a Self::Point) -> Vec<Vec<Cell<'a>>>;
    /// Returns the names of the CSV columns.
    fn names(&self) -> Vec<String>;
    /// Returns the line of a point in the CSV.
    fn record<'a>(&'a self, point: &'a Self::Point) -> Vec<Cell<'a>>;
    /// Returns the fields that the JSON has once, after the scene.
    fn head(&self) -> Vec<(String, serde_json::Value)> {
        Vec::new()
    }
    /// Returns the lines that a table has once, after the scene, each as a title and a text.
    fn preamble(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }
    /// Returns a point as JSON.
    fn json(&self, point: &Self::Point) -> serde_json::Value;
}

/// Function that receives the points.
pub type Visitor<'a, P> = &'a mut dyn FnMut(&P) -> Result<(), Failure>;

/// Rows of a table of the library, and the way they are written.
pub trait Table {
    /// The type of a row.
    type Row;

    /// Returns the number of rows.
    fn len(&self) -> usize;
    /// Computes the rows in order until the visitor fails.
    fn each(&self, visit: Visitor<'_, Self::Row>) -> Result<(), Failure>;
    /// Returns the columns.
    fn columns(&self) -> Vec<columns::Column<'_, Self::Row>>;
    /// Returns the arrangement of the motions.
    fn layout(&self) -> Layout {
        Layout::Flat
    }
    /// Returns whether the JSON of a row has motions and lists.
    fn has_motions(&self, _row: &Self::Row) -> bool {
        true
    }
    /// Returns the fields that the JSON has once, after the scene.
    fn head(&self) -> Vec<(String, serde_json::Value)> {
        Vec::new()
    }
    /// Returns the lines that a table for people has once, after the scene, each as a title and a text.
    fn preamble(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }
    /// Returns a further field of a row's JSON.
    fn more(&self, _row: &Self::Row) -> Option<(&'static str, serde_json::Value)> {
        None
    }
    /// Returns the lines of a row in a table for people.
    fn lines<'r>(
        &self,
        columns: &'r [columns::Column<'_, Self::Row>],
        row: &'r Self::Row,
    ) -> Vec<Vec<Cell<'r>>> {
        self.layout().lines(columns, row)
    }
}

/// Writes a table.
pub fn write<T: Table>(
    report: &T,
    summary: &Summary,
    form: Form,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    let mut progress = Progress::new(report.len(), "points");
    let (columns, layout) = (report.columns(), report.layout());
    if form == Form::Json {
        let mut writer = json::Writer::begin(&mut out, summary, &report.head())?;
        report.each(&mut |row| {
            progress.step();
            let motions = report.has_motions(row);
            let mut point = layout.json(&columns, row, motions);
            if let (Some((name, value)), Some(fields)) = (report.more(row), point.as_object_mut()) {
                fields.insert(name.to_owned(), value);
            }
            Ok(writer.point(&point)?)
        })?;
        writer.end()?;
    } else if let Form::Csv(extras) = form {
        if extras.comments {
            summary.comment(&mut out, &report.preamble())?;
        }
        let shown = || columns.iter().filter(|column| column.is_in_csv());
        let names: Vec<String> = shown().map(columns::Column::key).collect();
        csv::line(&mut out, names.iter().map(|name| name.into()))?;
        if extras.unit_row {
            csv::line(&mut out, shown().map(|column| column.unit.into()))?;
        }
        report.each(&mut |row| {
            progress.step();
            let cells = shown().map(|column| column.read(row));
            let cells: Vec<Cell<'_>> = cells.collect();
            Ok(csv::line(&mut out, cells.iter().map(Cell::exact))?)
        })?;
    } else {
        summary.write(&mut out, &report.preamble())?;
        let titles = layout.titles(&columns);
        table::header(&mut out, &titles)?;
        report.each(&mut |row| {
            progress.step();
            for line in report.lines(&columns, row) {
                table::row(&mut out, &titles, &line)?;
            }
            Ok(())
        })?;
    }
    drop(progress);
    Ok(out.flush()?)
}

/// Writes a report.
pub fn print<R: Report>(
    report: &R,
    summary: &Summary,
    form: Form,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    let mut progress = Progress::new(report.len(), "points");
    if form == Form::Json {
        let mut writer = json::Writer::begin(&mut out, summary, &report.head())?;
        report.each(&mut |point| {
            progress.step();
            Ok(writer.point(&report.json(point))?)
        })?;
        writer.end()?;
    } else if let Form::Csv(extras) = form {
        if extras.comments {
            summary.comment(&mut out, &report.preamble())?;
        }
        csv::header(&mut out, &report.names(), extras.unit_row)?;
        report.each(&mut |point| {
            progress.step();
            Ok(csv::row(&mut out, &report.record(point))?)
        })?;
    } else {
        summary.write(&mut out, &report.preamble())?;
        let columns = report.columns();
        table::header(&mut out, &columns)?;
        report.each(&mut |point| {
            progress.step();
            for row in report.rows(point) {
                table::row(&mut out, &columns, &row)?;
            }
            Ok(())
        })?;
    }
    drop(progress);
    Ok(out.flush()?)
}
