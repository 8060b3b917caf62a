//! Writes samples, one per line.

use super::motion::Motion;
use crate::asked::{CONTACT, Part};
use crate::failure::Failure;
use crate::measure::Dimension;
use crate::number::Cell;
use crate::output::{Report, Visitor};
use crate::table::Column;
use frictiongen::Of;
use serde_json::Value as Json;

/// Writer of the samples of a motion.
pub struct SamplesReport<'m> {
    /// The motion.
    pub motion: &'m Motion,
}

impl SamplesReport<'_> {
    /// Returns displacement and velocity of each part.
    fn movements(&self, index: usize) -> impl Iterator<Item = (&Part, [Cell<'static>; 2])> {
        let motion = self.motion;
        let course = &motion.course;
        let tracks = course.parts.iter().zip(&motion.history.tracks);
        tracks.map(move |(part, track)| {
            let displacement = track.displacement.get(index).copied();
            let velocity = track.velocity.get(index).copied();
            let velocity = velocity.map(|value| {
                let value = motion.signed(part.of, value);
                course.measure.velocity(value, course.omega)
            });
            let displacement =
                displacement.map_or(Cell::Missing, |value| motion.displacement(part.of, value));
            (part, [displacement, velocity.into()])
        })
    }

    /// Returns the names of displacement and velocity.
    fn movement_names(&self) -> [String; 2] {
        let measure = &self.motion.course.measure;
        [
            measure.name("displacement", Dimension::Length),
            measure.name("velocity", Dimension::Velocity),
        ]
    }

    /// Returns friction force and state of the contact.
    fn contact(&self, index: usize) -> [Cell<'static>; 2] {
        let motion = self.motion;
        let friction = motion.history.friction.get(index).copied();
        let friction = friction.map(|force| {
            let force = motion.signed(Of::Contact, force);
            motion.course.measure.force(force)
        });
        let state = motion.history.contact.get(index);
        let state = state.map_or(Cell::Missing, |contact| motion.state(*contact).into());
        [friction.into(), state]
    }

    /// Returns the names of friction force and state.
    fn contact_names(&self) -> [String; 2] {
        let force = self
            .motion
            .course
            .measure
            .name("friction", Dimension::Force);
        [force, "state".to_owned()]
    }
}

impl Report for SamplesReport<'_> {
    type Point = usize;

    fn len(&self) -> usize {
        self.motion.history.len()
    }

    fn each(&self, visit: Visitor<'_, usize>) -> Result<(), Failure> {
        (0..self.len()).try_for_each(|index| visit(&index))
    }

    fn columns(&self) -> Vec<Column> {
        let measure = &self.motion.course.measure;
        let (length, velocity) = (
            measure.title(Dimension::Length),
            measure.title(Dimension::Velocity),
        );
        let mut columns = self.motion.time_columns();
        columns.extend(self.motion.course.parts.iter().flat_map(|part| {
            [
                Column::computed(&[&part.name, "displacement", length]),
                Column::computed(&[&part.name, "velocity", velocity]),
            ]
        }));
        columns.extend([
            Column::computed(&[CONTACT, "friction", measure.title(Dimension::Force)]),
            Motion::state_column(),
        ]);
        columns
    }

    fn rows<'a>(&'a self, index: &'a usize) -> Vec<Vec<Cell<'a>>> {
        vec![self.record(index)]
    }

    fn names(&self) -> Vec<String> {
        let time = self.motion.time_names().iter();
        let mut names: Vec<String> = time.map(|name| (*name).to_owned()).collect();
        for part in &self.motion.course.parts {
            let both = self.movement_names();
            names.extend(both.map(|what| Motion::name(part, &what)));
        }
        let contact = self.contact_names();
        names.extend(contact.map(|what| format!("{CONTACT}.{what}")));
        names
    }

    fn record<'a>(&'a self, index: &'a usize) -> Vec<Cell<'a>> {
        let mut record: Vec<Cell<'a>> = self.motion.time(self.motion.history.tau(*index));
        record.extend(self.movements(*index).flat_map(|(_, values)| values));
        record.extend(self.contact(*index));
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
