//! Force in a stuck contact in a sub-interval, and work of the inputs while the contact sticks.

use super::dot::add;
use super::drive::{derived, growth};
use super::interval::{StepInterval, product};
use super::law::StepContact;
use super::rows::{HeldStep, next};
use super::table::HeldLoad;
use crate::motion::Power;
use crate::number::scalar::Float;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Returns the rates at which the inputs change one mode of the chain with its contact stuck, as polynomials. The
    /// first polynomial is the rate of the mode's displacement y. The second polynomial is the rate of the mode's
    /// scaled velocity u. The base to which the contact sticks is one of the inputs.
    #[inline]
    pub(super) fn held_load(&self, mode: usize, step: &HeldStep<S, D>) -> [[S; D]; 2] {
        let mut sum = [[S::constant(0.0); D]; 2];
        let loads = self.table.held_loads_of(mode);
        for (load, drive) in loads.iter().zip(&*self.store.drive) {
            for (sum, load) in sum.iter_mut().zip(load.drive) {
                add(sum, load, drive);
            }
        }
        if let Some(motions) = self.moving_base() {
            for (from_base, motion) in step.from_base.iter().zip(motions) {
                for (sum, from_base) in sum.iter_mut().zip(from_base) {
                    for (sum, term) in sum.iter_mut().zip(motion) {
                        *sum = *sum + *from_base * term;
                    }
                }
            }
        }
        sum
    }

    /// Returns the velocity and the acceleration of the base as polynomials, if the contact rubs on the base.
    fn moving_base(&self) -> Option<[[S; 4]; 2]> {
        let velocity = derived(self.base);
        let motions = [velocity, derived(velocity)];
        self.scene.rubs_on_base().then_some(motions)
    }

    /// Returns the displacement and the velocity of the base on which the contact rubs. The velocity is the derivative
    /// with respect to the non-dimensional time t√(k₁/m₁). If the contact does not rub on a moving base, both numbers
    /// are zero.
    pub(super) fn base_now(&self) -> [S; 2] {
        if self.scene.rubs_on_base() {
            let [place, velocity, ..] = self.base;
            [place, velocity / self.table.pace.span]
        } else {
            [S::constant(0.0); 2]
        }
    }

    /// Returns two results for the stuck contact. The first is the contact force without the contribution of the modes,
    /// as a polynomial. The second is an upper bound on the absolute value of this polynomial's second derivative in
    /// the sub-interval.
    pub(super) fn force_without_modes(&self) -> ([S; 4], S) {
        let sum = K::stuck_force_terms(self);
        let [_, _, c, d] = sum;
        let (two, six) = (S::constant(2.0), S::constant(6.0));
        (sum, two * c.abs() + six * d.abs())
    }

    /// Returns the force in the stuck contact as a power series about the present instant.
    pub(super) fn force_series(&mut self) -> Power<S> {
        let zero = S::constant(0.0);
        let mut force = Power::zero(self.terms());
        let (still, _) = self.force_without_modes();
        for (to, state) in self.store.scratch.iter_mut().zip(&*self.store.held) {
            *to = *state;
        }
        let motions = self.moving_base();
        let states = &mut *self.store.scratch;
        let (mut order, mut size) = (S::constant(1.0), zero);
        // `sum` is the term of the present order. `sizes` is the sum of the absolute values of the summands in this
        // term.
        let mut sum = still[0];
        let mut sizes = sum.abs();
        for (step, [y, _]) in self.table.held.iter().zip(&*states) {
            let term = step.force * *y;
            (sum, sizes) = (sum - term, sizes + term.abs());
        }
        for (place, slot) in force.slots().enumerate() {
            *slot = sum;
            if place < 4 {
                size = size + sizes;
            }
            let inverse = S::constant(1.0) / order;
            order = order + S::constant(1.0);
            sum = still.get(place + 1).copied().unwrap_or(zero);
            sizes = sum.abs();
            for (index, (step, state)) in self.table.held.iter().zip(&mut *states).enumerate() {
                let mut drive = [zero; 2];
                if place < D {
                    let loads = self.table.held_loads_of(index);
                    drive = held_load_term(loads, self.store.drive, place);
                }
                if let Some([velocity, acceleration]) = &motions {
                    let ([of_velocity, of_acceleration], [first, second]) = (step.from_base, drive);
                    let velocity = velocity.get(place).copied().unwrap_or(zero);
                    let acceleration = acceleration.get(place).copied().unwrap_or(zero);
                    drive = [
                        first + of_velocity[0] * velocity + of_acceleration[0] * acceleration,
                        second + of_velocity[1] * velocity + of_acceleration[1] * acceleration,
                    ];
                }
                let [rise, turn] = next((step.angle, step.zeta), *state, drive);
                let y = rise * inverse;
                *state = [y, turn * inverse];
                let term = step.force * y;
                (sum, sizes) = (sum - term, sizes + term.abs());
            }
        }
        force.size = size;
        force
    }

    /// Returns the present force in the stuck contact.
    pub(super) fn stuck_force(&self) -> S {
        let ([still, ..], _) = self.force_without_modes();
        let held = self.table.held.iter().zip(&*self.store.held);
        held.fold(still, |sum, (step, [y, _])| sum - step.force * *y)
    }

    /// Returns the work of the inputs from the present instant to the instant `place`, while the contact sticks to a
    /// moving base. The result does not contain the contribution of the modes. `still` is the contact force without
    /// this contribution, if the caller has computed it.
    pub(super) fn carried_work(&self, still: Option<&[S; 4]>, place: S) -> S {
        let zero = S::constant(0.0);
        if !self.scene.rubs_on_base() {
            return zero;
        }
        let velocity = derived(self.base);
        let mut work = zero;
        for (channel, drive) in self.table.channels.iter().zip(&*self.store.drive) {
            work = work + channel.lift * product(drive, &velocity, place);
        }
        let still = still
            .copied()
            .unwrap_or_else(|| self.force_without_modes().0);
        work - product(&still, &velocity, place)
    }

    /// Returns the work of the inputs through one mode of the chain with its contact stuck, up to the instant `place`.
    /// The code computes the work from the moments of the mode in this time.
    pub(super) fn held_work(
        &self,
        mode: usize,
        step: &HeldStep<S, D>,
        [moments, turns]: &[[S; D]; 2],
        to: S,
        place: S,
    ) -> S {
        let mut work = S::constant(0.0);
        let loads = self.table.held_loads_of(mode);
        for (load, drive) in loads.iter().zip(&*self.store.drive) {
            let [of_y, of_u] = load.reach;
            for ((term, y), u) in drive.iter().zip(moments).zip(turns) {
                work = work + *term * (of_y * *y + of_u * *u);
            }
        }
        if self.scene.rubs_on_base() {
            // This sum is the integral −∫f b′ after integration by parts. f is the contribution of the mode to the
            // contact force. b is the displacement of the base minus its present value.
            let rise = growth(&self.base, place);
            let mut sum = to * rise;
            for (term, moment) in self.base.iter().zip(moments).skip(1) {
                sum = sum - *term * *moment;
            }
            work = work + step.force * sum;
        }
        work
    }
}

/// Returns one coefficient of each polynomial with which the inputs change a mode. The mode belongs to the chain with
/// its contact stuck. The first number belongs to the rate of the mode's displacement y. The second number belongs to
/// the rate of the mode's scaled velocity u.
#[inline]
fn held_load_term<S: Float, const D: usize>(
    loads: &[HeldLoad<S>],
    inputs: &[[S; D]],
    place: usize,
) -> [S; 2] {
    let zero = S::constant(0.0);
    let pairs = loads.iter().zip(inputs);
    pairs.fold([zero; 2], |[first, second], (load, input)| {
        let term = input.get(place).copied().unwrap_or(zero);
        let [of_y, of_u] = load.drive;
        [first + of_y * term, second + of_u * term]
    })
}
