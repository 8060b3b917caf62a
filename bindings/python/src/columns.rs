//! Builds the answers for Python: arrays by name, in the order of the columns of the command's tables.

use frictiongen::study::columns::{Cell, Column, ColumnAxis, ColumnKind};
use numpy::{Complex64, PyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::borrow::Cow;

/// A column of words. It stores each distinct word only once.
#[derive(Default)]
pub struct Words {
    known: Vec<String>,
    places: Vec<i64>,
}

impl Words {
    /// Appends a word to the column.
    pub fn push<'w>(&mut self, word: impl Into<Cow<'w, str>>) {
        let word = word.into();
        let place = self.known.iter().position(|known| *known == word);
        let place = place.unwrap_or_else(|| {
            self.known.push(word.into_owned());
            self.known.len() - 1
        });
        self.places.push(place as i64);
    }
}

impl<'w, W: Into<Cow<'w, str>>> FromIterator<W> for Words {
    fn from_iter<I: IntoIterator<Item = W>>(words: I) -> Self {
        let mut all = Self::default();
        words.into_iter().for_each(|word| all.push(word));
        all
    }
}

/// Returns the number that a Python array contains for a value. −0 becomes 0, as in the output of the command. A
/// missing number becomes NaN.
pub fn cell(value: Option<f64>) -> f64 {
    value.map_or(f64::NAN, |value| value + 0.0)
}

/// Returns the whole number that a Python array contains for a count. A missing count becomes −1.
pub fn count(value: Option<usize>) -> i64 {
    value
        .and_then(|value| i64::try_from(value).ok())
        .unwrap_or(-1)
}

/// A collection of arrays by name, which becomes the Python answer.
pub struct NamedArrays<'py> {
    dict: Bound<'py, PyDict>,
    shape: Vec<usize>,
    /// Names of the contacts whose columns the collection has.
    contacts: Vec<String>,
}

impl<'py> NamedArrays<'py> {
    /// Returns an empty collection for arrays of this shape.
    pub fn new(py: Python<'py>, shape: &[usize]) -> Self {
        Self {
            dict: PyDict::new(py),
            shape: shape.to_vec(),
            contacts: Vec::new(),
        }
    }

    /// Sets the shape of all arrays that later calls add.
    pub fn reshape(&mut self, shape: &[usize]) {
        self.shape = shape.to_vec();
    }

