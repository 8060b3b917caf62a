//! Bounds on the number of events in a step, and the rule with which the stepper ends a sub-interval beyond these
//! bounds.
//!
//! The rule needs no search for events. If the contact is at rest and its force does not exceed μF, the contact stays
//! stuck for the rest of the sub-interval. In every other case the friction force is constant for the rest of the
//! sub-interval. The rule chooses this force between minus and plus the kinetic force, so that the contact moves least.
//! This force times the displacement of the contact is therefore dissipated energy or zero, and the rule never creates
//! energy. If the contact would not have stopped, the constant force is the kinetic force, and the motion is exact.

use super::cost::{PIECES, RULE, SEARCH};
use super::interval::{Departure, StepInterval, integral};
use super::law::StepContact;
use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::motion::{Contact, Law, Power, WALK};
use crate::number::scalar::Float;

/// Smallest force in a stuck contact at which the rule of this module lets the contact break away, divided by μF. The
/// constant exceeds 1 by far more than rounding errors, so that a contact that can stick never moves.
const OVERLOADED: f64 = 1.0 + 1.0 / 1024.0;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Returns two bounds for this sub-interval: the number of events, and the number of pieces of motion between
    /// events. At either bound the stepper ends the sub-interval without a search.
    pub(super) fn bounds(&self) -> (u32, u32) {
        if self.status.budget == 0 {
            // The rule costs at most as much as RULE pieces. The pieces and the rule together therefore cost at most as
            // much as MAX_STRETCHES pieces.
            return (MAX_EVENTS, MAX_STRETCHES - RULE);
        }
        let events =
            (u32::from(self.status.budget) + 1).saturating_sub(u32::from(self.status.spent));
        let pieces = if self.scene.law.is_empty() { 1 } else { PIECES };
        (events, pieces * events)
    }

    /// Returns the largest number of evaluations in one search for an event.
    #[inline]
    pub(super) fn search(&self) -> u32 {
        if self.status.budget == 0 {
            WALK
        } else {
            SEARCH
        }
    }

    /// Advances the motion to the end of the sub-interval without a search for events, by the rule of this module. A
    /// contact at rest stays stuck if its force does not exceed μF. In every other case the friction force is constant.
    pub(super) fn finish(&mut self, mut departing: Option<Departure<S>>) {
        self.exceeded = true;
        let left = S::constant(1.0) - self.progress;
        if self.status.contact == Contact::Stuck {
            departing = self.overloaded();
            if self.status.contact == Contact::Stuck {
                return self.move_held(left);
            }
        }
        let zero = S::constant(0.0);
        let contact = self.status.contact;
        let sign: S = contact.sign();
        let [level, slope] = self.law().kinetic_on(&self.line(), contact);
        let kinetic = if slope.is_zero() || departing.is_some() {
            level
        } else {
            level + slope * self.relative_rate()
        };
        let mut velocity = self.velocity_series([kinetic, zero]);
        let moved = integral(velocity.used(), left);
        if zero < sign * moved {
            return self.slide_on(&velocity, kinetic, left);
        }
        if let Some(Departure { stuck, .. }) = departing {
            // The contact would move against the direction in which it has started to slide. The code therefore keeps
            // the contact where it was stuck.
            self.start_sticking(stuck);
            return self.move_held(left);
        }
        if self.is_elastic() {
            self.start_sticking(None);
            return self.move_held(left);
        }
        let free = self.velocity_series([zero; 2]);
        let freely = integral(free.used(), left);
        // The displacement of the contact depends linearly on the friction force. The quotient is the force for zero
        // displacement, divided by the kinetic force. The quotient is less than 1. If the quotient is less than −1, the
        // contact reverses and then slides.
        let share = (freely / (freely - moved))
            .max(S::constant(-1.0))
            .min(S::constant(1.0));
        velocity.mix(&free, share);
        self.slide_on(&velocity, share * kinetic, left);
    }

    /// Changes the contact from sticking to sliding if its force exceeds μF by more than rounding errors. Returns the
    /// start of the sliding motion, or `None` if the contact still sticks or is elastic.
    fn overloaded(&mut self) -> Option<Departure<S>> {
        let (law, force) = (self.law(), self.stuck_force());
        if self.status.wedged || force.abs() <= law.grip() * S::constant(OVERLOADED) {
            return None;
        }
        let contact = Contact::along(force);
        if self.is_elastic() {
            self.yield_under(force, contact);
            return None;
        }
        let slide = law.slide(contact, force.abs());
        self.start_sliding();
        self.status.contact = slide.contact;
        self.status.line = 0;
        Some(Departure {
            slope: self.acceleration(slide.excess),
            stuck: Some(self.status.stuck_at),
        })
    }

    /// Advances the sliding contact to the end of the sub-interval under a constant friction force.
    fn slide_on(&mut self, velocity: &Power<S>, force: S, left: S) {
        let zero = S::constant(0.0);
        let contact = self.status.contact;
        self.move_modes(velocity, [force, zero], left);
        let rate = self.relative_rate();
        if self.scene.law.is_empty() && zero < contact.sign::<S>() * rate {
            return;
        }
        // The next sub-interval computes the state of the contact from its velocity.
        self.status.unknown = true;
        if !self.is_elastic() {
            self.status.contact = Contact::along(rate);
            self.status.contact_force = force;
        }
    }
}
