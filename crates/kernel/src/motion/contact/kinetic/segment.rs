//! One segment of the motion (between two events) under any kinetic friction law. With a constant force the motion is a
//! sum over the modes. On a line of the law the motion is a power series.

use super::coupled;
use super::lines::KineticLaw;
use crate::motion::contact::law::{ContactChain, Law};
use crate::motion::contact::state::{Contact, ContactState, Sought};
use crate::motion::oscillator::Part;
use crate::motion::segment;
use crate::motion::setting::MotionSetting;
use crate::number::scalar::Float;

impl<'a, S: Float, K: ContactChain<S>> MotionSetting<'a, S, K> {
    /// Searches for the event that ends the segment after the given state of the contact. The search covers the time
    /// `reach` in τ (rad of the excitation). Also prepares the oscillators for the segment.
    pub(crate) fn seek_under(
        &self,
        level: &mut impl KineticLaw<'a, S>,
        parts: &mut [Part<S>],
        contact_state: ContactState<S>,
        reach: S,
    ) -> Sought<S> {
        let (modes, stuck_modes) = self.split(parts);
        match level.lines_mut() {
            Some(lines) if contact_state.contact != Contact::Stuck => {
                coupled::seek(self, modes, lines, contact_state, reach)
            }
            _ => segment::seek(self, modes, stuck_modes, contact_state, reach),
        }
    }

    /// Sets the oscillators to their state a time τ after the start of the segment. `to` is sine and cosine of the
    /// excitation's phase at that instant.
    pub(crate) fn place_under(
        &self,
        level: &impl KineticLaw<'a, S>,
        parts: &mut [Part<S>],
        sought: &Sought<S>,
        (tau, to): (S, (S, S)),
    ) {
        let (modes, stuck_modes) = self.split(parts);
        match level.lines() {
            Some(lines) if sought.contact_state.contact != Contact::Stuck => {
                coupled::place(self, modes, lines, (&sought.contact_state, tau), to);
            }
            _ => segment::place(self, (modes, stuck_modes), sought, tau, to),
        }
    }

    /// Returns the contact force divided by P, the amplitude of the load. While the contact sticks, this force keeps
    /// the contact at rest.
    pub(crate) fn contact_force(
        &self,
        level: &impl KineticLaw<'a, S>,
        parts: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S {
        let contact = contact_state.contact;
        if contact == Contact::Stuck {
            return K::stuck_force(self, parts, contact_state, at);
        }
        let Some(lines) = level.lines() else {
            return self.law().kinetic(contact);
        };
        let (velocity, _) = self.relative_velocity(parts, at);
        let line = lines.line();
        // Rounding may put the speed slightly outside the line.
        let speed = velocity.abs().max(line.low);
        let speed = line.high.map_or(speed, |high| speed.min(high));
        self.law().kinetic_at(&line, contact, speed)
    }
}
