//! Law of a rigid contact. The contact sticks up to the static force μF, and slides under the kinetic force F.

mod derivative;
mod on_chain;

use super::law::{Law, SlideStart};
use super::state::Contact;
use crate::number::scalar::Float;

/// Number of modes that the chain loses while a rigid contact sticks, because the contact then has no motion of its
/// own.
pub const LOST_MODES: usize = 1;

/// Kinetic friction force F of a rigid contact, and ratio μ of static to kinetic friction. The contact sticks up to
/// the force μF and slides under F. An elastic contact has the same forces.
#[derive(Clone, Copy, Debug)]
pub struct Rigid<S> {
    /// Kinetic friction force at zero sliding speed.
    pub level: S,
    /// Ratio μ of the static to the kinetic friction force.
    pub stiction: S,
}

impl<S: Float> Law<S> for Rigid<S> {
    #[inline]
    fn level(self) -> S {
        self.level
    }

    /// Returns μF, the static friction force of the contact.
    #[inline]
    fn grip(self) -> S {
        self.stiction * self.level
    }

    /// Returns true if the static friction force does not exceed the kinetic friction force. The distance between two
    /// motions then never grows.
    fn is_contraction(self) -> bool {
        self.stiction <= S::constant(1.0)
    }

    #[inline]
    fn leave_rest(self, force: S) -> Option<SlideStart<S>> {
        if force.abs() <= self.grip() {
            return None;
        }
        Some(self.slide(Contact::along(force), force))
    }

    #[inline]
    fn break_away(self, contact: Contact) -> SlideStart<S> {
        SlideStart {
            contact,
            excess: self.grip() - self.level,
        }
    }
}
