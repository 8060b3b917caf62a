//! Finds the steady state of a chain with several contacts if this state attracts every motion.

use super::model::{Contact, Model};
use super::run::Motion;
use super::size::{Size, at};
use super::slid::LargestDisplacement;
use super::state::State;
use super::steady::{Search, Steady, modulus};
use crate::errors::Halt;
use crate::{Float, Scalar};

/// Number of cycles that the motion runs before the first search for the steady state of a chain with μ = 1.
const SOON: usize = 5;
/// Largest number of searches for the steady state of a chain with μ = 1.
const SEARCHES: usize = 4;
/// Largest number of waits after a search. In each wait the motion advances by `WAIT` cycles. The waits end when the
/// contacts that stick in the steady state can no longer slide.
const WAITS: usize = 32;
/// Number of cycles of the load in each wait.
const WAIT: usize = 4;
/// Number of successive waits (each of `WAIT` cycles of the load) in which no slider may move before the search starts
/// again from the present positions of the sliders.
const CALM: usize = 2;

impl<S: Float, Z: Size> Search<S, Z> {
    /// Returns the steady state of a chain with μ = 1 and constant kinetic friction, if a search finds it after a few
    /// cycles.
    ///
    /// If all contacts have μ = 1 and a constant kinetic friction, the energy of the difference between two motions
    /// under the same loads never grows. A steady state that attracts neighbouring motions therefore attracts every
    /// motion. The search then needs no test of the motion from rest. If the energy of the difference between the
    /// motion and the steady state is too small to make an elastic contact slide, the contact keeps the position of its
    /// slider.
    ///
    /// # Errors
    ///
    /// [`Halt`] if the motion exceeds a bound.
    pub(super) fn only(&mut self, motion: &Motion<S, Z>) -> Result<Option<Steady<S, Z>>, Halt> {
        let one = S::constant(1.0);
        if !motion.model().is_contraction() {
            return Ok(None);
        }
        let mut trial = motion.clone();
        self.advance(&mut trial, SOON - 1, &mut ())?;
        let mut reach = LargestDisplacement(S::constant(0.0));
        self.advance(&mut trial, 1, &mut reach)?;
        self.place = if reach.0 > S::constant(0.0) {
            reach.0
        } else {
            one
        };
        for _ in 0..SEARCHES {
            let Some(found) = self.scaled(&trial)? else {
                self.advance(&mut trial, CALM * WAIT, &mut ())?;
                continue;
            };
            let most = one - self.tolerances.attracts;
            let attracts = found.multipliers().iter().all(|m| modulus(m) < most);
            // The energy of the difference between two motions gives no bound on the force of a sticking rigid contact.
            let is_rigid = marginal(trial.model(), &found).any(|(_, contact)| contact.is_rigid());
            if found.neutral > 0 || !attracts || is_rigid {
                return Ok(None);
            }
            if self.waits(&mut trial, &found)? {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// Searches for a periodic motion near a state. The displacements in the first cycles may be much larger than those
    /// in the steady state. The search then starts again with the size of the steady state.
    fn scaled(&mut self, motion: &Motion<S, Z>) -> Result<Option<Steady<S, Z>>, Halt> {
        let Some(found) = self.newton(motion, 1)? else {
            return Ok(None);
        };
        let amplitudes = found.cycle.amplitudes.as_ref().iter().copied();
        let place = amplitudes.fold(S::constant(0.0), Scalar::max);
        if place >= S::constant(0.5) * self.place || place <= S::constant(0.0) {
            return Ok(Some(found));
        }
        self.place = place;
        let mut near = motion.clone();
        near.restart(found.state);
        self.newton(&near, 1)
    }

    /// Returns true if a contact slides so little that rounding errors may decide whether it slides at all. In this
    /// case the Floquet multipliers do not show whether the steady state attracts neighbouring motions.
    fn grazes(&self, steady: &Steady<S, Z>) -> bool {
        let least = self.tolerances.close * self.place;
        let contacts = steady.cycle.contacts.as_ref().iter();
        let mut contacts = contacts.zip(self.moving.as_ref());
        contacts.any(|(contact, moves)| *moves && contact.slip < least)
    }

    /// Advances the motion until the contacts that stick in the steady state can no longer slide. Returns false if one
    /// of these contacts has slid, or if the search must start again for another reason.
    fn waits(&self, motion: &mut Motion<S, Z>, steady: &Steady<S, Z>) -> Result<bool, Halt> {
        let mut belongs = !self.grazes(steady);
        let mut calm = 0;
        for _ in 0..WAITS {
            if belongs && keeps_its_sliders(motion, steady) {
                return Ok(true);
            }
            let before = motion.state().clone();
            self.advance(motion, WAIT, &mut ())?;
            belongs = belongs && same_sliders(motion, steady, &steady.state);
            let moves = !same_sliders(motion, steady, &before);
            calm = if moves { 0 } else { calm + 1 };
            if !belongs && calm >= CALM {
                return Ok(false);
            }
        }
        Ok(false)
    }
}

/// Returns true if no contact that sticks in a periodic motion can slide while a given motion approaches the periodic
/// motion. Both motions are at a maximum of the load. The energy of the difference between the two motions never grows.
/// The energy therefore gives a bound on the difference of the forces in each elastic contact.
fn keeps_its_sliders<S: Float, Z: Size>(motion: &Motion<S, Z>, steady: &Steady<S, Z>) -> bool {
    let (half, two) = (S::constant(0.5), S::constant(2.0));
    let model = motion.model();
    let (a, b) = (motion.state(), &steady.state);
    let apart = |a: &[S], b: &[S], index: usize| at(a, index) - at(b, index);
    let mut energy = S::constant(0.0);
    for (mass, value) in model.masses().iter().enumerate() {
        let speed = apart(a.v.as_ref(), b.v.as_ref(), mass);
        energy = energy + half * *value * speed * speed;
    }
    for &(plus, minus, stiffness) in model.springs.as_ref() {
        // The supports (wall and base) have the same displacement in both motions.
        let place = |node| apart(a.x.as_ref(), b.x.as_ref(), node);
        let stretch = place(plus) - place(minus);
        energy = energy + half * stiffness * stretch * stretch;
    }
    let forces = |j: usize| apart(a.forces.as_ref(), b.forces.as_ref(), j);
    for (j, contact) in model.contacts().iter().enumerate() {
        if let Some(stiffness) = contact.stiffness {
            energy = energy + half * forces(j) * forces(j) / stiffness;
        }
    }
    marginal(model, steady).all(|(j, contact)| {
        let most = steady.cycle.contacts.as_ref().get(j).map(|own| own.force);
        let bound = contact.stiffness.map(|k| (two * k * energy).sqrt());
        let (Some(most), Some(bound)) = (most, bound) else {
            return false;
        };
        most + bound < contact.level.constant
    })
}

/// Compares the sliders of all contacts that stick in a periodic motion. Returns true if each slider has the same
/// position in the given motion and in another state. The motion and the state are at a maximum of the load.
fn same_sliders<S: Float, Z: Size>(
    motion: &Motion<S, Z>,
    steady: &Steady<S, Z>,
    state: &State<S, Z>,
) -> bool {
    let model = motion.model();
    let (a, b) = (motion.state(), state);
    let (x, _) = a.nodes(model, motion.time());
    let (y, _) = b.nodes(model, motion.time());
    marginal(model, steady).all(|(j, contact)| {
        let Some(stiffness) = contact.stiffness else {
            return false;
        };
        let place = contact.across(x.as_ref()) - contact.across(y.as_ref());
        let force = at(a.forces.as_ref(), j) - at(b.forces.as_ref(), j);
        let moved = (stiffness * place - force).abs();
        moved <= S::constant(1e3 * S::EPSILON) * contact.level.constant
    })
}

/// Returns the contacts that do not slide in a periodic motion, each with its index.
fn marginal<'m, S: Float, Z: Size>(
    model: &'m Model<S, Z>,
    steady: &'m Steady<S, Z>,
) -> impl Iterator<Item = (usize, &'m Contact<S>)> {
    let contacts = model.contacts().iter().enumerate();
    contacts.filter(|(j, _)| steady.marginal.as_ref().get(*j) == Some(&true))
}
