//! Columns of tables. A column has a key, a heading, a unit, and a function that reads its cell from a row.

use super::cell::Cell;
use super::measure::PhysicalQuantity;
use crate::study::features::Sensed;
use std::borrow::Cow;

/// The kind of values that a column contains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColumnKind<'a> {
    /// The column contains numbers.
    Number,
    /// The column contains numbers that the user gave. The slice contains all given numbers, so that a printed table
    /// can choose the number of decimals.
    Given(&'a [f64]),
    /// The column contains counts.
    Count,
    /// The column contains words. The field is the number of characters of the longest usual word.
    Word(usize),
    /// The cells of the column are true or false.
    Flag,
    /// The cells of the column are lists of complex numbers.
    Complex,
    /// The cells of the column are lists of intervals. Each interval has a start and a length.
    Intervals,
}

/// The variables on which the values of a column depend: frequency, friction or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnAxis {
    /// The values of the column depend on the frequency alone.
    Frequency,
    /// The values of the column depend on the friction alone.
    Friction,
    /// The values of the column depend on frequency and friction.
    Row,
}

/// The outputs that contain a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Every output contains the column.
    Everywhere,
    /// CSV, JSON and Python contain the column. Printed tables do not.
    Files,
    /// JSON and Python contain the column. Its values do not fit into a cell of a printed table.
    Objects,
    /// Only JSON contains the column.
    Json,
    /// Printed tables and CSV contain the column. JSON and Python do not.
    Lines,
    /// Only the results in Python contain the column.
    Python,
}

/// Name, unit and heading of a column, before the units of the table are known.
#[derive(Clone, Debug)]
pub struct Head {
    pub(super) name: Cow<'static, str>,
    pub(super) under_load: Option<&'static str>,
    pub(super) attribute: Option<&'static str>,
    pub(super) dimension: PhysicalQuantity,
    pub(super) title: Option<Vec<String>>,
}

impl Head {
    /// Creates the head of a column that contains ratios or words, without a unit.
    #[must_use]
    pub fn new(name: impl Into<Cow<'static, str>>) -> Self {
        Self {
            name: name.into(),
            under_load: None,
            attribute: None,
            dimension: PhysicalQuantity::One,
            title: None,
        }
    }

    /// Creates the head of a column that contains values of a physical quantity.
    #[must_use]
    pub fn of(name: impl Into<Cow<'static, str>>, dimension: PhysicalQuantity) -> Self {
        Self {
            dimension,
            ..Self::new(name)
        }
    }

    /// Sets the name that the column has if the caller gives a load.
    #[must_use]
    pub fn under_load(self, name: &'static str) -> Self {
        Self {
            under_load: Some(name),
            ..self
        }
    }

    /// Sets a different name for the column in Python. The column needs it if its name is a reserved word in Python.
    #[must_use]
    pub fn attribute(self, name: &'static str) -> Self {
        Self {
            attribute: Some(name),
            ..self
        }
    }

