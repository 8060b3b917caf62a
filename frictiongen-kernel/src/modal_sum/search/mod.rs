//! The largest value of a modal sum over a half period, with a guarantee.
//!
//! The search walks from left to right.  At each instant it knows the sum, its slope and what its
//! curvature cannot exceed from there on, hence a distance within which the best value so far
//! cannot be beaten; it steps that far.  Where the best is beaten it climbs, to convergence, and
//! walks on from where it stood with the raised level: a climb may therefore be careless, the walk
//! is not.  Nothing larger than the answer times 1 + tolerance remains anywhere.

mod bounds;
mod cells;
mod climb;
mod ends;
mod grid;
mod series;
mod summit;
mod walk;

use crate::modal_sum::wave::{Local, Sum, Tail};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};

/// No search evaluates its sum more often than this.  The worst of 10⁴ random scenes at
/// r from 0.01 to 100 needs 1,810, half of them 6, and 33 for an amplitude; a search that would need more ends with the best
/// value it has found.
pub const MAX_EVALUATIONS: u32 = 20_000;

/// A search that takes longer looks at its sum's Taylor series as well.
const PLAIN_EVALUATIONS: u32 = 64;

/// Maxima closer than this many roundings count as equal.
const EQUAL: f64 = 64.0;
/// So many roundings of its largest terms may a sum be off.
const NOISE: f64 = 16.0;
/// Places closer than this belong to the same maximum: about it the sum falls by the square of the
/// distance, far more than maxima may differ that count as equal.
const APART: f64 = 0.05;

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

/// A place where the largest value is taken.
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
    /// How often the sum was evaluated.
    pub evaluations: u32,
}

/// What a search took.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Effort {
    /// It came to its end after so many evaluations, and nothing larger remains.
    Bounded(u32),
    /// It stopped after [`MAX_EVALUATIONS`]: its answer is the best that it had seen.
    Exceeded,
}

impl<S> Peak<S> {
    /// Whether the search came to its end.
    #[must_use]
    pub fn effort(&self) -> Effort {
        if self.evaluations < MAX_EVALUATIONS {
            Effort::Bounded(self.evaluations)
        } else {
            Effort::Exceeded
        }
    }
}

struct Search<'a, S, D> {
    sum: Sum<'a, S, D>,
    question: Problem<S>,
    peak: Peak<S>,
    tail: Option<Tail<S>>,
    /// What rounding leaves of the sum, below which nothing can be told.
    rounding: S,
}

/// The largest value of `sum` over (0, end], divided by the weight.
pub fn largest<S: Float, D: Decay<S>>(sum: Sum<'_, S, D>, question: Problem<S>) -> Peak<S> {
    let mut search = Search::new(sum, question);
    search.whole();
    search.peak
}

impl<'a, S: Float, D: Decay<S>> Search<'a, S, D> {
    fn new(sum: Sum<'a, S, D>, question: Problem<S>) -> Self {
        let rounding = match question.weight {
            Weight::One => sum.rounding(),
            Weight::Sine => sum.rounding_over_sine(),
        };
        Self {
            sum,
            question,
            peak: Peak {
                value: question.floor,
                places: [None; 4],
                evaluations: 0,
            },
            tail: None,
            rounding,
        }
    }

    fn local(&mut self, tau: S) -> (Local<S>, Option<Local<S>>) {
        self.peak.evaluations += 1;
        let at = Instant::new(tau * S::inverse_pi());
        self.sum.local(&at, self.tail.as_ref())
    }

    /// ±sum − level·weight about an instant.
    fn excess(&self, local: &Local<S>, negative: bool, level: S) -> Local<S> {
        let mut excess = *local;
        if negative {
            excess.value = -excess.value;
            excess.slope = -excess.slope;
            excess.curvature = -excess.curvature;
        }
        match self.question.weight {
            Weight::One => excess.value = excess.value - level,
            Weight::Sine => {
                let Local { sine, cosine, .. } = *local;
                let level = self.signed(level, negative);
                excess.value = excess.value - level * sine - self.noise(cosine);
                excess.slope = excess.slope - level * cosine;
                excess.curvature = excess.curvature + level * sine;
                excess.curvature_bound = excess.curvature_bound + level;
                excess.third_bound = excess.third_bound + level;
            }
        }
        excess
    }

    fn level(&self) -> S {
        let Peak { value, .. } = self.peak;
        let level = value + self.question.tolerance * (self.question.start + value);
        match self.question.weight {
            Weight::One => level.max(self.rounding),
            Weight::Sine => level,
        }
    }

    /// The level as the negative of the sum meets it: −(sum + start·sin τ) over sin τ, less `start`.
    fn signed(&self, level: S, negative: bool) -> S {
        if negative {
            level + self.question.start + self.question.start
        } else {
            level
        }
    }

    /// What says nothing about a sum that sin τ divides: towards π both vanish, and rounding does not, as it
    /// does towards 0.
    fn noise(&self, cosine: S) -> S {
        let zero = S::constant(0.0);
        if self.question.weight == Weight::Sine && cosine < zero {
            S::constant(NOISE) * self.rounding
        } else {
            zero
        }
    }

    /// The signs that count.
    fn signs(&self) -> &'static [bool] {
        if self.question.both_signs {
            &[false, true]
        } else {
            &[false]
        }
    }

    /// The whole half period.
    fn whole(&mut self) {
        if !self.by_grids() {
            self.by_walk();
        }
    }

    /// The same by a walk.
    fn by_walk(&mut self) {
        let signs = self.signs();
        let (mut tau, mut end) = (S::constant(0.0), self.question.end);
        if self.question.weight == Weight::Sine {
            self.choose_tail();
            tau = self.start(signs);
            end = self.last(signs);
        }
        self.walk(tau, end);
    }

    fn choose_tail(&mut self) {
        let size = self.question.start + self.peak.value;
        self.tail = self.sum.tail(size * S::constant(0.125));
    }
}

#[cfg(test)]
mod tests;
