//! Numbers with their intervals.

use frictiongen::measure::Estimate;

/// The best estimate, the lower and the upper bound.
pub type Interval = (f64, f64, f64);

/// Returns a number and its interval, both multiplied by `scale`.
pub fn scaled(found: Estimate, scale: f64) -> Interval {
    (found.value * scale, found.from * scale, found.to * scale)
}

/// Returns a number and its interval.
pub fn interval(found: Estimate) -> Interval {
    scaled(found, 1.0)
}
