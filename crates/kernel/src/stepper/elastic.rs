//! Elastic contact (a spring in series with a slider) within a step of the stepper.
//!
//! While an elastic contact sticks, its slider does not move, but its two sides may still move with the spring. The
//! field `stuck_at` of the status is then the displacement of the slider. The field `contact_force` is the force of
//! the spring at the end of every sub-interval, even while the slider moves. The slider has no mass. If the kinetic
//! friction force falls below the force of the spring, the slider jumps. Friction then dissipates the energy that the
//! spring loses.

use super::interval::StepInterval;
use super::law::StepContact;
use super::rigid::rigid_terms;
use crate::motion::{AnyContact, Contact, ElasticChain, Law, lift};
use crate::number::scalar::Float;

impl<S: Float> StepContact<S> for ElasticChain<S> {
    #[inline]
    fn stuck_force_terms<const D: usize>(interval: &StepInterval<'_, '_, S, D, Self>) -> [S; 4] {
        spring_terms(interval)
    }
}

impl<S: Float> StepContact<S> for AnyContact<S> {
    fn stuck_force_terms<const D: usize>(interval: &StepInterval<'_, '_, S, D, Self>) -> [S; 4] {
        match interval.scene.dynamics.chain {
            Self::Rigid(_) => rigid_terms(interval),
            Self::Elastic(_) => spring_terms(interval),
        }
    }
}

/// Returns the force of an elastic contact's spring over a sub-interval, as a polynomial. The result does not contain
/// the contribution of the modes. The slider moves with the base on which the slider rubs.
fn spring_terms<S: Float, const D: usize, K: StepContact<S>>(
    interval: &StepInterval<'_, '_, S, D, K>,
) -> [S; 4] {
    let mut place = [S::constant(0.0); 4];
    if interval.scene.rubs_on_base() {
        place = interval.base;
    }
    place[0] = place[0] + interval.status.stuck_at;
    place.map(|term| -(term / interval.table.pace.receptance))
}

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Returns true if the contact is elastic. An elastic contact is a spring in series with a slider.
    #[inline]
    pub(super) fn is_elastic(&self) -> bool {
        0 < self.scene.dynamics.chain.remembered()
    }

    /// Updates a sliding elastic contact after a change of the kinetic friction force between two steps. If the
    /// friction force has become larger, the contact sticks, and the force of its spring increases further. If the
    /// friction force has become smaller, the slider jumps until the force of the spring equals it.
    pub(super) fn adapt_to_level(&mut self) {
        if self.status.contact == Contact::Stuck || self.status.unknown {
            return;
        }
        let force = self.status.contact_force;
        let kinetic = self.law().kinetic(self.status.contact);
        if kinetic.abs() < force.abs() {
            self.drop_force(force, kinetic);
        } else if force.abs() < kinetic.abs() {
            self.start_sticking_under(force);
        }
    }

    /// Lets the slider of an elastic contact jump, so that the force of the contact's spring changes from `from` to
    /// `to`. Friction dissipates the energy that the spring loses.
    pub(super) fn drop_force(&mut self, from: S, to: S) {
        let half = S::constant(0.5);
        let compliance = self.scene.dynamics.chain.compliance();
        let lost = half * compliance * ((from - to) * (from + to));
        self.account(S::constant(0.0), lost);
        self.status.contact_force = to;
    }

    /// Starts the motion of the slider of an elastic contact. The force of the contact's spring has reached or exceeded
    /// μF. If the contact moves against this force, the slider only jumps. The contact then sticks under the kinetic
    /// force F.
    pub(super) fn yield_under(&mut self, force: S, contact: Contact) {
        let kinetic = self.law().kinetic(contact);
        self.start_sliding();
        self.status.contact = contact;
        self.status.line = 0;
        self.drop_force(force, kinetic);
        if contact.sign::<S>() * self.relative_rate() < S::constant(0.0) {
            self.start_sticking_under(kinetic);
        }
    }

    /// Determines whether an elastic contact sticks or slides. The result depends on the force of the contact's spring
    /// and on the contact's motion.
    pub(super) fn derive_elastic(&mut self) {
        let force = self.status.contact_force;
        let slid = self.status.contact != Contact::Stuck;
        let rate = self.relative_rate();
        if slid && S::constant(0.0) < force * rate && self.law().level() <= force.abs() {
            self.status.contact = Contact::along(rate);
            let kinetic = self.law().kinetic(self.status.contact);
            self.drop_force(force, kinetic);
        } else {
            self.start_sticking_under(force);
        }
    }

    /// Changes an elastic contact from sliding to sticking, under a given force of its spring. Computes the modes of
    /// the stuck chain (the chain with its contact stuck) from the modes of the chain. With a stiff spring, the force
    /// is a small difference of displacements and would have a large rounding error. The function therefore corrects
    /// the mode of the stuck chain that changes the force most, so that the modes give this force.
    pub(super) fn start_sticking_under(&mut self, force: S) {
        let zero = S::constant(0.0);
        let dynamics = &self.scene.dynamics;
        let receptance = self.table.pace.receptance;
        let [base, rate] = self.base_now();
        let modes = dynamics.driven().iter().zip(&*self.store.modes);
        let now = modes.fold(zero, |sum, (mode, [y, _])| sum + mode.contact * *y);
        self.status.stuck_at = now - base - dynamics.chain.compliance() * force;
        self.status.contact = Contact::Stuck;
        self.status.line = 0;
        self.status.contact_force = force;
        let lifted = self.status.stuck_at + base;
        let scratch = &mut *self.store.scratch;
        let modes = dynamics.driven().iter().zip(&*self.store.modes);
        for ((mode, [y, u]), to) in modes.zip(scratch.iter_mut()) {
            *to = [*y - lift(mode, receptance) * lifted, *u];
        }
        let states = scratch.iter().copied();
        let held = self.store.held.iter_mut().map(|[y, u]| (y, u));
        dynamics.project(receptance, states, (zero, rate), held);
        let (mut found, mut stiffest, mut most) = (-(lifted / receptance), 0, zero);
        for (index, (step, [y, _])) in self.table.held.iter().zip(&*self.store.held).enumerate() {
            found = found - step.force * *y;
            if most < step.force.abs() {
                (stiffest, most) = (index, step.force.abs());
            }
        }
        let step = self.table.held.get(stiffest);
        if let (Some(step), Some([y, _])) = (step, self.store.held.get_mut(stiffest)) {
            *y = *y + (found - force) / step.force;
        }
    }

    /// Returns the relative velocity of the contact, computed from the modes. The unit of this velocity is the unit of
    /// length divided by the sub-interval.
    pub(super) fn relative_rate(&self) -> S {
        let [_, base] = self.base_now();
        let modes = self.table.modes.iter().zip(&*self.store.modes);
        modes
            .take(self.driven())
            .fold(-(base * self.table.pace.span), |sum, (step, [_, u])| {
                sum + step.contact * step.angle * *u
            })
    }
}
