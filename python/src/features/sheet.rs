//! A list of features as columns, and the derivatives of its numbers.

use crate::asked::{Band, Measure};
use crate::columns::{Columns, Words, cell};
use frictiongen::System;
use frictiongen::study::columns::Dimension;
use frictiongen::study::{OperatingPoint, Parameter, Sensed};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// System, range and units of a sheet.
#[derive(Clone, Copy)]
pub struct Counted<'a> {
    /// The system.
    pub system: &'a System,
    /// The range of frequencies.
    pub band: &'a Band,
    /// The units of the answers.
    pub measure: &'a Measure,
}

impl Counted<'_> {
    fn point(&self) -> OperatingPoint {
        match self.measure.load() {
            // Names and units do not depend on the operating point, so that any point will do.
            Some(load) => OperatingPoint::Physical {
                hertz: 1.0,
                friction: 1.0,
                load,
            },
            None => OperatingPoint::Groups { r: 1.0, beta: 1.0 },
        }
    }

    fn has_hertz(&self) -> bool {
        self.band.tells_hertz(self.measure)
    }
}

/// One list: its columns, and for each column name the derivatives with respect to every parameter.
pub struct Sheet<'a, 'py, T> {
    counted: Counted<'a>,
    found: &'a [T],
    columns: Columns<'py>,
    derivatives: Bound<'py, PyDict>,
}

impl<'a, 'py, T> Sheet<'a, 'py, T> {
    /// Starts without columns.
    pub fn new(py: Python<'py>, counted: Counted<'a>, found: &'a [T]) -> Self {
        Self {
            counted,
            found,
            columns: Columns::new(py, &[found.len()]),
            derivatives: PyDict::new(py),
        }
    }

    /// Adds words.
    pub fn words(&mut self, name: &str, of: impl Fn(&'a T) -> &'a str) -> PyResult<()> {
        let words = self.found.iter().map(|line| of(line).to_owned());
        self.columns.words(name, words.collect::<Words>())
    }

    /// Adds counts.
    pub fn counts(&mut self, name: &str, of: impl Fn(&T) -> usize) -> PyResult<()> {
        let counts = self.found.iter().map(|line| of(line) as i64);
        self.columns.counts(name, counts.collect())
    }

    /// Adds flags.
    pub fn flags(&mut self, name: &str, of: impl Fn(&T) -> bool) -> PyResult<()> {
        self.columns
            .flags(name, self.found.iter().map(of).collect())
    }

    /// Adds numbers without a unit.
    pub fn numbers(&mut self, name: &str, of: impl Fn(&T) -> Option<f64>) -> PyResult<()> {
        let numbers = self.found.iter().map(|line| cell(of(line)));
        self.columns.numbers(name, numbers.collect())
    }

    /// Adds numbers that are forces under a load.
    pub fn forces(&mut self, name: &str, of: impl Fn(&T) -> Option<f64>) -> PyResult<()> {
        let name = self.counted.measure.name(name, Dimension::Force);
        self.numbers(&name, of)
    }

    /// Adds numbers that are lengths under a load.
    pub fn lengths(&mut self, name: &str, of: impl Fn(&T) -> Option<f64>) -> PyResult<()> {
        let name = self.counted.measure.name(name, Dimension::Length);
        self.numbers(&name, of)
    }

    /// Adds the requested friction.
    pub fn friction(&mut self, beta: impl Fn(&T) -> f64) -> PyResult<()> {
        let measure = self.counted.measure;
        if measure.scale().is_some() {
            self.numbers("friction_N", |line| Some(measure.force(beta(line))))?;
        }
        self.numbers("beta", |line| Some(beta(line)))
    }

    /// Adds frequencies. Their names begin with `before`.
    pub fn places(&mut self, before: &str, of: impl Fn(&T) -> Option<f64>) -> PyResult<()> {
        if self.counted.has_hertz() {
            let system = self.counted.system;
            self.numbers(&format!("{before}frequency_Hz"), |line| {
                of(line).map(|r| system.hertz(r))
            })?;
        }
        self.numbers(&format!("{before}r"), of)
    }

    /// Adds the derivatives of frequencies with respect to every parameter.
    pub fn places_move(
        &mut self,
        before: &str,
        of: impl Fn(&'a T) -> Option<&'a Sensed>,
    ) -> PyResult<()> {
        // Under a load the derivatives are those of the frequency in Hz.
        let name = match self.counted.measure.load() {
            Some(_) => format!("{before}frequency_Hz"),
            None => format!("{before}r"),
        };
        self.moved(&name, of)
    }

    /// Adds the derivatives of forces.
    pub fn forces_move(
        &mut self,
        name: &str,
        of: impl Fn(&'a T) -> Option<&'a Sensed>,
    ) -> PyResult<()> {
        let name = self.counted.measure.name(name, Dimension::Force);
        self.moved(&name, of)
    }

    /// Adds the derivatives of lengths.
    pub fn lengths_move(
        &mut self,
        name: &str,
        of: impl Fn(&'a T) -> Option<&'a Sensed>,
    ) -> PyResult<()> {
        let name = self.counted.measure.name(name, Dimension::Length);
        self.moved(&name, of)
    }

    /// Adds the parameters that change a column. Each has two arrays: derivatives, and per cent for one per cent of the
    /// parameter.
    fn moved(&mut self, name: &str, of: impl Fn(&'a T) -> Option<&'a Sensed>) -> PyResult<()> {
        let py = self.derivatives.py();
        let sensed: Vec<Option<&Sensed>> = self.found.iter().map(of).collect();
        let mut parameters: Vec<Parameter> = Vec::new();
        for slope in sensed.iter().flatten().flat_map(|sensed| &sensed.slopes) {
            if !parameters.contains(&slope.parameter) {
                parameters.push(slope.parameter);
            }
        }
        let column = |of: &dyn Fn(&Sensed) -> Option<f64>| {
            let values = sensed.iter().map(|sensed| cell(sensed.and_then(of)));
            PyArray1::from_vec(py, values.collect())
        };
        let all = PyList::empty(py);
        for parameter in parameters {
            let symbol = parameter.symbol(self.counted.system.scene(), &self.counted.point());
            let derivative = column(&|sensed| {
                let mut slopes = sensed.slopes.iter();
                let slope = slopes.find(|slope| slope.parameter == parameter)?;
                Some(slope.derivative)
            });
            let relative = column(&|sensed| sensed.relative(parameter));
            all.append((symbol, derivative, relative))?;
        }
        self.derivatives.set_item(name, all)
    }

    /// Returns columns and derivatives.
    pub fn done(self) -> (Bound<'py, PyDict>, Bound<'py, PyDict>) {
        (self.columns.done(), self.derivatives)
    }
}
