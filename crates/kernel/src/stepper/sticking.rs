//! Motion in a sub-interval in which the contact sticks. The stepper advances with the constant tables, or up to an
//! event with a power series.

use super::drive::at;
use super::interval::{Departure, OFF_CHORD, ROUNDINGS, StepInterval};
use super::law::StepContact;
use super::rows::moments;
use crate::motion::{Contact, Law, WalkResult, WalkStart, first_reach, lift};
use crate::number::scalar::Float;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Advances to the end of the sub-interval with the constant tables, if the contact provably keeps sticking.
    /// Returns true if the function has advanced the motion.
    pub(super) fn stick_by_tables(&mut self) -> bool {
        let zero = S::constant(0.0);
        if self.status.wedged {
            return false;
        }
        let one = S::constant(1.0);
        let (still, mut bend) = self.force_without_modes();
        let (mut start, mut end) = (still[0], at(&still, one));
        let mut size = start.abs();
        let mut work = self.carried_work(Some(&still), one);
        for index in 0..self.store.held.len() {
            let Some(step) = self.table.held.get(index) else {
                return false;
            };
            let drive = self.held_load(index, step);
            let Some(&state) = self.store.held.get(index) else {
                return false;
            };
            let (next, moments) = step.moved(state, &drive);
            work = work + self.held_work(index, step, &moments, next[0], one);
            start = start - step.force * state[0];
            end = end - step.force * next[0];
            size = size + (step.force * state[0]).abs();
            bend = bend + step.force.abs() * step.bend(state, &drive);
            if let Some(to) = self.store.scratch.get_mut(index) {
                *to = next;
            }
        }
        let grip = self.law().grip();
        let most = start.abs().max(end.abs());
        let room =
            bend * S::constant(OFF_CHORD) + (size + grip) * S::constant(ROUNDINGS * S::EPSILON);
        if !(most + room < grip) {
            return false;
        }
        let held = self.store.held.iter_mut().zip(&*self.store.scratch);
        for (state, next) in held {
            *state = *next;
        }
        self.account(work, zero);
        self.status.contact_force = end;
        true
    }

    /// Advances the motion until the contact breaks away or the sub-interval ends. The contact breaks away when its
    /// force reaches μF. If a rigid contact breaks away, the function returns the start of the sliding motion.
    pub(super) fn stick_to_event(&mut self) -> Option<Departure<S>> {
        let zero = S::constant(0.0);
        let left = S::constant(1.0) - self.progress;
        let force = self.force_series();
        let grip = self.law().grip();
        let now = force.term(0);
        let noise = (force.size + grip) * S::constant(ROUNDINGS * S::EPSILON);
        let wedged = self.status.wedged;
        self.status.wedged = false;
        let (tau, breaks) = if !wedged && grip + noise < now.abs() {
            (zero, Some(Contact::along(now)))
        } else {
            let start = if wedged {
                WalkStart::Wedged
            } else {
                WalkStart::Anywhere
            };
            let mut steps = 0;
            match first_reach(
                &force
                    .seen(S::constant(1.0), zero, left)
                    .within(self.search()),
                grip,
                zero,
                start,
                &mut steps,
            ) {
                WalkResult::Zero(tau, negative) => (tau, Some(Contact::towards(negative))),
                WalkResult::Until(tau) => (tau, None),
                WalkResult::NoStart => (left, None),
            }
        };
        if let Some(contact) = breaks.filter(|_| zero < tau) {
            self.note_crossing(&force, -(contact.sign::<S>() * grip), tau);
        }
        if zero < tau {
            self.move_held(tau);
        }
        let contact = breaks?;
        // The force has just reached μF, unless it exceeded μF at the start.
        let law = self.law();
        if self.is_elastic() {
            let force = if zero < tau {
                grip
            } else {
                grip.max(now.abs())
            };
            self.count_event();
            self.yield_under(contact.sign::<S>() * force, contact);
            return None;
        }
        let slide = if zero < tau {
            law.break_away(contact)
        } else {
            law.slide(contact, grip.max(now.abs()))
        };
        self.count_event();
        self.start_sliding();
        self.status.contact = slide.contact;
        self.status.line = 0;
        Some(Departure {
            slope: self.acceleration(slide.excess),
            stuck: Some(self.status.stuck_at),
        })
    }

    /// Advances the modes of the chain with its contact stuck during the time `tau`. No event occurs in this time.
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
            let [of_y, of_u] = &load;
            let term = |load: &[S; D], place: usize| load.get(place).copied().unwrap_or(zero);
            let drive = |place: usize| [term(of_y, place), term(of_u, place)];
            let of = (step.angle, step.zeta);
            let (rises, turns) = moments::<S, D, D>(of, state, drive, terms, tau);
            let first = |rows: &[S; D]| rows.first().copied().unwrap_or(zero);
            let [y, u] = state;
            let moved = [y + first(&rises), u + first(&turns)];
            work = work + self.held_work(index, step, &[rises, turns], moved[0], tau);
            if let Some(state) = self.store.held.get_mut(index) {
                *state = moved;
            }
        }
        self.account(work, zero);
        self.shift_inputs(tau);
    }

    /// Changes the contact from sliding to sticking. Computes the modes of the chain with its contact stuck from the
    /// modes of the sliding chain. The contact sticks at the displacement `place`. If `place` is `None`, the contact
    /// sticks at the displacement that the modes give.
    pub(super) fn start_sticking(&mut self, place: Option<S>) {
        if self.is_elastic() {
            return self.start_sticking_under(self.status.contact_force);
        }
        let dynamics = &self.scene.dynamics;
        let receptance = self.table.pace.receptance;
        let [base, rate] = self.base_now();
        let modes = dynamics.driven().iter().zip(&*self.store.modes);
        let now = modes.fold(S::constant(0.0), |sum, (mode, [y, _])| {
            sum + mode.contact * *y
        });
        self.status.stuck_at = place.unwrap_or(now - base);
        self.status.contact = Contact::Stuck;
        self.status.line = 0;
        let lifted = self.status.stuck_at + base;
        let zero = S::constant(0.0);
        let (mut moved, mut softest, mut most) = (zero, (0, S::constant(1.0)), zero);
        let scratch = &mut *self.store.scratch;
        let modes = dynamics.driven().iter().zip(&*self.store.modes);
        for (index, ((mode, [y, u]), to)) in modes.zip(scratch.iter_mut()).enumerate() {
            let lift = lift(mode, receptance);
            *to = [*y - lift * lifted, *u];
            moved = moved + mode.contact * to[0];
            let share = (mode.contact * lift).abs();
            if most < share {
                (softest, most) = ((index, mode.contact), share);
            }
        }
        let (index, contact) = softest;
        if let Some([y, _]) = scratch.get_mut(index) {
            *y = *y - moved / contact;
        }
        let states = scratch.iter().copied();
        let held = self.store.held.iter_mut().map(|[y, u]| (y, u));
        dynamics.project(receptance, states, (zero, rate), held);
    }

    /// Changes the contact from sticking to sliding. Computes the modes of the sliding chain from the modes of the
    /// chain with its contact stuck.
    pub(super) fn start_sliding(&mut self) {
        let [base, rate] = self.base_now();
        let lifted = (self.status.stuck_at + base, rate);
        let receptance = self.table.pace.receptance;
        self.store.release(self.scene, receptance, lifted);
    }
}
