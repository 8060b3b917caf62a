//! Rows and columns of the table of a motion that a stepper computes under a sampled input.

use crate::Of;
use crate::study::columns::{
    Column, Columns, Head, Measure, MovingPart, PhysicalQuantity, TableRow,
};
use crate::study::{System, stepper::SystemStepper, words};
use frictiongen_kernel::simulation::Contact;

/// The motion of the contact and of the requested masses at every sample of an input.
#[derive(Clone, Debug, Default)]
pub struct Driven {
    /// Time of each sample, in s.
    pub time: Vec<f64>,
    /// Displacement in m and velocity in m/s at every sample, as a pair of lists for each requested mass or contact.
    pub motions: Vec<[Vec<f64>; 2]>,
    /// Friction force at each sample, in N.
    pub force: Vec<f64>,
    state: Vec<Contact>,
    events: Vec<u32>,
}

/// Row of the table: the motion at one sample.
#[derive(Clone, Copy, Debug)]
pub struct DrivenRow<'d> {
    driven: &'d Driven,
    index: usize,
}

impl TableRow for DrivenRow<'_> {}

impl Driven {
    /// Creates a table without samples.
    #[must_use]
    pub fn new(parts: &[MovingPart]) -> Self {
        Self {
            motions: vec![Default::default(); parts.len()],
            ..Self::default()
        }
    }

    /// Adds the present state of a stepper to the table. `parts` lists the motions that the table contains. `events`
    /// is the number of events of the contact (stops, break-aways and reversals) since the previous sample. If
    /// `turned` is true, the table contains the contact's motion and force with the opposite sign.
    pub fn push(
        &mut self,
        stepper: &SystemStepper<'_>,
        parts: &[MovingPart],
        turned: bool,
        events: u32,
    ) {
        let signed = |value: f64| if turned { 0.0 - value } else { value };
        let contact = stepper.contact();
        for (part, [displacement, velocity]) in parts.iter().zip(&mut self.motions) {
            let (x, v) = match part.of {
                Of::Contact => (signed(contact.displacement()), signed(contact.velocity())),
                of => stepper.motion_of(of).unwrap_or_default(),
            };
            displacement.push(x);
            velocity.push(v);
        }
        self.force.push(signed(contact.force()));
        let state = contact.contact();
        self.state.push(match turned {
            true => state.reversed(),
            false => state,
        });
        self.events.push(events);
        self.time.push(stepper.time());
    }

    /// Returns the rows of the table, one for each sample.
    pub fn rows(&self) -> impl Iterator<Item = DrivenRow<'_>> {
        (0..self.time.len()).map(|index| DrivenRow {
            driven: self,
            index,
        })
    }

    /// Returns the columns of the table, with their names and units.
    #[must_use]
    pub fn columns<'d>(system: &System, parts: &[MovingPart]) -> Vec<Column<'d, DrivenRow<'d>>> {
        let mut columns = Columns::new(&Measure::si(system));
        let head = Head::of("time", PhysicalQuantity::Time);
        columns.number(head, |row: &DrivenRow<'_>| {
            row.driven.time.get(row.index).copied()
        });
        for (place, part) in parts.iter().enumerate() {
            columns.begin_motion(part);
            if part.of.is_force() {
                columns.converted(Head::of("force", PhysicalQuantity::Force), move |row| {
                    let [force, _] = row.driven.motions.get(place)?;
                    force.get(row.index).copied()
                });
                continue;
            }
            for (which, (name, dimension)) in [
                ("displacement", PhysicalQuantity::Length),
                ("velocity", PhysicalQuantity::Velocity),
            ]
            .into_iter()
            .enumerate()
            {
                columns.converted(Head::of(name, dimension), move |row| {
                    let motion = row.driven.motions.get(place)?.get(which)?;
                    motion.get(row.index).copied()
                });
            }
        }
        columns.begin_contact(&system.name_of_motion(Of::Contact));
        columns.number(Head::of("friction", PhysicalQuantity::Force), |row| {
            row.driven.force.get(row.index).copied()
        });
        columns.word("state", "backward", |row| {
            Some(words::contact(*row.driven.state.get(row.index)?))
        });
        columns.end_parts();
        columns.count("events", |row| {
            Some(*row.driven.events.get(row.index)? as usize)
        });
        columns.done()
    }
}
