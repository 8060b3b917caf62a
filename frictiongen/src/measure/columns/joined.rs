//! Rows and columns of the table of a motion that a stepper computes under a sampled input, for a scene with several
//! contacts.

use crate::study::System;
use crate::study::columns::{
    Column, Columns, Head, Measure, MovingPart, PhysicalQuantity, TableRow,
};
use crate::study::joined::{Joined, JoinedContactNow, JoinedStepper};

/// A contact, a mass or a combination of masses whose motion the table contains.
#[derive(Clone, Debug)]
pub enum JoinedPart {
    /// A contact. The number is its index in the scene description, counted from 0.
    Contact(usize),
    /// The motion of a mass, or of a combination of masses and base.
    Mass(MovingPart),
}

/// The motion of masses and of all contacts at every sample of an input.
#[derive(Clone, Debug, Default)]
pub struct JoinedDriven {
    /// Time of each sample, in s.
    pub time: Vec<f64>,
    /// Displacement in m and velocity in m/s of each requested mass or combination, at every sample. For the force of a
    /// spring, the lists contain the force in N and its time derivative.
    pub motions: Vec<[Vec<f64>; 2]>,
    /// For each sample, the motion and force of every contact.
    pub contacts: Vec<Vec<JoinedContactNow>>,
    /// Factor 1 or −1 by which the table multiplies the motion and the force of each contact ([`Joined::sign`]). The
    /// factor is −1 if the description of the contact names the later of its two masses first.
    signs: Vec<f64>,
    events: Vec<usize>,
}

/// Row of the table: the motion at one sample.
#[derive(Clone, Copy, Debug)]
pub struct JoinedDrivenRow<'d> {
    driven: &'d JoinedDriven,
    index: usize,
}

impl TableRow for JoinedDrivenRow<'_> {}

impl JoinedPart {
    /// Returns the mass or the combination of masses and base. Returns `None` for a contact.
    #[must_use]
    pub fn mass(&self) -> Option<&MovingPart> {
        match self {
            Self::Contact(_) => None,
            Self::Mass(part) => Some(part),
        }
    }
}

impl JoinedDriven {
    /// Adds the present state of a stepper to the table. `base` is the displacement and the velocity of the base, in m
    /// and m/s. `events` is the number of events of all contacts since the previous sample.
    pub fn push(
        &mut self,
        stepper: &JoinedStepper<'_>,
        (system, parts): (&System, &[JoinedPart]),
        base: [f64; 2],
        events: usize,
    ) {
        let masses = stepper.masses();
        let of_masses = || parts.iter().filter_map(JoinedPart::mass);
        self.motions.resize(of_masses().count(), Default::default());
        for (part, [displacement, velocity]) in of_masses().zip(&mut self.motions) {
            let motion = system.combination_of(part.of, base, &masses);
            let [x, v] = motion.unwrap_or_default();
            displacement.push(x);
            velocity.push(v);
        }
        let contacts = stepper.contacts();
        if self.signs.is_empty() {
            let signs = (0..contacts.len()).map(|contact| stepper.joined().sign(contact));
            self.signs = signs.collect();
        }
        let contacts = contacts.into_iter().zip(&self.signs);
        let contacts = contacts.map(|(now, sign)| now.signed(*sign));
        self.contacts.push(contacts.collect());
        self.events.push(events);
        self.time.push(stepper.time());
    }

    /// Returns the rows of the table, one for each sample.
    pub fn rows(&self) -> impl Iterator<Item = JoinedDrivenRow<'_>> {
        (0..self.time.len()).map(|index| JoinedDrivenRow {
            driven: self,
            index,
        })
    }

    /// Returns the motion and force of a contact at every sample.
    #[must_use]
    pub fn contact(&self, index: usize) -> Vec<JoinedContactNow> {
        let states = self.contacts.iter();
        states.filter_map(|all| all.get(index).copied()).collect()
    }

    /// Returns the columns of the table, with their names and units.
    #[must_use]
    pub fn columns<'d>(
        system: &System,
        joined: &Joined<'_>,
        parts: &[JoinedPart],
    ) -> Vec<Column<'d, JoinedDrivenRow<'d>>> {
        let names = joined.contact_names();
        let mut columns = Columns::new(&Measure::si(system));
        let head = Head::of("time", PhysicalQuantity::Time);
        columns.number(head, |row: &JoinedDrivenRow<'_>| {
            row.driven.time.get(row.index).copied()
        });
        let mut masses = 0;
        for part in parts {
            match part {
                JoinedPart::Contact(index) => {
                    columns.begin_contact(names.get(*index).map_or("", String::as_str));
                    moves(&mut columns, *index);
                }
                JoinedPart::Mass(part) => {
                    columns.begin_part(&part.name);
                    of_mass(&mut columns, part, masses);
                    masses += 1;
                }
            }
        }
        for (index, name) in names.iter().enumerate() {
            columns.begin_contact(name);
            pulls(&mut columns, index);
        }
        columns.end_parts();
        columns.count("events", |row| row.driven.events.get(row.index).copied());
        columns.done()
    }
}

/// Returns the motion and force of the contact with the index `contact` at the sample of a row.
fn now(row: &JoinedDrivenRow<'_>, contact: usize) -> Option<JoinedContactNow> {
    let all = row.driven.contacts.get(row.index)?;
    all.get(contact).copied()
}

/// Adds the columns with the relative displacement and velocity of a contact to a table.
fn moves<'d>(columns: &mut Columns<'d, JoinedDrivenRow<'d>>, index: usize) {
    columns.converted(
        Head::of("displacement", PhysicalQuantity::Length),
        move |row| Some(now(row, index)?.displacement),
    );
    columns.converted(
        Head::of("velocity", PhysicalQuantity::Velocity),
        move |row| Some(now(row, index)?.velocity),
    );
}

/// Adds the columns with the force, slip, energy and state of a contact to a table.
fn pulls<'d>(columns: &mut Columns<'d, JoinedDrivenRow<'d>>, index: usize) {
    columns.converted(Head::of("force", PhysicalQuantity::Force), move |row| {
        Some(now(row, index)?.force)
    });
    columns.converted(Head::of("slip", PhysicalQuantity::Length), move |row| {
        Some(now(row, index)?.slip)
    });
    columns.converted(Head::of("energy", PhysicalQuantity::Energy), move |row| {
        Some(now(row, index)?.energy)
    });
    columns.flag("sticks", move |row| Some(now(row, index)?.is_sticking));
}

/// Adds the columns of a mass or of a combination of masses and base to a table.
fn of_mass<'d>(columns: &mut Columns<'d, JoinedDrivenRow<'d>>, part: &MovingPart, place: usize) {
    let read = move |row: &JoinedDrivenRow<'_>, which: usize| {
        let motion = row.driven.motions.get(place)?.get(which)?;
        motion.get(row.index).copied()
    };
    if part.of.is_force() {
        columns.converted(Head::of("force", PhysicalQuantity::Force), move |row| {
            read(row, 0)
        });
        return;
    }
    columns.converted(
        Head::of("displacement", PhysicalQuantity::Length),
        move |row| read(row, 0),
    );
    columns.converted(
        Head::of("velocity", PhysicalQuantity::Velocity),
        move |row| read(row, 1),
    );
}
