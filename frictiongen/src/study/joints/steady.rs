//! Finds steady states (periodic motions) by the shooting method of the crate `frictiongen_kernel`.

use super::run::Motion;
use super::{Chain, Cycle, Heap, JointError, State};
use frictiongen_kernel::joints::{self, Observe};
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::orbit::NoDerivative;
use nalgebra::Complex;

pub use frictiongen_kernel::joints::{Approach, MAX_PERIOD, Place};

/// A steady state of a chain with several contacts: a motion that repeats after some cycles of the load.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Length of the period in cycles of the load.
    pub period: usize,
    /// The state at a maximum of the load, where the period begins.
    pub state: State,
    /// Number of independent displacements and constant velocities of parts of the chain that no path of springs
    /// connects to a support. The load does not determine them. In the steady state, they have the values that the
    /// preceding motion has reached.
    pub neutral: usize,
    /// Floquet multipliers over a period, in descending order of modulus. The list leaves out the multipliers 1 of
    /// contacts that never slide (`marginal`), and of parts of the chain without springs to a support (`neutral`).
    pub multipliers: Vec<Complex<f64>>,
    /// Indices of the contacts that do not slide during the period. The steady state depends on their positions, or on
    /// the constant forces in them.
    pub marginal: Vec<usize>,
    /// Amplitudes of the masses and results of the contacts over a period.
    pub cycle: Cycle,
    /// Largest difference between the states at the start and at the end of a period, divided by the size of the state.
    pub residual: f64,
    /// Relation of the steady state to the motion from which the search started.
    pub approach: Approach,
    /// The steady state as the type of the crate `frictiongen_kernel`.
    found: joints::Steady<f64, Heap>,
}

impl Steady {
    pub(super) fn new(found: joints::Steady<f64, Heap>) -> Self {
        let marginal = found.marginal.iter().enumerate();
        let marginal = marginal.filter(|(_, marginal)| **marginal);
        Self {
            period: found.period,
            state: found.state.clone(),
            neutral: found.neutral,
            multipliers: found.multipliers().to_vec(),
            marginal: marginal.map(|(j, _)| j).collect(),
            cycle: found.cycle.clone(),
            residual: found.residual,
            approach: found.approach,
            found,
        }
    }

    /// Returns the cycle of a motion without a load.
    pub(super) fn of_cycle(state: State, cycle: Cycle, size: &Heap) -> Self {
        Self::new(joints::Steady::of_cycle(state, cycle, size))
    }

    /// Computes the derivatives of this steady state, as [`joints::vary`] does.
    pub(in crate::study) fn vary(
        &self,
        model: joints::Model<Dual<f64>, Heap>,
        numbers: (Dual<f64>, f64),
        watch: &mut impl Observe<Dual<f64>, Heap>,
    ) -> Result<joints::Cycle<Dual<f64>, Heap>, NoDerivative> {
        joints::vary(model, numbers, &self.found, watch)
    }

    /// Returns true if every small deviation decays. The method ignores deviations of contacts that never slide
    /// (`marginal`), and of parts of the chain without springs to a support (`neutral`).
    pub fn is_stable(&self) -> bool {
        self.found.is_stable()
    }

    /// Returns true if the motion repeats with the opposite sign after half a period.
    ///
    /// # Errors
    ///
    /// [`JointError`] if the motion exceeds a bound of the solver.
    pub fn is_symmetric(&self, chain: &Chain, omega: f64) -> Result<bool, JointError> {
        let motion = Motion::from_rest(chain)?.into_engine();
        Ok(self.found.is_symmetric(motion, omega)?)
    }
}

/// Returns the steady state that a motion reaches, under loads of one frequency. If the motion does not settle, returns
/// another stable steady state or the last cycles of the motion. [`Steady::approach`] says which of these it is. If the
/// steady state is the only one, Newton's method starts from `near`, the steady state of a similar chain.
///
/// # Errors
///
/// [`JointError`] if the motion itself fails.
pub fn steady_state(
    motion: Motion,
    omega: f64,
    (place, near): (Place, Option<&Steady>),
) -> Result<Steady, JointError> {
    let near = near.map(|near| &near.found);
    let found = joints::settle_or_other(&motion.into_engine(), omega, place, near)?;
    Ok(Steady::new(found))
}

/// Returns the steady state that a motion reaches after few cycles, or the largest displacements of the masses in later
/// cycles. `attempts` and `place` are those of the engine's [`settle_soon`](joints::Motion::settle_soon).
///
/// # Errors
///
/// Other [`JointError`]s than [`JointError::NotSteady`] if the motion itself fails.
pub fn steady_state_soon(
    motion: Motion,
    omega: f64,
    (attempts, place): (usize, Place),
) -> Result<Result<Steady, Vec<f64>>, JointError> {
    let found = joints::settle_soon(&motion.into_engine(), omega, attempts, place)?;
    Ok(found
        .map(Steady::new)
        .map_err(|cycle| cycle.amplitudes.into_vec()))
}

/// Returns the steady states that Newton's method finds from a motion, stable or not: one that has the opposite sign half
/// a cycle later, and those with a period of one and of two cycles. `size` is that of the displacements.
pub fn steady_states_near(motion: &Motion, omega: f64, size: f64) -> Vec<Steady> {
    let motion = motion.clone().into_engine();
    let symmetric = joints::refine_symmetric(&motion, omega, size);
    let others = [1, 2].map(|period| joints::refine(&motion, omega, (period, size)));
    // A guess whose motion exceeds a bound leads to no state.
    let all = [symmetric].into_iter().chain(others);
    all.filter_map(|found| found.ok().flatten())
        .map(Steady::new)
        .collect()
}

/// Returns the mirror image of a steady state: the motion half a cycle later, with the opposite sign. Returns `None` if
/// the loads or the chain permit no such motion.
pub fn mirror_image(chain: &Chain, omega: f64, of: &Steady) -> Option<Steady> {
    let mut motion = Motion::from_rest(chain).ok()?;
    motion.restart(of.state.clone());
    let mirrored = motion.into_engine().mirrored(omega).ok()??;
    let size = of.cycle.amplitudes.iter().copied().fold(0.0, f64::max);
    let found = joints::refine(&mirrored, omega, (of.period, size)).ok()??;
    Some(Steady::new(found))
}
