//! Advances a stepper by one step.

mod span;

pub use span::Span;

use super::coast::{LIMITS, pieces};
use super::work::Sums;
use super::{Sample, Stepper};
use crate::Float;
use crate::errors::{Given, Halt, OutOfDomain};
use crate::joints::base::Curve;
use crate::joints::model::Model;
use crate::joints::run::{Bounds, Limits, Motion, Observe};
use crate::joints::series::Series;
use crate::joints::size::{Size, add, at};
use crate::joints::state::State;
use crate::joints::wave::Wave;
use crate::stepper::Input;

/// Largest number of events that the stepper follows in one sub-interval of a step without an event budget.
pub const MAX_STEP_EVENTS: usize = 64;

/// Result of one step of a stepper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stepped {
    /// Number of events in the step: instants at which a contact starts to stick, starts to slide, or reverses.
    pub events: u32,
    /// True if the stepper has reached its bound on events.
    pub exceeded: bool,
}

/// Observer of a step: counts its events, notes the instant of the last one, and adds up work.
struct Noted<'w, S, W> {
    events: u32,
    last: Option<S>,
    work: Sums<S>,
    watch: &'w mut W,
}

impl<S: Float, Z: Size, W: Observe<S, Z>> Observe<S, Z> for Noted<'_, S, W> {
    fn stretch(&mut self, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.watch.stretch(series, end, state);
    }

    fn follow(&mut self, model: &Model<S, Z>, series: &Series<S, Z>, end: S, state: &State<S, Z>) {
        self.work.follow(model, series, end, state);
    }

    fn event(&mut self, time: S, before: &Z::Contacts<i8>, after: &Z::Contacts<i8>) {
        self.events += 1;
        self.last = Some(time);
        self.watch.event(time, before, after);
    }
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Sets the input at the start of the first step. Without this call the input at this instant is 0. With linear
    /// input, the first step starts from `sample`.
    ///
    /// # Errors
    ///
    /// Same errors as [`advance`](Self::advance), and [`OutOfDomain::Begun`] after the first step.
    pub fn begin(&mut self, sample: Sample<'_, S>) -> Result<(), OutOfDomain> {
        self.check(&sample)?;
        if self.status.steps != 0 {
            return Err(OutOfDomain::Begun);
        }
        self.attempt(|stepper| {
            stepper.hold(&sample)?;
            stepper.keep(&sample);
            stepper.restart_work();
            Ok(())
        })
    }

    /// Advances the motion by one step. With linear input, the input reaches `sample` at the end of the step: forces
    /// and friction forces change linearly, and the base follows a cubic polynomial. With zero-order hold, forces and
    /// friction forces are constant during the step, and the base starts at the displacement and moves with the
    /// velocity of `sample`.
    ///
    /// # Errors
    ///
    /// The stepper keeps its state after an error.
    ///
    /// - [`OutOfDomain::Force`], [`OutOfDomain::BaseMotion`] and [`OutOfDomain::Friction`] for numbers that are not
    ///   finite, and for a negative friction force.
    /// - [`OutOfDomain::Forces`] for a wrong number of forces or friction forces.
    /// - [`OutOfDomain::BaseAtRest`] for a motion of the base in a scene whose base does not move.
    /// - [`OutOfDomain::Motion`] if the motion exceeds the range of the number type.
    pub fn advance(&mut self, sample: Sample<'_, S>) -> Result<Stepped, OutOfDomain> {
        self.advance_with(sample, &mut ())
    }

    /// Advances the motion by one step, as [`advance`](Self::advance) does, and passes each stretch and each event to
    /// `watch`. A stretch is the time interval of one power series. If the observer needs the series, the stepper does
    /// not use its tables.
    ///
    /// # Errors
    ///
    /// Same errors as [`advance`](Self::advance). After an error `watch` may have received the first stretches of the
    /// step.
    pub fn advance_with<W: Observe<S, Z>>(
        &mut self,
        sample: Sample<'_, S>,
        watch: &mut W,
    ) -> Result<Stepped, OutOfDomain> {
        self.check(&sample)?;
        self.take_step(watch, |stepper, noted| {
            match stepper.pace.input {
                Input::Hold => stepper.hold(&sample)?,
                Input::Linear => stepper.lead(&sample)?,
            }
            let mut exceeded = false;
            for part in 0..stepper.pace.parts {
                if W::NEEDS_SERIES || !stepper.leap(part) {
                    exceeded |= stepper.follow(part, noted)?;
                }
            }
            stepper.keep(&sample);
            Ok(exceeded)
        })
    }

    /// Takes a step and counts it. `advance` advances the motion, and returns true if the stepper has reached its bound on
    /// events.
    fn take_step<W: Observe<S, Z>>(
        &mut self,
        watch: &mut W,
        advance: impl FnOnce(&mut Self, &mut Noted<'_, S, W>) -> Result<bool, Halt>,
    ) -> Result<Stepped, OutOfDomain> {
        let mut noted = Noted {
            events: 0,
            last: None,
            work: self.status.work,
            watch,
        };
        self.motion.limits = match self.status.budget {
            0 => Limits::NONE,
            _ => LIMITS,
        };
        let exceeded = self.attempt(|stepper| {
            let exceeded = advance(stepper, &mut noted)?;
            stepper.recentre();
            Ok(exceeded)
        })?;
        let status = &mut self.status;
        status.last_event = noted.last;
        status.steps = status.steps.wrapping_add(1);
        status.exceeded += u64::from(exceeded);
        Ok(Stepped {
            events: noted.events,
            exceeded,
        })
    }

    /// Changes the velocity of the base at the present instant. With linear input, the next step starts at this
    /// velocity. The displacement of the base and the motion of the masses do not jump.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::BaseMotion`] if the velocity is not finite, and [`OutOfDomain::BaseAtRest`] if the base of the
    /// scene does not move. The stepper is then unchanged.
    pub fn set_base_velocity(&mut self, velocity: S) -> Result<(), OutOfDomain> {
        let [place, before] = self.status.base;
        if !self.pace.on_base {
            return Err(OutOfDomain::BaseAtRest);
        }
        check_base([place, velocity])?;
        if velocity == before {
            return Ok(());
        }
        self.attempt(|stepper| {
            stepper.motion.rewind();
            stepper
                .motion
                .jolt_base(Curve::straight([place, velocity]))?;
            stepper.status.base = [place, velocity];
            Ok(())
        })
    }

    /// Runs `change`. If it fails, the motion returns to its state before the call.
    fn attempt<R>(
        &mut self,
        change: impl FnOnce(&mut Self) -> Result<R, Halt>,
    ) -> Result<R, OutOfDomain> {
        let (state, status) = (self.motion.state().clone(), self.status.clone());
        change(self).map_err(|halt| {
            self.status = status;
            self.resume(state);
            OutOfDomain::Motion(halt)
        })
    }

    /// Sets the motion to a state at the end of a step, under the inputs in `status`.
    pub(super) fn resume(&mut self, state: State<S, Z>) {
        let status = &self.status;
        self.motion.resume(state, |model| {
            model.base = Curve::straight(status.base);
            model.base.square = S::constant(0.5) * status.lift;
            let (inputs, _) = model.inputs();
            let forces = status.forces.as_ref().iter().take(inputs);
            for ((_, load), force) in model.loads.as_mut().iter_mut().zip(forces) {
                *load = Wave::constant(*force);
            }
            let levels = model
                .contacts
                .as_mut()
                .iter_mut()
                .zip(status.levels.as_ref());
            for (contact, level) in levels {
                contact.level = Wave::constant(*level);
            }
        });
    }

    /// Returns an error if a number of the input is outside its range.
    fn check(&self, sample: &Sample<'_, S>) -> Result<(), OutOfDomain> {
        if (sample.forces.len(), sample.frictions.len()) != self.motion.model().inputs() {
            return Err(OutOfDomain::Forces);
        }
        check_base(sample.base)?;
        if !self.pace.on_base && sample.base.iter().any(|number| !number.is_zero()) {
            return Err(OutOfDomain::BaseAtRest);
        }
        if let Some(force) = sample.forces.iter().find(|force| !force.is_finite()) {
            return Err(OutOfDomain::Force(Given::of(*force)));
        }
        let fits = |friction: &&S| **friction >= S::constant(0.0) && friction.is_finite();
        let mut frictions = sample.frictions.iter();
        match frictions.find(|friction| !fits(friction)) {
            Some(friction) => Err(OutOfDomain::Friction(Given::of(*friction))),
            None => Ok(()),
        }
    }

    /// Stores the input at the end of a step.
    fn keep(&mut self, sample: &Sample<'_, S>) {
        let status = &mut self.status;
        status.base = sample.base;
        status.lift = self.motion.model().base.value(self.motion.time(), 2);
        let forces = status.forces.as_mut().iter_mut().zip(sample.forces);
        let levels = status.levels.as_mut().iter_mut().zip(sample.frictions);
        for (own, value) in forces.chain(levels) {
            *own = *value;
        }
    }

    /// Sets the inputs of a step to the constant values of `sample`. The base jumps to its displacement, and then moves
    /// with its velocity.
    pub(super) fn hold(&mut self, sample: &Sample<'_, S>) -> Result<(), Halt> {
        if self.pace.on_base {
            self.motion.rewind();
            self.jolt(Curve::straight(sample.base))?;
        }
        self.motion.time = S::constant(0.0);
        self.set_loads(sample.forces, |_, force| Wave::constant(force));
        let (motion, status) = (&mut self.motion, &self.status);
        let mut forces = status.forces.as_ref().iter().zip(sample.forces);
        if forces.any(|(before, after)| before != after) {
            motion.accelerations_jump();
        }
        let levels = status.levels.as_ref().iter().zip(sample.frictions);
        for (contact, (before, friction)) in levels.enumerate() {
            if before != friction {
                motion.lead_level(contact, Wave::constant(*friction), true)?;
            }
        }
        Ok(())
    }

    /// Sets each load to the function that `wave` returns for the force of the last sample and that in `forces`.
    fn set_loads(&mut self, forces: &[S], wave: impl Fn(S, S) -> Wave<S>) {
        let loads = self.motion.model.loads.as_mut().iter_mut();
        let ends = self.status.forces.as_ref().iter().zip(forces);
        for ((_, load), (before, after)) in loads.zip(ends) {
            *load = wave(*before, *after);
        }
    }

    /// Sets the inputs of a step to polynomials from the last sample to `sample`.
    pub(super) fn lead(&mut self, sample: &Sample<'_, S>) -> Result<(), Halt> {
        let (zero, dt) = (S::constant(0.0), self.pace.dt);
        let line = |from: S, to: S| Wave::line((zero, from), (dt, to));
        self.motion.time = zero;
        self.set_loads(sample.forces, line);
        let (motion, status) = (&mut self.motion, &self.status);
        if self.pace.on_base {
            motion.model.base = Curve::through(status.base, sample.base, dt);
            if motion.model.base.value(zero, 2) != status.lift {
                motion.accelerations_jump();
            }
        }
        let levels = status.levels.as_ref().iter().zip(sample.frictions);
        for (contact, (before, friction)) in levels.enumerate() {
            let level = line(*before, *friction);
            if motion
                .model
                .contact(contact)
                .is_some_and(|own| own.level != level)
            {
                motion.lead_level(contact, level, false)?;
            }
        }
        Ok(())
    }

    /// Advances the motion from event to event through the sub-interval with the index `part`. Returns true if the
    /// stepper has reached its bound on events.
    fn follow(
        &mut self,
        part: u32,
        noted: &mut Noted<'_, S, impl Observe<S, Z>>,
    ) -> Result<bool, Halt> {
        let events = match usize::from(self.status.budget) {
            0 => MAX_STEP_EVENTS,
            budget => budget.saturating_sub(noted.events as usize),
        };
        let bounds = Bounds {
            events,
            stretches: pieces(events, !self.motion.model.law.as_ref().is_empty()),
        };
        let until = self.pace.start(part + 1);
        noted.work = self.status.work;
        let followed = self.motion.run(until, bounds, noted);
        let exceeded = matches!(
            followed,
            Err(Halt::Events | Halt::Stretches | Halt::Stalled)
        );
        if exceeded {
            self.motion.coast(until, noted)?;
        } else {
            followed?;
        }
        self.status.work = noted.work;
        Ok(exceeded)
    }

    /// Moves the origin of the displacements to the first mass, if no spring holds the chain and the chain has moved far
    /// from the origin. Displacements in `f32` then keep their digits far from the start.
    fn recentre(&mut self) {
        let model = self.motion.model();
        if S::EPSILON < 1e-10 || !model.is_unheld() || model.has_stops() {
            return;
        }
        let places = self.motion.state().x.as_ref();
        let shift = at(places, 0);
        // Differences of numbers that differ by less than a factor of 2 are exact. Rounded differences at every step would
        // let the energy drift.
        let is_far = |place: &S| (*place - shift).abs() * S::constant(8.0) < shift.abs();
        if !places.iter().all(is_far) {
            return;
        }
        self.motion.translate(shift);
        self.status.origin = self.status.origin.plus(shift);
    }
}

