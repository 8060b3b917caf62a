//! Work of damping forces on the moving base, if the damping acts on velocities relative to the base.
//!
//! Damping relative to the base causes the load C·1·ẏ on the masses, where C is the damping matrix and ẏ is the
//! velocity of the base. The opposite force acts on the base. The damping force 1ᵀC1·ẏ also acts on the base. The work
//! of the base against both forces is 1ᵀC1∫ẏ²dt − ∫ẏ·1ᵀC·ẋ dt. The sums over the inputs, however, add ∫ẏ·1ᵀC·ẋ dt as
//! work of the load on the masses. The code therefore subtracts twice this integral.

use super::dot::add;
use super::drive::derived;
use super::interval::{StepInterval, product};
use super::law::StepContact;
use crate::number::scalar::Float;
use core::ops::Range;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Adds 1ᵀC1∫ẏ²dt in the sub-interval to the work of the base. C is the damping matrix, and ẏ is the velocity of
    /// the base.
    pub(super) fn account_base(&mut self) {
        let one = S::constant(1.0);
        let velocity = derived(self.base);
        let squared = product(&velocity, &velocity, one) / self.table.pace.span;
        self.account(self.scene.base_drag() * squared, S::constant(0.0));
    }

    /// Corrects the work of the load for the reaction of damping on the base. Subtracts twice the work that the damping
    /// load of the base does on some modes in the sub-interval. The caller has not yet changed the states of these
    /// modes. `force` is the constant friction force in the contact.
    pub(super) fn account_reaction(&mut self, modes: Range<usize>, force: S) {
        let mut work = S::constant(0.0);
        for index in modes {
            let (Some(step), Some(state)) =
                (self.table.modes.get(index), self.store.modes.get(index))
            else {
                continue;
            };
            let mut drive = self.load(index);
            if let [first, ..] = &mut drive[..] {
                *first = *first - step.per_force * step.contact * force;
            }
            let (_, done) = step.moved(*state, &drive, &self.base_load(index));
            work = work + done;
        }
        self.account(-(work + work), S::constant(0.0));
    }

    /// Returns twice the work that the damping load of the base does on a mode. The code computes this work from
    /// `rises`, the moments of the mode's velocity.
    pub(super) fn reaction(&self, mode: usize, rises: &[S; D]) -> S {
        let load = self.base_load(mode);
        let terms = load.iter().zip(rises);
        let done = terms.fold(S::constant(0.0), |sum, (term, moment)| {
            sum + *term * *moment
        });
        done + done
    }

    /// Returns the rate of a mode's scaled velocity u that the velocity of the base causes through damping, as a
    /// polynomial over the sub-interval.
    fn base_load(&self, mode: usize) -> [S; D] {
        let mut sum = [S::constant(0.0); D];
        let load = self.table.loads_of(mode).get(1);
        if let (Some(load), Some(drive)) = (load, self.store.drive.get(1)) {
            add(&mut sum, *load, drive);
        }
        sum
    }
}
