//! Finds steady states, which are periodic motions, by the shooting method.
//!
//! The unknowns are displacements and velocities at a maximum of the load, and positions of contacts. For an elastic
//! contact, the position is that of its slider. For a rigid contact that sticks at this instant, it is the relative
//! displacement. If a contact does not slide in the period, its position stays constant and is not an unknown. The
//! steady state is then *marginal*: it depends on the position that the earlier motion has left.

use super::neutral::neutral;
use super::run::Motion;
use super::{Chain, Cycle, Heap, JointError, State, Watch};
use frictiongen_kernel::joints::{FREE, Observe, STUCK, at, set};
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// Number of cycles from rest before the first attempt.
const WARM: usize = 30;
/// Largest number of attempts. Each attempt follows after twice as many cycles as the previous one.
const ATTEMPTS: usize = 6;
/// Largest period of a steady state, in cycles of the load.
pub const MAX_PERIOD: usize = 64;
/// Largest number of Newton steps in an attempt.
const NEWTON: usize = 12;
/// Two states count as equal if their relative difference is below this value.
const SAME: f64 = 2e-13;
/// Step of the finite differences, relative to the size of the unknowns.
const STEP: f64 = 1e-6;

/// A direction counts as neutral (without any effect on forces) if its singular value is below this value.
const RANK: f64 = 1e-7;
/// A multiplier may belong to a neutral direction if its distance from 1 is at most this value.
const SPLIT: f64 = 1e-3;

/// The test of a periodic motion ends when the multipliers predict that the motion's distance from it has fallen to
/// this fraction.
const DECAY: f64 = 1e-3;
/// Largest number of cycles that this test follows.
const MAX_CONFIRM: usize = 256;
/// The search accepts a periodic motion at once if the distance of the motion from it is below this value.
const CLOSE: f64 = 1e-9;

/// A steady state: a motion that repeats after some cycles of the load.
#[derive(Clone, Debug)]
pub struct Steady {
    /// Length of the period in cycles of the load.
    pub period: usize,
    /// The state at a maximum of the load, where the period begins.
    pub state: State,
    /// Number of independent displacements and velocities of parts without a support. The steady state has the values
    /// that the motion from rest has reached.
    pub neutral: usize,
    /// Floquet multipliers of a period, in descending order of modulus. The list omits the multipliers 1 that belong to
    /// `marginal` and `neutral`.
    pub multipliers: Vec<Complex<f64>>,
    /// Indices of the contacts that do not slide in the period. The steady state depends on their positions, or on the
    /// constant forces in them.
    pub marginal: Vec<usize>,
    /// Amplitudes of the masses and results of the contacts over a period.
    pub cycle: Cycle,
    /// Largest difference between the states at the start and at the end of a period, relative to the size of the
    /// state.
    pub residual: f64,
}

impl Steady {
    /// Returns true if every small deviation decays, except deviations that belong to `marginal` and `neutral`.
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|m| m.norm() < 1.0 - 1e-9)
    }
}

/// Returns the steady state that the motion from rest reaches, under loads of one frequency.
///
/// # Errors
///
/// [`JointError::NotSteady`] if the motion does not settle on a period of at most [`MAX_PERIOD`] cycles within some
/// thousand cycles. Other [`JointError`]s if the motion itself fails.
pub fn steady_state(chain: &Chain, omega: f64) -> Result<Steady, JointError> {
    steady_state_of(Motion::from_rest(chain)?, omega)
}

