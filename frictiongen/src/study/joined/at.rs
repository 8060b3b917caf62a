//! A scene with several contacts at one frequency.

use super::answers::{LinearResponse, StuckState};
use super::error::JoinedError;
use super::orbit::JoinedOrbit;
use super::scene::Joined;
use super::simulation::JoinedSimulation;
use super::units::AnswerUnits;
use crate::study::joints::{
    Chain, JointError, Motion, Place, Steady, Wave, limit_cycle, steady_state, steady_state_soon,
    stuck_response,
};
use crate::{Given, OutOfDomain};
use frictiongen_kernel::joints::SharedTables;
use frictiongen_model::scene::Excitation;

/// Number of attempts of a search that soon gives up a motion that does not settle. It then has followed 210 cycles.
const ATTEMPTS: usize = 3;
/// Number of attempts of a search that follows a motion for 1890 cycles, but finds no other state if it does not settle.
const LONG_ATTEMPTS: usize = 6;

/// Displacements and velocities of all masses, in the units of [`JoinedAt::units`].
type GivenState<'s> = (&'s [f64], &'s [f64]);

/// A scene with several contacts at one frequency.
#[derive(Clone, Debug)]
pub struct JoinedAt<'a> {
    joined: Joined<'a>,
    /// The chain with its load, for a common friction of 1. The friction force of each contact is then its share of
    /// the common friction.
    chain: Chain,
    omega: f64,
    units: AnswerUnits,
    /// Displacements and velocities at the start of the motions to steady states, if the system has an initial state.
    start: Option<(Vec<f64>, Vec<f64>)>,
    /// Tables of the chain at this frequency.
    tables: SharedTables,
}

