//! One part of a step, looked through: from event to event.

use super::drive::{derived, gain, shift};
use super::law;
use super::part::{Through, product};
use super::series::Power;
use super::table::{HeldLoad, moments, next};
use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::number::scalar::Float;
use crate::simulation::{Contact, Start, Walk, first_reach, first_zero};

/// The contact, on the point of leaving zero velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure<S> {
    /// How fast its velocity grows in the direction of sliding.
    slope: S,
    /// Whether it stuck until now: where.
    stuck: Option<S>,
}

impl<S: Float, const D: usize> Through<'_, '_, S, D> {
    /// Follows the contact from event to event to the end of the part.
    pub(super) fn look(&mut self) {
        let one = S::constant(1.0);
        let mut departing = None;
        for _ in 0..MAX_STRETCHES {
            if !(self.place < one) || MAX_EVENTS <= self.events {
                break;
            }
            departing = match self.status.contact {
                Contact::Stuck => self.stick(),
                _ => self.slide(departing),
            };
        }
        if self.place < one {
            self.rest(departing);
        }
        if self.status.contact == Contact::Stuck {
            self.status.holding = self.held_force();
        }
    }

    /// The rest of the part without events, in a way that creates no energy: held where the contact is at rest,
    /// without friction where it is not.
    fn rest(&mut self, departing: Option<Departure<S>>) {
        self.exceeded = true;
        let left = S::constant(1.0) - self.place;
        if self.status.contact != Contact::Stuck {
            let Some(departure) = departing else {
                self.status.unknown = true;
                let none = [S::constant(0.0); 2];
                let velocity = self.velocity(none);
                return self.move_modes(&velocity, none, left);
            };
            self.grip(departure.stuck);
        }
        self.move_held(left);
    }

    /// Says what the contact does, of which nothing is known but the state.
    pub(super) fn judge(&mut self) {
        self.status.unknown = false;
        self.status.wedged = false;
        let velocity = self.velocity([S::constant(0.0); 2]);
        let rate = velocity.term(0);
        let pace = &self.table.pace;
        let speed = rate.abs() * S::constant(f64::from(pace.parts)) / pace.step;
        self.status.contact = Contact::along(rate);
        self.status.line = law::place(self.scene.law, speed);
        if rate.abs() <= velocity.size * S::constant(8.0 * S::EPSILON) {
            // Whether it leaves at once, the force that holds it will say.
            self.grip(None);
        }
    }

    /// Sticks until the force in the contact reaches the grip, or to the end of the part.
    fn stick(&mut self) -> Option<Departure<S>> {
        let zero = S::constant(0.0);
        let left = S::constant(1.0) - self.place;
        let force = self.force();
        let grip = self.status.friction * self.status.stiction;
        let now = force.term(0);
        let noise = (force.size + grip) * S::constant(8.0 * S::EPSILON);
        let wedged = self.status.wedged;
        self.status.wedged = false;
        let (tau, breaks) = if !wedged && grip + noise < now.abs() {
            (zero, Some(Contact::along(now)))
        } else {
            let start = if wedged {
                Start::Wedged
            } else {
                Start::Anywhere
            };
            let mut steps = 0;
            match first_reach(
                &force.seen(S::constant(1.0), zero, left),
                grip,
                zero,
                start,
                &mut steps,
            ) {
                Walk::Zero(tau, true) => (tau, Some(Contact::Backward)),
                Walk::Zero(tau, false) => (tau, Some(Contact::Forward)),
                Walk::Until(tau) => (tau, None),
                Walk::NoStart => (left, None),
            }
        };
        if zero < tau {
            self.move_held(tau);
        }
        let contact = breaks?;
        // The force is what it was found to be, unless it jumped.
        let force = if zero < tau {
            grip
        } else {
            grip.max(now.abs())
        };
        self.events += 1;
        self.leave();
        self.status.contact = contact;
        self.status.line = 0;
        Some(Departure {
            slope: self.acceleration(force - self.status.friction),
            stuck: Some(self.status.place),
        })
    }

