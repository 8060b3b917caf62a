//! Finds the largest absolute value of a sum over oscillators between two events.  The search for events also finds
//! peaks.

use super::first::{Walk, WalkStart, first_reach};
use crate::motion::series::OscillatorSum;
use crate::number::scalar::Float;

/// Difference, in roundings, below which two values count as equal.
const EQUAL: f64 = 64.0;
/// Upper bound on the number of peaks in a segment to which the search climbs.
const MAX_CLIMBS: u32 = 256;
/// The search continues where the function has fallen from a summit by this multiple of the difference that counts as
/// equal.
const BELOW: f64 = 4.0;
/// Upper bound on the steps of a climb to a summit, shortened steps included.
const CLIMB_STEPS: usize = 60;
/// Longest first step of a climb, in radians of the excitation.  After a step downhill, half of that step is the
/// longest.
const TRUSTED: f64 = 0.25;
/// Length of a Newton step, in radians of the excitation, below which the climb is at the summit.  Closer to the
/// summit, values differ only by rounding.
const AT_SUMMIT: f64 = 1e-3;
/// Shortest step that rounding allows, in roundings.
const LEAST_ROUNDINGS: f64 = 4.0;

impl<S: Float> OscillatorSum<'_, S> {
    /// Calls `note` with the instant and the value of every local extreme whose size reaches `level` within rounding.
    /// `note` returns the new level.
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
            // The function starts at zero or at the bottom of a valley, from where no climb starts.  Two values between
            // the end points raise the level.  The fractions are constants of S, so that `f32` scenes link no
            // double-precision code.
            for share in [S::constant(0.3), S::constant(0.5)] {
                let value = self.local(self.reach * share).value;
                level = level.max(value.abs());
            }
        }
        for _ in 0..MAX_CLIMBS {
            let Walk::Zero(tau, _) =
                first_reach(self, level * near, from, WalkStart::Anywhere, &mut 0)
            else {
                return;
            };
            let (top, value, curve) = self.climbed(tau);
            level = note(top, value);
            // The search continues after the summit, where the function is below the level again.
            let fall = S::constant(BELOW * EQUAL * S::EPSILON) * value.abs();
            let width = (two * fall / curve.abs()).sqrt();
            let mut step = if !width.is_finite() {
                self.reach
            } else if zero < width {
                width
            } else {
                // The function is zero within rounding everywhere.  Its curvature then gives no width of the peak.
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

    /// Finds the local extreme near an instant by Newton's method on the slope, without steps downhill.  Returns its
    /// instant, value and curvature.
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
            // The instant of the extreme needs the derivative of the slope.  The value does not, because the slope is
            // zero there.
            at = at.primal();
            local = self.local(at);
            if zero < at && at < self.reach {
                at = at - (local.slope - local.slope.primal()) / local.curve.primal();
            }
        }
        (at, local.value, local.curve)
    }
}
