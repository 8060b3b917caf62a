//! Advances a stepper by a step of its own length, under loads that are lines and harmonics.

use super::Stepped;
use crate::errors::{Given, Halt, OutOfDomain};
use crate::joints::base::Curve;
use crate::joints::run::Observe;
use crate::joints::size::{Size, set};
use crate::joints::stepper::{Pace, Stepper};
use crate::joints::wave::Wave;
use crate::{Float, Scalar};

/// Differences of two values that count as rounding, as a multiple of the rounding unit.
const ROUNDINGS: f64 = 16.0;

/// Input of one step of any length. The time of all functions is 0 at the start of the step.
#[derive(Clone, Copy, Debug)]
pub struct Span<'i, S> {
    /// Length of the step, in seconds.
    pub length: S,
    /// Displacement of the base.
    pub base: Curve<S>,
    /// True if the displacement or the velocity of the base jumps at the start of the step.
    pub jolts: bool,
    /// Force of each load.
    pub forces: &'i [Wave<S>],
    /// Kinetic friction force of each contact.
    pub frictions: &'i [Wave<S>],
}

impl<S: Float> Span<'_, S> {
    /// Returns the longest interval in which power series represent all functions.
    fn longest_stretch(&self) -> S {
        let waves = self.forces.iter().chain([&self.base.wave]);
        let longest = waves.map(Wave::longest_stretch);
        longest.fold(self.base.wave.longest_stretch(), Scalar::min)
    }
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Advances the motion by one step of the length of `span`, and passes each stretch and each event to `watch`. The
    /// stepper does not use its tables. [`time`](Self::time) counts the step as one of the stepper's own length.
    ///
    /// # Errors
    ///
    /// Same errors as [`advance`](Self::advance), and those of [`Pace::new`] for the length of the step. The stepper
    /// keeps its state after an error.
    pub fn advance_over<W: Observe<S, Z>>(
        &mut self,
        span: Span<'_, S>,
        watch: &mut W,
    ) -> Result<Stepped, OutOfDomain> {
        self.check_span(&span)?;
        let (pace, stretch) = (self.pace, self.motion.model.stretch);
        let shorter = Scalar::min(stretch, span.longest_stretch());
        self.pace = Pace::new((span.length, shorter), pace.input, pace.on_base)?;
        self.motion.model.stretch = shorter;
        let taken = self.take_step(watch, |stepper, noted| {
            stepper.enter(&span)?;
            let mut exceeded = false;
            for part in 0..stepper.pace.parts {
                exceeded |= stepper.follow(part, noted)?;
            }
            stepper.leave(&span);
            Ok(exceeded)
        });
        (self.pace, self.motion.model.stretch) = (pace, stretch);
        taken
    }

    /// Returns an error if a number of the input is outside its range.
    fn check_span(&self, span: &Span<'_, S>) -> Result<(), OutOfDomain> {
        if (span.forces.len(), span.frictions.len()) != self.motion.model().inputs() {
            return Err(OutOfDomain::Forces);
        }
        if !self.pace.on_base && (span.jolts || !span.base.is_zero()) {
            return Err(OutOfDomain::BaseAtRest);
        }
        let at_end = [0, 1, 2].map(|order| span.base.value(span.length, order));
        if let Some(number) = at_end.iter().find(|number| !number.is_finite()) {
            return Err(OutOfDomain::BaseMotion(Given::of(*number)));
        }
        if let Some(force) = span.forces.iter().find(|force| !force.is_finite()) {
            return Err(OutOfDomain::Force(Given::of(force.value(span.length, 0))));
        }
        let zero = S::constant(0.0);
        let frictions = span.frictions.iter();
        let mut ends = frictions.flat_map(|level| [zero, span.length].map(|at| level.value(at, 0)));
        match ends.find(|level| !(*level >= zero && level.is_finite())) {
            Some(level) => Err(OutOfDomain::Friction(Given::of(level))),
            None => Ok(()),
        }
    }

    /// Sets the inputs of a step.
    fn enter(&mut self, span: &Span<'_, S>) -> Result<(), Halt> {
        let zero = S::constant(0.0);
        self.motion.rewind();
        if span.jolts {
            self.jolt(span.base)?;
        } else if self.pace.on_base {
            self.motion.model.base = span.base;
        }
        let motion = &mut self.motion;
        let mut jumps = motion.model.base.value(zero, 2) != self.status.lift;
        for (load, to) in span.forces.iter().enumerate() {
            let jump = motion.model.change_load(load, *to, zero);
            let jump = jump.ok_or(Halt::Load)?;
            let size = to.constant.abs() + to.amplitude.abs();
            // Rounding must not count as a jump, because the zeros of an event at this instant would then be lost.
            jumps |= jump.abs() > S::constant(ROUNDINGS * S::EPSILON) * size;
        }
        if jumps {
            motion.accelerations_jump();
        }
        let levels = self.status.levels.as_ref().iter().zip(span.frictions);
        for (contact, (before, level)) in levels.enumerate() {
            let own = motion.model.contact(contact);
            if own.is_some_and(|own| own.level != *level) {
                motion.lead_level(contact, *level, *before != level.value(zero, 0))?;
            }
        }
        Ok(())
    }

    /// Stores the input at the end of a step.
    fn leave(&mut self, span: &Span<'_, S>) {
        let end = span.length;
        let status = &mut self.status;
        status.base = [0, 1].map(|order| span.base.value(end, order));
        status.lift = span.base.value(end, 2);
        for (load, force) in span.forces.iter().enumerate() {
            set(status.forces.as_mut(), load, force.value(end, 0));
        }
        for (contact, level) in span.frictions.iter().enumerate() {
            set(status.levels.as_mut(), contact, level.value(end, 0));
        }
    }
}
