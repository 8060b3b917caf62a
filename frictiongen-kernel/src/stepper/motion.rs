//! The motion within a sub-interval of a step as power series about an instant, and pieces of that motion.

use super::drive::{derived, growth, shift};
use super::part::{Through, product};
use super::rows::{moments, next};
use super::table::HeldLoad;
use crate::motion::Power;
use crate::number::scalar::Float;

impl<S: Float, const D: usize> Through<'_, '_, S, D> {
    fn terms(&self) -> usize {
        self.scene.terms(self.table.pace.terms)
    }

    /// The relative velocity as a power series about the present instant, under the friction force level +
    /// slope·velocity.
    pub(super) fn velocity(&mut self, [level, slope]: [S; 2]) -> Power<S> {
        let zero = S::constant(0.0);
        let mut velocity = Power::zero(self.terms());
        let base = if self.scene.rubs_on_base() {
            derived(self.base)
        } else {
            [zero; 4]
        };
        let driven = self.driven();
        let modes = self.store.modes.iter().take(driven);
        for (to, state) in self.store.scratch.iter_mut().zip(modes) {
            *to = *state;
        }
        let steps = self.table.modes.get(..driven).unwrap_or_default();
        let mut base = base.into_iter();
        let (mut order, mut size) = (S::constant(1.0), zero);
        for (place, slot) in velocity.slots().enumerate() {
            let mut sum = -base.next().unwrap_or(zero);
            let mut sizes = sum.abs();
            for (step, [_, u]) in steps.iter().zip(&*self.store.scratch) {
                let term = step.contact * step.angle * *u;
                (sum, sizes) = (sum + term, sizes + term.abs());
            }
            *slot = sum;
            if place < 4 {
                size = size + sizes;
            }
            let force = slope * sum + if place == 0 { level } else { zero };
            let inverse = S::constant(1.0) / order;
            let states = steps.iter().zip(&mut *self.store.scratch);
            for (index, (step, state)) in states.enumerate() {
                let load = load_term(self.table.loads_of(index), self.store.drive, place);
                let drive = load - step.per_force * step.contact * force;
                let rates = next((step.angle, step.zeta), *state, [zero, drive]);
                *state = rates.map(|rate| rate * inverse);
            }
            order = order + S::constant(1.0);
        }
        velocity.size = size;
        velocity
    }

    /// The force in the sticking contact as a power series about the present instant.
    pub(super) fn force(&mut self) -> Power<S> {
        let zero = S::constant(0.0);
        let mut force = Power::zero(self.terms());
        let (still, _) = self.still();
        for (to, state) in self.store.scratch.iter_mut().zip(&*self.store.held) {
            *to = *state;
        }
        let motions = self.moving_base();
        let mut still = still.into_iter();
        let (mut order, mut size) = (S::constant(1.0), zero);
        for (place, slot) in force.slots().enumerate() {
            let mut sum = still.next().unwrap_or(zero);
            let mut sizes = sum.abs();
            for (step, [y, _]) in self.table.held.iter().zip(&*self.store.scratch) {
                let term = step.force * *y;
                (sum, sizes) = (sum - term, sizes + term.abs());
            }
            *slot = sum;
            if place < 4 {
                size = size + sizes;
            }
            let inverse = S::constant(1.0) / order;
            let states = self.table.held.iter().zip(&mut *self.store.scratch);
            for (index, (step, state)) in states.enumerate() {
                let mut drive = [zero; 2];
                if place < D {
                    let loads = self.table.held_loads_of(index);
                    drive = held_load_term(loads, self.store.drive, place);
                }
                if let Some(motions) = &motions {
                    for (from_base, motion) in step.from_base.iter().zip(motions) {
                        let motion = motion.get(place).copied().unwrap_or(zero);
                        for (term, from_base) in drive.iter_mut().zip(from_base) {
                            *term = *term + *from_base * motion;
                        }
                    }
                }
                let rates = next((step.angle, step.zeta), *state, drive);
                *state = rates.map(|rate| rate * inverse);
            }
            order = order + S::constant(1.0);
        }
        force.size = size;
        force
    }

