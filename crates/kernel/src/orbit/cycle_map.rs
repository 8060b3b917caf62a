//! Advances the motion by half a cycle or a whole cycle of the excitation, from a fixed phase of the excitation on.
//! The code calls this phase a *section*.

use super::types::MAX_STEPS;
use crate::errors::{NoOrbit, OutOfDomain};
use crate::motion::{Contact, ContactChain, ContactState, Event, Law, MotionSetting, Part, leap};
use crate::number::pairs::{pairs, pairs_mut};
use crate::number::scalar::Float;

/// Largest number of events in half a cycle. If a half cycle has more events, the search returns an error.
pub(super) const MOST_EVENTS: u32 = 4096;

/// Numbers of stops, break-aways and reversals of the contact in one or several half cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct EventPattern {
    pub stops: u32,
    pub reversals: u32,
    pub slips: u32,
}

impl EventPattern {
    fn note(&mut self, event: Event) {
        match event {
            Event::Stop => self.stops += 1,
            Event::Slip => self.slips += 1,
            Event::Reversal => self.reversals += 1,
        }
    }

    /// Divides each number of events by `parts`. Returns `None` if a division leaves a remainder.
    pub(super) fn divided(self, parts: u32) -> Option<Self> {
        let part = |count: u32| {
            let part = count.checked_div(parts)?;
            (part * parts == count).then_some(part)
        };
        Some(Self {
            stops: part(self.stops)?,
            reversals: part(self.reversals)?,
            slips: part(self.slips)?,
        })
    }

    /// Adds the numbers of events in two time intervals of a motion.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            stops: self.stops + other.stops,
            reversals: self.reversals + other.reversals,
            slips: self.slips + other.slips,
        }
    }
}

/// State of the motion at a fixed phase of the excitation (the *section*), with the data that the code needs to advance
/// this state.
pub(super) struct CycleMap<'f, 'a, S, K> {
    pub setting: &'f MotionSetting<'a, S, K>,
    pub modes: &'f mut [Part<S>],
    pub stuck_modes: &'f mut [Part<S>],
    pub contact_state: ContactState<S>,
    /// Middle of the longest segment of the last half cycle. In a segment the contact either sticks, or slides in one
    /// direction. The value is the phase at the middle minus the phase at the start of the half cycle, in half-turns
    /// (π rad).
    pub middle: S,
    /// Total time during which the contact stuck in the last half cycle, in rad of the excitation (τ).
    pub stuck: S,
    /// Number of steps that the searches for events may still take.
    pub step_budget: u32,
    /// True if the contact has slid since the caller last set this flag to false.
    pub slid: bool,
}

impl<'f, 'a, S: Float, K: ContactChain<S>> CycleMap<'f, 'a, S, K> {
    /// Creates the cycle map from its oscillators and the state of the contact. The oscillators are the modes of the
    /// chain, and the modes of the chain with its contact stuck. The searches for events may take [`MAX_STEPS`] steps.
    pub(super) fn new(
        setting: &'f MotionSetting<'a, S, K>,
        (modes, stuck_modes): (&'f mut [Part<S>], &'f mut [Part<S>]),
        contact_state: ContactState<S>,
    ) -> Self {
        let zero = S::constant(0.0);
        Self {
            setting,
            modes,
            stuck_modes,
            contact_state,
            middle: zero,
            stuck: zero,
            step_budget: MAX_STEPS,
            slid: false,
        }
    }

    /// Returns the number of scalars in a state of the motion.
    pub(super) fn size(&self) -> usize {
        self.setting.dynamics.state_size()
    }

    /// Returns the number of scalars that the contact stores, such as its force. In a state vector these scalars come
    /// after the modes.
    pub(super) fn remembered(&self) -> usize {
        self.setting.dynamics.chain.remembered()
    }

    /// Returns the present contact force, which the state vector of an elastic contact contains. While the contact
    /// slides, this force is the kinetic friction force. For a stuck contact that stores no force, the result is 0.
    pub(super) fn remembered_force(&self) -> S {
        let contact = self.contact_state.contact;
        if contact == Contact::Stuck {
            self.contact_state.memory.unwrap_or(S::constant(0.0))
        } else {
            self.setting.law().kinetic(contact)
        }
    }

