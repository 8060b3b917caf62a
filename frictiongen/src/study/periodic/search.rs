//! Finds a state that repeats: the search follows the motion from rest and applies Newton's method.

use super::PeriodicRequest;
use super::answer::PeriodicState;
use super::error::PeriodicError;
use super::walk::{FixedPoint, StateNumbers, StepState, Walk};
use crate::study::System;
use nalgebra::{Complex, DMatrix, DVector};

/// Number of periods of the load that the search follows from rest before its first attempt. Each further attempt
/// follows twice as many periods.
const WARM: usize = 8;
/// Number of attempts to find a state that repeats.
const ATTEMPTS: usize = 9;
/// Largest period of the motion, in periods of the load.
const MOST_PERIODS: usize = 64;
/// Largest distance from an earlier state at which the code treats the motion as nearly back in that state. The
/// distance is divided by the largest distance from that state. The search then tries the number of periods between the
/// two states.
const NEARLY: f64 = 0.02;
/// Largest number of steps of Newton's method in one attempt.
const NEWTON: usize = 14;
/// Largest relative difference at which two states one period apart are treated as equal.
const SAME: f64 = 1e-13;
/// Largest relative difference after a period at which Newton's method may end, if its last step has not halved the
/// difference.
const ENOUGH: f64 = 1e-11;
/// Step of the central differences, divided by the size of the motion. The relative error of the differences is about
/// the square of this step.
const STEP: f64 = 1e-5;
/// Largest singular value of I − A in a neutral direction, where A is the matrix of the derivatives over a period. A
/// deviation along a neutral direction does not change over a period, and Newton's method ignores this direction.
const RANK: f64 = 1e-7;
/// Largest distance of a Floquet multiplier from the unit circle at which the multiplier is treated as lying on the
/// circle. The code computes the multipliers from differences, which have rounding errors.
const ON_CIRCLE: f64 = 1e-7;
/// Fraction of the motion's distance from a steady state that determines the length of a test. The test ends when the
/// Floquet multipliers predict that the distance has fallen to this fraction.
const DECAY: f64 = 0.1;
/// Largest number of periods of the load over which the search tests a steady state.
const MOST_CONFIRMED: usize = 512;
/// Largest distance from a steady state at which the code treats the steady state as reached, divided by the size of
/// the motion.
const REACHED: f64 = 1e-7;
/// Largest distance from a steady state in a continuum at which the code treats this steady state as reached, divided
/// by the size of the motion. In a continuum, the initial state decides in which steady state the motion ends.
const SETTLED: f64 = 1e-10;

/// Returns the steady state in which the motion from rest ends.
pub(super) fn steady(
    system: &System,
    request: &PeriodicRequest,
) -> Result<PeriodicState, PeriodicError> {
    if let Some(of) = request.of.iter().find(|of| !system.has_motion(**of)) {
        return Err(PeriodicError::NoSuchMotion(*of));
    }
    let load = request.load.sampled(system)?;
    let mut search = PeriodicSearch {
        walk: Walk::new(system, &load, request.friction)?,
        size: 0.0,
    };
    let mut periods = WARM;
    for _ in 0..ATTEMPTS {
        search.walk.periods(periods)?;
        search.walk.reach_quiet()?;
        for period in search.periods(periods)? {
            if let Some(fixed) = search.newton(period)?
                && fixed.largest() < 1.0 + ON_CIRCLE
                && search.approaches(&fixed)?
            {
                search.walk.go(&fixed.place)?;
                return PeriodicState::of(&mut search.walk, &load, &fixed, &request.of);
            }
        }
        periods *= 2;
    }
    Err(PeriodicError::NotSteady)
}

struct PeriodicSearch<'a> {
    walk: Walk<'a>,
    /// Size of the motion: the largest absolute number of its state at the start of a period.
    size: f64,
}

