//! Columns: key, heading, unit, and the function that reads a cell from a row.

use super::cell::Cell;
use super::measure::{Dimension, Measure};
use crate::study::Sensed;
use std::borrow::Cow;

/// The kind of a column's values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind<'a> {
    /// Numbers.
    Number,
    /// Numbers that the user gave: all of them, from which a table takes the number of decimals.
    Given(&'a [f64]),
    /// Counts.
    Count,
    /// Words. The number of characters of the widest usual word.
    Word(usize),
    /// Flags.
    Flag,
    /// Lists of complex numbers.
    Complex,
    /// Lists of intervals, each with start and length.
    Intervals,
}

/// The arguments on which the values of a column depend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The frequency alone.
    Frequency,
    /// The friction alone.
    Friction,
    /// The whole row.
    Row,
}

/// The outputs that have a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Every output.
    Everywhere,
    /// Every output except tables for people.
    Files,
    /// JSON and Python, for values that do not fit into a cell.
    Objects,
    /// JSON alone.
    Json,
    /// Tables for people and CSV.
    Lines,
    /// Python alone.
    Python,
}

/// Name, unit and heading of a column.
#[derive(Clone, Debug)]
pub struct Head {
    name: Cow<'static, str>,
    under_load: Option<&'static str>,
    attribute: Option<&'static str>,
    dimension: Dimension,
    title: Option<Vec<String>>,
}

impl Head {
    /// Makes the head of a column of ratios or words.
    #[must_use]
    pub fn new(name: impl Into<Cow<'static, str>>) -> Self {
        Self {
            name: name.into(),
            under_load: None,
            attribute: None,
            dimension: Dimension::One,
            title: None,
        }
    }

    /// Makes the head of a column of this physical quantity.
    #[must_use]
    pub fn of(name: impl Into<Cow<'static, str>>, dimension: Dimension) -> Self {
        Self {
            dimension,
            ..Self::new(name)
        }
    }

    /// Sets another name for use under a load.
    #[must_use]
    pub fn under_load(self, name: &'static str) -> Self {
        Self {
            under_load: Some(name),
            ..self
        }
    }

    /// Sets another name for Python, where the name is a reserved word.
    #[must_use]
    pub fn attribute(self, name: &'static str) -> Self {
        Self {
            attribute: Some(name),
            ..self
        }
    }

    /// Sets the lines of the heading. By default they are the name and the unit.
    #[must_use]
    pub fn titled(self, lines: &[&str]) -> Self {
        let lines = lines.iter().map(|line| (*line).to_owned());
        Self {
            title: Some(lines.collect()),
            ..self
        }
    }
}

impl From<&'static str> for Head {
    fn from(name: &'static str) -> Self {
        Self::new(name)
    }
}

/// Function that reads a cell.
type Read<'a, Row> = Box<dyn for<'r> Fn(&'r Row) -> Cell<'r> + 'a>;

/// Function that returns whether a value says something in a list of lines.
type Says<'a, Row> = Box<dyn Fn(&Row) -> bool + 'a>;

/// Function that returns the derivatives of a value.
type Moves<'a, Row> = Box<dyn Fn(&Row) -> Option<&Sensed> + 'a>;

/// A column of a table.
pub struct Column<'a, Row> {
    /// Name of the contact or of the mass whose motion it is.
    pub part: Option<String>,
    /// Order of the harmonic.
    pub order: Option<u32>,
    /// Lines of the heading, without the name of the part.
    pub title: Vec<String>,
    /// Unit of the numbers, empty for ratios.
    pub unit: &'static str,
    /// Kind of the values.
    pub kind: Kind<'a>,
    /// The arguments on which the values depend.
    pub axis: Axis,
    /// The outputs that have the column.
    pub shown: Shown,
    name: String,
    attribute: Option<&'static str>,
    /// Unit, or reference of a displacement without a load.
    of_what: &'static str,
    read: Read<'a, Row>,
    says: Option<Says<'a, Row>>,
    moves: Option<Moves<'a, Row>>,
}

impl<Row> Column<'_, Row> {
    /// Reads the cell of a row.
    pub fn read<'r>(&self, row: &'r Row) -> Cell<'r> {
        (self.read)(row)
    }

    /// Returns whether the value of a row says something in a list of lines, such as a bound that was reached.
    pub fn says(&self, row: &Row) -> bool {
        self.says.as_ref().is_none_or(|says| says(row))
    }

    /// Returns true if the values may have derivatives with respect to the parameters.
    #[must_use]
    pub fn has_derivatives(&self) -> bool {
        self.moves.is_some()
    }

    /// Returns the derivatives of the value of a row, if it has any.
    pub fn derivatives<'r>(&self, row: &'r Row) -> Option<&'r Sensed> {
        self.moves.as_ref()?(row)
    }

    /// Returns the unit, and for a displacement without a load its reference: `m`, `P/k1`.
    #[must_use]
    pub fn of_what(&self) -> &'static str {
        self.of_what
    }

    /// Returns the name without part and harmonic: `amplitude_m`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the name without the part: `X3.amplitude_m`.
    #[must_use]
    pub fn name_in_part(&self) -> String {
        match self.order {
            Some(order) => format!("X{order}.{}", self.name),
            None => self.name.clone(),
        }
    }

    /// Returns the name of the column in CSV and JSON: `upper.X3.amplitude_m`.
    #[must_use]
    pub fn key(&self) -> String {
        match &self.part {
            Some(part) => format!("{part}.{}", self.name_in_part()),
            None => self.name_in_part(),
        }
    }

    /// Returns the name of the column in Python, which is its key unless that is a reserved word.
    #[must_use]
    pub fn attribute(&self) -> String {
        self.attribute.map_or_else(|| self.key(), str::to_owned)
    }

    /// Returns true if tables for people have the column.
    #[must_use]
    pub fn is_in_text(&self) -> bool {
        matches!(self.shown, Shown::Everywhere | Shown::Lines)
    }

    /// Returns true if CSV has the column.
    #[must_use]
    pub fn is_in_csv(&self) -> bool {
        matches!(self.shown, Shown::Everywhere | Shown::Files | Shown::Lines)
    }

    /// Returns true if JSON has the column.
    #[must_use]
    pub fn is_in_json(&self) -> bool {
        !matches!(self.shown, Shown::Lines | Shown::Python)
    }

    /// Returns true if Python has the column.
    #[must_use]
    pub fn is_in_python(&self) -> bool {
        !matches!(self.shown, Shown::Lines | Shown::Json)
    }
}

/// A row of a table.
pub trait Row {
    /// Returns ω in rad/s, which converts velocities, accelerations and powers of the row.
    fn omega(&self) -> f64 {
        f64::NAN
    }
}

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

    fn push(&mut self, head: Head, kind: Kind<'a>, read: Read<'a, R>) {
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
