//! Rows and columns of motions over time: samples, events and spectra.

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
use super::measure::PhysicalQuantity;
use super::setting::{Frequency, MovingPart, Setting};
use crate::study::units::{hertz, polar, seconds};
use crate::study::{
    history::{History, HistoryEvent, Spectrum},
    words,
};
use crate::{Complex, Of};
use frictiongen_kernel::simulation::Contact;

/// A row of the table of samples: the motion at one instant.
#[derive(Clone, Copy, Debug)]
pub struct SampleRow<'h> {
    /// The motion over time to which the row belongs.
    pub history: &'h History,
    /// Index of the sample, counted from 0.
    pub index: usize,
    /// Angular frequency ω of the excitation, in rad/s. 1 for a free vibration, whose history is in s.
    pub omega: f64,
}

/// A row of the table of events: one stop, break-away or reversal of the contact.
#[derive(Clone, Copy, Debug)]
pub struct EventRow<'h> {
    /// Event of the row: a stop, a break-away or a reversal.
    pub event: &'h HistoryEvent,
    /// Angular frequency ω of the excitation, in rad/s.
    pub omega: f64,
}

/// A row of the table of spectra: one order. The order is the frequency of a component divided by the frequency of the
/// excitation.
#[derive(Clone, Copy, Debug)]
pub struct HarmonicRow<'h> {
    /// The spectra of the motions, one for the contact and for each mass in the table.
    pub spectra: &'h [Spectrum],
    /// Index of the row's order in each spectrum, counted from 0.
    pub index: usize,
    /// Angular frequency ω of the excitation, in rad/s.
    pub omega: f64,
}

/// The tables of a motion over time: samples, events and spectra.
#[derive(Clone, Copy)]
pub struct HistoryTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
    /// Frequency of the excitation in this motion over time.
    pub at: Frequency,
    /// True if the tables have columns in seconds and Hz in addition to τ and orders.
    pub in_seconds: bool,
}

/// A row of a table that belongs to one instant.
trait Timed: TableRow {
    /// Returns the instant of the row as phase τ = ωt, or in s for a free vibration.
    fn tau(&self) -> f64;
}

impl TableRow for SampleRow<'_> {
    fn omega(&self) -> f64 {
        self.omega
    }
}

impl Timed for SampleRow<'_> {
    fn tau(&self) -> f64 {
        self.history.tau(self.index)
    }
}

impl TableRow for EventRow<'_> {
    fn omega(&self) -> f64 {
        self.omega
    }
}

impl Timed for EventRow<'_> {
    fn tau(&self) -> f64 {
        self.event.tau
    }
}

impl TableRow for HarmonicRow<'_> {
    fn omega(&self) -> f64 {
        self.omega
    }
}

impl HarmonicRow<'_> {
    fn order(&self) -> Option<f64> {
        Some(self.spectra.first()?.lines.get(self.index)?.order)
    }

    fn component(&self, part: usize) -> Option<Complex<f64>> {
        Some(self.spectra.get(part)?.lines.get(self.index)?.component)
    }
}

impl<'a> HistoryTable<'a> {
    /// Returns a value of the motion `of`. If `of` is the contact's motion, and the units of the table reverse its
    /// sign, the value has the opposite sign.
    #[must_use]
    pub fn signed(&self, of: Of, value: f64) -> f64 {
        // A negation would turn 0 into −0, which a table would print. The subtraction from 0 gives 0.
        if self.setting.measure.turns(of) {
            0.0 - value
        } else {
            value
        }
    }

