//! Follows the motion of a scene with any number of contacts under a recorded input.

#[cfg(test)]
mod tests;

use super::Inputs;
use super::columns::{DrivenSample, DrivenTable};
use crate::study::joined::{Joined, JoinedError, JoinedInput, JoinedStepper};
use crate::study::scene::{Excitation, NamedContact};
use frictiongen_kernel::stepper::Work;
use std::fmt;

/// Function that sees the motion at every sample: the stepper, the displacement and the velocity of the base, and the
/// number of events since the previous sample. The motion ends early if the function returns false.
pub(super) type Visit<'v> = &'v mut dyn FnMut(&JoinedStepper<'_>, [f64; 2], usize) -> bool;

/// Displacements in m and velocities in m/s of all masses.
pub(super) type GivenState<'s> = (&'s [f64], &'s [f64]);

/// Forces on masses and friction forces of contacts at one sample.
type Acting<'n> = (Vec<(&'n str, f64)>, Vec<(&'n str, f64)>);

/// Motion of a scene under a recorded input.
#[derive(Clone, Debug)]
pub struct DrivenMotion {
    /// Motion at every sample of the recording.
    pub samples: Vec<DrivenSample>,
    /// Energy balance since the first sample, in J.
    pub work: Work<f64>,
    /// Number of steps with more events than the stepper follows.
    pub exceeded: u64,
}

impl DrivenMotion {
    /// Returns the energy in J that friction has dissipated in each contact, with the name of the contact. `names` has the
    /// names of the contacts.
    #[must_use]
    pub fn energies<'n>(&self, names: &'n [String]) -> Vec<(&'n str, f64)> {
        let last = self.samples.last().into_iter();
        let last = last.flat_map(|sample| &sample.contacts);
        let names = names.iter().map(String::as_str);
        names.zip(last.map(|now| now.energy)).collect()
    }
}

/// Inputs that drive a scene over time: a recording, or signals in closed form.
#[doc(hidden)]
pub trait Drive: Send + Sync {
    /// Returns the number of samples of the motion.
    fn samples(&self) -> usize;

    /// Follows the motion from the first sample to the last, and calls `visit` at each of them.
    ///
    /// # Errors
    /// [`DriveError::Sample`] for the first step that fails.
    fn follow(
        &self,
        step: &mut JoinedStepper<'_>,
        joined: &Joined<'_>,
        visit: Visit<'_>,
    ) -> Result<(), DriveError>;
}

/// Reason why the motion under a recorded input fails.
#[derive(Clone, Debug)]
pub enum DriveError {
    /// The scene has no stepper for the time between two samples. The field has this time in s.
    Step(f64),
    /// The step that ends at a sample fails.
    Sample(usize, JoinedError),
    /// This number of steps has more events than the stepper follows.
    Events(u64),
}

impl fmt::Display for DriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Step(dt) => write!(
                f,
                "the samples are {dt:?} s apart: too far for the fastest mode of the scene"
            ),
            Self::Sample(sample, error) => write!(f, "sample {sample} of the input: {error}"),
            Self::Events(steps) => write!(
                f,
                "{steps} steps have more events than the stepper follows; take more samples"
            ),
        }
    }
}

impl std::error::Error for DriveError {}

impl Inputs<'_> {
    /// Returns a stepper of several contacts at the first sample. Without a state, all masses are at rest relative to the
    /// base.
    ///
    /// # Errors
    /// [`DriveError::Step`] for samples that are too far apart.
    pub fn joined_stepper<'s>(
        &self,
        joined: &Joined<'s>,
        state: Option<GivenState<'_>>,
    ) -> Result<JoinedStepper<'s>, DriveError> {
        let rest = self.initial_state_of(joined.scene().masses.len());
        let (x, v) = state.unwrap_or((&rest.0, &rest.1));
        let step = joined.stepper_from(self.dt(), (x, v));
        step.map_err(|_| DriveError::Step(self.dt()))
    }
}

/// Returns the friction force of each contact, with its name, for a common friction.
pub(super) fn shared(contacts: &[NamedContact], friction: f64) -> Vec<(&str, f64)> {
    let frictions = contacts.iter();
    frictions
        .map(|contact| (contact.name.as_str(), contact.law.share * friction))
        .collect()
}

impl Drive for Inputs<'_> {
    fn samples(&self) -> usize {
        self.len()
    }

    fn follow(
        &self,
        step: &mut JoinedStepper<'_>,
        joined: &Joined<'_>,
        visit: Visit<'_>,
    ) -> Result<(), DriveError> {
        let scene = joined.scene();
        let excited = match scene.excitation {
            Excitation::Force(mass) => scene.masses.get(mass).map(|mass| mass.name.as_str()),
            Excitation::Base => None,
        };
        let contacts = scene.named_contacts();
        let mut before: Option<Acting<'_>> = None;
        for sample in 0..self.len() {
            let input = self.sample(sample);
            let mut forces = input.others;
            forces.extend(excited.map(|mass| (mass, input.force)));
            let frictions = shared(&contacts, input.friction);
            let now = JoinedInput {
                base: input.base,
                start_velocity: input.start_velocity,
                forces: &forces,
                frictions: &frictions,
            };
            let times = self.uneven_times();
            let events = match (&before, times.and_then(|times| times.get(sample))) {
                (None, _) => step.begin(now).map(|()| 0),
                (_, None) => step.advance(now),
                (Some((forces, frictions)), Some(end)) => {
                    let before = JoinedInput {
                        forces,
                        frictions,
                        ..JoinedInput::default()
                    };
                    step.advance_between(before, now, *end)
                }
            };
            before = Some((forces, frictions));
            let events = events.map_err(|error| DriveError::Sample(sample, error))?;
            if !visit(step, input.end, events) {
                break;
            }
        }
        Ok(())
    }
}

impl DrivenTable<'_> {
    /// Computes the motion of the scene under a recorded input, from a stepper at the first sample. The motion ends early
    /// if `goes_on` returns false.
    ///
    /// # Errors
    /// Same errors as [`Drive::follow`].
    pub fn motion(
        &self,
        joined: &Joined<'_>,
        (inputs, mut step): (&dyn Drive, JoinedStepper<'_>),
        goes_on: &dyn Fn() -> bool,
    ) -> Result<DrivenMotion, DriveError> {
        let signs = (0..self.names.len()).map(|contact| joined.sign(contact));
        let signs: Vec<f64> = signs.collect();
        let mut samples = Vec::with_capacity(inputs.samples());
        inputs.follow(&mut step, joined, &mut |step, base, events| {
            let contacts = step.contacts().into_iter().zip(&signs);
            let contacts = contacts.map(|(now, sign)| now.signed(*sign)).collect();
            let instant = (step.time(), events);
            samples.push(self.sample(instant, (base, &step.masses()), contacts));
            goes_on()
        })?;
        Ok(DrivenMotion {
            samples,
            work: step.work(),
            exceeded: step.exceeded(),
        })
    }
}
