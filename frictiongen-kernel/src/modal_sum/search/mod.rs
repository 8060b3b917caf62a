//! The largest value of a modal sum over a half period, with a guarantee.
//!
//! The search covers the half period by grids. The interval between two nodes of a grid is a cell. In a cell, a cubic
//! and a bound on the fourth derivative give an upper bound on the sum. A cell is open while this bound exceeds the
//! largest value found. The search then evaluates a summit, a position from which one Newton step leads to a local
//! maximum. It divides the cells that remain open. At the end no value larger than the result times 1 + tolerance
//! exists, except for rounding (section 9 of `docs/derivation.md`).

mod about;
mod bounds;
mod cells;
mod grid;
mod neighbour;
mod peaks;
mod row;
mod summit;

pub use neighbour::Neighbour;

use crate::modal_sum::wave::Sum;
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// Upper bound on the evaluations of every search, whatever the scene. A grid of up to 32 nodes counts as two
/// evaluations. [`most_evaluations`] gives the smaller bound of a given scene, and `docs/evidence.md` has measured
/// numbers. A search that would need more ends with the best value that it has found.
pub const MAX_EVALUATIONS: u32 = 20_000;

/// Evaluations allowed to a search over sin τ, however slow the modes are. It is five times the largest number seen.
const OVER_SINE: u32 = 256;
/// Evaluations allowed to a search of a motion, however slow the modes are. The motion may be the remainder of modes
/// that cancel. It is three times the largest number seen.
const OF_MOTION: u32 = 1024;
/// Number of half turns of the fastest mode that allow one more evaluation. Measured searches need at most one for 120.
const HALF_TURNS: usize = 16;

/// Returns the upper bound on evaluations of one search, from the weight and from the fastest mode, max √λ(1 + 2ζ)/r.
///
/// A search counts its evaluations. It stops before a grid and its summits that might exceed the bound.
#[must_use]
pub fn most_evaluations<S: Float>(weight: Weight, fastest: S) -> u32 {
    let few = match weight {
        Weight::One => OF_MOTION,
        Weight::Sine => OVER_SINE,
    };
    let turns = fastest.to_index() / HALF_TURNS;
    let turns = u32::try_from(turns).unwrap_or(MAX_EVALUATIONS);
    few.saturating_add(turns).min(MAX_EVALUATIONS)
}

/// Number of roundings within which two maxima count as equal.
const EQUAL: f64 = 64.0;
/// Number of roundings of its largest terms by which a sum may be wrong.
const NOISE: f64 = 16.0;
/// Distance in τ below which two positions belong to the same maximum. Over this distance the sum falls by far more
/// than equal maxima may differ, since it falls with the square of the distance.
const SAME_MAXIMUM: f64 = 0.05;

/// Divisor of the sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// The sum is not divided.
    One,
    /// The sum is divided by sin τ, as in the velocity constraint.
    Sine,
}

/// A search problem.
#[derive(Clone, Copy, Debug)]
pub struct Problem<S> {
    /// Divisor of the sum.
    pub weight: Weight,
    /// True if the negative of the sum counts as well.
    pub both_signs: bool,
    /// Largest τ of the search: π, or π/2 for a sum that is odd about it.
    pub end: S,
    /// Lower bound on the values of interest. The search ignores smaller values.
    pub floor: S,
    /// Value of the wanted function for τ → 0, which the sum does not contain. The wanted function is the quotient plus
    /// `start`.
    pub start: S,
    /// Amount by which a larger value may be missed, relative to the value and `start` together.
    pub tolerance: S,
}

/// A position at which the largest value occurs, or where the search looks for it.
#[derive(Clone, Copy, Debug)]
pub struct Maximiser<S> {
    /// Position τ.
    pub tau: S,
    /// True if the negative of the sum is the largest value there.
    pub negative: bool,
}