    /// Returns the index of the stored contact force in a state vector. Returns `None` if the contact stores no force,
    /// or if the vector contains only the modes.
    pub(super) fn force_in(&self, state: &[S]) -> Option<usize> {
        let place = 2 * self.setting.dynamics.in_contact();
        (0 < self.remembered() && state.len() == self.size()).then_some(place)
    }

    /// Returns the present contact force minus the contact force in the state vector `state`. The result is 0 if the
    /// contact stores no force.
    fn force_difference(&self, state: &[S]) -> S {
        let there = self.force_in(state).and_then(|place| state.get(place));
        there.map_or(S::constant(0.0), |there| self.remembered_force() - *there)
    }

    /// Subtracts the search steps of one segment from the number of steps that the searches may still take. Returns an
    /// error if no steps are left.
    pub(super) fn spend(&mut self, steps: u32) -> Result<(), NoOrbit> {
        self.step_budget = self
            .step_budget
            .checked_sub(steps)
            .ok_or(NoOrbit::Unsettled)?;
        Ok(())
    }

    /// Advances the motion by half a cycle of the excitation. `columns` contains small deviations from the motion. The
    /// function advances them by the same time with the linearised motion.
    pub(super) fn advance_half(
        &mut self,
        columns: Option<&mut [S]>,
    ) -> Result<EventPattern, NoOrbit> {
        let start = self.contact_state.t;
        let pattern = self.advance(S::pi(), columns)?;
        // The phase advances by exactly half a cycle. A sum of the segments' lengths would have rounding errors.
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let t = start + one;
        self.contact_state.t = if t < two { t } else { t - two };
        Ok(pattern)
    }

    /// Advances the motion by a time τ (in rad of the excitation), from event to event.
    pub(super) fn advance(
        &mut self,
        tau: S,
        mut columns: Option<&mut [S]>,
    ) -> Result<EventPattern, NoOrbit> {
        let zero = S::constant(0.0);
        let mut pattern = EventPattern::default();
        let (mut left, mut longest) = (tau, zero);
        self.stuck = zero;
        for _ in 0..MOST_EVENTS {
            let contact_state = self.contact_state;
            let end = leap(
                self.setting,
                self.modes,
                self.stuck_modes,
                contact_state,
                left,
            );
            if longest < end.tau {
                longest = end.tau;
                self.middle = (tau - left + end.tau * S::constant(0.5)) * S::inverse_pi();
            }
            if let Some(columns) = &mut columns {
                K::carry_deviations(
                    self.setting,
                    (&*self.modes, &mut *self.stuck_modes),
                    &contact_state,
                    &end,
                    columns,
                );
            }
            if contact_state.contact == Contact::Stuck {
                self.stuck = self.stuck + end.tau;
            }
            self.slid |= contact_state.contact != Contact::Stuck || end.event.is_some();
            self.contact_state = end.contact_state;
            self.spend(end.steps)?;
            left = left - end.tau;
            match end.event {
                Some(event) => pattern.note(event),
                None if !(zero < left) => return Ok(pattern),
                None => {}
            }
            if !(zero < left) {
                return Ok(pattern);
            }
        }
        Err(NoOrbit::TooManyEvents)
    }

    /// Copies the state of the oscillators, and the contact force if the contact stores it, into the state vector
    /// `state`.
    pub(super) fn save(&self, state: &mut [S]) {
        for (part, state) in self.modes.iter().zip(pairs_mut(state)) {
            if let [y, u] = state {
                (*y, *u) = (part.y, part.u);
            }
        }
        if let Some(force) = self.force_in(state).and_then(|place| state.get_mut(place)) {
            *force = self.remembered_force();
        }
    }

