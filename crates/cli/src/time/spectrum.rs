//! Table of the spectra of a motion over time.

use super::motion::RunMotion;
use crate::failure::Failure;
use crate::layout::Layout;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, HarmonicRow};
use frictiongen::study::history::Spectrum;
use serde_json::Value as Json;
use std::borrow::Cow;

/// Table of the spectra of a motion over time.
pub struct SpectrumReport<'m> {
    /// Motion over time whose spectra the table contains.
    pub motion: &'m RunMotion<'m>,
    /// Spectra of the contact and masses in the output.
    pub spectra: &'m [Spectrum],
}

/// Returns the exact spectra of a steady state. For any other motion, returns the spectra of its samples.
pub fn spectra<'m>(motion: &'m RunMotion<'_>) -> Cow<'m, [Spectrum]> {
    if !motion.exact.is_empty() {
        return Cow::Borrowed(&*motion.exact);
    }
    let parts = motion.course.parts.iter();
    let spectra = parts.filter_map(|part| motion.history.spectrum(part.of));
    Cow::Owned(spectra.collect())
}

impl<'m> ResultTable for SpectrumReport<'m> {
    type Row = HarmonicRow<'m>;

    fn len(&self) -> usize {
        self.spectra.first().map_or(0, |first| first.lines.len())
    }

    fn each(&self, visit: Visitor<'_, HarmonicRow<'m>>) -> Result<(), Failure> {
        let mut rows = self.motion.course.table().lines(self.spectra);
        rows.try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, HarmonicRow<'m>>> {
        self.motion.course.table().spectrum_columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lists
    }

    fn head(&self) -> Vec<(String, Json)> {
        self.motion.head()
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        self.motion.preamble()
    }
}
