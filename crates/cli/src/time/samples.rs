//! Tables of the samples and of the events of a motion over time.

use super::motion::RunMotion;
use crate::failure::Failure;
use crate::layout::Layout;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, EventRow, SampleRow};
use serde_json::Value as Json;

/// Table of the samples of a motion over time.
pub struct SamplesReport<'m> {
    /// The motion over time whose samples the table contains.
    pub motion: &'m RunMotion<'m>,
}

/// Table of the events of a motion over time.
pub struct EventsReport<'m> {
    /// The motion over time whose events the table contains.
    pub motion: &'m RunMotion<'m>,
}

impl<'m> ResultTable for SamplesReport<'m> {
    type Row = SampleRow<'m>;

    fn len(&self) -> usize {
        self.motion.history.len()
    }

    fn each(&self, visit: Visitor<'_, SampleRow<'m>>) -> Result<(), Failure> {
        let mut rows = self.motion.course.table().samples(&self.motion.history);
        rows.try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, SampleRow<'m>>> {
        self.motion.course.table().sample_columns()
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

impl<'m> ResultTable for EventsReport<'m> {
    type Row = EventRow<'m>;

    fn len(&self) -> usize {
        self.motion.history.events.len()
    }

    fn each(&self, visit: Visitor<'_, EventRow<'m>>) -> Result<(), Failure> {
        let mut rows = self.motion.course.table().events(&self.motion.history);
        rows.try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, EventRow<'m>>> {
        self.motion.course.table().event_columns()
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