impl<'a> Joined<'a> {
    /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁). Frictions are ratios β = F/P (F/(k₁Y) for base
    /// motion). Displacements are divided by P/k₁ (by Y for base motion), and forces are divided by P (by k₁Y for base
    /// motion). Velocities are derivatives of these displacements with respect to the phase τ = ωt.
    ///
    /// # Errors
    /// [`JoinedError::NoSpring`] for a scene without springs. Otherwise same errors as [`at_any`](Self::at_any).
    pub fn at(&self, r: f64) -> Result<JoinedAt<'a>, JoinedError> {
        if self.scene().springs.is_empty() {
            return Err(JoinedError::NoSpring);
        }
        self.at_any(r)
    }

    /// Evaluates the scene at a frequency ratio, as [`at`](Self::at) does. If the scene has no spring, the method uses
    /// k₁ = 1 in the units of the scene description.
    ///
    /// # Errors
    /// [`OutOfDomain`] unless r is above 0 and finite. [`JoinedError::NoAmplitude`] if the scene has a length or a speed of
    /// its own and [`with_length`](Self::with_length) has not set the unit of displacement.
    pub fn at_any(&self, r: f64) -> Result<JoinedAt<'a>, JoinedError> {
        self.check_load()?;
        if !(r > 0.0 && r.is_finite()) {
            return Err(OutOfDomain::FrequencyRatioInTime(Given::of(r)).into());
        }
        let stiffness = self.scene().first_stiffness();
        let omega = r * self.reference();
        let amplitude = match self.scene().excitation {
            Excitation::Force(_) => stiffness,
            Excitation::Base => 1.0,
        };
        let units = AnswerUnits {
            force: stiffness,
            length: 1.0,
            speed: omega,
        };
        let mut at = self.loaded(omega, amplitude, units);
        at.start = self.start().map(|start| start.at(r));
        if self.scene().has_length() {
            at.chain
                .scale(self.length().ok_or(JoinedError::NoAmplitude)?);
        }
        Ok(at)
    }

    /// Evaluates the scene under a load in the units of the scene description. `omega` is the angular frequency ω in
    /// rad/s, and `amplitude` is P in N, or Y in m for base motion. Frictions are forces F in N, and all results are in
    /// these units.
    ///
    /// # Errors
    /// [`JoinedError::Frequency`] unless ω is above 0 and finite. [`JoinedError::Amplitude`] unless the amplitude is
    /// above 0 and finite.
    pub fn under(&self, omega: f64, amplitude: f64) -> Result<JoinedAt<'a>, JoinedError> {
        self.check_load()?;
        if !(omega > 0.0 && omega.is_finite()) {
            return Err(JoinedError::Frequency(Given::of(omega)));
        }
        if !(amplitude > 0.0 && amplitude.is_finite()) {
            return Err(JoinedError::Amplitude(Given::of(amplitude)));
        }
        let units = AnswerUnits::OF_SCENE;
        let mut at = self.loaded(omega, amplitude, units);
        let length = match self.scene().excitation {
            Excitation::Force(_) => amplitude / self.scene().first_stiffness(),
            Excitation::Base => amplitude,
        };
        let scaled = |values: Vec<f64>, unit: f64| values.iter().map(|x| unit * x).collect();
        at.start = self.start().map(|start| {
            let (x, v) = start.at(omega / self.reference());
            (scaled(x, length), scaled(v, omega * length))
        });
        Ok(at)
    }

    /// Starts a free vibration: a motion from a given state without a load, with a moving base at rest. `friction` is the
    /// common friction F in N. `state` has the displacement in m and the velocity in m/s of each mass. All results are in
    /// the units of the scene description, and τ is the time in s.
    ///
    /// # Errors
    /// Same errors as [`JoinedAt::simulation_from`].
    pub fn simulation_without_load(
        &self,
        friction: f64,
        state: GivenState<'_>,
    ) -> Result<JoinedSimulation<'a>, JoinedError> {
        let units = AnswerUnits::OF_SCENE;
        let at = JoinedAt::new(self.clone(), self.chain().clone(), 1.0, units);
        at.simulation_from(friction, state)
    }

    /// Returns the limit cycle that a motion without a load reaches: a periodic motion that a moving surface drives, with a
    /// moving base at rest. The motion starts from rest, or from the initial state of the system. `friction` is the common
    /// friction F in N, and all results are in the units of the scene description. The angular frequency
    /// [`omega`](JoinedOrbit::omega) of the result is that of the cycle. Returns `None` if the motion comes to rest, slides
    /// steadily, or does not repeat.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if the motion has too many
    /// events.
    ///
    /// ```
    /// use frictiongen::System;
    ///
    /// fn main() -> Result<(), Box<dyn std::error::Error>> {
    ///     let belt: System = "struct Belt {
    ///         masses: { block: 1 }, springs: { block - wall: 1 },
    ///         contacts: { pads: block - wall { speed: 0.3, stiction: 2 } },
    ///     }".parse()?;
    ///     let joined = belt.joined()?;
    ///     let cycle = joined.limit_cycle(1.0)?.ok_or("no cycle")?;
    ///     let period = std::f64::consts::TAU / cycle.omega();
    ///     // The block slips about x = F/k between two instants of the speed V, and sticks in between.
    ///     let slips = std::f64::consts::TAU - 2.0 * 1.0_f64.atan2(0.3);
    ///     assert!((period - slips - 2.0 / 0.3).abs() < 1e-10);
    ///     Ok(())
    /// }
    /// ```
    pub fn limit_cycle(&self, friction: f64) -> Result<Option<JoinedOrbit<'a>>, JoinedError> {
        let units = AnswerUnits::OF_SCENE;
        let at = JoinedAt::new(self.clone(), self.chain().clone(), 1.0, units);
        let start = self.start().map(|start| start.at(1.0));
        let start = start.as_ref().map(|(x, v)| (&x[..], &v[..]));
        let chain = at.chain(friction)?;
        let found = limit_cycle(at.started(&chain, start)?)?;
        Ok(found.map(|(steady, period)| {
            let omega = std::f64::consts::TAU / period;
            JoinedOrbit::new(self.clone(), chain, (omega, units), steady)
        }))
    }

    fn loaded(&self, omega: f64, amplitude: f64, units: AnswerUnits) -> JoinedAt<'a> {
        let mut chain = self.chain().clone();
        let wave = Wave::harmonic(amplitude, omega);
        match self.scene().excitation {
            Excitation::Force(mass) => chain.loads.push((mass, wave)),
            Excitation::Base => chain.base = wave,
        }
        JoinedAt::new(self.clone(), chain, omega, units)
    }
}

