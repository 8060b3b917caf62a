//! Changes of the motion of the base, with or without a jump of its displacement and velocity.

use super::base::Curve;
use super::run::Motion;
use super::size::{Size, at, set};
use super::state::{FREE, STUCK};
use crate::Float;
use crate::errors::Halt;

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Changes the motion of the base from the present instant on. The displacement and the velocity of the base may
    /// jump. The masses keep their displacements and velocities. In a contact between a mass and the base, the relative
    /// displacement and velocity therefore jump.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the solver cannot decide which contacts stick.
    pub(super) fn jolt_base(&mut self, to: Curve<S>) -> Result<(), Halt> {
        let zero = S::constant(0.0);
        let (before, after) = (self.model.base.value(self.time, 0), to.value(self.time, 0));
        let rounding = S::constant(4.0 * S::EPSILON) * after.abs();
        let rise = after - before;
        let rise = if rise.abs() <= rounding { zero } else { rise };
        self.model.base = to;
        self.accelerations_jump();
        let (x, v) = self.nodes();
        let base = self.model.base_node();
        for (j, contact) in self.model.contacts().iter().enumerate() {
            if contact.is_free() || contact.minus != base || self.model.is_stop(j) {
                continue;
            }
            let speed = self.model.slip(contact, v.as_ref());
            let slides = if speed > zero { 1 } else { -1 };
            let phase = match contact.stiffness {
                None if speed.is_zero() => STUCK,
                None => slides,
                Some(stiffness) => {
                    let level = contact.level.value(self.time, 0);
                    let slid = self.state.phase(j) != STUCK;
                    let force = at(self.state.forces.as_ref(), j) - stiffness * rise;
                    let most = if slid {
                        level
                    } else {
                        contact.stiction * level
                    };
                    let breaks = force.abs() > most;
                    let kept = if breaks { level.copysign(force) } else { force };
                    set(self.state.forces.as_mut(), j, kept);
                    let goes = breaks || (slid && kept.abs() >= level);
                    if goes && kept * speed > zero {
                        slides
                    } else {
                        STUCK
                    }
                }
            };
            set(self.state.places.as_mut(), j, contact.across(x.as_ref()));
            if self.state.phase(j) != phase && self.state.phase(j) != FREE {
                self.state.set_zeros(j, (0, phase));
            }
            self.state.set_phase(j, phase);
        }
        self.set_stops();
        self.decide_at_once()
    }
}