    /// Advances the modes that the contact drives by a piece of sliding of length `tau`.
    pub(super) fn move_modes(&mut self, velocity: &Power<S>, [level, slope]: [S; 2], tau: S) {
        let zero = S::constant(0.0);
        let mut work = zero;
        for index in 0..self.driven() {
            let load = self.load(index);
            let (Some(step), Some(state)) =
                (self.table.modes.get(index), self.store.modes.get_mut(index))
            else {
                continue;
            };
            let pull = step.per_force * step.contact;
            let drive = |place: usize| {
                let mut force = if place == 0 { level } else { zero };
                if !slope.is_zero() {
                    force = force + slope * velocity.term(place);
                }
                let load = load.get(place).copied().unwrap_or(zero);
                [zero, load - pull * force]
            };
            let of = (step.angle, step.zeta);
            let [rises, turns]: [[S; D]; 2] = moments(of, *state, drive, velocity.count, tau);
            let [y, u] = *state;
            let first = |rows: &[S; D]| rows.first().copied().unwrap_or(zero);
            *state = [y + first(&rises), u + first(&turns)];
            let done = load.iter().zip(&rises);
            let done = done.fold(zero, |sum, (term, moment)| sum + *term * *moment);
            work = work + done / step.per_force;
        }
        let used = velocity.used();
        let moved = integral(used, tau);
        let mut dissipated = level * moved;
        let mut carried = zero;
        if self.scene.rubs_on_base() {
            carried = level * growth(&self.base, tau);
        }
        if !slope.is_zero() {
            dissipated = dissipated + slope * product(used, used, tau);
            if self.scene.rubs_on_base() {
                carried = carried + slope * product(used, &derived(self.base), tau);
            }
        }
        self.account(work - carried, dissipated);
        self.passed(tau);
    }

    /// Advances the modes of the stuck chain by a piece of sticking of length `tau`.
    pub(super) fn move_held(&mut self, tau: S) {
        let zero = S::constant(0.0);
        let mut work = self.carried_work(None, tau);
        let terms = self.terms();
        for index in 0..self.store.held.len() {
            let (Some(step), Some(&state)) =
                (self.table.held.get(index), self.store.held.get(index))
            else {
                continue;
            };
            let load = self.held_load(index, step);
            let drive = |place: usize| load.map(|load| load.get(place).copied().unwrap_or(zero));
            let of = (step.angle, step.zeta);
            let rows: [[S; D]; 2] = moments(of, state, drive, terms, tau);
            let first = |rows: &[S; D]| rows.first().copied().unwrap_or(zero);
            let [y, u] = state;
            let moved = [y + first(&rows[0]), u + first(&rows[1])];
            work = work + self.held_work(index, step, &rows, moved[0], tau);
            if let Some(state) = self.store.held.get_mut(index) {
                *state = moved;
            }
        }
        self.account(work, zero);
        self.passed(tau);
    }

    /// Advances the instant by `tau` and shifts the inputs' polynomials to the new instant.
    fn passed(&mut self, tau: S) {
        let one = S::constant(1.0);
        let end = one - self.place <= tau;
        self.place = if end { one } else { self.place + tau };
        for drive in &mut *self.store.drive {
            shift(drive, tau);
        }
        shift(&mut self.base, tau);
    }
}

/// Integrates a power series from 0 to `place`.
fn integral<S: Float>(terms: &[S], place: S) -> S {
    product(terms, &[S::constant(1.0)], place)
}

/// One coefficient of the rate that the inputs add to the u of a mode.
#[inline]
fn load_term<S: Float, const D: usize>(loads: &[S], inputs: &[[S; D]], place: usize) -> S {
    let zero = S::constant(0.0);
    if D <= place {
        return zero;
    }
    let pairs = loads.iter().zip(inputs);
    pairs.fold(zero, |sum, (load, input)| {
        sum + *load * input.get(place).copied().unwrap_or(zero)
    })
}

/// One coefficient of the rates that the inputs add to y and u of a stuck chain's mode.
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
