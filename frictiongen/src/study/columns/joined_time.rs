//! Tables of motions in time of scenes with several contacts: samples and events.

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
use super::joined::JoinedTable;
use super::measure::PhysicalQuantity;
use crate::study::joined::JoinedHistory;

/// A row of the table of samples: the motion of a scene with several contacts at one instant.
#[derive(Clone, Copy, Debug)]
pub struct JoinedSample<'h> {
    /// The motion over time to which the row belongs.
    pub history: &'h JoinedHistory,
    /// Index of the sample, counted from 0.
    pub index: usize,
    /// Angular frequency ω of the excitation, in rad/s.
    pub omega: f64,
}

impl TableRow for JoinedSample<'_> {
    fn omega(&self) -> f64 {
        self.omega
    }
}

/// A row of the table of events: one event of a contact in a scene with several contacts.
#[derive(Clone, Copy, Debug)]
pub struct JoinedEventRow<'h> {
    /// The motion over time to which the row belongs.
    pub history: &'h JoinedHistory,
    /// Index of the event, counted from 0.
    pub index: usize,
    /// Angular frequency ω of the excitation, in rad/s.
    pub omega: f64,
}

impl TableRow for JoinedEventRow<'_> {
    fn omega(&self) -> f64 {
        self.omega
    }
}

impl<'a> JoinedTable<'a> {
    /// Fails if the table has a motion that a table of a motion in time cannot have.
    ///
    /// # Errors
    /// A message, which begins with the name of the `argument` that contains the motions.
    pub fn check_in_time(&self, argument: &str) -> Result<(), String> {
        let zeros = vec![0.0; self.joined.scene().masses.len()];
        let mut parts = self.setting.parts.iter();
        parts.find(|part| part.among(&zeros).is_none()).map_or(Ok(()), |part| {
            Err(format!(
                "{argument} `{}`: a motion in time of several contacts has masses and differences of two masses, such as f2-f1",
                part.name
            ))
        })
    }

    /// Returns the factor on the relative displacement of a contact. Under a load, a contact `a - b` of two masses has
    /// the displacement x_b − x_a. Without a load, the contact has the displacement of the later mass minus the
    /// displacement of the earlier mass.
    #[must_use]
    pub fn sign(&self, contact: usize) -> f64 {
        match self.setting.measure.scale() {
            Some(_) => self.joined.sign(contact),
            None => 1.0,
        }
    }

    /// Returns the columns of the table of samples.
    #[must_use]
    pub fn sample_columns<'h>(&self) -> Vec<Column<'a, JoinedSample<'h>>>
    where
        'h: 'a,
    {
        let mut columns = Columns::new(&self.setting.measure);
        let tau = |row: &JoinedSample<'h>| row.history.taus.get(row.index).copied();
        if self.setting.frequency.has_hertz() {
            columns.number(Head::of("time", PhysicalQuantity::Time), move |row| {
                Some(tau(row)? / row.omega)
            });
        }
        // The phase of a load has no meaning without a load.
        if !self.setting.measure.is_free() {
            columns.number("tau", tau);
        }
        for (index, name) in self.joined.contact_names().iter().enumerate() {
            columns.begin_contact(name);
            let sign = self.sign(index);
            let now = move |row: &JoinedSample<'h>| {
                let now = row.history.contacts.get(row.index)?.get(index)?;
                Some(now.signed(sign))
            };
            columns.number(
                Head::of("displacement", PhysicalQuantity::Length),
                move |row| Some(now(row)?.displacement),
            );
            columns.number(
                Head::of("velocity", PhysicalQuantity::Velocity),
                move |row| Some(now(row)?.velocity),
            );
            columns.number(Head::of("force", PhysicalQuantity::Force), move |row| {
                Some(now(row)?.force)
            });
            columns.number(Head::of("slip", PhysicalQuantity::Length), move |row| {
                Some(now(row)?.slip)
            });
            columns.flag("sticks", move |row| Some(now(row)?.is_sticking));
        }
        for part in self.setting.parts {
            columns.begin_part(&part.name);
            columns.number(
                Head::of("displacement", PhysicalQuantity::Length),
                move |row| {
                    let (x, _) = row.history.states.get(row.index)?;
                    part.among(x)
                },
            );
            columns.number(
                Head::of("velocity", PhysicalQuantity::Velocity),
                move |row| {
                    let (_, v) = row.history.states.get(row.index)?;
                    part.among(v)
                },
            );
        }
        columns.end_parts();
        columns.done()
    }

    /// Returns the columns of the table of events.
    #[must_use]
    pub fn event_columns<'h>(&self) -> Vec<Column<'a, JoinedEventRow<'h>>>
    where
        'h: 'a,
    {
        let mut columns = Columns::new(&self.setting.measure);
        let tau = |row: &JoinedEventRow<'h>| Some(row.history.events.get(row.index)?.tau);
        if self.setting.frequency.has_hertz() {
            columns.number(Head::of("time", PhysicalQuantity::Time), move |row| {
                Some(tau(row)? / row.omega)
            });
        }
        // The phase of a load has no meaning without a load.
        if !self.setting.measure.is_free() {
            columns.number("tau", tau);
        }
        columns.word("contact", "contact", |row: &JoinedEventRow<'h>| {
            Some(row.history.events.get(row.index)?.name.as_str())
        });
        columns.word("event", "reversal", |row: &JoinedEventRow<'h>| {
            Some(row.history.events.get(row.index)?.word())
        });
        for part in self.setting.parts {
            columns.begin_part(&part.name);
            let head = Head::of("displacement", PhysicalQuantity::Length);
            columns.number(head, move |row| {
                let event = row.history.events.get(row.index)?;
                part.among(&event.displacements)
            });
        }
        columns.done()
    }
}
