//! Motion in a sub-interval in which the contact slides. The stepper advances with the constant tables, or up to an
//! event with a power series.

use super::dot::{add, dot};
use super::drive::{at, derived, growth};
use super::interval::{Departure, OFF_CHORD, ROUNDINGS, StepInterval, integral, product};
use super::law::StepContact;
use super::rows::{moments, next};
use crate::motion::{KineticLine, Law, Power, WalkResult, WalkStart, first_zero, line};
use crate::number::scalar::Float;

impl<S: Float, const D: usize, K: StepContact<S>> StepInterval<'_, '_, S, D, K> {
    /// Returns the straight line of the friction law (force over speed) that contains the present speed. The unit of
    /// the line's speeds is the unit of length divided by the sub-interval.
    #[inline]
    pub(super) fn line(&self) -> KineticLine<S> {
        let mut line = line(self.scene.law, self.status.line);
        if self.scene.law.is_empty() {
            return line;
        }
        let pace = &self.table.pace;
        let seconds = pace.step / S::constant(f64::from(pace.parts));
        line.slope = line.slope / seconds;
        line.low = line.low * seconds;
        line.high = line.high.map(|high| high * seconds);
        line
    }

    /// Returns the rate at which the inputs change a mode's scaled velocity u, as a polynomial over the sub-interval.
    #[inline]
    pub(super) fn load(&self, mode: usize) -> [S; D] {
        let mut sum = [S::constant(0.0); D];
        let loads = self.table.loads_of(mode);
        for (load, drive) in loads.iter().zip(&*self.store.drive) {
            add(&mut sum, *load, drive);
        }
        sum
    }

    /// Returns the velocity of the base on which the contact rubs, at the start and at the end of the sub-interval.
    fn base_velocities(&self) -> [S; 2] {
        if !self.scene.rubs_on_base() {
            return [S::constant(0.0); 2];
        }
        let velocity = derived(self.base);
        [velocity[0], at(&velocity, S::constant(1.0))]
    }

    /// Advances to the end of the sub-interval with the constant tables, if the contact provably keeps sliding. Returns
    /// true if the function has advanced the motion.
    pub(super) fn slide_by_tables(&mut self) -> bool {
        let zero = S::constant(0.0);
        let line = self.line();
        if !line.slope.is_zero() || line.high.is_some() {
            return false;
        }
        let contact = self.status.contact;
        let sign: S = contact.sign();
        let [force, _] = self.law().kinetic_on(&line, contact);
        let [from, to] = self.base_velocities();
        let (mut start, mut rise) = (-from, from - to);
        let mut bend = if self.scene.rubs_on_base() {
            let [_, _, _, d] = self.base;
            S::constant(6.0) * d.abs()
        } else {
            zero
        };
        let (mut size, mut moved, mut work) = (from.abs(), zero, zero);
        for index in 0..self.driven() {
            let Some(step) = self.table.modes.get(index) else {
                return false;
            };
            let load = self.load(index);
            let mut drive = load;
            if let [first, ..] = &mut drive[..] {
                *first = *first - step.per_force * step.contact * force;
            }
            let Some(&[y, u]) = self.store.modes.get(index) else {
                return false;
            };
            let (next, done) = step.moved([y, u], &drive, &load);
            let weight = step.contact * step.angle;
            let own = weight * u;
            start = start + own;
            rise = rise + weight * (next[1] - u);
            size = size + own.abs();
            bend = bend + weight.abs() * step.bend([y, u], &drive);
            moved = moved + step.contact * (next[0] - y);
            work = work + done;
            if let Some(to) = self.store.scratch.get_mut(index) {
                *to = next;
            }
        }
        let least = (sign * start).min(sign * (start + rise));
        let room = bend * S::constant(OFF_CHORD) + size * S::constant(ROUNDINGS * S::EPSILON);
        if !(line.low + room < least) {
            return false;
        }
        let carried = if self.scene.rubs_on_base() {
            growth(&self.base, S::constant(1.0))
        } else {
            zero
        };
        if self.scene.damped_from_base() {
            self.account_reaction(0..self.driven(), force);
        }
        self.take_modes();
        self.account(work - force * carried, force * (moved - carried));
        true
    }

