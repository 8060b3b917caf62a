//! Writes spectra, one order per line.

use super::motion::Motion;
use crate::asked::Part;
use crate::failure::Failure;
use crate::harmonics;
use crate::measure::Dimension;
use crate::number::Cell;
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::Complex;
use frictiongen::study::{Spectrum, units};
use serde_json::Value as Json;
use std::borrow::Cow;

/// Writer of the spectra of a motion.
pub struct SpectrumReport<'m> {
    motion: &'m Motion,
    /// Spectrum of each part.
    spectra: Cow<'m, [Spectrum]>,
}

impl SpectrumReport<'_> {
    /// Returns the spectrum of each part.
    #[cfg(feature = "pictures")]
    pub fn spectra(&self) -> &[Spectrum] {
        &self.spectra
    }
}

impl<'m> SpectrumReport<'m> {
    /// Takes the exact spectra of a steady state, or computes those of a run's samples.
    pub fn of(motion: &'m Motion) -> Self {
        let parts = &motion.course.parts;
        let spectra = match motion.exact.is_empty() {
            false => Cow::Borrowed(&*motion.exact),
            true => {
                let spectra = parts
                    .iter()
                    .filter_map(|part| motion.history.spectrum(part.of));
                Cow::Owned(spectra.collect())
            }
        };
        Self { motion, spectra }
    }

    /// Returns the cells of an order.
    fn order(&self, index: usize) -> Vec<Cell<'static>> {
        let line = self
            .spectra
            .first()
            .and_then(|first| first.lines.get(index));
        let Some(line) = line else { return Vec::new() };
        let hertz = units::hertz(self.motion.course.omega) * line.order;
        let hertz = self.motion.course.in_seconds.then_some(hertz);
        let both = hertz.into_iter().chain([line.order]);
        both.map(Cell::from).collect()
    }

    /// Returns amplitude and phase of each part.
    fn components(&self, index: usize) -> impl Iterator<Item = (&Part, [Cell<'static>; 2])> {
        let parts = self.motion.course.parts.iter().zip(&*self.spectra);
        parts.filter_map(move |(part, spectrum)| {
            let component = spectrum.lines.get(index)?.component;
            let signed = |value| self.motion.signed(part.of, value);
            let component = Complex::new(signed(component.re), signed(component.im));
            Some((
                part,
                harmonics::values(component, &self.motion.course.measure),
            ))
        })
    }
}

impl Report for SpectrumReport<'_> {
    type Point = usize;

    fn len(&self) -> usize {
        self.spectra.first().map_or(0, |first| first.lines.len())
    }

    fn each(&self, visit: Visitor<'_, usize>) -> Result<(), Failure> {
        (0..self.len()).try_for_each(|index| visit(&index))
    }

    fn columns(&self) -> Vec<Column> {
        let measure = &self.motion.course.measure;
        let (length, angle) = (
            measure.title(Dimension::Length),
            measure.title(Dimension::Angle),
        );
        let seconds = self.motion.course.in_seconds;
        let hertz = seconds.then(|| Column::computed(&["frequency", "(Hz)"]));
        let mut columns: Vec<Column> = hertz.into_iter().collect();
        columns.push(Column::computed(&["order"]));
        columns.extend(self.motion.course.parts.iter().flat_map(|part| {
            [
                Column::computed(&[&part.name, "amplitude", length]),
                Column::computed(&[&part.name, "phase", angle]),
            ]
        }));
        columns
    }

    fn rows<'a>(&'a self, index: &'a usize) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(index)]
    }

    fn names(&self) -> Vec<String> {
        let course = &self.motion.course;
        let hertz = course.in_seconds.then(|| "frequency_Hz".to_owned());
        let mut names: Vec<String> = hertz.into_iter().chain(["order".to_owned()]).collect();
        let amplitude = course.measure.name("amplitude", Dimension::Length);
        let phase = course.measure.name("phase", Dimension::Angle);
        for part in &course.parts {
            names.extend([&amplitude, &phase].map(|what| Motion::name(part, what)));
        }
        names
    }

    fn record<'a>(&'a self, index: &'a usize) -> Vec<Cell<'a>> {
        let mut record: Vec<Cell<'a>> = self.order(*index);
        record.extend(self.components(*index).flat_map(|(_, values)| values));
        record
    }

    fn head(&self) -> Vec<(String, Json)> {
        self.motion.head()
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        self.motion.preamble()
    }

    fn json(&self, index: &usize) -> Json {
        self.motion.json(self.names(), &self.record(index))
    }
}
