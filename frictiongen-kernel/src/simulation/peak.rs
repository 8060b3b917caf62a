//! The largest |value| of a sum between two events, by the same walk that finds events.

use super::sum::Sum;
use super::walk::{Start, Walk, first_reach};
use crate::number::scalar::Float;

/// Values closer than this many roundings count as equal.
const EQUAL: f64 = 64.0;
/// No segment of a smooth sum has more peaks worth climbing than this.
const MAX_CLIMBS: u32 = 256;
/// Past a summit the walk goes on where the value has fallen by so many times what counts as equal.
const BELOW: f64 = 4.0;
/// A climb takes no more steps than this, halved ones among them.
const CLIMB_STEPS: usize = 60;
/// The longest first step of a climb, in radians of the excitation: a halved one is trusted from then on.
const TRUSTED: f64 = 0.25;
/// A step of Newton's method shorter than this is at the summit, where values differ by rounding alone.
const AT_SUMMIT: f64 = 1e-3;
/// No step can be below so many roundings.
const LEAST_ROUNDINGS: f64 = 4.0;

impl<S: Float> Sum<'_, S> {
    /// Calls `note` with the place and the value of every local extreme that comes up to `level`
    /// within rounding when it is met; `note` answers with the new level.
    pub(crate) fn peaks(&self, mut level: S, mut note: impl FnMut(S, S) -> S) {
        let (zero, two) = (S::constant(0.0), S::constant(2.0));
        let near = S::constant(1.0 - EQUAL * S::EPSILON);
        let mut from = zero;
        for end in [zero, self.reach] {
            let value = self.local(end).value;
            if level * near <= value.abs() {
                level = note(end, value);
            }
        }
        let start = self.local(zero);
        let low = start.value.abs() <= self.noise || !(start.curve * start.value < zero);
        if start.slope.abs() <= self.noise * self.rate && low {
            // It starts at zero or from the bottom of a valley, where no climb begins: from between its ends everything is in
            // sight.  Constants of S, so that `f32` scenes link no double precision.
            for share in [S::constant(0.3), S::constant(0.5)] {
                let value = self.local(self.reach * share).value;
                level = level.max(value.abs());
            }
        }
        for _ in 0..MAX_CLIMBS {
            let Walk::Zero(tau, _) = first_reach(self, level * near, from, Start::Anywhere, &mut 0)
            else {
                return;
            };
            let (top, value, curve) = self.climbed(tau);
            level = note(top, value);
            // Past the summit by as much as it takes to be below the level again.
            let fall = S::constant(BELOW * EQUAL * S::EPSILON) * value.abs();
            let width = (two * fall / curve.abs()).sqrt();
            let mut step = if !width.is_finite() {
                self.reach
            } else if zero < width {
                width
            } else {
                // Flat at zero, as far as numbers go.
                self.reach * S::constant(1.0 / f64::from(MAX_CLIMBS))
            };
            from = tau.max(top) + step;
            while from < self.reach && zero < level && level * near <= self.local(from).value.abs()
            {
                step = step * two;
                from = from + step;
            }
            if !(from < self.reach) {
                return;
            }
        }
    }

    /// The extreme next to an instant, by Newton's method on the slope, never downhill.
    fn climbed(&self, tau: S) -> (S, S, S) {
        let zero = S::constant(0.0);
        let mut at = tau;
        let mut local = self.local(at);
        let sign = S::constant(1.0).copysign(local.value);
        let mut trust = S::constant(TRUSTED);
        for _ in 0..CLIMB_STEPS {
            let (slope, curve) = (sign * local.slope, sign * local.curve);
            let newton = if curve < zero {
                -(slope / curve)
            } else {
                trust.copysign(slope)
            };
            let step = newton.max(-trust).min(trust);
            let next = (at + step).max(zero).min(self.reach);
            if next == at || slope.is_zero() {
                break;
            }
            let there = self.local(next);
            let near = curve < zero && step.abs() < S::constant(AT_SUMMIT);
            if sign * there.value < sign * local.value && !near {
                trust = step.abs() * S::constant(0.5);
                continue;
            }
            (at, local) = (next, there);
            if near && step.abs() < S::constant(LEAST_ROUNDINGS * S::EPSILON) {
                break;
            }
        }
        if S::CARRIES {
            // The place moves as the slope there does; the value does not see it.
            at = at.primal();
            local = self.local(at);
            if zero < at && at < self.reach {
                at = at - (local.slope - local.slope.primal()) / local.curve.primal();
            }
        }
        (at, local.value, local.curve)
    }
}
