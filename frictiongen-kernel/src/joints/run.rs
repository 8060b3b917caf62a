//! A run: from event to event.

mod changes;

use super::events::next_events;
use super::room::{Phase, Room};
use super::stretch::{Stretch, expand, holds, load, mobility};
use super::tied::tie;
use super::{Chain, Drive, JointState, MAX_JOINTS, Series, TERMS, term, value};
use crate::number::scalar::Float;

/// Largest number of events without progress of time. More show that no pattern goes on.
pub const MAX_EVENTS_AT_ONCE: usize = 4 * MAX_JOINTS + 8;
/// Roundings of a stretch within which two events are one.
const ROUNDINGS: f64 = 256.0;

/// Why a run does not start or does not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// The chain has more contacts than [`MAX_JOINTS`], or the room is for another number of contacts.
    TooManyJoints,
    /// Rigid contacts form a loop, so that their holding forces are not determined.
    Redundant,
    /// No pattern of stuck contacts fits, or a decision reached [`MAX_PATTERNS`](super::MAX_PATTERNS).
    Undecided,
    /// [`MAX_EVENTS_AT_ONCE`] events at one instant.
    Cycling,
    /// A number became infinite, or NaN.
    NotFinite,
}

/// A part of a run, at most one stretch.
#[derive(Clone, Copy, Debug)]
pub struct Step<T> {
    /// Start.
    pub from: T,
    /// End.
    pub to: T,
    /// The end in units of the series' stretch: 1 where the stretch ended without event.
    pub part: T,
    /// Length of the series' stretch.
    pub span: T,
    /// True if at least one contact has an event at the end.
    pub event: bool,
}

/// Motion in time of a chain with several joints.
pub struct Run<'a, T, D> {
    chain: Chain<'a, T>,
    drive: D,
    room: Room<'a, T>,
    stretch: Stretch<T>,
    time: T,
    rate: T,
    at_once: usize,
    bends: bool,
    event: Option<T>,
}

impl<'a, T: Float, D: Drive<T>> Run<'a, T, D> {
    /// Starts a run at the instant `time`, with positions and velocities of the masses.  Elastic contacts start with the
    /// forces of the states in `room`, which are 0 unless the caller sets them.
    ///
    /// # Errors
    ///
    /// [`Trouble::TooManyJoints`], [`Trouble::Redundant`] or [`Trouble::Undecided`].
    pub fn start(
        chain: Chain<'a, T>,
        drive: D,
        room: Room<'a, T>,
        time: T,
        (x, v): (&[T], &[T]),
    ) -> Result<Self, Trouble> {
        let zero = T::constant(0.0);
        if chain.joints.len() > MAX_JOINTS || chain.joints.len() != room.joints.len() {
            return Err(Trouble::TooManyJoints);
        }
        if chain.is_redundant() {
            return Err(Trouble::Redundant);
        }
        for (mass, place) in room.x.iter_mut().enumerate() {
            *place = term(x, mass);
        }
        for (mass, place) in room.v.iter_mut().enumerate() {
            *place = term(v, mass);
        }
        for state in room.joints.iter_mut() {
            state.phase = Phase::Free;
        }
        let rate = chain.rate().max(drive.rate());
        let stretch = Stretch {
            span: zero,
            base: [zero; TERMS],
            mobility: mobility(&chain),
        };
        let mut run = Self {
            chain,
            drive,
            room,
            stretch,
            time,
            rate,
            at_once: 0,
            bends: false,
            event: None,
        };
        run.begin()?;
        Ok(run)
    }

    /// Returns the present instant.
    pub fn time(&self) -> T {
        self.time
    }
    /// Returns the displacement of each mass.
    pub fn displacements(&self) -> &[T] {
        self.room.x
    }
    /// Returns the velocity of each mass.
    pub fn velocities(&self) -> &[T] {
        self.room.v
    }
    /// Returns the state of each contact.
    pub fn joints(&self) -> &[JointState<T>] {
        self.room.joints
    }
    /// Returns the series of the last step: displacements, velocities and the contacts' forces.
    pub fn series(&self) -> [&[Series<T>]; 3] {
        [
            self.room.displacements,
            self.room.velocities,
            self.room.forces,
        ]
    }
    /// Returns the series of the base's displacement in the last step.
    pub fn base(&self) -> &Series<T> {
        &self.stretch.base
    }

    /// Returns the length of the next stretch, at most `most`.
    fn span(&self, most: T) -> T {
        if most * self.rate < T::constant(1.0) {
            most
        } else {
            T::constant(1.0) / self.rate
        }
    }

