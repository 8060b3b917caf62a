//! Numbers with their intervals.

use frictiongen::measure::Estimate;

/// The best one, from, to.
pub type Interval = (f64, f64, f64);

/// A number and its interval, both times `scale`.
pub fn scaled(found: Estimate, scale: f64) -> Interval {
    (found.value * scale, found.from * scale, found.to * scale)
}

/// A number and its interval.
pub fn interval(found: Estimate) -> Interval {
    scaled(found, 1.0)
}