    /// Sets the lines of the heading. The default lines are the name and the unit.
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

/// Function that reads a column's cell from a row.
pub(super) type ReadCell<'a, TableRow> = Box<dyn for<'r> Fn(&'r TableRow) -> Cell<'r> + 'a>;

/// Function that returns true if a text output with one line for each value prints the value of a row.
type Says<'a, TableRow> = Box<dyn Fn(&TableRow) -> bool + 'a>;

/// Function that returns the derivatives of a row's value with respect to the parameters.
type Moves<'a, TableRow> = Box<dyn Fn(&TableRow) -> Option<&Sensed> + 'a>;

/// A column of a table, with the function that reads its cells.
pub struct Column<'a, TableRow> {
    /// Name of the contact or mass whose motion the column describes. `None` for the whole row.
    pub part: Option<String>,
    /// True if the column describes the motion of a contact.
    pub is_contact: bool,
    /// Order of the harmonic to which the column belongs. `None` for a column that belongs to no harmonic.
    pub order: Option<u32>,
    /// Lines of the heading, without the name of the contact or mass.
    pub title: Vec<String>,
    /// Unit of the column's numbers. It is empty for ratios.
    pub unit: &'static str,
    /// Kind of the column's values: numbers, counts, words, flags or lists.
    pub kind: ColumnKind<'a>,
    /// The variables on which the column's values depend: frequency, friction or both.
    pub axis: ColumnAxis,
    /// The outputs (printed table, CSV, JSON, Python) that contain the column.
    pub shown: Shown,
    pub(super) name: String,
    pub(super) attribute: Option<&'static str>,
    /// Unit of the column's numbers. For a displacement without a load it is the reference length, `P/k1` or `Y`.
    pub(super) of_what: &'static str,
    pub(super) read: ReadCell<'a, TableRow>,
    pub(super) says: Option<Says<'a, TableRow>>,
    pub(super) moves: Option<Moves<'a, TableRow>>,
}

impl<TableRow> Column<'_, TableRow> {
    /// Returns the value of a row in this column.
    pub fn read<'r>(&self, row: &'r TableRow) -> Cell<'r> {
        (self.read)(row)
    }

    /// Returns true if a text output with one line for each value prints the value of this row. Such an output omits,
    /// for example, a bound that was not reached.
    pub fn says(&self, row: &TableRow) -> bool {
        self.says.as_ref().is_none_or(|says| says(row))
    }

    /// Returns true if the column's values may have derivatives with respect to the parameters.
    #[must_use]
    pub fn has_derivatives(&self) -> bool {
        self.moves.is_some()
    }

    /// Returns the derivatives of a row's value in this column, if they exist.
    pub fn derivatives<'r>(&self, row: &'r TableRow) -> Option<&'r Sensed> {
        self.moves.as_ref()?(row)
    }

    /// Returns the unit of the column's numbers, for example `m`. For a displacement without a load, returns the
    /// reference length, `P/k1` or `Y`.
    #[must_use]
    pub fn of_what(&self) -> &'static str {
        self.of_what
    }

    /// Returns the name of the column without contact or mass and without harmonic, for example `amplitude_m`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the name of the column with its harmonic, but without contact or mass. For the third harmonic it is, for
    /// example, `X3.amplitude_m`.
    #[must_use]
    pub fn name_in_part(&self) -> String {
        match self.order {
            Some(order) => format!("X{order}.{}", self.name),
            None => self.name.clone(),
        }
    }

    /// Returns the name of the column in CSV and JSON, for example `upper.X3.amplitude_m`.
    #[must_use]
    pub fn key(&self) -> String {
        match &self.part {
            Some(part) => format!("{part}.{}", self.name_in_part()),
            None => self.name_in_part(),
        }
    }

    /// Returns the name of the column in Python. It is the key, unless the key is a reserved word of Python.
    #[must_use]
    pub fn attribute(&self) -> String {
        self.attribute.map_or_else(|| self.key(), str::to_owned)
    }

    /// Returns true if printed tables contain the column.
    #[must_use]
    pub fn is_in_text(&self) -> bool {
        matches!(self.shown, Shown::Everywhere | Shown::Lines)
    }

    /// Returns true if CSV files contain the column.
    #[must_use]
    pub fn is_in_csv(&self) -> bool {
        matches!(self.shown, Shown::Everywhere | Shown::Files | Shown::Lines)
    }

    /// Returns true if JSON files contain the column.
    #[must_use]
    pub fn is_in_json(&self) -> bool {
        !matches!(self.shown, Shown::Lines | Shown::Python)
    }

    /// Returns true if the results in Python contain the column.
    #[must_use]
    pub fn is_in_python(&self) -> bool {
        !matches!(self.shown, Shown::Lines | Shown::Json)
    }
}

/// A row of a table.
pub trait TableRow {
    /// Returns the row's angular frequency ω in rad/s. The table needs ω to convert velocities, accelerations and
    /// powers. The result is NaN for a row without a frequency.
    fn omega(&self) -> f64 {
        f64::NAN
    }
}
