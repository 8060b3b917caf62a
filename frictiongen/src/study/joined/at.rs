//! A scene with several contacts at one frequency.

use super::answers::{LinearResponse, StuckState};
use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::scene::Joined;
use super::simulation::JoinedSimulation;
use crate::study::joints::{Chain, JointError, Motion, Wave, steady_state_of, stuck_response};
use crate::{Given, OutOfDomain};

/// Displacements and velocities of all masses, in the units of the answers.
type Start<'s> = (&'s [f64], &'s [f64]);

/// Units of the answers, expressed in the units of the description.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of forces and frictions.
    pub force: f64,
    /// The unit of displacements.
    pub length: f64,
    /// The unit of velocities.
    pub speed: f64,
}

impl Units {
    /// Returns the unit of energies.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.force * self.length
    }
}

/// A scene with several contacts at one frequency.
#[derive(Clone, Debug)]
pub struct JoinedAt<'a> {
    joined: Joined<'a>,
    /// The chain with its load. The friction level of each contact is its share.
    chain: Chain,
    omega: f64,
    units: Units,
}

impl<'a> JoinedAt<'a> {
    pub(super) fn new(joined: Joined<'a>, chain: Chain, omega: f64, units: Units) -> Self {
        Self {
            joined,
            chain,
            omega,
            units,
        }
    }

    /// Returns the angular frequency in rad/s.
    #[must_use]
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// Returns the units of the answers.
    #[must_use]
    pub fn units(&self) -> Units {
        self.units
    }

    /// Returns the chain of the engine, with its load and with the levels of this common friction.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite.
    pub fn chain(&self, friction: f64) -> Result<Chain, JoinedError> {
        if !(friction >= 0.0 && friction.is_finite()) {
            return Err(OutOfDomain::FrictionRatio(Given::of(friction)).into());
        }
        let mut chain = self.chain.clone();
        for contact in &mut chain.contacts {
            let share = contact.level.constant;
            contact.level = Wave::constant(friction * self.units.force * share);
        }
        Ok(chain)
    }

    /// Returns the steady state that the motion from rest reaches. `friction` is the common friction, as β = F/P or as
    /// F in N. The friction force of a contact is its share of F. The period is at most 64 cycles.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if the motion does not
    /// settle, or if it has too many events.
    pub fn orbit(&self, friction: f64) -> Result<JoinedOrbit<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = Motion::from_rest(&chain)?;
        self.settled(motion, chain)
    }

    /// Returns the steady state that the motion from a given state reaches. `state` has the displacement and the
    /// velocity of each mass.
    ///
    /// # Errors
    /// Same errors as [`orbit`](Self::orbit). [`OutOfDomain::State`] for a state that is not finite, or not one number
    /// for each mass.
    pub fn orbit_from(
        &self,
        friction: f64,
        state: Start<'_>,
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = self.started(&chain, Some(state))?;
        self.settled(motion, chain)
    }

    fn settled(&self, motion: Motion, chain: Chain) -> Result<JoinedOrbit<'a>, JoinedError> {
        let steady = steady_state_of(motion, self.omega)?;
        Ok(JoinedOrbit::new(
            self.joined.clone(),
            chain,
            (self.omega, self.units),
            steady,
        ))
    }

    /// Creates a motion that starts from a state, or from rest.
    fn started(&self, chain: &Chain, state: Option<Start<'_>>) -> Result<Motion, JoinedError> {
        let Some((x, v)) = state else {
            return Ok(Motion::from_rest(chain)?);
        };
        let masses = chain.masses.len();
        let finite = x.iter().chain(v).all(|number| number.is_finite());
        if x.len() != masses || v.len() != masses || !finite {
            return Err(OutOfDomain::State.into());
        }
        let scaled = |values: &[f64], unit: f64| -> Vec<f64> {
            values.iter().map(|value| unit * value).collect()
        };
        let (x, v) = (scaled(x, self.units.length), scaled(v, self.units.speed));
        Ok(Motion::from(chain, &x, &v)?)
    }

    /// Creates the exact motion in time from rest. At the start the load is at its maximum.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite.
    pub fn simulation(&self, friction: f64) -> Result<JoinedSimulation<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = self.started(&chain, None)?;
        Ok(self.running(motion))
    }

    /// Creates the exact motion in time from a given state. `state` has the displacement and the velocity of each mass.
    ///
    /// # Errors
    /// Same errors as [`orbit_from`](Self::orbit_from).
    pub fn simulation_from(
        &self,
        friction: f64,
        state: Start<'_>,
    ) -> Result<JoinedSimulation<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = self.started(&chain, Some(state))?;
        Ok(self.running(motion))
    }

    fn running(&self, motion: Motion) -> JoinedSimulation<'a> {
        JoinedSimulation::new(self.joined.clone(), motion, (self.omega, self.units))
    }

    /// Returns the state in which no contact slides, in closed form: the amplitudes, the force of each contact, and the
    /// friction from which the state exists. In this state no earlier motion has left a constant force in a contact.
    ///
    /// # Errors
    /// [`JoinedError::Resonance`] on an undamped resonance of the chain with its contacts stuck.
    pub fn stuck(&self) -> Result<StuckState<'a>, JoinedError> {
        let response = stuck_response(&self.chain(1.0)?).map_err(resonance)?;
        Ok(StuckState::new(self.joined.clone(), response, self.units))
    }

    /// Returns the response of the chain without friction, in closed form.
    ///
    /// # Errors
    /// [`JoinedError::Resonance`] on an undamped resonance of the chain.
    pub fn linear(&self) -> Result<LinearResponse<'a>, JoinedError> {
        let response = stuck_response(&self.chain(0.0)?).map_err(resonance)?;
        Ok(LinearResponse::new(
            self.joined.clone(),
            response.displacements,
            self.units,
        ))
    }
}

/// Converts the error of a linear response. Only a resonance is possible, because all loads of a scene have one valid
/// frequency.
fn resonance(error: JointError) -> JoinedError {
    match error {
        JointError::Number(_) => JoinedError::Resonance,
        other => other.into(),
    }
}