/// Returns the steady state that a given motion reaches, as [`steady_state`] does for the motion from rest.
///
/// # Errors
///
/// Same errors as [`steady_state`].
pub fn steady_state_of(mut motion: Motion, omega: f64) -> Result<Steady, JointError> {
    let mut shooting = Shooting {
        cycle: TAU / omega,
        sizes: Vec::new(),
        moving: Vec::new(),
    };
    let mut cycles = WARM;
    for _ in 0..ATTEMPTS {
        let period = shooting.settle(&mut motion, cycles)?;
        for period in [Some(1), period.filter(|&period| period > 1)]
            .into_iter()
            .flatten()
        {
            if let Some(steady) = shooting.newton(&motion, period)?
                && steady.is_stable()
                && shooting.confirm(&mut motion, &steady)?
            {
                return shooting.about_its_mean(&motion, steady);
            }
        }
        cycles *= 2;
    }
    Err(JointError::NotSteady)
}

/// Search for a periodic motion by the shooting method.
struct Shooting {
    /// Duration of a cycle of the load.
    cycle: f64,
    /// Size of each unknown, by which the search divides differences.
    sizes: Vec<f64>,
    /// For each contact, true if it slides in a period.
    moving: Vec<bool>,
}

impl Shooting {
    /// Advances the motion by a number of cycles. Returns the shortest period after which the last states repeat, if
    /// there is one.
    fn settle(&mut self, motion: &mut Motion, cycles: usize) -> Result<Option<usize>, JointError> {
        let mut states: Vec<State> = Vec::new();
        let mut watch = Watch::new(motion.model());
        for cycle in 0..cycles {
            watch = Watch::new(motion.model());
            self.advance(motion, 1, &mut watch)?;
            if cycle + 2 * MAX_PERIOD > cycles {
                states.push(motion.state().clone());
            }
        }
        let place = watch.cycle(self.cycle).amplitudes;
        let place = place.into_iter().fold(0.0, f64::max);
        // Where nothing moves, any size will do.
        let place = if place > 0.0 { place } else { 1.0 };
        let speed = place * TAU / self.cycle;
        let masses = motion.state().x.len();
        let contacts = motion.state().phases.len();
        self.sizes = vec![place; masses];
        self.sizes.extend(vec![speed; masses]);
        self.sizes.extend(vec![place; 2 * contacts]);
        let Some(last) = states.last() else {
            return Ok(None);
        };
        let away = |state: &State| {
            let places = state
                .x
                .iter()
                .zip(&last.x)
                .map(|(a, b)| (a - b).abs() / place);
            let speeds = state
                .v
                .iter()
                .zip(&last.v)
                .map(|(a, b)| (a - b).abs() / speed);
            places.chain(speeds).fold(0.0, f64::max)
        };
        let aways: Vec<f64> = states
            .iter()
            .rev()
            .skip(1)
            .take(MAX_PERIOD)
            .map(away)
            .collect();
        let most = aways.iter().copied().fold(0.0, f64::max);
        Ok(aways
            .iter()
            .position(|&away| away <= 0.02 * most)
            .map(|place| place + 1))
    }

    /// Advances the motion by a number of cycles, from a maximum of the load. The time of this maximum becomes 0.
    fn advance(
        &self,
        motion: &mut Motion,
        cycles: usize,
        watch: &mut impl Observe<f64, Heap>,
    ) -> Result<(), JointError> {
        for _ in 0..cycles {
            let state = motion.state().clone();
            motion.restart(state);
            motion.run_with(self.cycle, watch)?;
        }
        Ok(())
    }

    /// Subtracts the constant velocities of masses without a support from their displacements.
    fn about_its_mean(&self, motion: &Motion, mut steady: Steady) -> Result<Steady, JointError> {
        if steady.neutral == 0 {
            return Ok(steady);
        }
        let length = steady.period as f64 * self.cycle;
        let mut motion = motion.clone();
        motion.restart(steady.state.clone());
        let start = motion.state().x.clone();
        let mut end = motion.clone();
        self.advance(&mut end, steady.period, &mut ())?;
        let ends = end.state().x.iter().zip(&start);
        let drifts = ends.map(|(end, start)| (end - start) / length).collect();
        let mut watch = Watch::drifting(motion.model(), drifts);
        self.advance(&mut motion, steady.period, &mut watch)?;
        steady.cycle.centred = watch.cycle(length).centred;
        Ok(steady)
    }