    /// Moves on by one stretch, to the next event or to `until`, whichever comes first.  The event itself happens in
    /// [`pass`](Self::pass), which this function calls if the caller has not.  In between the caller may read the series.
    ///
    /// # Errors
    ///
    /// [`Trouble::Undecided`], [`Trouble::Cycling`] or [`Trouble::NotFinite`].
    pub fn step(&mut self, until: T) -> Result<Step<T>, Trouble> {
        self.pass()?;
        let from = self.time;
        let bend = self.drive.bend_after(from).filter(|bend| *bend <= until);
        let end = bend.unwrap_or(until);
        let span = self.span(end - from);
        load(&mut self.room, &mut self.stretch, &self.drive, (from, span));
        if !expand(&self.chain, &mut self.room, &self.stretch) {
            return Err(Trouble::Redundant);
        }
        let roundings = self.roundings();
        self.event = next_events(&self.chain, &mut self.room, &self.stretch, roundings);
        let part = self.event.unwrap_or(T::constant(1.0));
        self.at_once = if part <= self.tolerance() {
            self.at_once + 1
        } else {
            0
        };
        if self.at_once > MAX_EVENTS_AT_ONCE {
            return Err(Trouble::Cycling);
        }
        let reached = self.event.is_none() && end - from <= span;
        self.time = if reached { end } else { from + part * span };
        self.bends = reached && bend.is_some();
        self.arrive(part)?;
        Ok(Step {
            from,
            to: self.time,
            part,
            span,
            event: self.event.is_some(),
        })
    }

    /// Lets the event happen to which the last step moved.  Returns true if a contact changed what it does.
    ///
    /// # Errors
    ///
    /// [`Trouble::Undecided`].
    pub fn pass(&mut self) -> Result<bool, Trouble> {
        let mut before = [Phase::Free; MAX_JOINTS];
        for (before, state) in before.iter_mut().zip(self.room.joints.iter()) {
            *before = state.phase;
        }
        if let Some(at) = self.event.take() {
            self.happen(at)?;
        }
        if core::mem::take(&mut self.bends) {
            self.begin()?;
        }
        let mut after = self.room.joints.iter().zip(before);
        Ok(after.any(|(state, before)| state.phase != before))
    }

    /// Returns the rounding errors of a velocity and of an acceleration at the start of a stretch.  Spring forces cancel
    /// in an acceleration, so its error is that of the largest.
    fn roundings(&self) -> (T, T) {
        let zero = T::constant(0.0);
        let largest = |numbers: &[T]| numbers.iter().fold(zero, |most, x| most.max(x.abs()));
        let (x, v) = (largest(self.room.x), largest(self.room.v));
        let loads = self.room.loads.iter().zip(self.chain.masses);
        let load = loads.fold(zero, |most, (load, mass)| {
            most.max((term(load, 0) / *mass).abs())
        });
        let base = term(&self.stretch.base, 0).abs();
        let x = x + base;
        let v = v + self.stretch.base_velocity(0).abs();
        let one = T::constant(16.0 * T::EPSILON);
        (one * v, one * (self.rate * (self.rate * x + v) + load))
    }

    /// Returns the part of a stretch within which two events are one.
    fn tolerance(&self) -> T {
        T::constant(ROUNDINGS * T::EPSILON)
    }

    /// Moves state, forces and tied masses to the end of a step.
    fn arrive(&mut self, part: T) -> Result<(), Trouble> {
        let finite = |x: &T| x.is_finite();
        for (x, series) in self.room.x.iter_mut().zip(self.room.displacements.iter()) {
            *x = value(series, part);
        }
        for (v, series) in self.room.v.iter_mut().zip(self.room.velocities.iter()) {
            *v = value(series, part);
        }
        if !self.room.x.iter().all(finite) || !self.room.v.iter().all(finite) {
            return Err(Trouble::NotFinite);
        }
        let mut held = [false; MAX_JOINTS];
        let states = self.room.joints.iter_mut().zip(self.room.forces.iter());
        for ((held, joint), (state, force)) in held.iter_mut().zip(self.chain.joints).zip(states) {
            state.force = value(force, part);
            *held = holds(joint.stiffness.is_none(), state);
            if T::constant(ROUNDINGS * T::EPSILON) < part {
                state.fresh = false;
            }
        }
        // The base at the end, from its series.
        let slope = self.stretch.base.iter().enumerate().skip(1).rev();
        let slope = slope.fold(T::constant(0.0), |sum, (n, &c)| {
            sum * part + c * super::whole(n)
        });
        let base = (value(&self.stretch.base, part), slope / self.stretch.span);
        tie(&self.chain, &mut self.room, &held, base);
        Ok(())
    }
}
