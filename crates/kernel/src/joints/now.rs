//! Motion of the masses and the contacts of a chain at one instant.

use super::run::Motion;
use super::size::{Size, at};
use super::state::STUCK;
use crate::Float;
use crate::motion::Contact;

/// Displacement and velocity of a mass at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MassState<S> {
    pub(super) displacement: S,
    pub(super) velocity: S,
}

impl<S: Float> MassState<S> {
    /// Returns the displacement of the mass at this instant.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the velocity of the mass at this instant.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// Motion and force of one contact at one instant, in a chain with several contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ContactState<S> {
    pub(super) displacement: S,
    pub(super) velocity: S,
    pub(super) force: S,
    pub(super) is_sticking: bool,
}

impl<S: Float> ContactState<S> {
    /// Returns the relative displacement of the contact's two sides at this instant.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the relative velocity of the contact's two sides at this instant. It is exactly 0 while a rigid contact
    /// sticks.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }

    /// Returns the force of the contact at this instant. A positive force opposes sliding in the positive direction.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Returns true if the contact sticks at this instant. An elastic contact that sticks moves with its spring. A
    /// contact whose friction force is 0 does not stick.
    #[must_use]
    pub fn is_sticking(&self) -> bool {
        self.is_sticking
    }

    /// Returns the direction in which the contact slides at this instant. The result is [`Contact::Stuck`] if the contact
    /// sticks, or if its relative velocity is 0.
    #[must_use]
    pub fn contact(&self) -> Contact {
        if self.is_sticking || self.velocity.is_zero() {
            Contact::Stuck
        } else {
            Contact::along(self.velocity)
        }
    }
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Returns the present displacement and velocity of a mass.
    pub fn mass(&self, mass: usize) -> MassState<S> {
        MassState {
            displacement: at(self.state().x.as_ref(), mass),
            velocity: at(self.state().v.as_ref(), mass),
        }
    }

    /// Returns the present motion and force of a contact.
    pub fn contact(&self, contact: usize) -> ContactState<S> {
        let (velocity, displacement) = self.relative(contact);
        ContactState {
            displacement,
            velocity,
            force: at(self.forces().as_ref(), contact),
            is_sticking: self.state().phase(contact) == STUCK,
        }
    }
}
