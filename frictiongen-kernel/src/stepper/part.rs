//! One sub-interval of a step: by the tables where the contact certainly has no event, by a search for events
//! elsewhere.

use super::dot::add;
use super::drive::{at, derived, growth};
use super::rows::HeldStep;
use super::scene::StepScene;
use super::state::{Status, StoreMut};
use super::table::View;
use crate::motion::Contact;
use crate::motion::contact::line::{self as law, Line};
use crate::number::scalar::Float;

/// Rounding bound of a sum over modes, in roundings of the sum of its terms' sizes.
pub(super) const ROUNDINGS: f64 = 8.0;
/// Over a unit of time a function deviates from its chord by at most this multiple of its largest second derivative.
const OFF_CHORD: f64 = 0.125;

/// A stepper within one sub-interval of a step.
pub(super) struct Through<'t, 'a, S, const D: usize> {
    pub scene: &'t StepScene<'a, S>,
    pub table: View<'t, S, D>,
    pub store: StoreMut<'t, S, D>,
    pub status: &'t mut Status<S>,
    /// The base's displacement over the sub-interval as a polynomial, where the contact rubs on the base.
    pub base: [S; 4],
    /// Progress through the sub-interval, from 0 to 1.  The polynomials of the inputs are about this instant.
    pub place: S,
    /// Number of events in the sub-interval so far.
    pub events: u32,
    /// True if the bound on followed events or pieces was reached.
    pub exceeded: bool,
}

impl<S: Float, const D: usize> Through<'_, '_, S, D> {
    pub(super) fn driven(&self) -> usize {
        self.scene.dynamics.in_contact().min(self.store.modes.len())
    }

    /// Rate that the inputs add to the u of a mode.
    #[inline]
    pub(super) fn load(&self, mode: usize) -> [S; D] {
        let mut sum = [S::constant(0.0); D];
        let loads = self.table.loads_of(mode);
        for (load, drive) in loads.iter().zip(&*self.store.drive) {
            add(&mut sum, *load, drive);
        }
        sum
    }

    /// Rates that the inputs, and the base that carries the contact, add to y and u of a stuck chain's mode.
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

    /// Velocity and acceleration of the base as polynomials, if the contact rubs on the base.
    pub(super) fn moving_base(&self) -> Option<[[S; 4]; 2]> {
        let velocity = derived(self.base);
        let motions = [velocity, derived(velocity)];
        self.scene.rubs_on_base().then_some(motions)
    }

