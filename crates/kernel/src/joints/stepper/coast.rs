//! Ends a sub-interval of a step without a search for events, once the stepper has reached its bound on events.

use crate::Float;
use crate::errors::Halt;
use crate::joints::run::{Limits, Motion, Observe};
use crate::joints::series::Series;
use crate::joints::size::{Size, set, sign};
use crate::joints::state::{FREE, STUCK};

/// Number of pieces of motion for each event, before the stepper ends a sub-interval by the rule of this module. An event
/// ends a piece even if no contact changes its phase.
const PIECES: usize = 2;
/// Number of pieces of motion for each event with a friction law. A piece then also ends where the sliding speed leaves a
/// straight line of the law.
const PIECES_OF_LAW: usize = 4;

/// Limits on the work for one event in a step with an event budget.
pub(super) const LIMITS: Limits = Limits {
    divisions: 12,
    patterns: 40,
};

/// Returns the largest number of pieces of motion in a sub-interval with at most `events` events, before the rule of this
/// module ends it.
pub(super) const fn pieces(events: usize, has_law: bool) -> usize {
    1 + events * if has_law { PIECES_OF_LAW } else { PIECES }
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Advances the motion to the instant `until`. All contacts keep their phases. A contact whose velocity then has the
    /// wrong sign has passed a stop. It sticks from there on: a rigid contact gives its two sides a common velocity that
    /// conserves their momentum, so that the work of the wrong friction force is lost again.
    pub(super) fn coast(&mut self, until: S, watch: &mut impl Observe<S, Z>) -> Result<(), Halt> {
        let length = until - self.time;
        if length > S::constant(0.0) {
            let series = Series::new(&self.model, &self.state, &self.tree, (self.time, length));
            let end = S::constant(1.0);
            watch.follow(&self.model, &series, end, &self.state);
            watch.stretch(&series, end, &self.state);
            self.take(&series, end);
            self.finite()?;
        }
        self.time = until;
        self.forget_events(S::constant(1.0), S::constant(0.0));
        let (x, v) = self.nodes();
        for j in 0..self.model.contacts().len() {
            let phase = self.state.phase(j);
            let Some(contact) = self.model.contact(j) else {
                continue;
            };
            let speed = sign::<S>(phase) * self.model.slip(contact, v.as_ref());
            if [FREE, STUCK].contains(&phase) || speed > contact.creep() {
                continue;
            }
            let force = sign::<S>(phase) * contact.level.value(until, 0);
            let (is_rigid, place) = (contact.is_rigid(), contact.across(x.as_ref()));
            self.state.set_phase(j, STUCK);
            if is_rigid {
                set(self.state.places.as_mut(), j, place);
            } else {
                set(self.state.forces.as_mut(), j, force);
            }
        }
        self.set_stops();
        self.join();
        let (_, mut v) = self.nodes();
        self.tree.meet_moving(&self.model, v.as_mut());
        self.state.keep_speeds(v.as_ref());
        Ok(())
    }
}
