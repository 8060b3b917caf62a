//! Newton's method that finds a periodic motion of a chain with several contacts.

use super::cycle::Watch;
use super::least::{solve, sort_by};
use super::model::{Contact, Model};
use super::neutral::neutral;
use super::run::Motion;
use super::size::{Size, set};
use super::slid::Slips;
use super::state::FREE;
use super::steady::{Approach, Search, Steady, from_one, modulus};
use super::tangent::{Both, ShotSpan};
use super::unknowns::Unknowns;
use crate::errors::Halt;
use crate::number::complex::{Complex, mul};
use crate::number::matrix::SquareMatrix;
use crate::{Float, Scalar};

/// Largest number of Newton steps in one attempt to find a periodic motion. A step computes the derivatives, or uses
/// those of the previous step.
const STEPS: usize = 24;
/// Largest ratio of the residual after a Newton step to the residual before, at which the next step uses the same
/// derivatives. At a larger ratio, the next step computes new derivatives.
const SLOW: f64 = 1e-2;
/// Number of shots in a row that end in other phases than they begin, after which a motion that repeats has an event at
/// the start of its period. Rounding then decides the phases there.
const TURNS: usize = 2;
/// Residual (non-dimensional change of the state in a period) above which the next Newton step computes the
/// derivatives together with the motion.
const FAR: f64 = 1e-4;

impl<S: Float, Z: Size> Search<S, Z> {
    /// Returns the conversion between states of the motion and unknowns of the search.
    pub(super) fn unknowns(&self) -> Unknowns<'_, S, Z> {
        let rate = S::constant(core::f64::consts::TAU) / self.cycle;
        Unknowns {
            place: self.place,
            speed: self.place * rate,
            moving: &self.moving,
        }
    }

    /// Searches for a periodic motion near a given state by Newton's method.
    ///
    /// Over half a cycle, the positions of all contacts are unknowns. A contact that never slides then ends in the
    /// middle of the interval in which it can stick, and a chain without a support about its mean place. Over whole
    /// cycles, a contact that never slides keeps its position.
    pub(super) fn newton(
        &mut self,
        motion: &Motion<S, Z>,
        span: ShotSpan,
    ) -> Result<Option<Steady<S, Z>>, Halt> {
        let (slow, far, half) = (S::constant(SLOW), S::constant(FAR), S::constant(0.5));
        let same = self.tolerances.same;
        let exact = S::constant(16.0 * S::EPSILON);
        if span == ShotSpan::Half {
            self.moving = motion.model().size.contacts(true);
        }
        let mut start = motion.clone();
        let mut before = S::constant(f64::INFINITY);
        let mut known: Option<Z::Square<S>> = None;
        let mut is_new = true;
        let mut turns = 0;
        for _ in 0..STEPS {
            let derives = known.is_none() || before > far;
            let shot = match self.shoot(&start, span, derives) {
                Ok(shot) => shot,
                // A step may lead to a state whose motion exceeds a bound, although the motion before the step does not.
                Err(_) if before.is_finite() => return Ok(None),
                Err(halt) => return Err(halt),
            };
            if span != ShotSpan::Half && shot.moving != self.moving {
                (self.moving, known) = (shot.moving, None);
            }
            let from = self.unknowns().read(&start);
            let to = self.unknowns().read(&shot.end);
            let residual = residual(&start, &shot.end, (&from, &to));
            let is_close = residual <= S::constant(50.0) * same;
            let has_turned = shot.end.state().phases != start.state().phases;
            turns = if has_turned { turns + 1 } else { 0 };
            if has_turned && !(turns > TURNS && is_close) {
                start = shot.end;
                continue;
            }
            let stops = is_new && residual >= half * before && is_close;
            let found = residual <= exact || stops || has_turned;
            // The code uses the derivatives of an earlier step as long as the residual falls quickly.
            let kept = known.take().filter(|_| !found && residual <= slow * before);
            is_new = kept.is_none() || shot.derivatives.is_some();
            let mut matrix = match shot.derivatives.or(kept) {
                Some(matrix) => matrix,
                None => match self.shoot(&start, span, true)?.derivatives {
                    Some(matrix) => matrix,
                    None => return Ok(None),
                },
            };
            if found {
                return self.found(start, &mut matrix, span).map(Some);
            }
            before = residual;
            let moved = self.step(start.model(), (&matrix, span), (&from, &to));
            if moved.as_ref().iter().any(|value| !value.is_finite()) {
                return Ok(None);
            }
            start = self.unknowns().write(&start, &moved);
            known = Some(matrix);
        }
        Ok(None)
    }

    /// Returns the unknowns after a step of Newton's method. `from` contains the unknowns at the start of a shot, and
    /// `to` those at its end. `matrix` contains the derivatives of `to` with respect to `from`.
    fn step(
        &self,
        model: &Model<S, Z>,
        (matrix, span): (&Z::Square<S>, ShotSpan),
        (from, to): (&Z::Unknowns<S>, &Z::Unknowns<S>),
    ) -> Z::Unknowns<S> {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let mut difference = to.clone();
        for (to, from) in difference.as_mut().iter_mut().zip(from.as_ref()) {
            *to = *to - *from;
        }
        let count = from.as_ref().len();
        let mut moved = difference.clone();
        let mut work = matrix.clone();
        // Over half a cycle no direction is neutral.
        let is_solved = span == ShotSpan::Half
            && SquareMatrix::new(work.as_mut(), count).solve_shifted(one, moved.as_mut());
        if !is_solved {
            let (mut work, mut turns) = (matrix.clone(), model.size.square(zero));
            subtract_from_one(work.as_mut(), count);
            let (rank, difference) = (self.tolerances.rank, difference.as_ref());
            solve(
                work.as_mut(),
                turns.as_mut(),
                difference,
                rank,
                moved.as_mut(),
            );
        }
        for (to, from) in moved.as_mut().iter_mut().zip(from.as_ref()) {
            *to = *from + *to;
        }
        moved
    }

    /// Returns the steady state that belongs to a periodic motion. `matrix` contains the derivatives of a shot. The
    /// function overwrites it.
    pub(super) fn found(
        &mut self,
        start: Motion<S, Z>,
        matrix: &mut Z::Square<S>,
        span: ShotSpan,
    ) -> Result<Steady<S, Z>, Halt> {
        let period = span.period();
        let from = self.unknowns().read(&start);
        let mut watch = Watch::new(start.model());
        let mut slips = Slips::new(start.model());
        let mut end = start.clone();
        self.pass(&mut end, span, &mut Both(&mut slips, &mut watch))?;
        watch.close(&start.state().phases, &end.state().phases);
        let to = self.unknowns().read(&end);
        let residual = residual(&start, &end, (&from, &to));
        self.moving = slips.slides(start.model());
        let model = start.model();
        let zero = S::constant(0.0);
        let mut multipliers = model.size.unknowns(Complex::new(zero, zero));
        let count = multipliers.as_ref().len();
        self.fix(matrix.as_mut(), 2 * model.wall(), count);
        SquareMatrix::new(matrix.as_mut(), count).eigenvalues(multipliers.as_mut());
        if span == ShotSpan::Half {
            for multiplier in multipliers.as_mut() {
                *multiplier = mul(*multiplier, *multiplier, true);
            }
        }
        let moving = self.moving.as_ref();
        let neutral = neutral(model, |j| moving.get(j) == Some(&false));
        // A part of the chain without a support gives a double multiplier 1, for its position and its velocity. Rounding
        // splits the double multiplier into two multipliers close to 1.
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
            *marginal = !*moves && start.state().phase(j) != FREE && !model.is_stop(j);
        }
        Ok(Steady {
            period,
            state: start.state().clone(),
            neutral,
            multipliers,
            count,
            marginal,
            cycle: match span {
                ShotSpan::Half => watch.half_cycle(self.length(period)),
                ShotSpan::Cycles(_) => watch.cycle(self.length(period)),
            },
            residual,
            approach: Approach::Reached,
        })
    }

    /// Removes the positions of contacts that never slide from the derivatives. `first` is the index of the first
    /// contact's position among the `count` unknowns.
    fn fix(&self, matrix: &mut [S], first: usize, count: usize) {
        for (column, entries) in matrix.chunks_exact_mut(count.max(1)).enumerate() {
            for (row, entry) in entries.iter_mut().enumerate() {
                let fixed = |index: usize| index >= first && !self.unknowns().moves(index - first);
                if fixed(row) || fixed(column) {
                    *entry = S::constant(0.0);
                }
            }
        }
    }
}