impl<'a> JoinedAt<'a> {
    pub(super) fn new(joined: Joined<'a>, chain: Chain, omega: f64, units: AnswerUnits) -> Self {
        Self {
            joined,
            chain,
            omega,
            units,
            start: None,
            tables: SharedTables::default(),
        }
    }

    /// Returns the angular frequency ω of the load, in rad/s.
    #[must_use]
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// Returns the units of the results at this frequency.
    #[must_use]
    pub fn units(&self) -> AnswerUnits {
        self.units
    }

    /// Returns the chain that the solver uses, with its load. The friction force of each contact is its share of the
    /// common friction `friction`.
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

    /// Returns the steady state that the motion from rest reaches, except that a contact that never slides is in the
    /// middle of the interval in which it can stick. If the system [starts from](crate::System::starting_from) an
    /// initial state, the method returns the steady state that the motion from there reaches. `friction` is the common
    /// friction, as β = F/P or as F in N. The friction force of a contact is its share of the common friction. The
    /// period is at most 64 cycles of the load.
    ///
    /// A motion with μ > 1 may wander for ever. The method then returns the stable steady state to which the motion has
    /// come closest, and [`JoinedOrbit::is_from_rest`] is false.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if the motion does not
    /// settle, or if it has too many events.
    pub fn orbit(&self, friction: f64) -> Result<JoinedOrbit<'a>, JoinedError> {
        settled(self.orbit_or_last_cycles(friction, None)?)
    }

    /// Returns the steady state of [`orbit`](Self::orbit), the same to within rounding. `near` is the steady state at a
    /// similar friction or frequency. It shortens the search if the steady state is the only one.
    ///
    /// # Errors
    /// Same errors as [`orbit`](Self::orbit).
    pub fn orbit_near(
        &self,
        friction: f64,
        near: &JoinedOrbit<'_>,
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        settled(self.orbit_or_last_cycles(friction, Some(near))?)
    }

    /// Returns the steady state of [`orbit`](Self::orbit). If the motion does not settle and the search finds no other
    /// steady state, returns the last 64 cycles of the motion, and [`JoinedOrbit::is_settled`] is false. `near` is that
    /// of [`orbit_near`](Self::orbit_near), if it is known.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if the motion has too many
    /// events.
    pub fn orbit_or_last_cycles(
        &self,
        friction: f64,
        near: Option<&JoinedOrbit<'_>>,
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        match &self.start {
            Some((x, v)) => self.found(friction, Some((x, v)), (Place::Reached, None)),
            None => self.found(
                friction,
                None,
                (Place::Centred, near.map(JoinedOrbit::steady)),
            ),
        }
    }

    /// Returns the steady state that the motion from a given state reaches. `state` has the displacement and the
    /// velocity of each mass. A contact that never slides stays where the motion has left it.
    ///
    /// # Errors
    /// Same errors as [`orbit`](Self::orbit). [`OutOfDomain::State`] for a state that is not finite, or not one number
    /// for each mass.
    pub fn orbit_from(
        &self,
        friction: f64,
        state: GivenState<'_>,
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        settled(self.found(friction, Some(state), (Place::Reached, None))?)
    }

    /// Returns the steady state of [`orbit_from`](Self::orbit_from) if the motion settles.
    ///
    /// # Errors
    /// Same errors as [`orbit_from`](Self::orbit_from).
    pub(super) fn orbit_reached_from(
        &self,
        friction: f64,
        state: GivenState<'_>,
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = self.started(&chain, Some(state))?;
        let found = steady_state_soon(motion, self.omega, (LONG_ATTEMPTS, Place::Reached))?;
        let steady = found.map_err(|_| JointError::NotSteady)?;
        Ok(self.settled(steady, chain))
    }

    fn found(
        &self,
        friction: f64,
        state: Option<GivenState<'_>>,
        place: (Place, Option<&Steady>),
    ) -> Result<JoinedOrbit<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let steady = steady_state(self.started(&chain, state)?, self.omega, place)?;
        Ok(self.settled(steady, chain))
    }

    pub(super) fn settled(&self, steady: Steady, chain: Chain) -> JoinedOrbit<'a> {
        let units = (self.omega, self.units);
        JoinedOrbit::new(self.joined.clone(), chain, units, steady)
    }

    /// Returns the steady state of [`orbit`](Self::orbit) if the motion settles in few cycles. Otherwise returns the largest
    /// |x̄| of every mass in 64 later cycles.
    pub(in crate::study) fn orbit_soon(
        &self,
        friction: f64,
    ) -> Result<Result<JoinedOrbit<'a>, Vec<f64>>, JoinedError> {
        let chain = self.chain(friction)?;
        let start = self.start.as_ref().map(|(x, v)| (&x[..], &v[..]));
        let place = match start {
            None => Place::Centred,
            Some(_) => Place::Reached,
        };
        let motion = self.started(&chain, start)?;
        let found = steady_state_soon(motion, self.omega, (ATTEMPTS, place))?;
        let ratios = |largest: Vec<f64>| largest.iter().map(|x| x / self.units.length).collect();
        Ok(found
            .map(|steady| self.settled(steady, chain))
            .map_err(ratios))
    }

    /// Starts a motion from a given state, or from rest if no state is given.
    pub(super) fn started(
        &self,
        chain: &Chain,
        state: Option<GivenState<'_>>,
    ) -> Result<Motion, JoinedError> {
        let Some((x, v)) = state else {
            return Ok(Motion::from_rest(chain)?.sharing(&self.tables));
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
        Ok(Motion::from(chain, &x, &v)?.sharing(&self.tables))
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
        state: GivenState<'_>,
    ) -> Result<JoinedSimulation<'a>, JoinedError> {
        let chain = self.chain(friction)?;
        let motion = self.started(&chain, Some(state))?;
        Ok(self.running(motion))
    }

    fn running(&self, motion: Motion) -> JoinedSimulation<'a> {
        JoinedSimulation::new(self.joined.clone(), motion, (self.omega, self.units))
    }

    /// Returns the state in which no contact slides, in closed form. The result contains the amplitude of each mass,
    /// the force in each contact, and the smallest friction for this state. The method assumes that no earlier motion
    /// has left a constant force in a contact.
    ///
    /// # Errors
    /// [`JoinedError::Resonance`] on an undamped resonance of the chain with its contacts stuck. [`JoinedError::NotLinear`]
    /// for a scene with stops, moving surfaces or constant forces.
    pub fn stuck(&self) -> Result<StuckState<'a>, JoinedError> {
        self.check_linear()?;
        let response = stuck_response(&self.chain(1.0)?).map_err(resonance)?;
        Ok(StuckState::new(self.joined.clone(), response, self.units))
    }

    fn check_linear(&self) -> Result<(), JoinedError> {
        if self.joined.scene().has_linear_states() {
            Ok(())
        } else {
            Err(JoinedError::NotLinear)
        }
    }

    /// Returns the response of the chain without friction, in closed form.
    ///
    /// # Errors
    /// [`JoinedError::Resonance`] on an undamped resonance of the chain. [`JoinedError::NotLinear`] for a scene with stops,
    /// moving surfaces or constant forces.
    pub fn linear(&self) -> Result<LinearResponse<'a>, JoinedError> {
        self.check_linear()?;
        let response = stuck_response(&self.chain(0.0)?).map_err(resonance)?;
        Ok(LinearResponse::new(
            self.joined.clone(),
            response.displacements,
            self.units,
        ))
    }
}

/// Returns the reason why there is no steady state if an orbit contains the last cycles of a motion.
fn settled(orbit: JoinedOrbit<'_>) -> Result<JoinedOrbit<'_>, JoinedError> {
    match orbit.is_settled() {
        true => Ok(orbit),
        false => Err(JointError::NotSteady.into()),
    }
}

/// Converts the error of a linear response. The frequency of a load in a scene is always valid. [`JointError::Number`]
/// therefore means a resonance.
fn resonance(error: JointError) -> JoinedError {
    match error {
        JointError::Number(_) => JoinedError::Resonance,
        other => other.into(),
    }
}
