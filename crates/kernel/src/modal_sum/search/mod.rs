//! Search for the largest value of a modal sum in a half period, with a proof that no larger value exists.
//!
//! The search covers the half period by grids. The interval between two nodes of a grid is a *cell*. A cubic and a
//! bound on the fourth derivative give an upper bound on the sum in a cell. A cell is *open* if its upper bound exceeds
//! the largest value found so far. On each grid the search refines local maxima. A *summit* is a position from which
//! one Newton step leads to a local maximum. Finer grids then divide the cells that remain open. At the end, no value
//! exceeds result·(1 + tolerance), except by rounding (section 9 of `docs/derivation.md`).

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

/// Upper bound on the evaluations of the modal sum in one search, for any scene. A grid of up to 32 nodes counts as two
/// evaluations. [`most_evaluations`] returns a smaller bound for a given scene. `docs/evidence.md` contains measured
/// numbers. A search that reaches its bound returns the largest value that it has found.
pub const MAX_EVALUATIONS: u32 = 20_000;

/// Upper bound on the evaluations in a search of sum/sin τ if no mode is fast compared with the excitation. The bound
/// is five times the largest measured number.
const OVER_SINE: u32 = 256;
/// Upper bound on the evaluations in a search of a motion if no mode is fast compared with the excitation. The bound is
/// three times the largest measured number. A search of a motion needs more evaluations than a search of sum/sin τ,
/// because the terms of the modes may nearly cancel.
const OF_MOTION: u32 = 1024;
/// Number of half turns of the fastest mode for which the bound on the evaluations increases by one. Measured searches
/// need at most one evaluation for 120 half turns.
const HALF_TURNS: usize = 16;

/// Returns the upper bound on the number of evaluations of the modal sum in one search. The bound grows with
/// `fastest`, the largest √λ(1 + 2ζ)/r among the modes. √λ/r is the natural frequency of a mode divided by the
/// excitation frequency, and ζ its damping ratio.
///
/// A search stops before a grid if the evaluations for this grid and its local maxima could exceed the bound.
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

/// Largest relative difference of two maxima that count as equal, as a multiple of the scalar type's resolution.
const EQUAL: f64 = 64.0;
/// Safety factor on the rounding error of a sum that is divided by sin τ, for τ > π/2.
const NOISE: f64 = 16.0;
/// Largest distance in τ (in rad) of two positions that belong to the same maximum. Around a maximum the sum falls with
/// the square of the distance. At a distance of `SAME_MAXIMUM`, the sum has fallen by far more than the tolerance for
/// equal maxima.
const SAME_MAXIMUM: f64 = 0.05;

/// Divisor of the modal sum in a search: 1 or sin τ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// The divisor is 1. The search finds the maximum of the sum, such as the amplitude of a motion.
    One,
    /// The divisor is sin τ. The search finds the maximum of sum/sin τ, such as the velocity constraint.
    Sine,
}

/// Settings of a search for the largest value of a modal sum, or of the sum divided by sin τ.
#[derive(Clone, Copy, Debug)]
pub struct SearchSettings<S> {
    /// Divisor of the modal sum in this search.
    pub weight: Weight,
    /// True if the search covers the sum and the negative of the sum, and therefore finds the largest absolute value.
    pub both_signs: bool,
    /// End of the searched interval 0 < τ ≤ `end`. The end is π/2 for a sum that is odd about π/2, otherwise π.
    pub end: S,
    /// Smallest value that the search looks for. The search ignores smaller values.
    pub floor: S,
    /// Limit for τ → 0 of the function that the search maximises. This function is `start` + sum or `start` + sum/sin
    /// τ. The modal sum itself does not contain `start`.
    pub start: S,
    /// Tolerance of the search. The search may miss a value that exceeds the result by less than `tolerance` times
    /// (result + `start`).
    pub tolerance: S,
}

/// Position of a maximum of a modal sum, or a position near which the search looks for a maximum.
#[derive(Clone, Copy, Debug)]
pub struct Maximiser<S> {
    /// Phase τ of the maximum or of the position, in rad.
    pub tau: S,
    /// True for a maximum of the negative of the sum, false for a maximum of the sum.
    pub negative: bool,
}

