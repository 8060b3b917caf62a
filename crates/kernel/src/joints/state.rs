//! State of a chain with several contacts: the motion of its masses, and the phase of each contact.

use super::model::Model;
use super::size::{Size, add, set};
use crate::Float;

/// Phase of a contact that sticks.
pub const STUCK: i8 = 0;
/// Phase of a contact that has no force, because its kinetic friction force is 0, and of an open stop.
pub const FREE: i8 = 2;

/// Phase of a stop at the instant of an impact, after which it is open.
pub const IMPACT: i8 = 3;

/// State of a chain with several contacts at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct State<S: Float, Z: Size> {
    /// Displacement of each mass, in the order of the scene description.
    pub x: Z::Masses<S>,
    /// Velocity of each mass, in the order of the scene description.
    pub v: Z::Masses<S>,
    /// Force of each elastic contact, and 0 for each rigid contact.
    pub forces: Z::Contacts<S>,
    /// Relative displacement of each rigid contact while the contact sticks.
    pub places: Z::Contacts<S>,
    /// Phase of each contact. It is −1 or 1 while the contact slides (the sign of ż), 0 while it sticks, and 2 if its
    /// friction force is 0.
    pub phases: Z::Contacts<i8>,
    /// Number of leading coefficients that are exactly 0 in a polynomial of each contact. A root of this polynomial is
    /// the contact's next event. The second entry is the direction of sliding to which the number applies.
    pub zeros: Z::Contacts<(usize, i8)>,
}

impl<S: Float, Z: Size> State<S, Z> {
    /// Returns the state of a chain in which all displacements, velocities and forces are 0.
    pub fn at_rest(size: &Z) -> Self {
        let zero = S::constant(0.0);
        Self {
            x: size.masses(zero),
            v: size.masses(zero),
            forces: size.contacts(zero),
            places: size.contacts(zero),
            phases: size.contacts(FREE),
            zeros: size.contacts((0, 0)),
        }
    }

    /// Returns the phase of a contact. It is −1 or 1 while the contact slides (the sign of ż), 0 while it sticks, and 2
    /// if its friction force is 0.
    pub fn phase(&self, contact: usize) -> i8 {
        self.phases.as_ref().get(contact).copied().unwrap_or(FREE)
    }

    /// Returns the displacements and the velocities of all nodes at the instant `time`. The nodes are the masses, the
    /// wall and the base.
    pub fn nodes(&self, model: &Model<S, Z>, time: S) -> (Z::Nodes<S>, Z::Nodes<S>) {
        let base = model.base_node();
        let of = |masses: &[S], derivative| {
            let mut nodes = model.size.nodes(S::constant(0.0));
            for (node, mass) in nodes.as_mut().iter_mut().zip(masses) {
                *node = *mass;
            }
            if !model.base.is_zero() {
                add(nodes.as_mut(), base, model.base.value(time, derivative));
            }
            nodes
        };
        (of(self.x.as_ref(), 0), of(self.v.as_ref(), 1))
    }

    /// Returns the state in which all displacements, velocities and forces have the opposite sign.
    pub(super) fn opposite(&self) -> Self {
        let mut state = self.clone();
        let masses = state.x.as_mut().iter_mut().chain(state.v.as_mut());
        let contacts = state.forces.as_mut().iter_mut();
        let contacts = contacts.chain(state.places.as_mut());
        for value in masses.chain(contacts) {
            *value = -*value;
        }
        for phase in state
            .phases
            .as_mut()
            .iter_mut()
            .filter(|phase| **phase != FREE)
        {
            *phase = -*phase;
        }
        for (_, side) in state.zeros.as_mut() {
            *side = -*side;
        }
        state
    }

    /// Copies the velocities of the masses from `v`, which contains the velocities of all nodes.
    pub(super) fn keep_speeds(&mut self, v: &[S]) {
        for (mass, node) in self.v.as_mut().iter_mut().zip(v) {
            *mass = *node;
        }
    }

    /// Copies the displacements of the masses from `x`, which contains the displacements of all nodes.
    pub(super) fn keep_places(&mut self, x: &[S]) {
        for (mass, node) in self.x.as_mut().iter_mut().zip(x) {
            *mass = *node;
        }
    }

    /// Returns a number for the set of contacts that stick.
    pub(super) fn key(&self) -> u64 {
        let phases = self.phases.as_ref().iter().rev();
        phases.fold(0, |key, phase| key << 1 | u64::from(*phase == STUCK))
    }

    /// Takes the motion at the end of a stretch from its coordinates.
    pub(super) fn land(&mut self, model: &Model<S, Z>, coordinates: &[S]) {
        let mut coordinates = coordinates.iter();
        for own in [self.x.as_mut(), self.v.as_mut()] {
            for (own, value) in own.iter_mut().zip(coordinates.by_ref()) {
                *own = *value;
            }
        }
        let contacts = model.contacts().iter().enumerate().zip(coordinates);
        for ((j, _), value) in contacts.filter(|((_, contact), _)| !contact.is_rigid()) {
            if self.phase(j) == STUCK {
                set(self.forces.as_mut(), j, *value);
            }
        }
    }

    /// Makes all contacts with a friction force stick at the start of a motion, each in the middle of the interval in
    /// which it can stick.
    pub(super) fn stick(&mut self, model: &Model<S, Z>) {
        let zero = S::constant(0.0);
        let (x, _) = self.nodes(model, zero);
        for (j, contact) in model.contacts().iter().enumerate() {
            if self.phase(j) == FREE {
                continue;
            }
            self.set_phase(j, STUCK);
            set(self.places.as_mut(), j, zero);
            let force = contact.stiffness.map(|k| k * contact.across(x.as_ref()));
            set(self.forces.as_mut(), j, force.unwrap_or(zero));
        }
        self.zeros = model.size.contacts((0, 0));
    }

    pub(super) fn set_phase(&mut self, contact: usize, phase: i8) {
        set(self.phases.as_mut(), contact, phase);
    }

    pub(super) fn set_zeros(&mut self, contact: usize, zeros: (usize, i8)) {
        set(self.zeros.as_mut(), contact, zeros);
    }
}
