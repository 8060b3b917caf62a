//! Stops and moving surfaces of a chain.
//!
//! A stop is open until its two nodes have come nearer than its gap. A stop with a spring is then shut: its spring and
//! its dashpot act until the gap opens again. A stop without a spring reverses the relative velocity of its nodes by an
//! impact. A sequence of impacts that follow each other ever faster ends in a state of rest once all further impacts would
//! happen within the rounding error of the time. The stop is then shut until it would have to pull.
//!
//! No friction force is large enough to take part in an impact. A rigid contact of a node that an impact moves
//! therefore slides afterwards, unless its relative velocity is 0. Impacts at the same instant happen one after another,
//! in the order of the description.

use super::model::{Contact, Model, Stop};
use super::roots::first_negative_within;
use super::run::Motion;
use super::series::Series;
use super::size::{Size, at, set, sign};
use super::state::{FREE, IMPACT, STUCK, State};
use crate::Float;
use crate::errors::Halt;

/// Relative velocity, divided by the velocities of the two nodes, that counts as 0 when a stop shuts or opens.
const GRAZE: f64 = 64.0;

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns the force of the dashpot of a stop that is shut, for the velocities `v` of the nodes.
    pub(super) fn dashpot(&self, contact: usize, v: &[S]) -> S {
        match (self.stop(contact), self.contact(contact)) {
            (Some(stop), Some(own)) => stop.damping * own.across(v),
            _ => S::constant(0.0),
        }
    }

    /// Adds the forces of the dashpots of all stops that are shut to the forces on the nodes.
    pub(super) fn pull_dashpots(&self, state: &State<S, Z>, v: &[S], forces: &mut [S]) {
        if !Z::HAS_PARTS {
            return;
        }
        for (j, contact) in self.contacts().iter().enumerate() {
            if contact.stop.is_some() && state.phase(j) == STUCK {
                contact.pull(forces, self.dashpot(j, v));
            }
        }
    }

    /// Returns the changes of the velocities of the two nodes of a contact, of which the second has the opposite sign, if an
    /// impact changes their relative velocity by `change`.
    pub(super) fn impact_of(&self, contact: &Contact<S>, change: S) -> (S, S) {
        let [plus, minus] = [contact.plus, contact.minus].map(|node| self.inverse_mass(node));
        let factor = change / (plus + minus);
        (factor * plus, factor * minus)
    }
}

