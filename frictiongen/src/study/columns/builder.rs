//! The list of a table's columns, to which each column is added in one line.

use super::cell::Cell;
use super::column::{Axis, Column, Head, Kind, ReadCell, Row, Shown};
use super::measure::{Dimension, Measure};
use crate::study::features::Sensed;

/// The columns of a table, in order.
pub struct Columns<'a, R> {
    measure: Measure,
    part: Option<String>,
    order: Option<u32>,
    axis: Axis,
    shown: Shown,
    all: Vec<Column<'a, R>>,
}

impl<'a, R: Row + 'a> Columns<'a, R> {
    /// Starts without columns.
    #[must_use]
    pub fn new(measure: &Measure) -> Self {
        Self {
            measure: *measure,
            part: None,
            order: None,
            axis: Axis::Row,
            shown: Shown::Everywhere,
            all: Vec::new(),
        }
    }

    /// Returns the units of the columns.
    #[must_use]
    pub fn measure(&self) -> &Measure {
        &self.measure
    }

    /// Sets the part to which the columns from now on belong.
    pub fn begin_part(&mut self, part: &str) {
        self.part = Some(part.to_owned());
        self.order = None;
    }

    /// Ends the parts: the columns from now on belong to the whole row.
    pub fn end_parts(&mut self) {
        self.part = None;
        self.order = None;
    }

    /// Sets the order of the harmonic to which the columns from now on belong.
    pub fn begin_harmonic(&mut self, order: u32) {
        self.order = Some(order);
    }

    /// Sets the outputs that have the columns from now on.
    pub fn show(&mut self, shown: Shown) {
        self.shown = shown;
    }

    /// Sets the arguments on which the columns from now on depend.
    pub fn along(&mut self, axis: Axis) {
        self.axis = axis;
    }

    /// Adds numbers, which `read` gives as groups.
    pub fn number(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<f64> + 'a) {
        let (head, measure) = (head.into(), self.measure);
        let dimension = head.dimension;
        let convert = move |row: &R| {
            let value = read(row)?;
            Some(measure.convert(dimension, value, row.omega()))
        };
        self.push(head, Kind::Number, Box::new(move |row| convert(row).into()));
    }

    /// Adds numbers that have their unit already.
    pub fn converted(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<f64> + 'a) {
        self.given(head, &[], read);
    }

    /// Adds numbers that the user gave, all of which are `grid`, and that have their unit already.
    pub fn given(
        &mut self,
        head: impl Into<Head>,
        grid: &'a [f64],
        read: impl Fn(&R) -> Option<f64> + 'a,
    ) {
        let kind = match grid {
            [] => Kind::Number,
            grid => Kind::Given(grid),
        };
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds counts.
    pub fn count(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<usize> + 'a) {
        self.push(
            head.into(),
            Kind::Count,
            Box::new(move |row| read(row).into()),
        );
    }

    /// Adds words. `widest` is the widest usual word.
    pub fn word(
        &mut self,
        head: impl Into<Head>,
        widest: &str,
        read: impl Fn(&R) -> Option<&str> + 'a,
    ) {
        let kind = Kind::Word(widest.chars().count());
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds flags.
    pub fn flag(&mut self, head: impl Into<Head>, read: impl Fn(&R) -> Option<bool> + 'a) {
        self.push(
            head.into(),
            Kind::Flag,
            Box::new(move |row| read(row).into()),
        );
    }

    /// Adds lists.
    pub fn list(
        &mut self,
        head: impl Into<Head>,
        kind: Kind<'a>,
        read: impl Fn(&R) -> Option<Vec<[f64; 2]>> + 'a,
    ) {
        self.push(head.into(), kind, Box::new(move |row| read(row).into()));
    }

    /// Adds cells of any kind.
    pub fn cell(
        &mut self,
        head: impl Into<Head>,
        kind: Kind<'a>,
        read: impl for<'r> Fn(&'r R) -> Cell<'r> + 'a,
    ) {
        self.push(head.into(), kind, Box::new(read));
    }

    /// Sets the derivatives of the last column.
    pub fn moves(&mut self, of: impl Fn(&R) -> Option<&Sensed> + 'a) {
        self.moves_before(0, of);
    }

    /// Sets the derivatives of a column before the last one.
    pub fn moves_before(&mut self, before: usize, of: impl Fn(&R) -> Option<&Sensed> + 'a) {
        if let Some(column) = self.all.iter_mut().rev().nth(before) {
            column.moves = Some(Box::new(of));
        }
    }

    /// Sets the condition under which the last column says something in a list of lines.
    pub fn say_if(&mut self, says: impl Fn(&R) -> bool + 'a) {
        if let Some(last) = self.all.last_mut() {
            last.says = Some(Box::new(says));
        }
    }

    fn push(&mut self, head: Head, kind: Kind<'a>, read: ReadCell<'a, R>) {
        let name = match (head.under_load, self.measure.scale()) {
            (Some(name), Some(_)) => name,
            _ => &head.name,
        };
        let title = head.title.unwrap_or_else(|| match head.dimension {
            Dimension::One => vec![name.to_owned()],
            dimension => vec![name.to_owned(), self.measure.title(dimension).to_owned()],
        });
        self.all.push(Column {
            part: self.part.clone(),
            order: self.order,
            title,
            unit: self.measure.unit(head.dimension),
            kind,
            axis: self.axis,
            shown: self.shown,
            name: self.measure.name(name, head.dimension),
            attribute: head.attribute,
            of_what: match (self.measure.unit(head.dimension), head.dimension) {
                ("", Dimension::Length) => self.measure.reference(Dimension::Length),
                (unit, _) => unit,
            },
            read,
            says: None,
            moves: None,
        });
    }

    /// Returns the columns.
    #[must_use]
    pub fn done(self) -> Vec<Column<'a, R>> {
        self.all
    }
}
