//! What the contacts do at a start and at an event.

use super::{Run, Trouble};
use crate::joints::patterns::{Candidate, Resting, decide};
use crate::joints::room::{Kind, Phase};
use crate::joints::stretch::{accelerate, holds, load};
use crate::joints::tied::tie;
use crate::joints::{Drive, MAX_JOINTS, term};
use crate::number::scalar::Float;

impl<T: Float, D: Drive<T>> Run<'_, T, D> {
    /// Lets each contact begin anew at the present instant, where a level or a load jumps.
    pub(super) fn begin(&mut self) -> Result<(), Trouble> {
        let span = self.span(T::constant(1.0));
        load(
            &mut self.room,
            &mut self.stretch,
            &self.drive,
            (self.time, span),
        );
        let mut asked = [None; MAX_JOINTS];
        for (index, asked) in asked.iter_mut().enumerate().take(self.chain.joints.len()) {
            *asked = self.begun(index);
        }
        self.settle(&asked)
    }

    /// Lets one contact begin.  Returns `Some` if a pattern has to say what a rigid contact does.
    fn begun(&mut self, index: usize) -> Option<Phase> {
        let zero = T::constant(0.0);
        let velocity = self.relative_velocity(index);
        let place = self.relative_displacement(index);
        let joint = self.chain.joints.get(index)?;
        let level = self.room.levels.get(index)?;
        let slope = term(level, 1) / self.stretch.span;
        let level = term(level, 0);
        let state = self.room.joints.get_mut(index)?;
        state.fresh = true;
        if level <= zero {
            state.phase = Phase::Free;
            state.force = zero;
            return None;
        }
        let Some(stiffness) = joint.stiffness else {
            if state.phase == Phase::Stuck {
                return Some(Phase::Stuck);
            }
            if state.phase != Phase::Free && !velocity.is_zero() {
                return None;
            }
            state.place = place;
            state.phase = Phase::along(velocity);
            return velocity.is_zero().then_some(Phase::Stuck);
        };
        let direction = Phase::along(state.force);
        let limit = match state.phase {
            Phase::Positive | Phase::Negative => level,
            Phase::Free | Phase::Stuck => level * joint.stiction,
        };
        if limit <= state.force.abs() {
            state.force = direction.signed(level);
            let slides = zero < direction.signed(velocity) - slope / stiffness;
            state.phase = if slides { direction } else { Phase::Stuck };
        } else {
            state.phase = Phase::Stuck;
        }
        None
    }

    fn relative_velocity(&self, index: usize) -> T {
        let Some(joint) = self.chain.joints.get(index) else {
            return T::constant(0.0);
        };
        joint.link.difference(self.room.v) - joint.link.base * self.stretch.base_velocity(0)
    }
    fn relative_displacement(&self, index: usize) -> T {
        let Some(joint) = self.chain.joints.get(index) else {
            return T::constant(0.0);
        };
        joint.link.difference(self.room.x) - joint.link.base * term(&self.stretch.base, 0)
    }

    /// Decides what the rigid contacts of `asked` do, together with all that stick.  `asked` has the direction of a
    /// contact that broke away.
    fn settle(&mut self, asked: &[Option<Phase>; MAX_JOINTS]) -> Result<(), Trouble> {
        let mut unknown = [false; MAX_JOINTS];
        let contacts = self.chain.joints.iter().zip(self.room.joints.iter());
        for ((unknown, asked), (joint, state)) in unknown.iter_mut().zip(asked).zip(contacts) {
            *unknown = asked.is_some() || holds(joint.stiffness.is_none(), state);
        }
        if !unknown.contains(&true) {
            return Ok(());
        }
        let base = (term(&self.stretch.base, 0), self.stretch.base_velocity(0));
        tie(&self.chain, &mut self.room, &unknown, base);
        self.refresh();
        accelerate(&self.chain, &mut self.room, &self.stretch, &unknown, 0);
        let nothing = Candidate {
            acceleration: T::constant(0.0),
            rounding: T::constant(0.0),
            level: T::constant(0.0),
            stiction: T::constant(1.0),
            gone: Phase::Stuck,
        };
        let (mut candidates, mut indices) = ([nothing; MAX_JOINTS], [0; MAX_JOINTS]);
        let mut count = 0;
        let rounding = self.roundings().1;
        let base = self.stretch.base_acceleration(0);
        let contacts = self.chain.joints.iter().zip(self.room.levels.iter());
        for (index, (joint, level)) in contacts.enumerate() {
            if !unknown.get(index).copied().unwrap_or(false) {
                continue;
            }
            let free = joint.link.difference(self.room.acceleration);
            if let (Some(candidate), Some(place)) =
                (candidates.get_mut(count), indices.get_mut(count))
            {
                *candidate = Candidate {
                    acceleration: free - joint.link.base * base,
                    rounding,
                    level: term(level, 0),
                    stiction: joint.stiction,
                    gone: asked.get(index).copied().flatten().unwrap_or(Phase::Stuck),
                };
                *place = index;
                count += 1;
            }
        }
        let mut chosen = [[T::constant(0.0); MAX_JOINTS]; MAX_JOINTS];
        for (row, &i) in chosen.iter_mut().zip(&indices).take(count) {
            for (entry, &j) in row.iter_mut().zip(&indices).take(count) {
                *entry = self
                    .stretch
                    .mobility
                    .get(i)
                    .map_or(T::constant(0.0), |row| term(row, j));
            }
        }
        let rest = Resting {
            phase: Phase::Stuck,
            force: T::constant(0.0),
        };
        let mut answers = [rest; MAX_JOINTS];
        let candidates = candidates.get(..count).unwrap_or_default();
        decide(candidates, &chosen, &mut answers).ok_or(Trouble::Undecided)?;
        for (&index, answer) in indices.iter().zip(answers).take(count) {
            if let Some(state) = self.room.joints.get_mut(index) {
                state.fresh |=
                    state.phase != answer.phase || asked.get(index).is_some_and(Option::is_some);
                state.phase = answer.phase;
                state.force = answer.force;
            }
        }
        Ok(())
    }

    /// Writes positions and velocities into the first coefficients of the series.
    fn refresh(&mut self) {
        let starts = self.room.displacements.iter_mut().zip(self.room.x.iter());
        for (series, x) in starts.chain(self.room.velocities.iter_mut().zip(self.room.v.iter())) {
            if let Some(first) = series.first_mut() {
                *first = *x;
            }
        }
    }

    /// Lets the events at `at` happen.
    pub(super) fn happen(&mut self, at: T) -> Result<(), Trouble> {
        let (span, tolerance) = (self.stretch.span, self.tolerance());
        load(
            &mut self.room,
            &mut self.stretch,
            &self.drive,
            (self.time, span),
        );
        let mut asked = [None; MAX_JOINTS];
        for (index, asked) in asked.iter_mut().enumerate().take(self.chain.joints.len()) {
            let found = self.room.joints.get(index).and_then(|state| state.next);
            *asked = match found.filter(|found| found.at <= at + tolerance) {
                Some(found) => self.changed(index, found.kind),
                None => self.just_gone(index, at <= tolerance),
            };
        }
        self.settle(&asked)
    }

    /// Returns the direction of a rigid contact that went at this very instant.
    fn just_gone(&self, index: usize, no_progress: bool) -> Option<Phase> {
        let (joint, state) = (self.chain.joints.get(index)?, self.room.joints.get(index)?);
        let slides = state.phase != Phase::Stuck && state.phase != Phase::Free;
        (no_progress && state.fresh && slides && joint.stiffness.is_none()).then_some(state.phase)
    }

    /// Changes a contact at its event.  Returns `Some` if a pattern has to say what a rigid contact does.
    fn changed(&mut self, index: usize, kind: Kind) -> Option<Phase> {
        let place = self.relative_displacement(index);
        let joint = self.chain.joints.get(index)?;
        let level = term(self.room.levels.get(index)?, 0);
        let state = self.room.joints.get_mut(index)?;
        state.fresh = true;
        match (kind, joint.stiffness) {
            (Kind::Opens, _) => {
                state.phase = Phase::Free;
                state.force = T::constant(0.0);
                None
            }
            (Kind::Closes, None) => {
                state.place = place;
                let velocity = self.relative_velocity(index);
                let state = self.room.joints.get_mut(index)?;
                state.phase = Phase::along(velocity);
                velocity.is_zero().then_some(Phase::Stuck)
            }
            (Kind::Closes, Some(_)) => {
                state.phase = Phase::Stuck;
                None
            }
            (Kind::Breaks(direction), Some(_)) => {
                state.phase = direction;
                state.force = direction.signed(level);
                None
            }
            (Kind::Breaks(direction), None) => Some(direction),
            (Kind::Stops, Some(_)) => {
                state.force = state.phase.signed(level);
                state.phase = Phase::Stuck;
                None
            }
            (Kind::Stops, None) => {
                state.place = place;
                Some(Phase::Stuck)
            }
        }
    }
}
