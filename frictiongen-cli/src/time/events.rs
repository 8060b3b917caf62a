//! Writes the events of a motion, one per line.

use super::motion::Motion;
use crate::asked::CONTACT;
use crate::failure::Failure;
use crate::measure::Dimension;
use crate::number::Cell;
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::study::{HistoryEvent, words};
use serde_json::Value as Json;

/// Writer of the events of a motion.
pub struct EventsReport<'m> {
    /// The motion.
    pub motion: &'m Motion,
}

impl Report for EventsReport<'_> {
    type Point = HistoryEvent;

    fn len(&self) -> usize {
        self.motion.history.events.len()
    }

    fn each(&self, visit: Visitor<'_, HistoryEvent>) -> Result<(), Failure> {
        self.motion.history.events.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column> {
        let unit = self.motion.course.measure.title(Dimension::Length);
        let mut columns = self.motion.time_columns();
        columns.extend([
            Column::words(&["event"], ["break-away"]),
            Motion::state_column(),
        ]);
        let parts = self.motion.course.parts.iter();
        columns.extend(parts.map(|part| Column::computed(&[&part.name, "displacement", unit])));
        columns
    }

    fn rows<'a>(&'a self, event: &'a HistoryEvent) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(event)]
    }

    fn names(&self) -> Vec<String> {
        let time = self.motion.time_names().iter();
        let mut names: Vec<String> = time.map(|name| (*name).to_owned()).collect();
        names.extend(["event".to_owned(), format!("{CONTACT}.state")]);
        let displacement = self
            .motion
            .course
            .measure
            .name("displacement", Dimension::Length);
        let parts = self.motion.course.parts.iter();
        names.extend(parts.map(|part| Motion::name(part, &displacement)));
        names
    }

    fn record<'a>(&'a self, event: &'a HistoryEvent) -> Vec<Cell<'a>> {
        let mut record: Vec<Cell<'a>> = self.motion.time(event.tau);
        record.extend([
            words::event(event.event).into(),
            self.motion.state(event.contact).into(),
        ]);
        let parts = self.motion.course.parts.iter().zip(&event.displacements);
        record.extend(parts.map(|(part, value)| self.motion.displacement(part.of, *value)));
        record
    }

    fn head(&self) -> Vec<(String, Json)> {
        self.motion.head()
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        self.motion.preamble()
    }

    fn json(&self, event: &HistoryEvent) -> Json {
        self.motion.json(self.names(), &self.record(event))
    }
}
