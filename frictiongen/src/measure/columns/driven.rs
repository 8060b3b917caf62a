//! Rows and columns of the table of a motion that a stepper computes under a sampled input.

use crate::Of;
use crate::study::columns::{
    Column, Columns, Head, Measure, MovingPart, PhysicalQuantity, TableRow,
};
use crate::study::joined::JoinedContactNow;
use crate::study::{System, words};

/// Row of the table: the motion at one sample of the input.
#[derive(Clone, Debug)]
pub struct DrivenSample {
    /// Time of the sample, in s.
    pub time: f64,
    /// Displacement in m and velocity in m/s of each requested contact, mass or combination. For the force of a spring,
    /// the force in N and its time derivative.
    pub motions: Vec<[f64; 2]>,
    /// Motion and force of every contact, and then of every stop, with the signs of the scene description.
    pub contacts: Vec<JoinedContactNow>,
    /// Number of events of all contacts since the previous sample.
    pub events: usize,
}

impl TableRow for DrivenSample {}

/// The motions that the table contains.
#[derive(Clone, Debug)]
pub struct DrivenTable<'s> {
    /// The system that moves.
    pub system: &'s System,
    /// The requested contacts, masses and combinations. A contact has its own name.
    pub parts: &'s [MovingPart],
    /// Names of the contacts, and then of the stops.
    pub names: &'s [String],
    /// True if the table contains the slip and the energy of each contact.
    pub has_slips: bool,
}

/// Returns the motions with these names, each once. `contacts` has the names of the contacts. Without names, returns all
/// contacts and all masses, which are relative to the base if the base moves: under a recorded acceleration the base
/// drifts by metres, which would hide all relative motion.
///
/// # Errors
/// A message, which begins with the name of the `argument` that contains the names.
pub fn driven_parts(
    system: &System,
    argument: &str,
    (contacts, names): (&[String], &[String]),
) -> Result<Vec<MovingPart>, String> {
    let contact = |name: &String| MovingPart {
        name: name.clone(),
        ..MovingPart::contact(system)
    };
    if names.is_empty() {
        let masses = MovingPart::of_joined(system, argument, &[])?.into_iter();
        let masses = masses.map(|mass| mass.from_base(system));
        return Ok(contacts.iter().map(contact).chain(masses).collect());
    }
    let mut found: Vec<MovingPart> = Vec::new();
    for name in names {
        if found.iter().any(|part| part.name == *name) {
            return Err(format!("{argument} `{name}`: it is given twice"));
        }
        found.push(match contacts.iter().find(|contact| *contact == name) {
            Some(name) => contact(name),
            None => part_beside(system, argument, (contacts, name))?,
        });
    }
    Ok(found)
}

/// Returns the mass, or the combination of masses and base, with this name. With a single contact, the name may also be
/// that of the contact in the description.
pub(super) fn part_beside(
    system: &System,
    argument: &str,
    (contacts, name): (&[String], &str),
) -> Result<MovingPart, String> {
    let known = contacts.join(", ");
    MovingPart::named(system, name)
        .map_err(|error| format!("{argument}: {error}; the contacts are {known}"))
}

impl DrivenTable<'_> {
    /// Returns the index of the contact that a part names.
    fn contact(&self, part: &MovingPart) -> Option<usize> {
        let index = || self.names.iter().position(|name| *name == part.name);
        // With a single contact, its name may also be `slip(contact)`.
        match part.of {
            Of::Contact => Some(index().unwrap_or(0)),
            Of::ContactAt(index) => Some(index),
            _ => None,
        }
    }

    /// Returns a row of the table. `base` and `masses` have displacements in m and velocities in m/s.
    #[must_use]
    pub fn sample(
        &self,
        (time, events): (f64, usize),
        (base, masses): ([f64; 2], &[[f64; 2]]),
        contacts: Vec<JoinedContactNow>,
    ) -> DrivenSample {
        let motion = |part: &MovingPart| match self.contact(part) {
            Some(index) => {
                let now = contacts.get(index)?;
                Some([now.displacement, now.velocity])
            }
            None => self.system.combination_of(part.of, base, masses),
        };
        let motions = self
            .parts
            .iter()
            .map(|part| motion(part).unwrap_or_default());
        DrivenSample {
            time,
            motions: motions.collect(),
            contacts,
            events,
        }
    }

    /// Returns the columns of the table, with their names and units.
    #[must_use]
    pub fn columns<'d>(&self) -> Vec<Column<'d, DrivenSample>> {
        let mut columns = Columns::new(&Measure::si(self.system));
        let head = Head::of("time", PhysicalQuantity::Time);
        columns.number(head, |row: &DrivenSample| Some(row.time));
        for (place, part) in self.parts.iter().enumerate() {
            columns.begin_motion(part);
            let [displacement, velocity] = [0, 1]
                .map(|which| move |row: &DrivenSample| row.motions.get(place)?.get(which).copied());
            if part.of.is_force() {
                columns.converted(Head::of("force", PhysicalQuantity::Force), displacement);
                continue;
            }
            let head = Head::of("displacement", PhysicalQuantity::Length);
            columns.converted(head, displacement);
            columns.converted(Head::of("velocity", PhysicalQuantity::Velocity), velocity);
        }
        let stops = self.system.scene().joints.stops.len();
        let stops = self.names.len().saturating_sub(stops)..;
        for (index, name) in self.names.iter().enumerate() {
            columns.begin_contact(name);
            let now = move |row: &DrivenSample| row.contacts.get(index).copied();
            let is_stop = stops.contains(&index);
            let force = if is_stop { "force" } else { "friction" };
            columns.converted(Head::of(force, PhysicalQuantity::Force), move |row| {
                Some(now(row)?.force)
            });
            columns.word("state", "backward", move |row| {
                let now = now(row)?;
                Some(match is_stop {
                    true if now.is_sticking => "shut",
                    true => "open",
                    false => words::contact(now.contact()),
                })
            });
            if self.has_slips {
                columns.converted(Head::of("slip", PhysicalQuantity::Length), move |row| {
                    Some(now(row)?.slip)
                });
                columns.converted(Head::of("energy", PhysicalQuantity::Energy), move |row| {
                    Some(now(row)?.energy)
                });
            }
        }
        columns.end_parts();
        columns.count("events", |row| Some(row.events));
        columns.done()
    }
}