    /// Adds one array for each column of a table of the library.
    pub fn table<R>(&mut self, columns: &[Column<'_, R>], rows: &[R]) -> PyResult<()> {
        let shown = columns.iter().filter(|column| column.is_in_python());
        for column in shown {
            self.column(column, rows)?;
        }
        Ok(())
    }

    /// Adds one array for each column of a table that depends on `axis`. The axis is the frequency alone, the friction
    /// alone, or the whole row.
    pub fn along<R>(
        &mut self,
        axis: ColumnAxis,
        columns: &[Column<'_, R>],
        rows: &[R],
    ) -> PyResult<()> {
        let shown = columns.iter().filter(|column| column.is_in_python());
        for column in shown.filter(|column| column.axis == axis) {
            self.column(column, rows)?;
        }
        Ok(())
    }

    fn column<R>(&mut self, column: &Column<'_, R>, rows: &[R]) -> PyResult<()> {
        if let Some(contact) = column.part.as_ref().filter(|_| column.is_contact)
            && !self.contacts.contains(contact)
        {
            self.contacts.push(contact.clone());
            self.dict.set_item("contacts", &self.contacts)?;
        }
        let (name, cells) = (column.attribute(), rows.iter().map(|row| column.read(row)));
        match column.kind {
            ColumnKind::Number | ColumnKind::Given(_) => {
                let number = |cell| match cell {
                    Cell::Number(value) | Cell::Within { value, .. } => value,
                    _ => f64::NAN,
                };
                self.numbers(name, cells.map(number).collect())
            }
            ColumnKind::Count => {
                let counts = cells.map(|cell| match cell {
                    Cell::Count(value) => count(Some(value)),
                    _ => count(None),
                });
                self.counts(name, counts.collect())
            }
            ColumnKind::Word(_) => {
                let words = cells.map(|cell| match cell {
                    Cell::Word(word) => word,
                    _ => Cow::Borrowed(""),
                });
                self.words(name, words.collect())
            }
            ColumnKind::Flag => {
                self.flags(name, cells.map(|cell| cell == Cell::Flag(true)).collect())
            }
            ColumnKind::Complex | ColumnKind::Intervals => self.lists(column, cells),
        }
    }

    /// Adds an array in which each row is a list. The lists are along the last dimension, and NaN fills up the shorter
    /// lists.
    fn lists<'c, R>(
        &mut self,
        column: &Column<'_, R>,
        cells: impl Iterator<Item = Cell<'c>>,
    ) -> PyResult<()> {
        let lists: Vec<Vec<[f64; 2]>> = cells
            .map(|cell| match cell {
                Cell::Pairs(pairs) => pairs,
                _ => Vec::new(),
            })
            .collect();
        let longest = lists.iter().map(Vec::len).max().unwrap_or(0);
        let missing = std::iter::repeat([f64::NAN; 2]);
        let lists = lists.into_iter();
        let pairs = lists.flat_map(|list| list.into_iter().chain(missing.clone()).take(longest));
        let name = column.attribute();
        let shape = self.shape.clone();
        self.shape.push(longest);
        if column.kind == ColumnKind::Complex {
            let values = pairs.map(|[re, im]| Complex64::new(re, im));
            self.complex(name, values.collect())?;
        } else {
            self.shape.push(2);
            self.numbers(name, pairs.flatten().collect())?;
        }
        self.shape = shape;
        Ok(())
    }

    /// Adds an array of numbers under a name.
    pub fn numbers(&mut self, name: impl AsRef<str>, values: Vec<f64>) -> PyResult<()> {
        let array = PyArray1::from_vec(self.dict.py(), values).into_any();
        self.put(name.as_ref(), array)
    }

    /// Adds an array of whole numbers under a name.
    pub fn counts(&mut self, name: impl AsRef<str>, values: Vec<i64>) -> PyResult<()> {
        let array = PyArray1::from_vec(self.dict.py(), values).into_any();
        self.put(name.as_ref(), array)
    }

    /// Adds an array of truth values under a name.
    pub fn flags(&mut self, name: impl AsRef<str>, values: Vec<bool>) -> PyResult<()> {
        let array = PyArray1::from_vec(self.dict.py(), values).into_any();
        self.put(name.as_ref(), array)
    }

    /// Adds an array of complex numbers under a name.
    pub fn complex(&mut self, name: impl AsRef<str>, values: Vec<Complex64>) -> PyResult<()> {
        let array = PyArray1::from_vec(self.dict.py(), values).into_any();
        self.put(name.as_ref(), array)
    }

    /// Adds an array of words under a name.
    pub fn words(&mut self, name: impl AsRef<str>, words: Words) -> PyResult<()> {
        let py = self.dict.py();
        let numpy = py.import("numpy")?;
        let options = PyDict::new(py);
        options.set_item("dtype", "U")?;
        let known: Vec<&str> = words.known.iter().map(AsRef::as_ref).collect();
        let known = numpy.call_method("array", (known,), Some(&options))?;
        let places = PyArray1::from_vec(py, words.places);
        self.put(name.as_ref(), known.get_item(places)?)
    }

    /// Adds any other object unchanged under a name.
    pub fn other(&mut self, name: &str, value: impl IntoPyObject<'py>) -> PyResult<()> {
        self.dict.set_item(name, value)
    }

    fn put(&mut self, name: &str, array: Bound<'py, PyAny>) -> PyResult<()> {
        let py = self.dict.py();
        let array = match self.shape.as_slice() {
            // An empty shape means that the caller gave single numbers. The answer then contains a number instead of an
            // array with one element.
            [] => array
                .call_method1("reshape", (PyTuple::empty(py),))?
                .get_item(PyTuple::empty(py))?,
            [_] => array,
            shape => array.call_method1("reshape", (PyTuple::new(py, shape)?,))?,
        };
        self.dict.set_item(name, array)
    }

    /// Returns the Python dictionary of all added arrays, by their names.
    pub fn done(self) -> Bound<'py, PyDict> {
        self.dict
    }
}
