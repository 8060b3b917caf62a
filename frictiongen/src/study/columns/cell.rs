//! The content of one cell of a table.

use std::borrow::Cow;

/// Content of one cell of a table, in one row and one column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell<'a> {
    /// The cell contains a number. It is never NaN and never −0.
    Number(f64),
    /// The cell contains a number that is known only to lie within an interval. A printed table shows only its valid
    /// digits.
    Within {
        /// Number in the cell.
        value: f64,
        /// Width of the interval that contains the exact number. It is above 0.
        width: f64,
    },
    /// The cell contains a count.
    Count(usize),
    /// The cell contains a word, such as the name of a regime.
    Word(Cow<'a, str>),
    /// The cell contains true or false.
    Flag(bool),
    /// The cell contains a list of complex numbers (real and imaginary part), or of intervals (start and length).
    Pairs(Vec<[f64; 2]>),
    /// The row has no value in this column.
    Missing,
}

impl Cell<'_> {
    /// Returns this cell with an owned copy of its word.
    #[must_use]
    pub fn into_owned(self) -> Cell<'static> {
        match self {
            Self::Number(value) => Cell::Number(value),
            Self::Within { value, width } => Cell::Within { value, width },
            Self::Count(value) => Cell::Count(value),
            Self::Word(word) => Cell::Word(Cow::Owned(word.into_owned())),
            Self::Flag(value) => Cell::Flag(value),
            Self::Pairs(pairs) => Cell::Pairs(pairs),
            Self::Missing => Cell::Missing,
        }
    }

    /// Returns this cell with a borrowed word.
    #[must_use]
    pub fn borrowed(&self) -> Cell<'_> {
        match self {
            Self::Word(word) => Cell::Word(Cow::Borrowed(word)),
            Self::Number(value) => Cell::Number(*value),
            Self::Within { value, width } => Cell::Within {
                value: *value,
                width: *width,
            },
            Self::Count(value) => Cell::Count(*value),
            Self::Flag(value) => Cell::Flag(*value),
            Self::Pairs(pairs) => Cell::Pairs(pairs.clone()),
            Self::Missing => Cell::Missing,
        }
    }
}

impl From<f64> for Cell<'_> {
    fn from(value: f64) -> Self {
        if value.is_nan() {
            Self::Missing
        } else {
            Self::Number(value + 0.0)
        }
    }
}

impl From<usize> for Cell<'_> {
    fn from(value: usize) -> Self {
        Self::Count(value)
    }
}

impl From<bool> for Cell<'_> {
    fn from(value: bool) -> Self {
        Self::Flag(value)
    }
}

impl<'a> From<&'a str> for Cell<'a> {
    fn from(value: &'a str) -> Self {
        Self::Word(Cow::Borrowed(value))
    }
}

impl From<String> for Cell<'_> {
    fn from(value: String) -> Self {
        Self::Word(Cow::Owned(value))
    }
}

impl From<Vec<[f64; 2]>> for Cell<'_> {
    fn from(value: Vec<[f64; 2]>) -> Self {
        Self::Pairs(value)
    }
}

impl<'a, T: Into<Cell<'a>>> From<Option<T>> for Cell<'a> {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}
