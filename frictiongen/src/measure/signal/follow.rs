//! Follows the motion of a scene under signals.

use super::{Piece, SAME, Signal, Target};
use crate::measure::driven::{Drive, DriveError, GivenState, Visit, shared};
use crate::measure::error::MeasureError;
use crate::study::joined::{
    Joined, JoinedError, JoinedHistory, JoinedInput, JoinedSpan, JoinedStepper,
};
use crate::study::joints::Wave;
use frictiongen_kernel::joints::Curve;

/// Signals that act together, with the length of the motion, its samples and the friction force.
#[derive(Clone, Debug)]
pub struct SignalInputs<'i> {
    signals: &'i [Signal],
    until: f64,
    samples: usize,
    friction: f64,
}

impl<'i> SignalInputs<'i> {
    /// Collects signals for a motion from 0 s to `until`, with `samples` equal intervals. `friction` is the common friction
    /// F in N. Forces add up, also on one mass. Only one signal may move the base.
    ///
    /// # Errors
    /// [`MeasureError::Signal`] for two motions of the base, and for numbers outside their range.
    pub fn new(
        signals: &'i [Signal],
        (until, samples): (f64, usize),
        friction: f64,
    ) -> Result<Self, MeasureError> {
        let refuse = |what: &str| {
            Err(MeasureError::Signal {
                text: String::new(),
                what: what.to_owned(),
            })
        };
        let moving = signals.iter().filter(|signal| signal.moves_base());
        if 1 < moving.count() {
            return refuse("only one input can move the base; forces add up");
        }
        if !(0.0 < until && until.is_finite() && 0 < samples) {
            return refuse("the motion needs an end above 0 s and at least one sample interval");
        }
        Ok(Self {
            signals,
            until,
            samples,
            friction,
        })
    }

    /// Returns a stepper of a scene at 0 s. Without a state, all masses are at rest with the displacement 0.
    ///
    /// # Errors
    /// [`DriveError::Step`] for samples that are too far apart.
    pub fn stepper<'s>(
        &self,
        joined: &Joined<'s>,
        state: Option<GivenState<'_>>,
    ) -> Result<JoinedStepper<'s>, DriveError> {
        let dt = self.until / self.samples as f64;
        let loads = self.forces().map(|(mass, _)| mass).collect();
        let step = joined.stepper_loaded(dt, state.unwrap_or((&[], &[])), loads);
        step.map_err(|_| DriveError::Step(dt))
    }

    /// Computes the samples and the events of the motion. The times of the result are in s.
    ///
    /// # Errors
    /// Same errors as [`stepper`](Self::stepper), [`DriveError::Sample`] for the first step that fails, and
    /// [`DriveError::Events`] for a motion with more events than the solver follows.
    pub fn history(
        &self,
        joined: &Joined<'_>,
        state: Option<GivenState<'_>>,
    ) -> Result<JoinedHistory, DriveError> {
        let mut step = self.stepper(joined, state)?;
        step.keep_events();
        let mut history = JoinedHistory::default();
        self.follow(&mut step, joined, &mut |step, _, _| {
            history.taus.push(step.time());
            let masses = step.masses().into_iter();
            history.states.push(masses.map(|[x, v]| (x, v)).unzip());
            history.contacts.push(step.contacts());
            true
        })?;
        if 0 < step.exceeded() {
            return Err(DriveError::Events(step.exceeded()));
        }
        history.events = step.events();
        Ok(history)
    }

    /// Returns the forces, each with the index of its mass.
    fn forces(&self) -> impl Iterator<Item = (usize, &'i Signal)> {
        let signals = self.signals.iter();
        signals.filter_map(|signal| match signal.target {
            Target::Force(mass) => Some((mass, signal)),
            _ => None,
        })
    }

    /// Advances to the next instant at which a signal changes its form, but not beyond `target`.
    fn advance(&self, step: &mut JoinedStepper<'_>, target: f64) -> Result<usize, JoinedError> {
        let now = step.time();
        let forces: Vec<Piece> = self.forces().map(|(_, own)| own.piece(now)).collect();
        let moving = self.signals.iter().find(|signal| signal.moves_base());
        let base = moving.map(|signal| (signal, signal.piece(now)));
        let pieces = forces.iter().chain(base.iter().map(|(_, piece)| piece));
        let end = pieces.map(|piece| piece.end).fold(target, f64::min);
        let end = if target - end <= SAME * target {
            target
        } else {
            end
        };
        let (base, jolts) = match &base {
            Some((signal, piece)) => signal.base(piece, step.base()),
            None => (Curve::zero(), false),
        };
        let waves: Vec<Wave> = forces.iter().map(|piece| piece.wave).collect();
        step.advance_over(JoinedSpan {
            end,
            base,
            jolts,
            forces: &waves,
            frictions: &[],
        })
    }
}

impl Drive for SignalInputs<'_> {
    fn samples(&self) -> usize {
        self.samples + 1
    }

    fn follow(
        &self,
        step: &mut JoinedStepper<'_>,
        joined: &Joined<'_>,
        visit: Visit<'_>,
    ) -> Result<(), DriveError> {
        let contacts = joined.scene().named_contacts();
        let frictions = shared(&contacts, self.friction);
        let begun = step.begin(JoinedInput {
            frictions: &frictions,
            ..JoinedInput::default()
        });
        begun.map_err(|error| DriveError::Sample(0, error))?;
        for sample in 0..=self.samples {
            let target = self.until * (sample as f64 / self.samples as f64);
            let mut events = 0;
            while step.time() < target {
                let taken = self.advance(step, target);
                events += taken.map_err(|error| DriveError::Sample(sample, error))?;
            }
            if !visit(step, step.base(), events) {
                break;
            }
        }
        Ok(())
    }
}

impl Signal {
    /// Returns true if the signal moves the base.
    fn moves_base(&self) -> bool {
        !matches!(self.target, Target::Force(_))
    }
}
