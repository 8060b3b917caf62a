//! Searches a sub-interval of a step for events (stops, break-aways and reversals), and advances the motion from event
//! to event.

use super::interval::{ROUNDINGS, StepInterval};
use super::law::StepContact;
use crate::motion::{Contact, Law, line_at};
use crate::number::scalar::Float;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Advances the motion from event to event until the end of the sub-interval.
    pub(super) fn follow_events(&mut self) {
        let one = S::constant(1.0);
        let mut departing = None;
        let (events, pieces) = self.bounds();
        for _ in 0..pieces {
            if !(self.progress < one) || events <= self.events {
                break;
            }
            departing = match self.status.contact {
                Contact::Stuck => self.stick_to_event(),
                _ => self.slide_to_event(departing),
            };
        }
        if self.progress < one {
            self.finish(departing);
        }
        if self.status.contact == Contact::Stuck {
            self.status.contact_force = self.stuck_force();
        }
    }

    /// Determines the state of the contact before the first step. The inputs have their values at the start of the
    /// first step.
    pub(super) fn begin(&mut self) {
        self.derive_contact();
        if self.status.contact != Contact::Stuck {
            return;
        }
        let force = self.stuck_force();
        let law = self.law();
        // The acceleration of a moving base is unknown before the first step. The first step therefore decides if the
        // contact breaks away. Until then the force stays within the static friction force.
        self.status.contact_force = law.limited(force);
        let slide = law.leave_rest(force);
        if let Some(slide) = slide.filter(|_| !self.scene.rubs_on_base()) {
            // The contact breaks away at once. The first step finds this break-away again, and counts it as an event.
            self.start_sliding();
            self.status.contact = slide.contact;
            self.status.contact_force = law.kinetic(slide.contact);
            self.status.unknown = true;
        }
    }

    /// Determines the state of the contact from the velocities of the modes. For an elastic contact, the state also
    /// depends on the force of the contact's spring.
    pub(super) fn derive_contact(&mut self) {
        self.status.unknown = false;
        self.status.wedged = false;
        if self.is_elastic() {
            return self.derive_elastic();
        }
        let velocity = self.velocity_series([S::constant(0.0); 2]);
        let rate = velocity.term(0);
        let pace = &self.table.pace;
        let speed = rate.abs() * S::constant(f64::from(pace.parts)) / pace.step;
        self.status.contact = Contact::along(rate);
        self.status.line = line_at(self.scene.law, speed);
        let size = velocity.size + self.status.given * pace.span;
        if rate.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
            // The search for events comes next. This search decides from the contact force if the contact breaks away
            // at once.
            self.start_sticking(None);
        }
    }
}
