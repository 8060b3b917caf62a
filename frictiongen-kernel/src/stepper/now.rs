//! What a stepper answers: the masses, the contact and the force in it.

use super::cost::Cost;
use super::part::ROUNDINGS;
use super::run::Stepper;
use super::state::Store;
use super::table::Tables;
use crate::number::scalar::Float;
use crate::simulation::{Contact, law};

/// What a step has led to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stepped<S> {
    /// What the contact does at its end.
    pub contact: Contact,
    /// The friction force in the contact at its end.
    pub force: S,
    /// How many stops, break-aways and reversals there were.
    pub events: u32,
    /// Whether there were more in a part of it than are followed.
    pub exceeded: bool,
}

/// A mass at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MassNow<S> {
    displacement: S,
    velocity: S,
}

impl<S: Float> MassNow<S> {
    /// Its displacement, in the scene's unit of length.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.displacement
    }

    /// Its velocity, in that unit a second.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.velocity
    }
}

/// The contact at the end of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactNow<S> {
    motion: MassNow<S>,
    contact: Contact,
    force: S,
}

impl<S: Float> ContactNow<S> {
    /// The relative displacement.
    #[must_use]
    pub fn displacement(&self) -> S {
        self.motion.displacement
    }

    /// The relative velocity; 0 while the contact sticks.
    #[must_use]
    pub fn velocity(&self) -> S {
        self.motion.velocity
    }

    /// The friction force, in the scene's unit of force: what holds the contact while it sticks; positive against
    /// positive sliding.
    #[must_use]
    pub fn force(&self) -> S {
        self.force
    }

    /// Whether it sticks, or which way it slides.
    #[must_use]
    pub fn contact(&self) -> Contact {
        self.contact
    }

    /// Whether it sticks.
    #[must_use]
    pub fn is_sticking(&self) -> bool {
        self.contact == Contact::Stuck
    }
}

impl<S: Float, const D: usize, T: Tables<S, D>, V: Store<S, D>> Stepper<'_, S, D, T, V> {
    /// What a step costs at most.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let pace = self.tables.view().pace;
        self.scene.cost(D, pace.parts, pace.terms)
    }

    /// The length of a step, in seconds.
    #[must_use]
    pub fn dt(&self) -> S {
        self.tables.view().pace.step
    }

    /// How many steps were taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.status.steps
    }

    /// The time since the start, in seconds.
    #[must_use]
    pub fn time(&self) -> S {
        // Halves of 32 bits become a scalar without double precision, which a microcontroller emulates.
        let [high, low] = [
            self.status.steps >> 32,
            self.status.steps & u64::from(u32::MAX),
        ]
        .map(|half| S::constant(f64::from(u32::try_from(half).unwrap_or(u32::MAX))));
        (high * S::constant(4_294_967_296.0) + low) * self.dt()
    }

    /// In how many steps more events happened than are followed.
    #[must_use]
    pub fn exceeded(&self) -> u64 {
        self.status.exceeded
    }

    /// μ, static over kinetic friction force.
    #[must_use]
    pub fn stiction(&self) -> S {
        self.status.stiction
    }

    /// What the contact's velocity says of it: at rest where that is no more than the roundings of its terms.
    pub(super) fn direction(&self) -> Contact {
        let [_, velocity] = self.carrying();
        let (mut sum, mut size) = (-velocity, velocity.abs() + self.status.given);
        for (index, mode) in self.scene.dynamics.driven().iter().enumerate() {
            let [_, rate] = self.mode(index);
            let term = mode.contact * rate;
            (sum, size) = (sum + term, size + term.abs());
        }
        if sum.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
            Contact::Stuck
        } else {
            Contact::along(sum)
        }
    }

    /// The motion of the contact as the modes say.
    fn contact_sum(&self) -> MassNow<S> {
        let zero = S::constant(0.0);
        let modes = self.scene.dynamics.driven();
        let sum = self.sum(|mode| modes.get(mode).map_or(zero, |mode| mode.contact));
        let [place, velocity] = self.carrying();
        MassNow {
            displacement: sum.displacement - place,
            velocity: sum.velocity - velocity * self.scene.units.rate,
        }
    }

    /// Where the held contact is, and how fast, in the time t√(k₁/m₁).
    pub(super) fn lifted(&self) -> (S, S) {
        let [place, velocity] = self.carrying();
        (self.status.place + place, velocity)
    }

    /// The base's motion where it carries the contact, in the time t√(k₁/m₁).
    fn carrying(&self) -> [S; 2] {
        if self.scene.rubs_on_base() {
            let [place, velocity] = self.status.base;
            [place, velocity / self.scene.units.rate]
        } else {
            [S::constant(0.0); 2]
        }
    }

    /// A mass now, by its place in the description; at rest if there is no such mass.
    #[must_use]
    pub fn mass(&self, index: usize) -> MassNow<S> {
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        if sticks && self.scene.dynamics.moves_as_contact(index) {
            return MassNow {
                displacement: self.status.place,
                velocity: S::constant(0.0),
            };
        }
        let shape = self.scene.dynamics.shape(index);
        self.sum(|mode| shape.get(mode).copied().unwrap_or(S::constant(0.0)))
    }

    /// A weighted sum of the modes' displacements, and of their velocities.
    pub(super) fn sum(&self, weight: impl Fn(usize) -> S) -> MassNow<S> {
        let zero = S::constant(0.0);
        let (mut displacement, mut velocity) = (zero, zero);
        for index in 0..self.scene.dynamics.modes.len() {
            let [y, rate] = self.mode(index);
            displacement = displacement + weight(index) * y;
            velocity = velocity + weight(index) * rate;
        }
        MassNow {
            displacement,
            velocity: velocity * self.scene.units.rate,
        }
    }

    /// A mode's displacement, and its velocity in the time t√(k₁/m₁).
    pub(super) fn mode(&self, index: usize) -> [S; 2] {
        let zero = S::constant(0.0);
        let dynamics = &self.scene.dynamics;
        let store = self.store.read();
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        let Some(mode) = dynamics.modes.get(index) else {
            return [zero; 2];
        };
        if sticks && index < dynamics.in_contact() {
            let receptance = self.tables.view().pace.receptance;
            let held = store.held.iter().copied();
            let [y, u] = dynamics.released(receptance, held, self.lifted(), index);
            return [y, u * mode.resonance];
        }
        let [y, u] = store.modes.get(index).copied().unwrap_or([zero; 2]);
        [y, u * mode.resonance]
    }

    /// The contact now.
    #[must_use]
    pub fn contact(&self) -> ContactNow<S> {
        let contact = self.status.contact;
        let motion = if contact == Contact::Stuck && !self.status.unknown {
            MassNow {
                displacement: self.status.place,
                velocity: S::constant(0.0),
            }
        } else {
            self.contact_sum()
        };
        ContactNow {
            motion,
            contact,
            force: self.force(),
        }
    }

    /// The friction force now.
    pub(super) fn force(&self) -> S {
        let zero = S::constant(0.0);
        let status = &self.status;
        let sign: S = status.contact.sign();
        let force = if status.contact != Contact::Stuck && !status.unknown {
            let line = law::line(self.scene.law, status.line);
            let slides = !line.slope.is_zero();
            let speed = if slides {
                self.contact_sum().velocity.abs()
            } else {
                zero
            };
            sign * status.friction * (line.level + line.slope * speed)
        } else {
            status.holding
        };
        force * self.scene.units.stiffness
    }
}
