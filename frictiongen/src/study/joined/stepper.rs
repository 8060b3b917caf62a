//! Motion of scenes with several contacts under sampled forces.

use super::error::JoinedError;
use super::scene::Joined;
use super::simulation::JoinedContactNow;
use crate::study::joints::{Chain, Motion, Wave};
use crate::{Given, OutOfDomain};
use frictiongen_model::scene::{Excitation, StepInput};

/// Input of one step, in the units of the description.
#[derive(Clone, Copy, Debug, Default)]
pub struct JoinedInput<'i> {
    /// Forces on masses at the end of the step, each with the name of its mass. Masses that are not listed have no
    /// force.
    pub forces: &'i [(&'i str, f64)],
    /// Kinetic friction forces of contacts during the step, each with the name of its contact. A contact with the
    /// friction force 0 has no effect. Contacts that are not listed keep their friction force.
    pub frictions: &'i [(&'i str, f64)],
}

/// Stepper with a fixed time step, in the units of the description.
#[derive(Clone, Debug)]
pub struct JoinedStepper<'a> {
    joined: Joined<'a>,
    motion: Motion,
    dt: f64,
    steps: u64,
    input: StepInput,
    /// Force on each mass at the end of the last step.
    forces: Vec<f64>,
}

impl<'a> Joined<'a> {
    /// Returns a stepper that starts from rest. A force can act on every mass. Every contact has a separate friction
    /// force, which is 0 until an input sets it. The description determines the input between two samples: linear, or
    /// constant (`hold`).
    ///
    /// # Errors
    /// [`OutOfDomain`] for a step that is not above 0 and finite. [`JoinedError::BaseMoves`] if the base drives the
    /// scene.
    pub fn stepper(&self, dt: f64) -> Result<JoinedStepper<'a>, JoinedError> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(OutOfDomain::Step(Given::of(dt)).into());
        }
        if self.scene().excitation == Excitation::Base {
            return Err(JoinedError::BaseMoves);
        }
        let mut chain: Chain = self.chain().clone();
        for contact in &mut chain.contacts {
            contact.level = Wave::default();
        }
        let masses = chain.masses.len();
        chain.loads = (0..masses).map(|mass| (mass, Wave::default())).collect();
        Ok(JoinedStepper {
            motion: Motion::from_rest(&chain)?,
            joined: self.clone(),
            dt,
            steps: 0,
            input: self.scene().stepping.input,
            forces: vec![0.0; masses],
        })
    }
}

impl JoinedStepper<'_> {
    /// Advances by one step. Returns the number of events in the step.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a force that is not finite, and for a friction force that is negative or not finite.
    /// [`JoinedError::UnknownMass`] and [`JoinedError::UnknownContact`] for a name that the scene does not have. After
    /// an error the stepper is unchanged.
    pub fn advance(&mut self, input: JoinedInput<'_>) -> Result<usize, JoinedError> {
        let mut forces = vec![0.0; self.forces.len()];
        for (name, force) in input.forces {
            if !force.is_finite() {
                return Err(OutOfDomain::Force(Given::of(*force)).into());
            }
            let mass = self.joined.mass_index(name)?;
            if let Some(own) = forces.get_mut(mass) {
                *own = *force;
            }
        }
        let (start, end) = (self.time(), (self.steps + 1) as f64 * self.dt);
        let mut motion = self.motion.clone();
        for (mass, (before, after)) in self.forces.iter().zip(&forces).enumerate() {
            let wave = match self.input {
                StepInput::Hold => Wave::constant(*after),
                StepInput::Linear => Wave::line((start, *before), (end, *after)),
            };
            motion.set_load(mass, wave)?;
        }
        for (name, friction) in input.frictions {
            if !(*friction >= 0.0 && friction.is_finite()) {
                return Err(OutOfDomain::Friction(Given::of(*friction)).into());
            }
            let contact = self.joined.contact_index(name)?;
            motion.set_level(contact, Wave::constant(*friction))?;
        }
        let events = motion.run(end, &mut |_, _, _| {})?.len();
        self.motion = motion;
        self.forces = forces;
        self.steps += 1;
        Ok(events)
    }

    /// Returns the time at the end of the last step.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.dt
    }

    /// Returns displacement and velocity of the mass called `name`.
    ///
    /// # Errors
    /// [`JoinedError::UnknownMass`] if no mass has this name.
    pub fn mass(&self, name: &str) -> Result<(f64, f64), JoinedError> {
        let mass = self.joined.mass_index(name)?;
        let state = self.motion.state();
        let of = |values: &[f64]| values.get(mass).copied().unwrap_or_default();
        Ok((of(&state.x), of(&state.v)))
    }

    /// Returns the state of the contact `name` at the end of the last step. The stepper does not compute the slip,
    /// which is 0.
    ///
    /// # Errors
    /// [`JoinedError::UnknownContact`] if no contact has this name.
    pub fn contact_named(&self, name: &str) -> Result<JoinedContactNow, JoinedError> {
        let index = self.joined.contact_index(name)?;
        let (velocity, displacement) = self.motion.relative(index);
        let force = self.motion.forces().get(index).copied();
        Ok(JoinedContactNow {
            displacement,
            velocity,
            force: force.unwrap_or_default(),
            slip: 0.0,
            is_sticking: self.motion.state().phase(index) == 0,
        })
    }
}
