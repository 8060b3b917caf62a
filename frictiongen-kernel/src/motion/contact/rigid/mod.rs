//! The law of a rigid contact: it sticks up to the static force μF, and slides under the kinetic force F.

mod derivative;
mod on_chain;

use super::law::{Law, Slide};
use super::state::Contact;
use crate::number::scalar::Float;

/// Number of modes that the chain loses while a rigid contact sticks. The contact then has no motion of its own.
pub const LOST_MODES: usize = 1;

/// The friction forces of a contact that sticks up to μF and slides under F, in one unit.
#[derive(Clone, Copy, Debug)]
pub struct Rigid<S> {
    /// Kinetic friction force at zero speed.
    pub level: S,
    /// Ratio μ of the static to the kinetic friction force.
    pub stiction: S,
}

impl<S: Float> Law<S> for Rigid<S> {
    #[inline]
    fn level(self) -> S {
        self.level
    }

    /// Returns the static friction force μF.
    #[inline]
    fn grip(self) -> S {
        self.stiction * self.level
    }

    /// The distance of two motions never grows if the static force does not exceed the kinetic force.
    fn is_contraction(self) -> bool {
        self.stiction <= S::constant(1.0)
    }

    #[inline]
    fn leave_rest(self, force: S) -> Option<Slide<S>> {
        if force.abs() <= self.grip() {
            return None;
        }
        Some(self.slide(Contact::along(force), force))
    }

    #[inline]
    fn break_away(self, contact: Contact) -> Slide<S> {
        Slide {
            contact,
            excess: self.grip() - self.level,
        }
    }
}
