//! Finds the largest absolute value of a sum over oscillators between two events. A *walk*, a search in steps that
//! skip no zero, leads to each peak.

use super::first::{WalkResult, WalkStart, first_reach};
use crate::motion::series::OscillatorSum;
use crate::number::scalar::Float;

/// Largest difference of two values that count as equal, in rounding units.
const EQUAL: f64 = 64.0;
/// Largest number of peaks in a segment that the search refines.
const MAX_CLIMBS: u32 = 256;
/// Amount by which the value must fall after a peak before the search for the next peak starts. The unit is the largest
/// difference of two values that count as equal.
const BELOW: f64 = 4.0;
/// Largest number of Newton steps to a peak. The number includes shortened steps.
const CLIMB_STEPS: usize = 60;
/// Longest first Newton step to a peak, in radians of the excitation. If a step decreases the value, the longest
/// permitted step becomes half of that step.
const TRUSTED: f64 = 0.25;
/// Length of a Newton step, in radians of the excitation, below which the code has reached the peak. Even closer to the
/// peak, values differ only by rounding.
const AT_SUMMIT: f64 = 1e-3;
/// Size of a Newton step that is only rounding error, in rounding units.
const LEAST_ROUNDINGS: f64 = 4.0;

impl<S: Float> OscillatorSum<'_, S> {
    /// Calls `note` with the instant and the value of every local extreme whose absolute value is at least `level`,
    /// except for rounding. `note` returns the new level.
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
            // The function may start at zero or at a minimum, where a search for a peak cannot start. Values at two
            // inner instants therefore raise the level. The fractions are constants of S, so that `f32` scenes link no
            // double-precision code.
            for share in [S::constant(0.3), S::constant(0.5)] {
                let value = self.local(self.reach * share).value;
                level = level.max(value.abs());
            }
        }
        for _ in 0..MAX_CLIMBS {
            let WalkResult::Zero(tau, _) =
                first_reach(self, level * near, from, WalkStart::Anywhere, &mut 0)
            else {
                return;
            };
            let (top, value, curve) = self.climbed(tau);
            level = note(top, value);
            // The search continues after the peak, at an instant at which the function is less than the level.
            let fall = S::constant(BELOW * EQUAL * S::EPSILON) * value.abs();
            let width = (two * fall / curve.abs()).sqrt();
            let mut step = if !width.is_finite() {
                self.reach
            } else if zero < width {
                width
            } else {
                // Except for rounding, the function is zero everywhere. Its curvature therefore gives no width of the
                // peak.
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

    /// Finds the local extreme near an instant by Newton's method on the slope. The method shortens a step that
    /// decreases the absolute value, unless the peak is already closer than `AT_SUMMIT`. Returns the instant, the
    /// value and the curvature of the extreme.
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
            // One Newton step adds the derivative to the instant of the extreme. The value needs no Newton step,
            // because the slope is zero at the extreme.
            at = at.primal();
            local = self.local(at);
            if zero < at && at < self.reach {
                at = at - (local.slope - local.slope.primal()) / local.curve.primal();
            }
        }
        (at, local.value, local.curve)
    }
}
