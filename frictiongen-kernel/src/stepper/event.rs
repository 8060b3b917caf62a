//! One sub-interval of a step that is searched for events and followed from event to event.

use super::drive::derived;
use super::part::{ROUNDINGS, Through};
use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::motion::contact::line as law;
use crate::motion::{Contact, Start, Walk, first_reach, first_zero, lift};
use crate::number::scalar::Float;

/// The contact at the instant at which it leaves zero velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure<S> {
    /// Relative acceleration in the direction of sliding.
    slope: S,
    /// Displacement at which the contact stuck until now, if it stuck.
    stuck: Option<S>,
}

impl<S: Float, const D: usize> Through<'_, '_, S, D> {
    /// Follows the contact from event to event to the end of the sub-interval.
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
            self.without_events(departing);
        }
        if self.status.contact == Contact::Stuck {
            self.status.holding = self.held_force();
        }
    }

    /// Advances over the rest of the sub-interval without events, in a way that creates no energy.  A contact at rest
    /// stays stuck, and a sliding contact slides without friction.
    fn without_events(&mut self, departing: Option<Departure<S>>) {
        self.exceeded = true;
        let left = S::constant(1.0) - self.place;
        if self.status.contact != Contact::Stuck {
            let Some(departure) = departing else {
                self.status.unknown = true;
                self.status.holding = S::constant(0.0);
                let none = [S::constant(0.0); 2];
                let velocity = self.velocity(none);
                return self.move_modes(&velocity, none, left);
            };
            self.grip(departure.stuck);
        }
        self.move_held(left);
    }

    /// Determines the contact's state before the first step, under the inputs at the start.
    pub(super) fn begin(&mut self) {
        self.judge();
        if self.status.contact != Contact::Stuck {
            return;
        }
        let force = self.held_force();
        let friction = self.status.friction;
        let grip = friction * self.status.stiction;
        // The acceleration of a moving base is not known before the first step.  The first step decides whether the
        // contact breaks away.
        self.status.holding = force.abs().min(grip).copysign(force);
        if grip < force.abs() && !self.scene.rubs_on_base() {
            // The contact breaks away at once.  The first step finds that again, and counts the event.
            self.leave();
            self.status.contact = Contact::along(force);
            self.status.holding = friction.copysign(force);
            self.status.unknown = true;
        }
    }

    /// Determines the contact's state from the motion alone.
    pub(super) fn judge(&mut self) {
        self.status.unknown = false;
        self.status.wedged = false;
        let velocity = self.velocity([S::constant(0.0); 2]);
        let rate = velocity.term(0);
        let pace = &self.table.pace;
        let speed = rate.abs() * S::constant(f64::from(pace.parts)) / pace.step;
        self.status.contact = Contact::along(rate);
        self.status.line = law::place(self.scene.law, speed);
        let size = velocity.size + self.status.given * pace.span;
        if rate.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
            // The search that follows decides from the force in the contact whether it breaks away at once.
            self.grip(None);
        }
    }

    /// Sticks until the force in the contact reaches μF, or to the end of the sub-interval.
    fn stick(&mut self) -> Option<Departure<S>> {
        let zero = S::constant(0.0);
        let left = S::constant(1.0) - self.place;
        let force = self.force();
        let grip = self.status.friction * self.status.stiction;
        let now = force.term(0);
        let noise = (force.size + grip) * S::constant(ROUNDINGS * S::EPSILON);
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
        // The force has reached μF, unless it had jumped beyond μF at the start.
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

    /// Slides until the contact stops, its speed reaches the next line of the law, or the sub-interval ends.
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
        // A piece of motion without length has no earlier crossing.
        if let Some(high) = line.high.filter(|_| zero < tau) {
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

    /// Length over which a power series of the sliding motion converges.  A steep law bends the motion more than the
    /// modes do.
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

    /// Acceleration of the contact under a force that exceeds by `excess` the force that would keep its velocity.
    fn acceleration(&self, excess: S) -> S {
        self.scene.acceleration(&self.table.pace, excess)
    }

    /// The force in the sticking contact.
    fn held_force(&self) -> S {
        let ([still, ..], _) = self.still();
        let held = self.table.held.iter().zip(&*self.store.held);
        held.fold(still, |sum, (step, [y, _])| sum - step.force * *y)
    }

    /// The contact force that would keep the relative velocity constant, while the contact slides.
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

    /// Changes from sliding to sticking, at `place` or at the displacement that the modes give.  The modes of the stuck
    /// chain take over the state.
    ///
    /// The state is projected as the difference between the modes and the rest position of the chain with its contact
    /// at that displacement.  Far from the origin these differences are small differences of large numbers, above all
    /// in the softest mode.  The rounding of these differences would strain stiff springs.  The differences do not
    /// displace the contact, so that the softest mode's difference follows from the others.
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
        let lifted = self.status.place + base;
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

    /// Changes from sticking to sliding.  The modes take over the state.
    pub(super) fn leave(&mut self) {
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
}
