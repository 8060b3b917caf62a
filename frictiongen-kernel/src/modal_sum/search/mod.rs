//! The largest value of a modal sum over a half period, with a guarantee.
//!
//! Grids cover the half period.  Between two nodes a cubic and a bound on the fourth derivative say what the sum
//! cannot exceed; where that is more than the largest value known, a summit is looked at, and what is open then is divided.
//! Nothing larger than the answer times 1 + tolerance remains anywhere, but for rounding (section 9 of
//! `docs/derivation.md`).

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

/// No search takes more than this, whatever the scene; a grid of up to 32 nodes counts as two evaluations.  The worst of
/// 10⁴ random scenes at r from 0.01 to 100 takes 34, half of them 4, and 8 for an amplitude.  [`most_evaluations`] says
/// what a scene's own searches may take; one that would need more ends with the best value it has found.
pub const MAX_EVALUATIONS: u32 = 20_000;

/// What a search over sin τ may take however slow the modes are: five times the most seen.
const OVER_SINE: u32 = 256;
/// The same of a motion, which may be what is left where modes cancel: three times the most seen.
const OF_MOTION: u32 = 1024;
/// One evaluation more for so many half turns of the fastest mode; the most seen is one for 120.
const HALF_TURNS: usize = 16;

/// How many evaluations a search may take at most, by the weight and by the fastest mode, max √λ(1 + 2ζ)/r.
///
/// A search counts, and stops before a grid and its summits that might lead beyond.
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

/// Maxima closer than this many roundings count as equal.
const EQUAL: f64 = 64.0;
/// So many roundings of its largest terms may a sum be off.
const NOISE: f64 = 16.0;
/// Places closer than this belong to the same maximum: about it the sum falls by the square of the
/// distance, far more than maxima may differ that count as equal.
const SAME_MAXIMUM: f64 = 0.05;

/// By what the sum is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// By nothing.
    One,
    /// By sin τ, as in the velocity constraint.
    Sine,
}

/// What to search.
#[derive(Clone, Copy, Debug)]
pub struct Problem<S> {
    /// By what the sum is divided.
    pub weight: Weight,
    /// Whether the negative of the sum counts as well.
    pub both_signs: bool,
    /// Where to stop: π, or π/2 for a sum that is odd about it.
    pub end: S,
    /// Values up to this one are of no interest.
    pub floor: S,
    /// By what the quotient falls short of what is looked for: its value for τ → 0, which the sum is without.
    pub start: S,
    /// Amount by which a larger value may be missed, relative to the value and `start` together.
    pub tolerance: S,
}

/// A place where the largest value is taken, or is looked for.
#[derive(Clone, Copy, Debug)]
pub struct Maximiser<S> {
    /// τ.
    pub tau: S,
    /// Whether the negative of the sum is the largest there.
    pub negative: bool,
}

/// The answer.
#[derive(Clone, Copy, Debug)]
pub struct Peak<S> {
    /// The largest value, or the floor if nothing exceeds it.
    pub value: S,
    /// Where it is taken; none if nothing exceeds the floor.  Up to four equal ones.
    pub places: [Option<Maximiser<S>>; 4],
    /// How often the sum was evaluated; a grid counts as two.
    pub evaluations: u32,
    /// Whether the search stopped before its end, at what it [may take](most_evaluations).
    pub exceeded: bool,
}

/// What a search took.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Effort {
    /// It came to its end after so many evaluations, and nothing larger remains.
    Bounded(u32),
    /// It stopped at [what it may take](most_evaluations): its answer is the best that it had seen.
    Exceeded,
}

impl<S> Peak<S> {
    /// Whether the search came to its end.
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
    /// What rounding leaves of the sum, below which nothing can be told.
    rounding: S,
    /// What it may take.
    most: u32,
    /// Where to look for the first summit.
    guess: Option<Maximiser<S>>,
}

/// The largest value of `sum` over (0, end], divided by the weight.
pub fn largest<S: Float, D: Decay<S>>(sum: Sum<'_, S, D>, problem: Problem<S>) -> Peak<S> {
    let mut search = Search::new(sum, problem);
    search.by_grids();
    search.peak
}

/// The same beside other searches: it begins where they lead, and its place leads the next.
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

    /// The level as the negative of the sum meets it: −(sum + start·sin τ) over sin τ, less `start`.
    fn signed(&self, level: S, negative: bool) -> S {
        if negative {
            level + self.problem.start + self.problem.start
        } else {
            level
        }
    }

    /// What says nothing about a sum that sin τ divides: towards π both vanish, and rounding does not, as it
    /// does towards 0.
    fn noise(&self, cosine: S) -> S {
        let zero = S::constant(0.0);
        if self.problem.weight == Weight::Sine && cosine < zero {
            S::constant(NOISE) * self.rounding
        } else {
            zero
        }
    }

    /// The signs that count.
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
