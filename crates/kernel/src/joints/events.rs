//! Decides the phase of each contact (sticking or sliding) after an event.

use super::decide::{Decision, MAX_PATTERNS, add_contact, holds};
use super::model::Contact;
use super::run::Motion;
use super::size::{Size, at, set, sign};
use super::state::{FREE, STUCK};
use crate::Float;
use crate::errors::Halt;

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Changes the phases of the contacts at an event. For each contact that has an event, `hits` contains the sign of
    /// the force or velocity that causes the event. `place` returns the relative displacement of a contact.
    pub(super) fn change_phases(
        &mut self,
        hits: &Z::Contacts<Option<i8>>,
        place: impl Fn(&Contact<S>) -> S,
    ) -> Result<(), Halt> {
        let (_, v) = self.nodes();
        let mut arrived = self.model.size.contacts(false);
        let mut broke = self.model.size.contacts(0);
        let contacts = self.model.contacts().iter().zip(hits.as_ref()).enumerate();
        for (j, (contact, hit)) in contacts {
            let Some(side) = *hit else {
                continue;
            };
            let stuck = self.state.phase(j) == STUCK;
            if self.model.is_stop(j) {
                continue;
            }
            match (contact.stiffness, stuck) {
                (None, true) => set(broke.as_mut(), j, side),
                (None, false) => {
                    set(self.state.places.as_mut(), j, place(contact));
                    set(arrived.as_mut(), j, true);
                }
                (Some(_), true) => {
                    let force = sign::<S>(side) * contact.level.value(self.time, 0);
                    set(self.state.forces.as_mut(), j, force);
                    self.state.set_phase(j, side);
                    // The sliding velocity is proportional to the rate of the force, so that its power series has one
                    // leading zero less.
                    let zeros = self.state.zeros.as_ref().get(j).copied();
                    let (zeros, zero_side) = zeros.unwrap_or_default();
                    let left = if zero_side == side {
                        zeros.saturating_sub(1)
                    } else {
                        0
                    };
                    self.state.set_zeros(j, (left, side));
                }
                (Some(_), false) => {
                    let level = contact.level.value(self.time, 0);
                    let force = sign::<S>(self.state.phase(j)) * level;
                    set(self.state.forces.as_mut(), j, force);
                    self.state.set_phase(j, STUCK);
                    // The contact has just stopped, so that its force is at the limit, and the rate of the force is 0.
                    // If the computed velocity already has the opposite sign, the force will fall. The code then uses
                    // the sign of the computed rate, even if this rate is only a rounding error.
                    let turns = sign::<S>(side) * self.model.slip(contact, v.as_ref());
                    let rate_is_zero = turns >= contact.creep();
                    let zeros = if rate_is_zero { 2 } else { 1 };
                    let at_limit = contact.stiction == S::constant(1.0);
                    self.state
                        .set_zeros(j, (if at_limit { zeros } else { 0 }, side));
                }
            }
        }
        self.hit_stops(hits);
        self.ask(&arrived, &broke)
    }

    /// Determines the phases of all contacts (sticking or sliding) at the first instant.
    pub(super) fn begin(&mut self) -> Result<(), Halt> {
        let zero = S::constant(0.0);
        let (x, v) = self.nodes();
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let speed = self.model.slip(contact, v.as_ref());
            let phase = match contact.is_rigid() && speed != zero {
                _ if contact.is_free() => FREE,
                true if speed > zero => 1,
                true => -1,
                false => STUCK,
            };
            self.state.set_phase(j, phase);
            set(self.state.places.as_mut(), j, contact.across(x.as_ref()));
        }
        self.set_stops();
        self.decide_at_once()
    }

    /// Decides which of the sticking contacts continue to stick, at an instant without an event.
    pub(super) fn decide_at_once(&mut self) -> Result<(), Halt> {
        let size = self.model.size.clone();
        self.ask(&size.contacts(false), &size.contacts(0))
    }

    /// Decides the phases of all rigid contacts whose relative velocity is 0. These are the contacts that stick, and
    /// the contacts that have just stopped.
    fn ask(&mut self, arrived: &Z::Contacts<bool>, broke: &Z::Contacts<i8>) -> Result<(), Halt> {
        let mut asked = self.model.size.contacts(false);
        for (j, contact) in self.model.contacts().iter().enumerate() {
            let stops = self.state.phase(j) == STUCK || holds(arrived, j);
            set(asked.as_mut(), j, contact.is_rigid() && stops);
        }
        if !asked.as_ref().contains(&true) {
            self.join();
            return Ok(());
        }
        let decision = self.decision(asked, broke.clone());
        let pattern = match decision.decide_within(self.limits.patterns) {
            // Within a limit, all these contacts stick if no pattern is found. A contact that sticks does no work.
            Err(Halt::Patterns) if self.limits.patterns < MAX_PATTERNS => {
                self.model.size.contacts(STUCK)
            }
            pattern => pattern?,
        };
        let (accelerations, held) = decision.accelerations(&decision.asked, &pattern);
        let (_, v) = self.nodes();
        let mut zeros = self.model.size.contacts((0, 0));
        let contacts = self.model.contacts().iter().zip(pattern.as_ref());
        for (j, (contact, &phase)) in contacts.enumerate() {
            let rate = contact.across(accelerations.as_ref());
            let of_contact = if !contact.is_rigid() {
                self.at_limit(&decision, j, (self.model.slip(contact, v.as_ref()), rate))
            } else if !holds(&decision.asked, j) {
                (0, 0)
            } else if phase == STUCK {
                let hold = at(held.as_ref(), j);
                let most = contact.stiction * at(decision.levels.as_ref(), j);
                let at_limit = most - hold.abs() <= decision.rounding();
                let side = if hold > S::constant(0.0) { 1 } else { -1 };
                (usize::from(at_limit), side)
            } else {
                let sure = sign::<S>(phase) * rate > decision.noise(j);
                (if sure { 1 } else { 2 }, phase)
            };
            set(zeros.as_mut(), j, of_contact);
        }
        let asked = decision.asked;
        let decided = pattern.as_ref().iter().zip(zeros.as_ref()).enumerate();
        for (j, (&phase, &zeros)) in decided {
            if !holds(&asked, j) {
                if zeros.0 > 0 {
                    self.state.set_zeros(j, zeros);
                }
                continue;
            }
            let was_stuck = self.state.phase(j) == STUCK;
            if self.model.is_stop(j) && phase != STUCK {
                self.state.set_phase(j, FREE);
                self.state.set_zeros(j, (zeros.0 + 1, 1));
                continue;
            }
            self.state.set_phase(j, phase);
            if phase != STUCK || !was_stuck || zeros.0 > 0 {
                self.state.set_zeros(j, zeros);
            }
        }
        self.join();
        let (_, mut v) = self.nodes();
        self.tree.meet_moving(&self.model, v.as_mut());
        self.state.keep_speeds(v.as_ref());
        Ok(())
    }

    /// Returns the number of leading zeros of the next event of an elastic contact, and its side, if the contact sticks at
    /// its limit and a rigid contact has held its two sides together. The relative velocity `speed` and the rate of the
    /// force are then 0. If the acceleration `rate` is a rounding error, too, only the jerk shows whether the contact
    /// slips. If the limit changes with time, its slope decides.
    fn at_limit(
        &self,
        decision: &Decision<'_, S, Z>,
        contact: usize,
        (speed, rate): (S, S),
    ) -> (usize, i8) {
        let force = at(self.state.forces.as_ref(), contact);
        let level = at(decision.levels.as_ref(), contact);
        let own = self
            .model
            .contact(contact)
            .filter(|_| !self.model.is_stop(contact));
        let rests = own.is_some_and(|own| force.abs() == own.stiction * level);
        if !rests || !speed.is_zero() || self.state.phase(contact) != STUCK {
            return (0, 0);
        }
        let side = if force > S::constant(0.0) { 1 } else { -1 };
        if own.is_some_and(|own| !own.level.value(self.time, 1).is_zero()) {
            return (1, side);
        }
        let is_sure = rate.abs() > decision.noise(contact);
        (if is_sure { 2 } else { 3 }, side)
    }

    /// Returns the numbers that decide which of the contacts in `asked` stick at this instant.
    pub(super) fn decision(
        &self,
        asked: Z::Contacts<bool>,
        broke: Z::Contacts<i8>,
    ) -> Decision<'_, S, Z> {
        let model = &self.model;
        let (x, v) = self.nodes();
        let mut sizes = model.size.nodes(S::constant(0.0));
        let load = |index| model.load_value(index, self.time);
        let mut forces = model.forces(x.as_ref(), v.as_ref(), load, Some(&mut sizes));
        let mut levels = model.size.contacts(S::constant(0.0));
        let mut asked_levels = S::constant(0.0);
        let contacts = model.contacts().iter().zip(levels.as_mut());
        for (j, (contact, level)) in contacts.enumerate() {
            *level = contact.level.value(self.time, 0);
            if holds(&asked, j) {
                asked_levels = asked_levels + *level;
                continue;
            }
            let force = match self.state.phase(j) {
                FREE => S::constant(0.0),
                _ if !contact.is_rigid() => {
                    at(self.state.forces.as_ref(), j) + model.dashpot(j, v.as_ref())
                }
                phase => {
                    let velocity = model.slip(contact, v.as_ref());
                    sign::<S>(phase) * model.kinetic(contact, self.time, velocity)
                }
            };
            add_contact(contact, force, (forces.as_mut(), sizes.as_mut()));
        }
        let sizes = sizes.as_ref().iter();
        Decision {
            model,
            forces,
            size: sizes.fold(S::constant(0.0), |sum, size| sum + *size) + asked_levels,
            base: model.base.value(self.time, 2),
            levels,
            asked,
            broke,
        }
    }
}