    /// The line of the friction law on which the speed lies.  The line's speeds are in lengths a sub-interval.
    #[inline]
    pub(super) fn line(&self) -> Line<S> {
        let mut line = law::line(self.scene.law, self.status.line);
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

    /// Velocity of the base that carries the contact, at the start and at the end of the sub-interval.
    fn base_velocities(&self) -> [S; 2] {
        if !self.scene.rubs_on_base() {
            return [S::constant(0.0); 2];
        }
        let velocity = derived(self.base);
        [velocity[0], at(&velocity, S::constant(1.0))]
    }

    /// Advances through the sub-interval.
    pub(super) fn go(&mut self) {
        if self.status.friction.is_zero() {
            return self.free();
        }
        self.glide(self.driven());
        if self.status.unknown {
            self.judge();
        }
        let known = match self.status.contact {
            Contact::Stuck => self.sticks(),
            _ => self.slides(),
        };
        if !known {
            self.look();
        }
    }

    /// Advances without friction.  No force then keeps the contact at rest, so that its turning points are no events.
    ///
    /// The tables serve for the whole sub-interval.  Power series about events would not do.  Their rounded sums do not
    /// keep the energy of an undamped chain in step with the work.
    fn free(&mut self) {
        if self.status.contact == Contact::Stuck && !self.status.unknown {
            self.leave();
        }
        self.status.unknown = true;
        self.status.wedged = false;
        self.status.holding = S::constant(0.0);
        self.glide(0);
    }

    /// Advances the modes from index `first` on, which feel no friction, over the whole sub-interval.
    fn glide(&mut self, first: usize) {
        for index in first..self.store.modes.len() {
            let Some(step) = self.table.modes.get(index) else {
                continue;
            };
            let drive = self.load(index);
            let Some(state) = self.store.modes.get_mut(index) else {
                continue;
            };
            let (next, work) = step.moved(*state, &drive, &drive);
            *state = next;
            self.status.load = self.status.load.plus(work);
        }
    }

    /// Advances by the tables if the contact certainly keeps sliding, and returns whether it does.
    fn slides(&mut self) -> bool {
        let zero = S::constant(0.0);
        let line = self.line();
        if !line.slope.is_zero() || line.high.is_some() {
            return false;
        }
        let sign: S = self.status.contact.sign();
        let force = sign * self.status.friction * line.level;
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
        self.take_modes();
        self.account(work - force * carried, force * (moved - carried));
        true
    }

    /// Advances by the tables if the contact certainly keeps sticking, and returns whether it does.
    fn sticks(&mut self) -> bool {
        let zero = S::constant(0.0);
        if self.status.wedged {
            return false;
        }
        let one = S::constant(1.0);
        let (still, mut bend) = self.still();
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
        let grip = self.status.friction * self.status.stiction;
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
        self.status.holding = end;
        true
    }

    pub(super) fn take_modes(&mut self) {
        let driven = self.driven();
        let modes = self.store.modes.iter_mut().take(driven);
        for (state, next) in modes.zip(&*self.store.scratch) {
            *state = *next;
        }
    }

    pub(super) fn account(&mut self, load: S, friction: S) {
        self.status.load = self.status.load.plus(load);
        self.status.dissipated = self.status.dissipated.plus(friction);
    }

    /// The force in the sticking contact without the share of the stuck chain's modes.  The result is a polynomial,
    /// with an upper bound on its second derivative over the sub-interval.
    pub(super) fn still(&self) -> ([S; 4], S) {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let pace = &self.table.pace;
        let mass = one / self.scene.dynamics.chain.inverse_mass;
        let mut sum = [zero; 4];
        for (channel, drive) in self.table.channels.iter().zip(&*self.store.drive) {
            for (sum, term) in sum.iter_mut().zip(drive) {
                *sum = *sum + channel.residue * *term;
            }
        }
        for term in &mut sum {
            *term = *term * mass;
        }
        sum[0] = sum[0] - self.status.place / pace.receptance;
        if self.scene.rubs_on_base() {
            let velocity = derived(self.base);
            let acceleration = derived(velocity);
            let inverse = one / pace.span;
            let of_place = one / pace.receptance;
            let of_velocity = pace.drag * inverse * mass;
            let of_acceleration = inverse * inverse * mass;
            let motions = self.base.iter().zip(velocity).zip(acceleration);
            for (sum, ((place, velocity), acceleration)) in sum.iter_mut().zip(motions) {
                *sum = *sum
                    - *place * of_place
                    - of_velocity * velocity
                    - of_acceleration * acceleration;
            }
        }
        let [_, _, c, d] = sum;
        let (two, six) = (S::constant(2.0), S::constant(6.0));
        (sum, two * c.abs() + six * d.abs())
    }

    /// Work of the inputs up to `place` while the base carries the sticking contact, without the share of the stuck
    /// chain's modes.
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
        let still = still.copied().unwrap_or_else(|| self.still().0);
        work - product(&still, &velocity, place)
    }

    /// Work that the inputs do through one mode of the stuck chain, from the mode's moments up to `place`.
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
            // −∫F b′ is integrated by parts, with b counted from its present value.
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

/// Integrates the product of two polynomials from 0 to `place`.
pub(super) fn product<S: Float>(a: &[S], b: &[S], place: S) -> S {
    let one = S::constant(1.0);
    let mut sum = S::constant(0.0);
    let (mut order, mut power) = (one, place);
    for a in a {
        let (mut n, mut p) = (order, power);
        for b in b {
            sum = sum + *a * *b * p / n;
            (n, p) = (n + one, p * place);
        }
        (order, power) = (order + one, power * place);
    }
    sum
}
