//! A walk from left to right by safe steps, for what grids leave open.

use super::series::Series;
use super::{EQUAL, MAX_EVALUATIONS, PLAIN_EVALUATIONS, Search, Weight};
use crate::modal_sum::wave::Local;
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// From an instant to another, by safe steps.
    #[inline(never)]
    pub(super) fn walk(&mut self, tau: S, end: S) {
        let zero = S::constant(0.0);
        let signs = self.signs();
        let (mut tau, mut end) = (tau, end);
        self.choose_tail();
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
    pub(super) fn over_summit(
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
}

/// How far value + slope·h + bound·h²/2 ≤ 0 holds, or the part of it over which the sum falls.
pub(super) fn safe_step<S: Float>(excess: &Local<S>) -> S {
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