    /// Advances the sliding motion to the first of four instants. At these instants the contact stops, the speed
    /// reaches the next line of the friction law, the sub-interval ends, or the power series ends. If the contact
    /// starts this motion from zero velocity, `departing` contains its acceleration. If the contact then slides on
    /// from zero velocity, the function returns its new acceleration.
    pub(super) fn slide_to_event(
        &mut self,
        departing: Option<Departure<S>>,
    ) -> Option<Departure<S>> {
        let zero = S::constant(0.0);
        let contact = self.status.contact;
        let sign: S = contact.sign();
        let line = self.line();
        let kinetic = self.law().kinetic_on(&line, contact);
        let velocity = self.velocity_series(kinetic);
        let reach = self.series_reach(kinetic[1]);
        let mut steps = 0;
        let start = departing.map_or(WalkStart::Anywhere, |departure| {
            WalkStart::Zero(departure.slope)
        });
        let seen = velocity.seen(sign, line.low, reach).within(self.search());
        let (mut tau, mut halts) = match first_zero(&seen, start, &mut steps) {
            WalkResult::Zero(tau, _) => (tau, true),
            WalkResult::Until(tau) => (tau, false),
            WalkResult::NoStart => {
                self.start_sticking(departing.and_then(|departure| departure.stuck));
                self.status.wedged = true;
                return None;
            }
        };
        let mut rises = false;
        // A piece of motion of length zero cannot contain a crossing to the next line of the friction law.
        if let Some(high) = line.high.filter(|_| zero < tau) {
            let seen = velocity.seen(-sign, -high, tau).within(self.search());
            match first_zero(&seen, WalkStart::Anywhere, &mut steps) {
                WalkResult::Zero(at, _) => (tau, halts, rises) = (at, false, true),
                WalkResult::Until(at) if at < tau => (tau, halts) = (at, false),
                _ => {}
            }
        }
        if halts {
            self.note_crossing(&velocity, -(sign * line.low), tau);
        } else if rises {
            let high = line.high.unwrap_or(zero);
            self.note_crossing(&velocity, -(sign * high), tau);
        }
        if zero < tau {
            self.move_modes(&velocity, kinetic, tau);
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
        self.count_event();
        if self.is_elastic() {
            self.start_sticking(None);
            return None;
        }
        let holding = self.holding();
        self.note_choice(holding);
        let Some(slide) = self.law().leave_rest(holding) else {
            self.start_sticking(None);
            return None;
        };
        self.status.contact = slide.contact;
        Some(Departure {
            slope: self.acceleration(slide.excess),
            stuck: None,
        })
    }

    /// Returns the length of time in which a power series of the sliding motion converges, as a fraction of the
    /// sub-interval. The length is at most the rest of the sub-interval. A steep friction law reduces the length,
    /// because the motion then changes faster than the modes oscillate.
    fn series_reach(&self, slope: S) -> S {
        let left = S::constant(1.0) - self.progress;
        let pace = &self.table.pace;
        let rate = pace.rate + self.acceleration(slope.abs());
        if S::constant(1.0) < rate * left {
            S::constant(1.0) / rate
        } else {
            left
        }
    }

    /// Returns the contact force at which the relative velocity of the sliding contact would stay constant.
    fn holding(&self) -> S {
        let two = S::constant(2.0);
        let mut sum = S::constant(0.0);
        for (channel, drive) in self.table.channels.iter().zip(&*self.store.drive) {
            let now = drive.first().copied().unwrap_or(S::constant(0.0));
            sum = sum + channel.acceleration * now;
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
        sum / self.scene.dynamics.chain().inverse_mass
    }

    /// Returns the relative velocity of the contact as a power series about the present instant. The friction force is
    /// `level` + `slope`·velocity.
    pub(super) fn velocity_series(&mut self, [level, slope]: [S; 2]) -> Power<S> {
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
        let states = &mut *self.store.scratch;
        let (mut order, mut size) = (S::constant(1.0), zero);
        // `sum` is the term of the present order. `sizes` is the sum of the absolute values of the summands in this
        // term.
        let mut sum = -base[0];
        let mut sizes = sum.abs();
        for (step, [_, u]) in steps.iter().zip(&*states) {
            let term = step.contact * step.angle * *u;
            (sum, sizes) = (sum + term, sizes + term.abs());
        }
        for (place, slot) in velocity.slots().enumerate() {
            *slot = sum;
            if place < 4 {
                size = size + sizes;
            }
            let force = slope * sum + if place == 0 { level } else { zero };
            let inverse = S::constant(1.0) / order;
            order = order + S::constant(1.0);
            sum = -base.get(place + 1).copied().unwrap_or(zero);
            sizes = sum.abs();
            for (index, (step, state)) in steps.iter().zip(&mut *states).enumerate() {
                let mut drive = zero;
                if place < D {
                    drive = load_term(self.table.loads_of(index), self.store.drive, place);
                }
                drive = drive - step.per_force * step.contact * force;
                let [rise, turn] = next((step.angle, step.zeta), *state, [zero, drive]);
                let u = turn * inverse;
                *state = [rise * inverse, u];
                let term = step.contact * step.angle * u;
                (sum, sizes) = (sum + term, sizes + term.abs());
            }
        }
        velocity.size = size;
        velocity
    }

    /// Advances the modes that the contact drives during the time `tau`. The contact slides, and no event occurs.
    pub(super) fn move_modes(&mut self, velocity: &Power<S>, [level, slope]: [S; 2], tau: S) {
        let zero = S::constant(0.0);
        let mut work = zero;
        let reacts = self.scene.damped_from_base();
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
            let (rises, [turn]) = moments::<S, D, 1>(of, *state, drive, velocity.count, tau);
            let [y, u] = *state;
            *state = [y + rises.first().copied().unwrap_or(zero), u + turn];
            let mut done = dot(zero, &load, &rises);
            if reacts {
                done = done - self.reaction(index, &rises);
            }
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
        self.shift_inputs(tau);
    }
}

/// Returns one coefficient of the polynomial with which the inputs change a mode's scaled velocity u.
#[inline]
fn load_term<S: Float, const D: usize>(loads: &[S], inputs: &[[S; D]], place: usize) -> S {
    let zero = S::constant(0.0);
    let pairs = loads.iter().zip(inputs);
    pairs.fold(zero, |sum, (load, input)| {
        sum + *load * input.get(place).copied().unwrap_or(zero)
    })
}
