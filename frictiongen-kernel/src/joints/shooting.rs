//! Newton's method that finds a periodic motion of a chain with several contacts.

use super::cycle::Watch;
use super::least::{apart, solve, sort_by};
use super::neutral::neutral;
use super::run::Motion;
use super::size::{Size, add, at, set};
use super::state::FREE;
use super::steady::{Search, Steady, from_one, modulus};
use super::unknowns::Unknowns;
use crate::Float;
use crate::errors::Halt;
use crate::number::complex::Complex;
use crate::number::matrix::SquareMatrix;

/// Largest number of Newton steps in one attempt to find a periodic motion.
const NEWTON: usize = 12;

impl<S: Float, Z: Size> Search<S, Z> {
    /// Returns the conversion between states of the motion and unknowns of the search.
    fn unknowns(&self) -> Unknowns<'_, S, Z> {
        let rate = S::constant(core::f64::consts::TAU) / self.cycle;
        Unknowns {
            place: self.place,
            speed: self.place * rate,
            moving: &self.moving,
        }
    }

    /// Searches for a periodic motion near a given state by Newton's method.
    pub(super) fn newton(
        &mut self,
        motion: &Motion<S, Z>,
        period: usize,
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let size = motion.model().size.clone();
        let (zero, half) = (S::constant(0.0), S::constant(0.5));
        let (same, rank) = (self.tolerances.same, self.tolerances.rank);
        let mut start = motion.clone();
        let mut before = S::constant(f64::INFINITY);
        for _ in 0..NEWTON {
            let mut watch = Watch::new(motion.model());
            let mut end = start.clone();
            self.advance(&mut end, period, &mut watch)?;
            self.moving = watch.slides(motion.model());
            if end.state().phases != start.state().phases {
                start = end;
                continue;
            }
            let from = self.unknowns().read(&start);
            let to = self.unknowns().read(&end);
            let residual = apart(to.as_ref(), from.as_ref());
            let Ok(mut matrix) = self.derivatives(&start, &to, period) else {
                return Ok(None);
            };
            let stops = residual >= half * before && residual <= S::constant(50.0) * same;
            if residual <= same || stops {
                let found = self.found(&start, &mut matrix, (period, residual), watch);
                return Ok(Some(found));
            }
            before = residual;
            subtract_from_one(matrix.as_mut(), from.as_ref().len());
            let mut difference = to;
            for (to, from) in difference.as_mut().iter_mut().zip(from.as_ref()) {
                *to = *to - *from;
            }
            let (mut turns, mut moved) = (size.square(zero), size.unknowns(zero));
            let known = difference.as_ref();
            solve(matrix.as_mut(), turns.as_mut(), known, rank, moved.as_mut());
            for (to, from) in moved.as_mut().iter_mut().zip(from.as_ref()) {
                *to = *from + *to;
            }
            if moved.as_ref().iter().any(|value| !value.is_finite()) {
                return Ok(None);
            }
            start = self.unknowns().write(&start, &moved);
        }
        Ok(None)
    }

    /// Returns the derivatives of the unknowns after a period with respect to the unknowns before the period. The
    /// matrix is stored column by column.
    fn derivatives(
        &self,
        start: &Motion<S, Z>,
        to: &Z::Unknowns<S>,
        period: usize,
    ) -> Result<Z::Square<S>, Halt> {
        let unknowns = self.unknowns();
        let step = self.tolerances.step;
        let from = unknowns.read(start);
        let mut matrix = start.model().size.square(S::constant(0.0));
        let size = from.as_ref().len().max(1);
        for (index, column) in matrix.as_mut().chunks_exact_mut(size).enumerate() {
            let mut moved = from.clone();
            add(moved.as_mut(), index, step);
            let mut end = unknowns.write(start, &moved);
            self.advance(&mut end, period, &mut ())?;
            let end = unknowns.read(&end);
            for (row, entry) in column.iter_mut().enumerate() {
                *entry = (at(end.as_ref(), row) - at(to.as_ref(), row)) / step;
            }
        }
        Ok(matrix)
    }

    /// Returns the steady state that belongs to a periodic motion. The function overwrites `matrix`.
    fn found(
        &self,
        start: &Motion<S, Z>,
        matrix: &mut Z::Square<S>,
        (period, residual): (usize, S),
        watch: Watch<S, Z>,
    ) -> Steady<S, Z> {
        let model = start.model();
        let zero = S::constant(0.0);
        let mut multipliers = model.size.unknowns(Complex::new(zero, zero));
        let count = multipliers.as_ref().len();
        SquareMatrix::new(matrix.as_mut(), count).eigenvalues(multipliers.as_mut());
        let moving = self.moving.as_ref();
        let neutral = neutral(model, |j| moving.get(j) == Some(&false));
        // The position and the velocity of a part without a support give a double multiplier 1. The finite differences
        // split it into two multipliers close to 1.
        let all = multipliers.as_mut();
        sort_by(all, from_one);
        let split = self.tolerances.split;
        let ones = all.iter().take(neutral).filter(|m| from_one(m) < split);
        let ones = ones.count();
        let count = count.saturating_sub(ones);
        for index in 0..count {
            if let Some(&kept) = all.get(index + ones) {
                set(all, index, kept);
            }
        }
        if let Some(kept) = all.get_mut(..count) {
            sort_by(kept, |m| -modulus(m));
        }
        let mut marginal = model.size.contacts(false);
        let contacts = marginal.as_mut().iter_mut().enumerate();
        for ((j, marginal), moves) in contacts.zip(moving) {
            *marginal = !*moves && start.state().phase(j) != FREE;
        }
        Steady {
            period,
            state: start.state().clone(),
            neutral,
            multipliers,
            count,
            marginal,
            cycle: watch.cycle(self.length(period)),
            residual,
        }
    }
}

/// Replaces a matrix M by 1 − M, where 1 is the unit matrix.
fn subtract_from_one<S: Float>(matrix: &mut [S], size: usize) {
    for (index, entry) in matrix.iter_mut().enumerate() {
        let diagonal = size > 0 && index / size == index % size;
        *entry = S::constant(f64::from(u8::from(diagonal))) - *entry;
    }
}