impl PeriodicSearch<'_> {
    /// Returns the numbers of load periods after which the motion may repeat. The first number is 1. A second number
    /// exists if the motion comes close to its present state again after more than one period. At the end the function
    /// restores the present state.
    fn periods(&mut self, most: usize) -> Result<Vec<usize>, PeriodicError> {
        let here = self.walk.place();
        let first = self.walk.numbers();
        self.size = first.size();
        let mut aways = Vec::new();
        for _ in 0..most.min(MOST_PERIODS) {
            self.walk.periods(1)?;
            let numbers = self.walk.numbers();
            self.size = self.size.max(numbers.size());
            aways.push(numbers.away(&first));
        }
        self.walk.go(&here)?;
        // If the motion has not begun, its size is 0. Any positive size then gives the same result, and the code uses
        // 1.
        if self.size == 0.0 {
            self.size = 1.0;
        }
        let finite = aways.iter().copied().filter(|away| away.is_finite());
        let widest = finite.fold(0.0, f64::max);
        let near = |away: &f64| *away <= NEARLY * widest;
        let several = aways.iter().skip(1).position(near).map(|place| place + 2);
        Ok(std::iter::once(1).chain(several).collect())
    }

    /// Searches near the present state for a state that repeats after `period` periods of the load. At the end the
    /// function restores the present state.
    fn newton(&mut self, period: usize) -> Result<Option<FixedPoint>, PeriodicError> {
        let here = self.walk.place();
        let found = self.newton_from(here.clone(), period);
        self.walk.go(&here)?;
        found
    }

    fn newton_from(
        &mut self,
        mut start: StepState,
        period: usize,
    ) -> Result<Option<FixedPoint>, PeriodicError> {
        let mut before = f64::INFINITY;
        for _ in 0..NEWTON {
            self.walk.go(&start)?;
            let from = self.walk.numbers();
            self.walk.periods(period)?;
            let to = self.walk.numbers();
            let away = to.away(&from);
            if !away.is_finite() {
                start = self.walk.place();
                continue;
            }
            let residual = away / self.size;
            let Some(matrix) = self.differences(&start, &from, period)? else {
                return Ok(None);
            };
            if residual <= SAME || (residual <= ENOUGH && 0.5 * before <= residual) {
                let mut multipliers: Vec<Complex<f64>> =
                    matrix.complex_eigenvalues().iter().copied().collect();
                multipliers.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
                return Ok(Some(FixedPoint {
                    place: start,
                    numbers: from,
                    period,
                    multipliers,
                    residual,
                }));
            }
            before = residual;
            let count = from.values.len();
            let change = to
                .values
                .iter()
                .zip(&from.values)
                .map(|(to, from)| to - from);
            let change = DVector::from_iterator(count, change);
            let system = DMatrix::identity(count, count) - matrix;
            let Ok(step) = system.svd(true, true).solve(&change, RANK) else {
                return Ok(None);
            };
            self.walk.go(&start)?;
            self.walk.add(step.as_slice());
            start = self.walk.place();
        }
        Ok(None)
    }

    /// Returns the derivatives of the state after a period with respect to the state before the period, by central
    /// differences. Returns `None` if a small change of the initial state changes the state of the contact (stuck, or
    /// its direction of sliding) at the end of the period.
    fn differences(
        &mut self,
        start: &StepState,
        from: &StateNumbers,
        period: usize,
    ) -> Result<Option<DMatrix<f64>>, PeriodicError> {
        let count = from.values.len();
        let step = STEP * self.size;
        let mut matrix = DMatrix::zeros(count, count);
        for column in 0..count {
            let mut after = |side: f64| {
                self.walk.go(start)?;
                let mut changes = vec![0.0; count];
                if let Some(change) = changes.get_mut(column) {
                    *change = side * step;
                }
                self.walk.add(&changes);
                self.walk.periods(period)?;
                Ok::<StateNumbers, PeriodicError>(self.walk.numbers())
            };
            let (above, below) = (after(1.0)?, after(-1.0)?);
            let alike = |numbers: &StateNumbers| numbers.contact == from.contact;
            if !(alike(&above) && alike(&below)) {
                return Ok(None);
            }
            let pairs = above.values.iter().zip(&below.values);
            let slopes = pairs.map(|(above, below)| (above - below) / (step + step));
            matrix.set_column(column, &DVector::from_iterator(count, slopes));
        }
        Ok(Some(matrix))
    }

    /// Returns true if the motion has reached a steady state, or if its distance from the state falls at least half as
    /// much as the Floquet multipliers predict. With a multiplier on the unit circle, only a motion that has reached
    /// the state counts. The function may advance the motion.
    fn approaches(&mut self, fixed: &FixedPoint) -> Result<bool, PeriodicError> {
        let rate = fixed.largest();
        if 1.0 - ON_CIRCLE <= rate {
            let away = self.walk.numbers().away(&fixed.numbers);
            return Ok(away <= SETTLED * self.size);
        }
        let count = DECAY.ln() / rate.max(DECAY).ln();
        let most = (MOST_CONFIRMED / fixed.period).max(1);
        let count = (count.ceil() as usize).clamp(1, most);
        let before = self.walk.numbers().away(&fixed.numbers);
        self.walk.periods(count * fixed.period)?;
        let after = self.walk.numbers().away(&fixed.numbers);
        let expected = rate.powf(count as f64).max(DECAY);
        Ok(after <= REACHED * self.size || after <= 0.5 * (1.0 + expected) * before)
    }
}
