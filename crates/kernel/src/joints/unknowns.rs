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

    /// Returns true if the unknown with this index affects the motion that starts from the unknowns. Each contact has
    /// two indices. The first index is for the slider of an elastic contact. The second index is for the relative
    /// displacement of a rigid contact that sticks.
    pub(super) fn uses(&self, motion: &Motion<S, Z>, index: usize) -> bool {
        let model = motion.model();
        let Some(which) = index.checked_sub(2 * model.masses().len()) else {
            return true;
        };
        let j = which / 2;
        let Some(contact) = model.contacts().get(j) else {
            return false;
        };
        self.moves(j)
            && match which % 2 {
                0 => !contact.is_rigid(),
                _ => contact.is_rigid() && motion.state().phase(j) == STUCK,
            }
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
        for (j, contact) in motion.model().contacts().iter().enumerate() {
            let place = motion.relative(j).1;
            let index = 2 * masses + 2 * j;
            match contact.stiffness {
                _ if !self.moves(j) => {}
                Some(stiffness) => {
                    let slider = place - at(state.forces.as_ref(), j) / stiffness;
                    put(index, slider / self.place);
                }
                None if state.phase(j) == STUCK => put(index + 1, place / self.place),
                None => {}
            }
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
        let of_contact = |j: usize, which: usize| own(2 * masses + 2 * j + which) * self.place;
        let contacts = || model.contacts().iter().enumerate();
        for (j, _) in contacts().filter(|(j, contact)| self.moves(*j) && contact.is_rigid()) {
            set(state.places.as_mut(), j, of_contact(j, 1));
        }
        moved.restart(state);
        let mut state = moved.state().clone();
        for (j, contact) in contacts() {
            let Some(stiffness) = contact.stiffness else {
                continue;
            };
            let slider = if self.moves(j) {
                of_contact(j, 0)
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
        moved
    }
}