/// Returns the largest difference between the unknowns at the start and at the end of a shot. A rigid contact whose phase
/// differs there has its event at this instant, so that its place is an unknown at one end only.
fn residual<S: Float, Z: Size>(
    start: &Motion<S, Z>,
    end: &Motion<S, Z>,
    (from, to): (&Z::Unknowns<S>, &Z::Unknowns<S>),
) -> S {
    let model = start.model();
    let differs = |j: usize| start.state().phase(j) != end.state().phase(j);
    let is_one_sided = |index: usize| {
        let contact = index.checked_sub(2 * model.wall());
        contact.is_some_and(|j| differs(j) && model.contact(j).is_some_and(Contact::is_rigid))
    };
    let pairs = from.as_ref().iter().zip(to.as_ref()).enumerate();
    let pairs = pairs.filter(|(index, _)| !is_one_sided(*index));
    pairs.fold(S::constant(0.0), |most, (_, (from, to))| {
        Scalar::max(most, (*to - *from).abs())
    })
}

/// Replaces a matrix M by 1 − M, where 1 is the unit matrix.
fn subtract_from_one<S: Float>(matrix: &mut [S], size: usize) {
    for (index, entry) in matrix.iter_mut().enumerate() {
        let diagonal = size > 0 && index / size == index % size;
        *entry = S::whole(usize::from(diagonal)) - *entry;
    }
}
