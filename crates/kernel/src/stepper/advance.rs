//! Advances the motion through one sub-interval of a step. If the contact provably has no event, the stepper uses its
//! constant tables. In every other case it searches for events.

use super::interval::StepInterval;
use super::law::StepContact;
use crate::motion::Contact;
use crate::number::scalar::Float;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Advances the modes and the contact to the end of the sub-interval.
    pub(super) fn advance(&mut self) {
        if self.scene.damped_from_base() {
            self.account_base();
        }
        if self.status.level.is_zero() {
            return self.advance_without_friction();
        }
        self.advance_by_tables(self.driven());
        if self.status.unknown {
            self.derive_contact();
        }
        if self.is_elastic() {
            self.adapt_to_level();
        }
        let known = match self.status.contact {
            Contact::Stuck => self.stick_by_tables(),
            _ => self.slide_by_tables(),
        };
        if !known {
            self.follow_events();
        }
    }

    /// Advances the motion to the end of the sub-interval without friction. The contact then has no force, so that its
    /// reversals are not events.
    ///
    /// The stepper uses its constant tables for the whole sub-interval. Power series from event to event have rounding
    /// errors. These errors would violate the energy balance of an undamped chain.
    fn advance_without_friction(&mut self) {
        if self.status.contact == Contact::Stuck && !self.status.unknown {
            self.start_sliding();
        }
        self.status.unknown = true;
        self.status.wedged = false;
        if self.is_elastic() {
            self.drop_force(self.status.contact_force, S::constant(0.0));
        }
        self.status.contact_force = S::constant(0.0);
        self.advance_by_tables(0);
    }

    /// Advances the modes from the index `first` on to the end of the sub-interval. Friction does not act on these
    /// modes.
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