    /// Returns true if the motion approaches a periodic motion as fast as its multipliers predict. A contact that has not
    /// slid for some cycles may slide again while the motion settles.
    fn confirm(&self, motion: &mut Motion, steady: &Steady) -> Result<bool, JointError> {
        let rate = steady.multipliers.first().map_or(0.0, |m| m.norm());
        let periods = (DECAY.ln() / rate.max(DECAY).ln()).ceil() as usize;
        let periods = periods.clamp(1, (MAX_CONFIRM / steady.period).max(1));
        let expected = rate.powf(periods as f64).max(DECAY);
        let before = self.away(motion.state(), steady);
        let mut watch = Watch::new(motion.model());
        self.advance(motion, periods * steady.period, &mut watch)?;
        let slides = watch.slides();
        if steady
            .marginal
            .iter()
            .any(|&j| slides.get(j) == Some(&true))
        {
            return Ok(false);
        }
        let after = self.away(motion.state(), steady);
        Ok(after <= CLOSE || after <= 0.5 * (1.0 + expected) * before)
    }

    /// Returns the largest difference between a state and a periodic motion, relative to the sizes of the unknowns. For
    /// parts that can move without a force, only the velocities count.
    fn away(&self, state: &State, steady: &Steady) -> f64 {
        let masses = state.x.len();
        let of = |state: &State| -> Vec<f64> { state.x.iter().chain(&state.v).copied().collect() };
        let (a, b) = (of(state), of(&steady.state));
        let differences = a.iter().zip(&b).zip(&self.sizes);
        let differences = differences.map(|((a, b), size)| (a - b).abs() / size);
        let first = if steady.neutral > 0 { masses } else { 0 };
        differences.skip(first).fold(0.0, f64::max)
    }

    /// Returns the unknowns of a state: all displacements and velocities, and the position of each contact that slides
    /// in a period.
    fn unknowns(&self, motion: &Motion) -> DVector<f64> {
        let state = motion.state();
        let mut unknowns: Vec<f64> = state.x.iter().chain(&state.v).copied().collect();
        for (j, contact) in motion.model().contacts.iter().enumerate() {
            let moves = self.moving.get(j) == Some(&true);
            let sticks = state.phase(j) == STUCK;
            let place = motion.relative(j).1;
            let slider = contact.stiffness.map(|k| place - at(&state.forces, j) / k);
            unknowns.push(if moves { slider.unwrap_or(0.0) } else { 0.0 });
            unknowns.push(if moves && sticks && slider.is_none() {
                place
            } else {
                0.0
            });
        }
        let sized = unknowns
            .iter()
            .zip(&self.sizes)
            .map(|(value, size)| value / size);
        DVector::from_iterator(unknowns.len(), sized)
    }

    /// Returns a motion that starts with the given unknowns. Contacts that do not slide keep their positions.
    fn with(&self, motion: &Motion, unknowns: &DVector<f64>) -> Motion {
        let mut moved = motion.clone();
        let mut state = motion.state().clone();
        let values: Vec<f64> = unknowns
            .iter()
            .zip(&self.sizes)
            .map(|(u, size)| u * size)
            .collect();
        let masses = state.x.len();
        state.x = values.iter().take(masses).copied().collect();
        state.v = values.iter().skip(masses).take(masses).copied().collect();
        let own = |j: usize, which: usize| at(&values, 2 * masses + 2 * j + which);
        let contacts = motion.model().contacts.iter().enumerate();
        let moves = |j: &usize| self.moving.get(*j) == Some(&true);
        for (j, _) in contacts
            .clone()
            .filter(|(j, contact)| moves(j) && contact.is_rigid())
        {
            set(&mut state.places, j, own(j, 1));
        }
        moved.restart(state.clone());
        let mut state = moved.state().clone();
        for (j, contact) in contacts {
            let Some(stiffness) = contact.stiffness else {
                continue;
            };
            let slider = if moves(&j) {
                own(j, 0)
            } else {
                motion.relative(j).1 - at(&motion.state().forces, j) / stiffness
            };
            let force = stiffness * (moved.relative(j).1 - slider);
            let most = contact.stiction * contact.level.constant;
            let force = match state.phase(j) {
                FREE => 0.0,
                STUCK => force.clamp(-most, most),
                side => f64::from(side) * contact.level.constant,
            };
            set(&mut state.forces, j, force);
        }
        moved.restart(state);
        moved
    }