    /// Slides until the contact stops, its speed reaches the next line of the law, or the part ends.
    fn slide(&mut self, departing: Option<Departure<S>>) -> Option<Departure<S>> {
        let zero = S::constant(0.0);
        let sign: S = self.status.contact.sign();
        let line = self.line();
        let friction = self.status.friction;
        let law = [sign * friction * line.level, friction * line.slope];
        let velocity = self.velocity(law);
        let reach = self.reach(law[1]);
        let mut steps = 0;
        let start = departing.map_or(Start::Anywhere, |departure| Start::Zero(departure.slope));
        let seen = velocity.seen(sign, line.low, reach);
        let (mut tau, mut halts) = match first_zero(&seen, start, &mut steps) {
            Walk::Zero(tau, _) => (tau, true),
            Walk::Until(tau) => (tau, false),
            Walk::NoStart => {
                self.grip(departing.and_then(|departure| departure.stuck));
                self.status.wedged = true;
                return None;
            }
        };
        let mut rises = false;
        if let Some(high) = line.high {
            let seen = velocity.seen(-sign, -high, tau);
            match first_zero(&seen, Start::Anywhere, &mut steps) {
                Walk::Zero(at, _) => (tau, halts, rises) = (at, false, true),
                Walk::Until(at) if at < tau => (tau, halts) = (at, false),
                _ => {}
            }
        }
        if zero < tau {
            self.move_modes(&velocity, law, tau);
        }
        if rises {
            self.status.line += 1;
            return None;
        }
        if !halts {
            return None;
        }
        if zero < line.low {
            self.status.line = self.status.line.saturating_sub(1);
            return None;
        }
        self.events += 1;
        let force = self.holding();
        if force.abs() <= friction * self.status.stiction {
            self.grip(None);
            return None;
        }
        if force * sign < zero {
            self.status.contact = self.status.contact.reversed();
        }
        Some(Departure {
            slope: self.acceleration(force.abs() - friction),
            stuck: None,
        })
    }

    /// How far a series of the sliding motion holds: a steep law bends it more than the modes do.
    fn reach(&self, slope: S) -> S {
        let left = S::constant(1.0) - self.place;
        let pace = &self.table.pace;
        let rate = pace.rate + self.acceleration(slope.abs());
        if S::constant(1.0) < rate * left {
            S::constant(1.0) / rate
        } else {
            left
        }
    }

    /// The contact's acceleration under a force of so much more than it takes to keep its velocity.
    fn acceleration(&self, excess: S) -> S {
        self.scene.acceleration(&self.table.pace, excess)
    }

    /// The force in the held contact.
    fn held_force(&self) -> S {
        let ([still, ..], _) = self.still();
        let held = self.table.held.iter().zip(&*self.store.held);
        held.fold(still, |sum, (step, [y, _])| sum - step.force * *y)
    }

    /// The contact force that would keep the relative velocity as it is, while the contact slides.
    fn holding(&self) -> S {
        let two = S::constant(2.0);
        let mut sum = S::constant(0.0);
        for (channel, drive) in self.table.channels.iter().zip(&*self.store.drive) {
            let now = drive.first().copied().unwrap_or(S::constant(0.0));
            sum = sum + channel.residue * now;
        }
        if self.scene.rubs_on_base() {
            let [acceleration, ..] = derived(derived(self.base));
            let span = self.table.pace.span;
            sum = sum - acceleration / (span * span);
        }
        let modes = self.scene.dynamics.driven().iter();
        for (mode, [y, u]) in modes.zip(&*self.store.modes) {
            let lambda = mode.resonance * mode.resonance;
            sum = sum - mode.contact * lambda * (*y + two * mode.zeta * *u);
        }
        sum / self.scene.dynamics.chain.inverse_mass
    }

    /// From sliding to sticking, at this place or where the modes say: the held modes take over.
    fn grip(&mut self, place: Option<S>) {
        let dynamics = &self.scene.dynamics;
        let receptance = self.table.pace.receptance;
        let [base, rate] = self.carried();
        let modes = dynamics.driven().iter().zip(&*self.store.modes);
        let now = modes.fold(S::constant(0.0), |sum, (mode, [y, _])| {
            sum + mode.contact * *y
        });
        self.status.place = place.unwrap_or(now - base);
        self.status.contact = Contact::Stuck;
        self.status.line = 0;
        let lifted = (self.status.place + base, rate);
        let states = self.store.modes.iter().copied();
        let held = self.store.held.iter_mut().map(|[y, u]| (y, u));
        dynamics.project(receptance, states, lifted, held);
    }

