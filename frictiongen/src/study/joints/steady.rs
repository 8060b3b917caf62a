//! Steady states: periodic motions, by shooting. The kernel has the search.

use super::run::Motion;
use super::{Chain, Cycle, Heap, JointError, State};
use frictiongen_kernel::joints;
use nalgebra::Complex;

pub use frictiongen_kernel::joints::MAX_PERIOD;

/// A periodic motion.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Length of the period in cycles of the load.
    pub period: usize,
    /// The state at a maximum of the load.
    pub state: State,
    /// Number of displacements and velocities of parts that nothing holds. The steady state keeps the values that the
    /// motion from rest has reached.
    pub neutral: usize,
    /// Floquet multipliers of a period, largest first. The multipliers of 1 that belong to `marginal` and `neutral` are
    /// left out.
    pub multipliers: Vec<Complex<f64>>,
    /// The contacts that do not slide in the period. The steady state depends on their place, or on the force that the
    /// past left in them.
    pub marginal: Vec<usize>,
    /// Amplitudes of the masses and results of the contacts over a period.
    pub cycle: Cycle,
    /// Largest difference after a period, relative to the size of the state.
    pub residual: f64,
    /// The result of the search.
    found: joints::Steady<f64, Heap>,
}

impl Steady {
    /// Returns true if every small change dies out, except for changes of `marginal` and `neutral`.
    pub fn is_stable(&self) -> bool {
        self.found.is_stable()
    }

    /// Returns true if the motion repeats with the opposite sign after half a period.
    ///
    /// # Errors
    ///
    /// Those of a motion.
    pub fn is_symmetric(&self, chain: &Chain, omega: f64) -> Result<bool, JointError> {
        let motion = Motion::from_rest(chain)?.into_engine();
        Ok(self.found.is_symmetric(motion, omega)?)
    }
}

/// Returns the steady state to which the motion from rest comes, under loads of one frequency.
///
/// # Errors
///
/// [`JointError::NotSteady`] if the motion does not settle on a period of at most [`MAX_PERIOD`] cycles within some
/// thousand cycles; and the errors of a motion.
pub fn steady_state(chain: &Chain, omega: f64) -> Result<Steady, JointError> {
    steady_state_of(Motion::from_rest(chain)?, omega)
}

/// Returns the steady state to which a motion comes, as [`steady_state`] does.
///
/// # Errors
///
/// Those of [`steady_state`].
pub fn steady_state_of(motion: Motion, omega: f64) -> Result<Steady, JointError> {
    let found = motion.into_engine().settle(omega)?;
    let found = found.ok_or(JointError::NotSteady)?;
    let marginal = found.marginal.iter().enumerate();
    let marginal = marginal.filter(|(_, marginal)| **marginal);
    Ok(Steady {
        period: found.period,
        state: found.state.clone(),
        neutral: found.neutral,
        multipliers: found.multipliers().to_vec(),
        marginal: marginal.map(|(j, _)| j).collect(),
        cycle: found.cycle.clone(),
        residual: found.residual,
        found,
    })
}
