//! The largest value of a modal sum over a half period, with a guarantee.
//!
//! The search walks from left to right.  At each instant it knows the sum, its slope and what its
//! curvature cannot exceed from there on, hence a distance within which the best value so far
//! cannot be beaten; it steps that far.  Where the best is beaten it climbs, to convergence, and
//! walks on from where it stood with the raised level: a climb may therefore be careless, the walk
//! is not.  Nothing larger than the answer times 1 + tolerance remains anywhere.

mod climb;
mod ends;
mod series;

use crate::modal_sum::wave::{Local, Sum, Tail};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};
use series::Series;

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
    search.walk();
    search.peak
}

/// The same, knowing a place from which to climb first.
pub fn largest_from<S: Float, D: Decay<S>>(
    sum: Sum<'_, S, D>,
    question: Problem<S>,
    guess: S,
) -> Peak<S> {
    let mut search = Search::new(sum, question);
    let guess = guess.held();
    let local = search.local(guess).0;
    search.climb(guess, local, local.value < S::constant(0.0));
    search.walk();
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

    fn walk(&mut self) {
        let zero = S::constant(0.0);
        let signs: &[bool] = if self.question.both_signs {
            &[false, true]
        } else {
            &[false]
        };
        let mut end = self.question.end;
        let mut tau = zero;
        self.choose_tail();
        if self.question.weight == Weight::Sine {
            tau = self.start(signs);
            end = self.last(signs);
        }
        let (mut skipped, mut by_series) = (false, false);
        while tau < end && self.peak.evaluations < MAX_EVALUATIONS {
            // How the walk's steps move would grow from step to step, without bound.
            tau = tau.held();
            if self.question.weight == Weight::Sine && !skipped {
                // Away from the ends sin τ alone keeps the quotient below the level.
                let level = self.question.start + self.level();
                let edge = S::pi() * S::constant(0.5) * self.sum.bound_over_sine() / level;
                if edge < tau {
                    skipped = true;
                    tau = tau.max(S::pi() - edge);
                    continue;
                }
            }
            let tail = self.tail;
            let (local, slow) = self.local(tau);
            for &negative in signs {
                if zero < self.excess(&local, negative, self.level()).value {
                    self.climb(tau, local, negative);
                }
            }
            let mut step = end;
            let mut ahead = None;
            for &negative in signs {
                let level = self.level();
                let excess = self.excess(&local, negative, level);
                let mut reach = safe_step(&excess);
                if let (Some(slow), Some(tail)) = (slow, &tail) {
                    let mut slow = self.excess(&slow, negative, level);
                    slow.value = slow.value + tail.amplitude;
                    if slow.value < zero {
                        reach = reach.max(safe_step(&slow));
                    }
                }
                if zero < excess.slope && excess.curvature < zero {
                    let summit = -(excess.slope / excess.curvature);
                    if reach < summit + summit {
                        ahead = Some((summit, negative, excess.third_bound));
                    }
                }
                step = step.min(reach);
            }
            if self.peak.evaluations > PLAIN_EVALUATIONS {
                if !by_series {
                    by_series = true;
                    end = end.min(self.last_by_series(signs));
                }
                let reach = self.series_step(tau, signs);
                if step < reach {
                    tau = tau + reach;
                    continue;
                }
            }
            tau = match ahead {
                Some((summit, negative, third)) => {
                    self.over_summit(tau, summit, step, (negative, third), signs)
                }
                None => tau + step.max(tau * S::constant(S::RESOLUTION)),
            };
        }
    }

    /// A safe step by the sum's Taylor series.
    fn series_step(&mut self, tau: S, signs: &[bool]) -> S {
        self.peak.evaluations += 1;
        let at = Instant::new(tau * S::inverse_pi());
        let series = Series::of(&self.sum, &at);
        let sine = self.question.weight == Weight::Sine;
        signs.iter().fold(self.question.end, |step, &negative| {
            let noise = self.noise(at.cosine);
            // The series is good enough to pass over a maximum that is equal but for the tolerance.
            let level = if sine {
                self.signed(self.level(), negative)
            } else {
                let equal = self.peak.value * S::constant(1.0 - EQUAL * S::RESOLUTION);
                equal.max(self.rounding)
            };
            let excess = series.excess(negative, level, sine, &at).less(noise);
            step.min(excess.reach())
        })
    }

    /// A summit not far ahead would be approached by ever smaller steps: look at it instead.  If
    /// the sum is concave about it, from here to as far beyond, it is settled in one evaluation.
    fn over_summit(
        &mut self,
        tau: S,
        summit: S,
        step: S,
        (negative, third): (bool, S),
        signs: &[bool],
    ) -> S {
        let zero = S::constant(0.0);
        let half = S::constant(0.5);
        let stepped = tau + step.max(tau * S::constant(S::RESOLUTION));
        let top = tau + summit;
        if !(top < self.question.end) {
            return stepped;
        }
        // `third` bounds the third derivative from `tau` on, so about the summit too.
        let (local, _) = self.local(top);
        for &negative in signs {
            if zero < self.excess(&local, negative, self.level()).value {
                self.climb(top, local, negative);
                return tau;
            }
        }
        self.note_tie(top, local, negative);
        let excess = self.excess(&local, negative, self.level());
        let radius = -(excess.curvature) / third * half;
        let rise = excess.slope * (excess.slope / -excess.curvature);
        let settled = zero < radius && excess.value + rise <= zero && summit <= radius;
        // The other sign must be out of reach over the same stretch.
        let other = signs.len() == 1 || {
            let opposite = self.excess(&local, !negative, self.level());
            let swing = opposite.slope.abs() * radius
                + opposite.curvature_bound.max(third) * radius * radius;
            opposite.value + swing < zero
        };
        if settled && other {
            stepped.max(top + radius)
        } else {
            stepped
        }
    }

    fn choose_tail(&mut self) {
        let size = self.question.start + self.peak.value;
        self.tail = self.sum.tail(size * S::constant(0.125));
    }
}

/// How far value + slope·h + bound·h²/2 ≤ 0 holds, or the part of it over which the sum falls.
fn safe_step<S: Float>(excess: &Local<S>) -> S {
    let zero = S::constant(0.0);
    let two = S::constant(2.0);
    let Local {
        value,
        slope,
        curvature,
        curvature_bound,
        third_bound,
        ..
    } = *excess;
    let value = value.min(zero);
    if !(zero < curvature_bound) {
        return S::pi();
    }
    // Over the bounds: squares of the sum itself may be out of range.
    let (value, fall) = (value / curvature_bound, slope / curvature_bound);
    let root = (fall * fall - two * value).sqrt();
    let step = if zero < slope {
        -(two * value) / (fall + root)
    } else {
        root - fall
    };
    if slope <= zero && curvature < zero && zero < third_bound {
        let (slope, curvature) = (slope / third_bound, curvature / third_bound);
        let root = (curvature * curvature - two * slope).sqrt();
        return step.max(root - curvature);
    }
    step
}

#[cfg(test)]
mod tests;