    fn state(&self, contact: Contact) -> &'static str {
        match self.setting.measure.turns_contact() {
            true => words::contact(contact.reversed()),
            false => words::contact(contact),
        }
    }

    /// Returns the table rows of the samples of a motion.
    pub fn samples<'h>(
        &self,
        history: &'h History,
    ) -> impl Iterator<Item = SampleRow<'h>> + use<'h> {
        let omega = self.at.omega;
        (0..history.len()).map(move |index| SampleRow {
            history,
            index,
            omega,
        })
    }

    /// Returns the table rows of the events of a motion.
    pub fn events<'h>(&self, history: &'h History) -> impl Iterator<Item = EventRow<'h>> + use<'h> {
        let omega = self.at.omega;
        let events = history.events.iter();
        events.map(move |event| EventRow { event, omega })
    }

    /// Returns the table rows of the spectra of the contact and masses.
    pub fn lines<'h>(
        &self,
        spectra: &'h [Spectrum],
    ) -> impl Iterator<Item = HarmonicRow<'h>> + use<'h> {
        let omega = self.at.omega;
        let count = spectra.first().map_or(0, |first| first.lines.len());
        (0..count).map(move |index| HarmonicRow {
            spectra,
            index,
            omega,
        })
    }

    fn time<R: Timed + 'a>(&self, columns: &mut Columns<'a, R>) {
        if self.in_seconds {
            columns.number(Head::of("time", PhysicalQuantity::Time), |row: &R| {
                Some(seconds(row.tau(), row.omega()))
            });
        }
        // The phase of a load has no meaning without a load.
        if !self.setting.measure.is_free() {
            columns.number("tau", |row: &R| Some(row.tau()));
        }
    }

    /// Returns the columns of the table of samples.
    #[must_use]
    pub fn sample_columns<'h: 'a>(&self) -> Vec<Column<'a, SampleRow<'h>>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.time(&mut columns);
        let table = *self;
        for (place, part) in self.setting.parts.iter().enumerate() {
            columns.begin_motion(part);
            let head = Head::of(word(part), part.dimension());
            columns.number(head, move |row: &SampleRow<'_>| {
                let track = row.history.tracks.get(place)?;
                let value = track.displacement.get(row.index)?;
                Some(table.signed(part.of, *value))
            });
            if part.of.is_force() {
                continue;
            }
            let head = Head::of("velocity", PhysicalQuantity::Velocity);
            columns.number(head, move |row| {
                let track = row.history.tracks.get(place)?;
                Some(table.signed(part.of, *track.velocity.get(row.index)?))
            });
        }
        columns.begin_contact(&self.setting.system.name_of_motion(Of::Contact));
        columns.number(Head::of("friction", PhysicalQuantity::Force), move |row| {
            let force = row.history.friction.get(row.index)?;
            Some(table.signed(Of::Contact, *force))
        });
        columns.word("state", "backward", move |row| {
            Some(table.state(*row.history.contact.get(row.index)?))
        });
        columns.done()
    }

    /// Returns the columns of the table of events.
    #[must_use]
    pub fn event_columns<'h: 'a>(&self) -> Vec<Column<'a, EventRow<'h>>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.time(&mut columns);
        let table = *self;
        columns.word("event", "break-away", |row: &EventRow<'_>| {
            Some(words::event(row.event.event))
        });
        columns.begin_contact(&self.setting.system.name_of_motion(Of::Contact));
        columns.word("state", "backward", move |row| {
            Some(table.state(row.event.contact))
        });
        for (place, part) in self.setting.parts.iter().enumerate() {
            columns.begin_motion(part);
            let head = Head::of(word(part), part.dimension());
            columns.number(head, move |row| {
                let value = row.event.displacements.get(place)?;
                Some(table.signed(part.of, *value))
            });
        }
        columns.done()
    }

    /// Returns the columns of the table of spectra.
    #[must_use]
    pub fn spectrum_columns<'h: 'a>(&self) -> Vec<Column<'a, HarmonicRow<'h>>> {
        let mut columns = Columns::new(&self.setting.measure);
        let table = *self;
        if self.in_seconds {
            let head = Head::of("frequency", PhysicalQuantity::Hertz);
            columns.number(head, |row: &HarmonicRow<'_>| {
                Some(hertz(row.omega) * row.order()?)
            });
        }
        columns.number("order", |row: &HarmonicRow<'_>| row.order());
        for (place, part) in self.setting.parts.iter().enumerate() {
            let component = move |row: &HarmonicRow<'_>| {
                let component = row.component(place)?;
                let signed = |value| table.signed(part.of, value);
                let component = Complex::new(signed(component.re), signed(component.im));
                Some(polar(component))
            };
            columns.begin_motion(part);
            let head = Head::of("amplitude", part.dimension());
            columns.number(head, move |row| Some(component(row)?.0));
            let head = Head::of("phase", PhysicalQuantity::Angle);
            columns.number(head, move |row| Some(component(row)?.1));
        }
        columns.done()
    }
}

/// Returns the word for a quantity in the names of columns: `force` for a spring or the base shear, otherwise
/// `displacement`.
fn word(part: &MovingPart) -> &'static str {
    if part.of.is_force() {
        "force"
    } else {
        "displacement"
    }
}