    /// Sets the oscillators from a state vector. If `contact_state` is stuck, the contact sticks. If `contact_state`
    /// slides, the code determines the new contact state from the velocities in the state vector.
    pub(super) fn restore(&mut self, state: &[S], contact_state: &ContactState<S>) {
        for (part, state) in self.modes.iter_mut().zip(pairs(state)) {
            if let [y, u] = state {
                (part.y, part.u) = (*y, *u);
            }
        }
        self.contact_state = *contact_state;
        self.contact_state.memory = None;
        if contact_state.contact != Contact::Stuck {
            self.contact_state = K::sliding_state(self.setting, self.modes, contact_state);
        } else if let Some(force) = self.force_in(state).and_then(|place| state.get(place)) {
            self.contact_state.memory = Some(*force);
        }
    }

    /// Stores the present state times `sign` minus the former `state` in `state`. Sets the oscillators to the former
    /// `state`, and returns the contact force in the former `state`.
    pub(super) fn subtract(&mut self, state: &mut [S], sign: S) -> S {
        for (part, state) in self.modes.iter_mut().zip(pairs_mut(state)) {
            if let [y, u] = state {
                let difference = [sign * part.y - *y, sign * part.u - *u];
                (part.y, part.u) = (*y, *u);
                [*y, *u] = difference;
            }
        }
        let Some(force) = self.force_in(state).and_then(|place| state.get_mut(place)) else {
            return S::constant(0.0);
        };
        let start = *force;
        *force = sign * self.remembered_force() - start;
        start
    }

    /// Adds the present state of the oscillators and the contact force `force` to `step`. Returns the largest absolute
    /// value in `step` before this addition.
    pub(super) fn add(&self, step: &mut [S], force: S) -> S {
        let mut largest = S::constant(0.0);
        for (part, state) in self.modes.iter().zip(pairs_mut(step)) {
            if let [y, u] = state {
                largest = largest.max(y.abs()).max(u.abs());
                (*y, *u) = (part.y + *y, part.u + *u);
            }
        }
        if let Some(own) = self.force_in(step).and_then(|place| step.get_mut(place)) {
            largest = largest.max(own.abs());
            *own = force + *own;
        }
        largest
    }

    /// Returns the distance between the present state and `state`: the largest absolute difference of two
    /// corresponding numbers.
    pub(super) fn distance(&self, state: &[S]) -> S {
        let states = self.modes.iter().zip(pairs(state));
        let force = self.force_difference(state).abs();
        states.fold(force, |most, (part, state)| match state {
            [y, u] => most.max((part.y - *y).abs()).max((part.u - *u).abs()),
            _ => most,
        })
    }

    /// Returns twice the energy of the difference between the present state and `state`.
    pub(super) fn energy_between(&self, state: &[S]) -> S {
        let modes = self.modes.iter().zip(self.setting.dynamics.driven());
        let states = modes.zip(pairs(state));
        let compliance = self.setting.dynamics.chain.compliance();
        let force = self.force_difference(state);
        states.fold(
            compliance * force * force,
            |sum, ((part, mode), state)| match state {
                [y, u] => {
                    let (y, u) = (part.y - *y, part.u - *u);
                    sum + mode.resonance * mode.resonance * (y * y + u * u)
                }
                _ => sum,
            },
        )
    }

    /// Returns an error if the state contains an infinite number or NaN.
    pub(super) fn check_finite(&self) -> Result<(), NoOrbit> {
        let driven = self.setting.dynamics.in_contact();
        let mut parts = self.modes.iter().take(driven);
        if parts.all(|part| part.y.is_finite() && part.u.is_finite()) {
            Ok(())
        } else {
            Err(OutOfDomain::Start.into())
        }
    }

    /// Returns the size of the present state: the largest absolute displacement or scaled velocity of the modes that
    /// the contact drives.
    pub(super) fn scale(&self) -> S {
        let driven = self.setting.dynamics.in_contact();
        self.modes
            .iter()
            .take(driven)
            .fold(S::constant(0.0), |most, part| {
                most.max(part.y.abs()).max(part.u.abs())
            })
    }
}

/// Sets `columns` to the unit matrix. Each column is then a unit deviation of one number of the state.
pub(super) fn unit<S: Float>(columns: &mut [S], size: usize) {
    for (index, entry) in columns.iter_mut().enumerate() {
        let own = index.checked_rem(size + 1) == Some(0);
        *entry = S::constant(if own { 1.0 } else { 0.0 });
    }
}