/// Returns an error if the displacement or the velocity of the base is not finite.
fn check_base<S: Float>(base: [S; 2]) -> Result<(), OutOfDomain> {
    match base.iter().find(|number| !number.is_finite()) {
        Some(number) => Err(OutOfDomain::BaseMotion(Given::of(*number))),
        None => Ok(()),
    }
}

impl<S: Float, Z: Size> Motion<S, Z> {
    /// Changes the kinetic friction force of a contact from the present instant on. It `jumps`, or only its slope changes.
    /// If the contact keeps its phase, this needs no decision.
    fn lead_level(&mut self, contact: usize, level: Wave<S>, jumps: bool) -> Result<(), Halt> {
        let Some(own) = self.model.contacts.as_mut().get_mut(contact) else {
            return Ok(());
        };
        let starts_or_ends = own.is_free() != level.is_zero();
        let has_law = !self.model.law.as_ref().is_empty();
        let is_rigid = own.is_rigid();
        if has_law || starts_or_ends || (!is_rigid && jumps) {
            return self.set_level(contact, level);
        }
        own.level = level;
        if jumps {
            self.accelerations_jump();
        }
        if let Some(zeros) = self.state.zeros.as_mut().get_mut(contact)
            && !is_rigid
        {
            zeros.0 = zeros.0.min(1);
        }
        Ok(())
    }

    /// Moves the origin of all displacements by `shift`. Springs to the wall or to the base must not exist.
    fn translate(&mut self, shift: S) {
        for place in self.state.x.as_mut() {
            *place = *place - shift;
        }
        let wall = self.model.wall();
        let contacts = self.model.contacts.as_ref().iter().enumerate();
        for (j, contact) in contacts {
            let moved = match (contact.plus < wall, contact.minus < wall) {
                (true, false) => -shift,
                (false, true) => shift,
                _ => continue,
            };
            add(self.state.places.as_mut(), j, moved);
        }
    }
}
