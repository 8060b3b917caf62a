//! Collects the columns of a table. Each call of a method adds one column.

use super::cell::Cell;
use super::column::{Column, ColumnAxis, ColumnKind, Head, ReadCell, Shown, TableRow};
use super::measure::{Measure, PhysicalQuantity};
use super::setting::MovingPart;
use crate::Of;
use crate::study::features::Sensed;

/// The columns of a table, from left to right.
pub struct Columns<'a, R> {
    measure: Measure,
    part: Option<String>,
    is_contact: bool,
    order: Option<u32>,
    axis: ColumnAxis,
    shown: Shown,
    all: Vec<Column<'a, R>>,
}

impl<'a, R: TableRow + 'a> Columns<'a, R> {
    /// Creates an empty list of columns. Their numbers will be in the units of `measure`.
    #[must_use]
    pub fn new(measure: &Measure) -> Self {
        Self {
            measure: *measure,
            part: None,
            is_contact: false,
            order: None,
            axis: ColumnAxis::Row,
            shown: Shown::Everywhere,
            all: Vec::new(),
        }
    }

    /// Returns the system of units of the columns.
    #[must_use]
    pub fn measure(&self) -> &Measure {
        &self.measure
    }

    /// Sets the mass to which all columns of later calls belong.
    pub fn begin_part(&mut self, part: &str) {
        self.part = Some(part.to_owned());
        self.is_contact = false;
        self.order = None;
    }

    /// Sets the contact to which all columns of later calls belong.
    pub fn begin_contact(&mut self, contact: &str) {
        self.begin_part(contact);
        self.is_contact = true;
    }

    /// Sets the contact, the mass or the combination to which all columns of later calls belong.
    pub fn begin_motion(&mut self, part: &MovingPart) {
        self.begin_part(&part.name);
        self.is_contact = part.of == Of::Contact && !part.has_rate();
    }

    /// Ends the columns of a contact or mass. The columns of later calls belong to the whole row.
    pub fn end_parts(&mut self) {
        self.part = None;
        self.order = None;
    }

    /// Sets the order of the harmonic for the columns of later calls.
    pub fn begin_harmonic(&mut self, order: u32) {
        self.order = Some(order);
    }

    /// Selects the outputs (text, CSV, JSON, Python) that contain the columns of later calls.
    pub fn show(&mut self, shown: Shown) {
        self.shown = shown;
    }

    /// Sets the variables on which the values of later columns depend: frequency, friction or both.
    pub fn along(&mut self, axis: ColumnAxis) {
        self.axis = axis;
    }

    /// Adds a column of numbers. `read` returns each number as a non-dimensional group. The column converts this number
    /// to the unit of the table.
    pub fn number(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<f64> + 'a) {
        let (head, measure) = (head.into(), self.measure);
        let dimension = head.dimension;
        let convert = move |row: &R| {
            let value = read(row)?;
            Some(measure.convert(dimension, value, row.omega()))
        };
        self.push(
            head,
            ColumnKind::Number,
            Box::new(move |row| convert(row).into()),
        );
    }

    /// Adds a column of numbers, each of which is known only to lie within an interval. `width` returns the width of
    /// the interval. `read` and `width` return non-dimensional groups. If the width is missing or 0, all digits of the
    /// number are valid.
    pub fn number_within(
        &mut self,
        head: impl Into<Head>,
        read: impl Fn(&R) -> Option<f64> + 'a,
        width: impl Fn(&R) -> Option<f64> + 'a,
    ) {
        let (head, measure) = (head.into(), self.measure);
        let dimension = head.dimension;
        let convert = move |row: &R, value: Option<f64>| {
            Some(measure.convert(dimension, value?, row.omega()))
        };
        self.push(
            head,
            ColumnKind::Number,
            Box::new(move |row| {
                let value = convert(row, read(row));
                match (value, convert(row, width(row))) {
                    (Some(value), Some(width)) if 0.0 < width => Cell::Within { value, width },
                    _ => value.into(),
                }
            }),
        );
    }

    /// Adds a column of numbers that `read` returns in the unit of the column.
    pub fn converted(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<f64> + 'a) {
        self.given(head, &[], read);
    }

    /// Adds a column of numbers that the user gave, in the unit of the column. `grid` contains all given numbers.
    pub fn given(
        &mut self,
        head: impl Into<Head>,
        grid: &'a [f64],
        read: impl Fn(&R) -> Option<f64> + 'a,
    ) {
        let kind = match grid {
            [] => ColumnKind::Number,
            grid => ColumnKind::Given(grid),
        };
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds a column that contains counts.
    pub fn count(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<usize> + 'a) {
        self.push(
            head.into(),
            ColumnKind::Count,
            Box::new(move |row| read(row).into()),
        );
    }

    /// Adds a column of words. `widest` is the longest of the usual words. A printed table makes the column as wide as
    /// this word.
    pub fn word(
        &mut self,
        head: impl Into<Head>,
        widest: &str,
        read: impl Fn(&R) -> Option<&str> + 'a,
    ) {
        let kind = ColumnKind::Word(widest.chars().count());
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds a column whose cells are true or false.
    pub fn flag(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<bool> + 'a) {
        self.push(
            head.into(),
            ColumnKind::Flag,
            Box::new(move |row| read(row).into()),
        );
    }

    /// Adds a column whose cells are lists of complex numbers or of intervals.
    pub fn list(
        &mut self,
        head: impl Into<Head>,
        kind: ColumnKind<'a>,
        read: impl Fn(&R) -> Option<Vec<[f64; 2]>> + 'a,
    ) {
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds a column. `read` returns each cell, which may be any variant of [`Cell`]: number, word, flag or list.
    pub fn cell(
        &mut self,
        head: impl Into<Head>,
        kind: ColumnKind<'a>,
        read: impl for<'r> Fn(&'r R) -> Cell<'r> + 'a,
    ) {
        self.push(head.into(), kind, Box::new(read));
    }

    /// Sets the function that returns the derivatives of the last column's values with respect to the parameters.
    pub fn moves(&mut self, of: impl Fn(&R) -> Option<&Sensed> + 'a) {
        self.moves_before(0, of);
    }

    /// Sets the function that returns the derivatives of an earlier column's values with respect to the parameters.
    /// `before` is the number of columns that were added after this earlier column.
    pub fn moves_before(&mut self, before: usize, of: impl Fn(&R) -> Option<&Sensed> + 'a) {
        if let Some(column) = self.all.iter_mut().rev().nth(before) {
            column.moves = Some(Box::new(of));
        }
    }

    /// Sets a condition for the last column. A text output with one line for each value prints the value of a row only
    /// if the condition is true for this row.
    pub fn say_if(&mut self, says: impl Fn(&R) -> bool + 'a) {
        if let Some(last) = self.all.last_mut() {
            last.says = Some(Box::new(says));
        }
    }

    fn push(&mut self, head: Head, kind: ColumnKind<'a>, read: ReadCell<'a, R>) {
        let name = match (head.under_load, self.measure.scale()) {
            (Some(name), Some(_)) => name,
            _ => &head.name,
        };
        let title = head.title.unwrap_or_else(|| match head.dimension {
            PhysicalQuantity::One => vec![name.to_owned()],
            dimension => vec![name.to_owned(), self.measure.title(dimension).to_owned()],
        });
        self.all.push(Column {
            part: self.part.clone(),
            is_contact: self.is_contact,
            order: self.order,
            title,
            unit: self.measure.unit(head.dimension),
            kind,
            axis: self.axis,
            shown: self.shown,
            name: self.measure.name(name, head.dimension),
            attribute: head.attribute,
            of_what: match (self.measure.unit(head.dimension), head.dimension) {
                ("", PhysicalQuantity::Length) => self.measure.reference(PhysicalQuantity::Length),
                (unit, _) => unit,
            },
            read,
            says: None,
            moves: None,
        });
    }

    /// Returns all columns that were added, from left to right.
    #[must_use]
    pub fn done(self) -> Vec<Column<'a, R>> {
        self.all
    }
}
