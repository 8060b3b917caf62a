//! One part of a step, looked through: from event to event.

use super::drive::derived;
use super::part::{ROUNDINGS, Through};
use super::{MAX_EVENTS, MAX_STRETCHES};
use crate::number::scalar::Float;
use crate::simulation::{Contact, Start, Walk, first_reach, first_zero, law, lift};

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
            self.without_events(departing);
        }
        if self.status.contact == Contact::Stuck {
            self.status.holding = self.held_force();
        }
    }

    /// The rest of the part without events, in a way that creates no energy: held where the contact is at rest,
    /// without friction where it is not.
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

    /// Says what the contact does before the first step, under the inputs of its start.
    pub(super) fn begin(&mut self) {
        self.judge();
        if self.status.contact != Contact::Stuck {
            return;
        }
        let force = self.held_force();
        let friction = self.status.friction;
        let grip = friction * self.status.stiction;
        // The first step tells how a moving base speeds up, and with it whether the contact goes.
        self.status.holding = force.abs().min(grip).copysign(force);
        if grip < force.abs() && !self.scene.rubs_on_base() {
            // It goes at once: the first step finds that again, and counts the event.
            self.leave();
            self.status.contact = Contact::along(force);
            self.status.holding = friction.copysign(force);
            self.status.unknown = true;
        }
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
        let size = velocity.size + self.status.given * pace.span;
        if rate.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
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
        // Where the line ends at once there is nothing before it.
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
    ///
    /// What is held is how far the modes are from those of the chain at rest with its contact there.  Far from the origin
    /// these are small differences of large numbers, in the softest mode above all, and their rounding would strain stiff
    /// springs.  The contact moves by none of them, so that the softest mode's follows from the others'.
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

    /// From sticking to sliding: the modes take over.
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
