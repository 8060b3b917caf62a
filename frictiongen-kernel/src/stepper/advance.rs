//! One sub-interval of a step: by the tables where the contact certainly has no event, by a search for events
//! elsewhere.

use super::interval::Interval;
use crate::motion::Contact;
use crate::number::scalar::Float;

impl<S: Float, const D: usize> Interval<'_, '_, S, D> {
    /// Advances through the sub-interval.
    pub(super) fn advance(&mut self) {
        if self.scene.damped_from_base() {
            self.account_base();
        }
        if self.status.law.level.is_zero() {
            return self.advance_without_friction();
        }
        self.advance_by_tables(self.driven());
        if self.status.unknown {
            self.derive_contact();
        }
        let known = match self.status.contact {
            Contact::Stuck => self.stick_by_tables(),
            _ => self.slide_by_tables(),
        };
        if !known {
            self.follow_events();
        }
    }

    /// Advances without friction.  No force then keeps the contact at rest, so that its turning points are no events.
    ///
    /// The tables serve for the whole sub-interval.  Power series about events would not do.  Their rounded sums do not
    /// keep the energy of an undamped chain in step with the work.
    fn advance_without_friction(&mut self) {
        if self.status.contact == Contact::Stuck && !self.status.unknown {
            self.start_sliding();
        }
        self.status.unknown = true;
        self.status.wedged = false;
        self.status.contact_force = S::constant(0.0);
        self.advance_by_tables(0);
    }

    /// Advances the modes from index `first` on, which feel no friction, over the whole sub-interval.
    fn advance_by_tables(&mut self, first: usize) {
        if self.scene.damped_from_base() {
            self.account_reaction(first..self.store.modes.len(), S::constant(0.0));
        }
        for index in first..self.store.modes.len() {
            let Some(step) = self.table.modes.get(index) else {
                continue;
            };
            let drive = self.load(index);
            let Some(state) = self.store.modes.get_mut(index) else {
                continue;
            };
            let (next, work) = step.moved(*state, &drive, &drive);
            *state = next;
            self.status.load = self.status.load.plus(work);
        }
    }
}