    /// From sticking to sliding: the modes take over.
    fn leave(&mut self) {
        let [base, rate] = self.carried();
        let lifted = (self.status.place + base, rate);
        let receptance = self.table.pace.receptance;
        self.store.release(self.scene, receptance, lifted);
    }

    /// Displacement of the base that carries the contact, and its velocity in the time t√(k₁/m₁).
    fn carried(&self) -> [S; 2] {
        if self.scene.rubs_on_base() {
            let [place, velocity, ..] = self.base;
            [place, velocity / self.table.pace.span]
        } else {
            [S::constant(0.0); 2]
        }
    }

    fn terms(&self) -> usize {
        self.scene.terms(self.table.pace.terms)
    }

    /// The relative velocity as a power series about here, under the friction force level + slope·velocity.
    fn velocity(&mut self, [level, slope]: [S; 2]) -> Power<S> {
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
                let drive = load - step.gain * step.contact * force;
                let rates = next((step.angle, step.zeta), *state, [zero, drive]);
                *state = rates.map(|rate| rate * inverse);
            }
            order = order + S::constant(1.0);
        }
        velocity.size = size;
        velocity
    }

    /// The force in the held contact as a power series about here.
    fn force(&mut self) -> Power<S> {
        let zero = S::constant(0.0);
        let mut force = Power::zero(self.terms());
        let (still, _) = self.still();
        for (to, state) in self.store.scratch.iter_mut().zip(&*self.store.held) {
            *to = *state;
        }
        let motions = self.carrier();
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
                    for (lift, motion) in step.lift.iter().zip(motions) {
                        let motion = motion.get(place).copied().unwrap_or(zero);
                        for (term, lift) in drive.iter_mut().zip(lift) {
                            *term = *term + *lift * motion;
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

    /// Moves the modes that the contact drives on by a stretch of sliding.
    fn move_modes(&mut self, velocity: &Power<S>, [level, slope]: [S; 2], tau: S) {
        let zero = S::constant(0.0);
        let mut work = zero;
        for index in 0..self.driven() {
            let load = self.load(index);
            let (Some(step), Some(state)) =
                (self.table.modes.get(index), self.store.modes.get_mut(index))
            else {
                continue;
            };
            let pull = step.gain * step.contact;
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
            let gained = |rows: &[S; D]| rows.first().copied().unwrap_or(zero);
            *state = [y + gained(&rises), u + gained(&turns)];
            let done = load.iter().zip(&rises);
            let done = done.fold(zero, |sum, (term, moment)| sum + *term * *moment);
            work = work + done / step.gain;
        }
        let used = velocity.used();
        let moved = gain_of_integral(used, tau);
        let mut dissipated = level * moved;
        let mut carried = zero;
        if self.scene.rubs_on_base() {
            carried = level * gain(&self.base, tau);
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

    /// Moves the held modes on by a stretch of sticking.
    fn move_held(&mut self, tau: S) {
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
            let gained = |rows: &[S; D]| rows.first().copied().unwrap_or(zero);
            let [y, u] = state;
            let moved = [y + gained(&rows[0]), u + gained(&rows[1])];
            work = work + self.held_work(index, step, &rows, moved[0], tau);
            if let Some(state) = self.store.held.get_mut(index) {
                *state = moved;
            }
        }
        self.account(work, zero);
        self.passed(tau);
    }

    /// The inputs about the place that has been reached.
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

/// ∫ of a power series from 0 to a place.
fn gain_of_integral<S: Float>(terms: &[S], place: S) -> S {
    product(terms, &[S::constant(1.0)], place)
}

/// What the inputs add to the u′ of a mode, one coefficient.
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

/// What the inputs add to the y′ and u′ of a held mode, one coefficient.
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