/// Result of a search: the largest value, its positions, and the number of evaluations.
#[derive(Clone, Copy, Debug)]
pub struct Peak<S> {
    /// Largest value that the search found. If no value exceeds the floor of the search problem, the result is the
    /// floor.
    pub value: S,
    /// Positions of up to four equal largest values. All four entries are `None` if no value exceeds the floor of the
    /// search problem.
    pub places: [Option<Maximiser<S>>; 4],
    /// Number of evaluations of the modal sum in the search. The evaluation of a grid of nodes counts as two.
    pub evaluations: u32,
    /// True if the search stopped at its [bound](most_evaluations) and may have missed a larger value.
    pub exceeded: bool,
}

/// Work of a search for the largest value of a modal sum: the number of evaluations, or a mark that the search is
/// incomplete.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Effort {
    /// The search is complete: no larger value exists. The field is the number of evaluations of the modal sum.
    Bounded(u32),
    /// The search stopped at its [bound](most_evaluations). Its result is the largest value found, but a larger value
    /// may exist.
    Exceeded,
}

impl<S> Peak<S> {
    /// Returns the number of evaluations of a complete search. For a search that stopped early, returns
    /// [`Effort::Exceeded`].
    #[must_use]
    pub fn effort(&self) -> Effort {
        if self.exceeded {
            Effort::Exceeded
        } else {
            Effort::Bounded(self.evaluations)
        }
    }
}

struct MaximumSearch<'a, S, D> {
    sum: Sum<'a, S, D>,
    problem: SearchSettings<S>,
    peak: Peak<S>,
    /// Upper bound on the rounding error of the sum. A value of the sum below this bound may be pure rounding error.
    rounding: S,
    /// Upper bound on the number of evaluations of the modal sum in the search.
    most: u32,
    /// Position near which the search looks for its first maximum, predicted by earlier searches.
    guess: Option<Maximiser<S>>,
}

/// Finds the largest value of a modal sum, or of the sum divided by sin τ, over 0 < τ ≤ `end`.
pub fn largest<S: Float, D: Decay<S>>(sum: Sum<'_, S, D>, problem: SearchSettings<S>) -> Peak<S> {
    let mut search = MaximumSearch::new(sum, problem);
    search.by_grids();
    search.peak
}

/// Finds the largest value as [`largest`] does, for the next of a sequence of similar sums. `neighbour` predicts the
/// position of the maximum from the previous searches. After the search, the function stores the new position in
/// `neighbour`.
pub fn largest_near<S: Float, D: Decay<S>>(
    sum: Sum<'_, S, D>,
    problem: SearchSettings<S>,
    neighbour: &mut Neighbour<S>,
) -> Peak<S> {
    let speed = sum.fastest();
    let mut search = MaximumSearch::new(sum, problem);
    search.guess = neighbour.guess(speed);
    search.by_grids();
    neighbour.learn(speed, &search.peak);
    search.peak
}

impl<'a, S: Float, D: Decay<S>> MaximumSearch<'a, S, D> {
    fn new(sum: Sum<'a, S, D>, problem: SearchSettings<S>) -> Self {
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

    /// Returns the level with which the search compares ±sum/sin τ. The search maximises the function ±(`start` +
    /// sum/sin τ). If ±sum/sin τ exceeds the returned level, the function exceeds `start` + `level`. For the negative
    /// sign, the returned level is therefore higher by 2·`start`.
    fn signed(&self, level: S, negative: bool) -> S {
        if negative {
            level + self.problem.start + self.problem.start
        } else {
            level
        }
    }

    /// Returns an upper bound on the rounding error of the sum in a quotient sum/sin τ. Towards τ = π the sum and sin τ
    /// both vanish, but the rounding error does not. For τ ≤ π/2 the result is 0, because towards τ = 0 the rounding
    /// error also vanishes.
    fn noise(&self, cosine: S) -> S {
        let zero = S::constant(0.0);
        if self.problem.weight == Weight::Sine && cosine < zero {
            S::constant(NOISE) * self.rounding
        } else {
            zero
        }
    }

    /// Returns the signs of the sum that the search covers. `false` means the sum itself, and `true` means the negative
    /// of the sum.
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
