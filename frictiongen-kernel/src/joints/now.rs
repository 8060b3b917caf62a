//! Motion of masses and contacts at one instant.

use super::run::Motion;
use super::size::{Size, at};
use super::state::STUCK;
use crate::Float;

/// Displacement and velocity of a mass at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MassState<S> {
    pub(super) displacement: S,
    pub(super) velocity: S,
}

impl<S: Float> MassState<S> {
    /// Returns the displacement of the mass.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the velocity of the mass.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// Motion and force of one of several contacts at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactState<S> {
    pub(super) displacement: S,
    pub(super) velocity: S,
    pub(super) force: S,
    pub(super) is_sticking: bool,
}

impl<S: Float> ContactState<S> {
    /// Returns the relative displacement of both sides.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Returns the relative velocity of both sides. It is exactly 0 while a rigid contact sticks.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }

    /// Returns the force of the contact. A positive force opposes sliding in the positive direction.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Returns true if the contact sticks. An elastic contact that sticks moves with its spring. A contact with the
    /// friction force 0 does not stick.
    #[must_use]
    pub fn is_sticking(&self) -> bool {
        self.is_sticking
    }
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Returns displacement and velocity of a mass.
    pub fn mass(&self, mass: usize) -> MassState<S> {
        MassState {
            displacement: at(self.state().x.as_ref(), mass),
            velocity: at(self.state().v.as_ref(), mass),
        }
    }

    /// Returns motion and force of a contact.
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