/// Result of a search.
#[derive(Clone, Copy, Debug)]
pub struct Peak<S> {
    /// Largest value, or the floor if nothing exceeds the floor.
    pub value: S,
    /// Positions of the largest value; none if nothing exceeds the floor. Up to four equal maxima are kept.
    pub places: [Option<Maximiser<S>>; 4],
    /// Number of evaluations of the sum. A grid counts as two.
    pub evaluations: u32,
    /// True if the search stopped early, at its [bound](most_evaluations).
    pub exceeded: bool,
}

/// Work of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Effort {
    /// The search was completed after this number of evaluations, and nothing larger remains.
    Bounded(u32),
    /// The search stopped at its [bound](most_evaluations). Its result is the best value that it has found.
    Exceeded,
}

impl<S> Peak<S> {
    /// Returns the work of the search, and whether it was completed.
    #[must_use]
    pub fn effort(&self) -> Effort {
        if self.exceeded {
            Effort::Exceeded
        } else {
            Effort::Bounded(self.evaluations)
        }
    }
}

struct Search<'a, S, D> {
    sum: Sum<'a, S, D>,
    problem: Problem<S>,
    peak: Peak<S>,
    /// Upper bound on the sum's rounding error. Smaller values carry no information.
    rounding: S,
    /// Upper bound on the evaluations.
    most: u32,
    /// Position at which to look for the first summit.
    guess: Option<Maximiser<S>>,
}

/// Returns the largest value of `sum` over (0, end], divided by the weight.
pub fn largest<S: Float, D: Decay<S>>(sum: Sum<'_, S, D>, problem: Problem<S>) -> Peak<S> {
    let mut search = Search::new(sum, problem);
    search.by_grids();
    search.peak
}

/// Returns the largest value as [`largest`] does, in a sequence of similar searches. The search begins at the position
/// that the previous searches predict. Its own result updates the prediction.
pub fn largest_near<S: Float, D: Decay<S>>(
    sum: Sum<'_, S, D>,
    problem: Problem<S>,
    neighbour: &mut Neighbour<S>,
) -> Peak<S> {
    let speed = sum.fastest();
    let mut search = Search::new(sum, problem);
    search.guess = neighbour.guess(speed);
    search.by_grids();
    neighbour.learn(speed, &search.peak);
    search.peak
}

impl<'a, S: Float, D: Decay<S>> Search<'a, S, D> {
    fn new(sum: Sum<'a, S, D>, problem: Problem<S>) -> Self {
        let rounding = match problem.weight {
            Weight::One => sum.rounding(),
            Weight::Sine => sum.rounding_over_sine(),
        };
        Self {
            sum,
            problem,
            peak: Peak {
                value: problem.floor,
                places: [None; 4],
                evaluations: 0,
                exceeded: false,
            },
            rounding,
            most: most_evaluations(problem.weight, sum.fastest()),
            guess: None,
        }
    }

    fn level(&self) -> S {
        let Peak { value, .. } = self.peak;
        let level = value + self.problem.tolerance * (self.problem.start + value);
        match self.problem.weight {
            Weight::One => level.max(self.rounding),
            Weight::Sine => level,
        }
    }

    /// Returns the level for the sum, or for its negative. The wanted value of the negative is −(sum + start·sin τ)/sin
    /// τ. Less `start`, it must exceed the same level, so that −sum/sin τ must exceed a level raised by 2·start.
    fn signed(&self, level: S, negative: bool) -> S {
        if negative {
            level + self.problem.start + self.problem.start
        } else {
            level
        }
    }

    /// Returns the size up to which a sum over sin τ is only rounding error. Towards π the sum and sin τ both vanish,
    /// but the rounding error does not. Towards 0 the rounding error vanishes as well.
    fn noise(&self, cosine: S) -> S {
        let zero = S::constant(0.0);
        if self.problem.weight == Weight::Sine && cosine < zero {
            S::constant(NOISE) * self.rounding
        } else {
            zero
        }
    }

    /// Returns the signs that count: `false` for the sum, `true` for its negative.
    fn signs(&self) -> &'static [bool] {
        if self.problem.both_signs {
            &[false, true]
        } else {
            &[false]
        }
    }
}

#[cfg(test)]
mod tests;
