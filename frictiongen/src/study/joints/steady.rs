//! Steady states: periodic motions, by shooting.
//!
//! The unknowns are displacements and velocities at a maximum of the load, the slider of each elastic contact, and the
//! place of each rigid contact that sticks there. A contact that does not slide in the period keeps its slider or its
//! place. These are then no unknowns: the steady state is *marginal*, it depends on what the motion before has left.

use super::neutral::neutral;
use super::run::Motion;
use super::{Chain, Cycle, Heap, JointError, State, Watch};
use frictiongen_kernel::joints::{FREE, Observe, STUCK, at, set};
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// Cycles from rest before the first attempt.
const WARM: usize = 30;
/// Attempts, with twice as many cycles before each.
const ATTEMPTS: usize = 6;
/// Largest period in cycles.
pub const MAX_PERIOD: usize = 64;
/// Newton's steps in an attempt.
const NEWTON: usize = 12;
/// Relative difference after a period that counts as none.
const SAME: f64 = 2e-13;
/// Step of the differences, relative to the size of the unknowns.
const STEP: f64 = 1e-6;

/// Singular values below which a direction counts as neutral.
const RANK: f64 = 1e-7;
/// Largest distance from 1 of a multiplier of a neutral direction.
const SPLIT: f64 = 1e-3;

/// Factor by which a difference must fall before a periodic motion is believed.
const DECAY: f64 = 1e-3;
/// Most cycles for that.
const MAX_CONFIRM: usize = 256;
/// Difference that is believed at once.
const CLOSE: f64 = 1e-9;

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
}

impl Steady {
    /// Returns true if every small change dies out, except for changes of `marginal` and `neutral`.
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|m| m.norm() < 1.0 - 1e-9)
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

/// Data of a search for a periodic motion.
struct Shooting {
    /// Length of a cycle of the load.
    cycle: f64,
    /// Size of each unknown.
    sizes: Vec<f64>,
    /// The contacts that slide in a period.
    moving: Vec<bool>,
}

impl Shooting {
    /// Runs some cycles. Returns the shortest period after which the last states come back, if there is one.
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

    /// Runs some cycles from a maximum of the load, where time starts anew.
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

    /// Takes the constant velocities of masses that nothing holds out of their displacements.
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

    /// Returns the largest difference from a periodic motion in the sizes of the unknowns. Where the chain may be moved
    /// as a whole, only velocities count.
    fn away(&self, state: &State, steady: &Steady) -> f64 {
        let masses = state.x.len();
        let of = |state: &State| -> Vec<f64> { state.x.iter().chain(&state.v).copied().collect() };
        let (a, b) = (of(state), of(&steady.state));
        let differences = a.iter().zip(&b).zip(&self.sizes);
        let differences = differences.map(|((a, b), size)| (a - b).abs() / size);
        let first = if steady.neutral > 0 { masses } else { 0 };
        differences.skip(first).fold(0.0, f64::max)
    }

    /// Returns the unknowns of a state: displacements, velocities, and for each contact that moves its slider or its
    /// place.
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

    /// Returns a motion that starts with given unknowns. Contacts that do not move keep what they have.
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

    /// Seeks a periodic motion near a state by Newton's method.
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

    /// Returns the derivatives of the unknowns after a period.
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

    /// Returns the result for a periodic motion.
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