/// Returns the force of the spring of a stop, for the relative displacement of its nodes.
fn spring_force<S: Float>(stop: &Stop<S>, stiffness: S, place: S) -> S {
    stiffness * (place - stop.side * stop.gap)
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Returns the fraction of the time interval of a power series after which a stop shuts or opens, or `None` if it
    /// does neither. The first `zeros` coefficients of the watched quantity are 0.
    ///
    /// # Errors
    ///
    /// [`Halt::Stretches`] if the search reaches its limit.
    pub(super) fn stop_event_in(
        &self,
        series: &Series<S, Z>,
        (j, stop): (usize, &Stop<S>),
        zeros: usize,
        divisions: &mut u32,
    ) -> Result<Option<(S, i8)>, Halt> {
        let Some(contact) = self.model.contact(j) else {
            return Ok(None);
        };
        let watched = if self.state.phase(j) == STUCK {
            series.force_terms(j).map(|term| stop.side * term)
        } else {
            series.opening_terms(contact, stop)
        };
        let first = first_negative_within(&watched, zeros, divisions)?;
        Ok(first.map(|at| (at, 1)))
    }

    /// Shuts or opens each stop that has an event, or lets its nodes collide.
    pub(super) fn hit_stops(&mut self, hits: &Z::Contacts<Option<i8>>) {
        if !self.model.has_stops() {
            return;
        }
        let mut collides = false;
        for (j, hit) in hits.as_ref().iter().enumerate() {
            let Some(stop) = self.model.stop(j).filter(|_| hit.is_some()) else {
                continue;
            };
            let shut = self.state.phase(j) == STUCK;
            let is_rigid = self.model.contact(j).is_some_and(Contact::is_rigid);
            match (shut, is_rigid) {
                (true, true) => {
                    self.state.set_phase(j, FREE);
                    // The force of the stop has fallen to 0, so that the relative acceleration starts from 0.
                    self.state.set_zeros(j, (3, 1));
                }
                (false, true) => {
                    self.collide(j, &stop);
                    collides = true;
                }
                (_, false) => {
                    self.state.set_phase(j, if shut { FREE } else { STUCK });
                    set(self.state.forces.as_mut(), j, S::constant(0.0));
                    let zeros = if self.grazes(j) { 2 } else { 1 };
                    self.state.set_zeros(j, (zeros, 1));
                }
            }
        }
        if collides {
            self.pass_on();
            self.slide_on();
        }
    }

    /// Opens the stops whose nodes have just collided.
    pub(super) fn part(&mut self) {
        if !Z::HAS_PARTS {
            return;
        }
        for phase in self.state.phases.as_mut() {
            if *phase == IMPACT {
                *phase = FREE;
            }
        }
    }

    /// Returns true if the relative velocity of a stop is a rounding error.
    fn grazes(&self, contact: usize) -> bool {
        let (_, v) = self.nodes();
        self.model.contact(contact).is_some_and(|own| {
            let sizes = at(v.as_ref(), own.plus).abs() + at(v.as_ref(), own.minus).abs();
            own.across(v.as_ref()).abs() <= S::constant(GRAZE * S::EPSILON) * sizes
        })
    }

    /// Lets the two nodes of a stop without a spring collide.
    fn collide(&mut self, contact: usize, stop: &Stop<S>) {
        let Some(own) = self.model.contact(contact).copied() else {
            return;
        };
        let (_, mut v) = self.nodes();
        let speed = own.across(v.as_ref());
        let zero = S::constant(0.0);
        let restitution = if self.comes_to_rest(&own, stop, speed) {
            zero
        } else {
            stop.restitution
        };
        // Impacts can follow each other ever faster, and are no sign of a motion that does not advance.
        self.stalls = 0;
        let change = -(S::constant(1.0) + restitution) * speed;
        let (plus, minus) = self.model.impact_of(&own, change);
        for (node, impulse) in [(own.plus, plus), (own.minus, -minus)] {
            let moved = at(v.as_ref(), node) + impulse;
            set(v.as_mut(), node, moved);
        }
        self.state.keep_speeds(v.as_ref());
        let is_shut = restitution.is_zero();
        set(self.state.places.as_mut(), contact, stop.side * stop.gap);
        self.state
            .set_phase(contact, if is_shut { STUCK } else { IMPACT });
        self.state.set_zeros(contact, (usize::from(!is_shut), 1));
    }

    /// Returns true if the nodes of a stop collide so fast one after another that no further impact is distinct: if all
    /// further impacts happen within the rounding error of the time.
    fn comes_to_rest(&self, own: &Contact<S>, stop: &Stop<S>, speed: S) -> bool {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let size = &self.model.size;
        let decision = self.decision(size.contacts(false), size.contacts(0));
        let none = size.contacts(false);
        let (accelerations, _) = decision.accelerations(&none, &size.contacts(0));
        let pressing = stop.side * own.across(accelerations.as_ref());
        let flight = S::constant(2.0) * stop.restitution * speed.abs();
        let rounding = S::constant(8.0 * S::EPSILON) * self.time;
        pressing > zero && flight <= (one - stop.restitution) * rounding * pressing
    }

    /// Lets the nodes of stops that rest collide, as long as an impact at another stop drives them together.
    fn pass_on(&mut self) {
        let contacts = self.model.contacts().len();
        for _ in 0..8 * contacts {
            let mut is_done = true;
            for j in 0..contacts {
                let Some(stop) = self.model.stop(j) else {
                    continue;
                };
                let rests = self.state.phase(j) == STUCK
                    && self.model.contact(j).is_some_and(Contact::is_rigid);
                if !rests || self.grazes(j) {
                    continue;
                }
                let (_, v) = self.nodes();
                let speed = self.model.contact(j).map(|own| own.across(v.as_ref()));
                if speed.is_some_and(|speed| stop.side * speed > S::constant(0.0)) {
                    self.collide(j, &stop);
                    is_done = false;
                } else {
                    self.state.set_phase(j, FREE);
                    self.state.set_zeros(j, (1, 1));
                }
            }
            if is_done {
                return;
            }
        }
    }

    /// Gives each contact with friction the phase that belongs to the velocities after an impact.
    fn slide_on(&mut self) {
        let (x, v) = self.nodes();
        let zero = S::constant(0.0);
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let phase = self.state.phase(j);
            if phase == FREE || contact.stop.is_some() {
                continue;
            }
            let speed = self.model.slip(contact, v.as_ref());
            let sizes = at(v.as_ref(), contact.plus).abs()
                + at(v.as_ref(), contact.minus).abs()
                + contact.speed.abs();
            let is_still = speed.abs() <= S::constant(GRAZE * S::EPSILON) * sizes;
            let along = if speed < zero { -1 } else { 1 };
            if contact.is_rigid() {
                let new = if is_still { STUCK } else { along };
                if new != phase {
                    set(self.state.places.as_mut(), j, contact.across(x.as_ref()));
                    self.state.set_phase(j, new);
                    self.state.set_zeros(j, (0, 0));
                }
            } else if phase != STUCK && sign::<S>(phase) * speed <= contact.creep() {
                let force = sign::<S>(phase) * contact.level.value(self.time, 0);
                set(self.state.forces.as_mut(), j, force);
                self.state.set_phase(j, STUCK);
                let at_limit = contact.stiction == S::constant(1.0);
                self.state.set_zeros(j, (usize::from(at_limit), phase));
            }
        }
    }

    /// Shuts or opens each stop with a spring, as the present displacements demand. A stop without a spring is shut if its
    /// nodes touch at rest.
    pub(super) fn set_stops(&mut self) {
        if !self.model.has_stops() {
            return;
        }
        let (x, v) = self.nodes();
        let zero = S::constant(0.0);
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let Some(stop) = contact.stop else {
                continue;
            };
            let place = contact.across(x.as_ref());
            let depth = stop.side * place - stop.gap;
            let closing = stop.side * contact.across(v.as_ref());
            let (is_shut, force) = match contact.stiffness {
                Some(stiffness) => (
                    depth > zero || (depth.is_zero() && closing > zero),
                    spring_force(&stop, stiffness, place),
                ),
                None => (depth >= zero && closing.is_zero(), zero),
            };
            self.state.set_phase(j, if is_shut { STUCK } else { FREE });
            set(self.state.places.as_mut(), j, place);
            set(
                self.state.forces.as_mut(),
                j,
                if is_shut { force } else { zero },
            );
        }
    }

    /// Updates what a stretch of the duration `length` has changed: the forces of stops that are shut, and the relative
    /// displacements of contacts that stick to a moving surface.
    pub(super) fn keep_parts(&mut self, length: S) {
        if !Z::HAS_PARTS {
            return;
        }
        let (x, _) = self.nodes();
        for (j, contact) in self.model.contacts().iter().enumerate() {
            if self.state.phase(j) != STUCK {
                continue;
            }
            match (contact.stop, contact.stiffness) {
                (Some(stop), Some(stiffness)) => {
                    let force = spring_force(&stop, stiffness, contact.across(x.as_ref()));
                    set(self.state.forces.as_mut(), j, force);
                }
                (None, None) if !contact.speed.is_zero() => {
                    let place = at(self.state.places.as_ref(), j) + contact.speed * length;
                    set(self.state.places.as_mut(), j, place);
                }
                _ => {}
            }
        }
    }
}
