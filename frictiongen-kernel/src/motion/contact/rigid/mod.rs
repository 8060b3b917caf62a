//! The law of a rigid contact: it sticks up to the static force μF, and slides under the kinetic force F.

mod derivative;
mod sticking;
mod stuck_chain;

pub(crate) use derivative::carry_deviations;

use super::kinetic::Line;
use super::state::Contact;
use crate::contact::sums::Chain;
use crate::number::scalar::Float;

/// Number of modes that the chain loses while a rigid contact sticks.  The contact then has no motion of its own.
pub const LOST_MODES: usize = 1;

/// Floquet multipliers of a contact that never slides.  A deviation of its displacement stays, and a deviation of its
/// velocity vanishes at once.
pub(crate) const STUCK_MULTIPLIERS: [f64; 2 * LOST_MODES] = [1.0, 0.0];

/// The forces of a contact, all in one unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rigid<S> {
    /// Kinetic friction force at zero speed.
    pub level: S,
    /// μ, static over kinetic friction force.
    pub stiction: S,
}

/// Start of sliding, from rest or from a stuck contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slide<S> {
    /// Direction of sliding.
    pub contact: Contact,
    /// Excess over the kinetic force of the force that would keep the contact at rest.
    pub excess: S,
}

impl<S: Float> Rigid<S> {
    /// The law of a chain's contact under this kinetic friction force.
    #[inline]
    pub(crate) fn on_chain(chain: &Chain<S>, level: S) -> Self {
        Self {
            level,
            stiction: chain.stiction,
        }
    }

    /// Largest contact force that keeps the contact stuck.
    #[inline]
    pub(crate) fn grip(self) -> S {
        self.stiction * self.level
    }

    /// A force in the stuck contact, limited to the static force.
    pub(crate) fn limited(self, force: S) -> S {
        force.abs().min(self.grip()).copysign(force)
    }

    /// Returns true if a force that holds the contact is so near the static force that rounding decides.  `share` is the
    /// distance, relative to the static force.
    pub(crate) fn is_marginal(self, force: S, share: S) -> bool {
        let grip = self.grip();
        (force.abs() - grip).abs() <= grip * share
    }

    /// Returns true if two motions never move apart, because the static force does not exceed the kinetic one.
    pub(crate) fn is_contraction(self) -> bool {
        self.stiction <= S::constant(1.0)
    }

    /// The contact force while the contact slides under constant kinetic friction.
    #[inline]
    pub(crate) fn kinetic(self, contact: Contact) -> S {
        contact.sign::<S>() * self.level
    }

    /// Level and slope of the contact force over the relative velocity, on a line of the kinetic friction.
    #[inline]
    pub(crate) fn kinetic_on(self, line: &Line<S>, contact: Contact) -> [S; 2] {
        let sign: S = contact.sign();
        [sign * self.level * line.level, self.level * line.slope]
    }

    /// The contact force while the contact slides at this speed, on a line of the kinetic friction.
    #[inline]
    pub(crate) fn kinetic_at(self, line: &Line<S>, contact: Contact, speed: S) -> S {
        contact.sign::<S>() * (self.level * (line.level + line.slope * speed))
    }

    /// Decides what follows at zero relative velocity.  `force` would keep the contact at rest.  Returns `None` if the
    /// contact sticks.
    #[inline]
    pub(crate) fn leave_rest(self, force: S) -> Option<Slide<S>> {
        if force.abs() <= self.grip() {
            return None;
        }
        Some(self.slide(Contact::along(force), force))
    }

    /// The start of sliding in a direction, where `force` would keep the contact at rest.
    #[inline]
    pub(crate) fn slide(self, contact: Contact, force: S) -> Slide<S> {
        Slide {
            contact,
            excess: force.abs() - self.level,
        }
    }

    /// The start of sliding where the force in the stuck contact has reached the static force.
    #[inline]
    pub(crate) fn break_away(self, contact: Contact) -> Slide<S> {
        Slide {
            contact,
            excess: self.grip() - self.level,
        }
    }
}
