//! Unknowns in the search for a steady state of a chain with several contacts. They are the displacements and
//! velocities of the masses, and the position of each contact that slides in the period. The position of an elastic
//! contact is that of its slider. The position of a rigid contact is the relative displacement at which it sticks.

use super::run::Motion;
use super::size::{Size, at, set, sign};
use super::state::{FREE, STUCK};
use crate::{Float, Scalar};

/// Conversion between the state of a motion and the unknowns of the search for a steady state. It contains the sizes by
/// which the code divides the unknowns, and the contacts that slide in the period.
pub(super) struct Unknowns<'s, S: Float, Z: Size> {
    /// Typical size of the displacements and of the positions of contacts. The code divides these unknowns by this
    /// size.
    pub(super) place: S,
    /// Typical size of the velocities. The code divides the velocities by this size.
    pub(super) speed: S,
    /// True for each contact that slides in the period.
    pub(super) moving: &'s Z::Contacts<bool>,
}

impl<S: Float, Z: Size> Unknowns<'_, S, Z> {
    /// Returns a conversion with the same sizes, in which the contacts in `moving` slide.
    pub(super) fn of<'m>(&self, moving: &'m Z::Contacts<bool>) -> Unknowns<'m, S, Z> {
        Unknowns {
            place: self.place,
            speed: self.speed,
            moving,
        }
    }

    pub(super) fn moves(&self, contact: usize) -> bool {
        self.moving.as_ref().get(contact) == Some(&true)
    }

    /// Returns true if the position of a contact affects the motion that starts from the unknowns. The position of a
    /// rigid contact does so while the contact sticks.
    pub(super) fn uses(&self, motion: &Motion<S, Z>, contact: usize) -> bool {
        let phase = motion.state().phase(contact);
        let is_rigid = motion
            .model()
            .contact(contact)
            .is_some_and(|own| own.is_rigid());
        self.moves(contact) && phase != FREE && (!is_rigid || phase == STUCK)
    }

    /// Returns the unknowns that correspond to the present state of a motion.
    pub(super) fn read(&self, motion: &Motion<S, Z>) -> Z::Unknowns<S> {
        let state = motion.state();
        let masses = motion.model().masses().len();
        let mut unknowns = motion.model().size.unknowns(S::constant(0.0));
        let mut put = |index, value| set(unknowns.as_mut(), index, value);
        let speeds = state.v.as_ref().iter();
        for (mass, (x, v)) in state.x.as_ref().iter().zip(speeds).enumerate() {
            put(mass, *x / self.place);
            put(masses + mass, *v / self.speed);
        }
        let contacts = motion.model().contacts().iter().enumerate();
        for (j, contact) in contacts.filter(|(j, _)| self.uses(motion, *j)) {
            let place = motion.relative(j).1;
            let stretch = contact.stiffness.map(|k| at(state.forces.as_ref(), j) / k);
            let place = place - stretch.unwrap_or(S::constant(0.0));
            put(2 * masses + j, place / self.place);
        }
        unknowns
    }

    /// Returns a motion that starts with the given unknowns. Contacts that do not slide keep their positions.
    pub(super) fn write(&self, motion: &Motion<S, Z>, unknowns: &Z::Unknowns<S>) -> Motion<S, Z> {
        let model = motion.model();
        let masses = model.masses().len();
        let own = |index: usize| at(unknowns.as_ref(), index);
        let mut moved = motion.clone();
        let mut state = motion.state().clone();
        for mass in 0..masses {
            set(state.x.as_mut(), mass, own(mass) * self.place);
            set(state.v.as_mut(), mass, own(masses + mass) * self.speed);
        }
        let of_contact = |j: usize| own(2 * masses + j) * self.place;
        let contacts = || model.contacts().iter().enumerate();
        for (j, _) in contacts().filter(|(j, contact)| self.moves(*j) && contact.is_rigid()) {
            set(state.places.as_mut(), j, of_contact(j));
        }
        // The old state may be at an event, which the new one is not.
        state.zeros = model.size.contacts((0, 0));
        moved.restart(state);
        let mut state = moved.state().clone();
        for (j, contact) in contacts() {
            let Some(stiffness) = contact.stiffness.filter(|_| !model.is_stop(j)) else {
                continue;
            };
            let slider = if self.moves(j) {
                of_contact(j)
            } else {
                motion.relative(j).1 - at(motion.state().forces.as_ref(), j) / stiffness
            };
            let force = stiffness * (moved.relative(j).1 - slider);
            let most = contact.stiction * contact.level.constant;
            let force = match state.phase(j) {
                FREE => S::constant(0.0),
                STUCK => Scalar::max(-most, Scalar::min(force, most)),
                side => sign::<S>(side) * contact.level.constant,
            };
            set(state.forces.as_mut(), j, force);
        }
        moved.restart(state);
        moved.set_stops();
        moved.join();
        moved
    }
}