    /// Searches for a periodic motion near a state by Newton's method.
    fn newton(&mut self, motion: &Motion, period: usize) -> Result<Option<Steady>, JointError> {
        let mut start = motion.clone();
        let mut before = f64::INFINITY;
        for _ in 0..NEWTON {
            let mut watch = Watch::new(motion.model());
            let mut end = start.clone();
            self.advance(&mut end, period, &mut watch)?;
            self.moving.clone_from(watch.slides());
            if end.state().phases != start.state().phases {
                start = end;
                continue;
            }
            let (from, to) = (self.unknowns(&start), self.unknowns(&end));
            let residual = (&to - &from).amax();
            let matrix = match self.derivatives(&start, &to, period) {
                Ok(matrix) => matrix,
                Err(_) => return Ok(None),
            };
            if residual <= SAME || residual >= 0.5 * before && residual <= 50.0 * SAME {
                return Ok(Some(self.found(&start, matrix, (period, residual), watch)));
            }
            before = residual;
            let count = from.len();
            let system = DMatrix::identity(count, count) - &matrix;
            let Ok(step) = system.svd(true, true).solve(&(&to - &from), RANK) else {
                return Ok(None);
            };
            start = self.with(&start, &(&from + step));
        }
        Ok(None)
    }

    /// Returns the derivatives of the unknowns after a period with respect to the unknowns before it.
    fn derivatives(
        &self,
        start: &Motion,
        to: &DVector<f64>,
        period: usize,
    ) -> Result<DMatrix<f64>, JointError> {
        let from = self.unknowns(start);
        let mut matrix = DMatrix::zeros(from.len(), from.len());
        for column in 0..from.len() {
            let mut moved = from.clone();
            if let Some(value) = moved.get_mut(column) {
                *value += STEP;
            }
            let mut end = self.with(start, &moved);
            self.advance(&mut end, period, &mut ())?;
            matrix.set_column(column, &((self.unknowns(&end) - to) / STEP));
        }
        Ok(matrix)
    }

    /// Returns the steady state that belongs to a periodic motion.
    fn found(
        &self,
        start: &Motion,
        matrix: DMatrix<f64>,
        (period, residual): (usize, f64),
        watch: Watch,
    ) -> Steady {
        let mut multipliers: Vec<Complex<f64>> =
            matrix.complex_eigenvalues().iter().copied().collect();
        let keeps = |j: usize| self.moving.get(j) == Some(&false);
        let neutral = neutral(start.model(), keeps);
        // Place and velocity of a free part are a double root, which the differences split.
        multipliers.sort_by(|a, b| (a - 1.0).norm().total_cmp(&(b - 1.0).norm()));
        let ones = multipliers.iter().take(neutral);
        let ones = ones.filter(|m| (**m - 1.0).norm() < SPLIT).count();
        multipliers.drain(..ones);
        multipliers.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        let contacts = self.moving.iter().zip(&start.state().phases).enumerate();
        let marginal = contacts.filter(|(_, (moves, phase))| !**moves && **phase != FREE);
        Steady {
            period,
            state: start.state().clone(),
            neutral,
            multipliers,
            marginal: marginal.map(|(j, _)| j).collect(),
            cycle: watch.cycle(period as f64 * self.cycle),
            residual,
        }
    }
}
