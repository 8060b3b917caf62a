//! Random numbers and intervals for tests.

use super::random;
use crate::interval::Interval;
use frictiongen_kernel::number::dd::Dd;

/// A generator of random numbers and intervals.
#[derive(Clone, Debug)]
pub struct RandomNumbers(pub u64);

impl RandomNumbers {
    /// Returns a random number from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        random(&mut self.0)
    }

    /// Returns a random number of either sign, with a modulus from 10⁻⁵ to 10⁵. The result is sometimes 0.
    pub fn end(&mut self) -> f64 {
        let size = 10_f64.powf(10.0 * self.unit() - 5.0);
        match (16.0 * self.unit()) as u32 {
            0 => 0.0,
            even if even % 2 == 0 => size,
            _ => -size,
        }
    }

    /// Returns an interval between two random numbers from [`end`](Self::end).
    pub fn interval(&mut self) -> Interval {
        let (a, b) = (self.end(), self.end());
        // Two of five intervals are narrow.
        if self.unit() < 0.4 {
            Interval::new(a, a + a.abs() * 1e-12 * self.unit())
        } else {
            Interval::new(a.min(b), a.max(b))
        }
    }

    /// Returns a random number of an interval, which is often one of its two bounds.
    pub fn within(&mut self, interval: Interval) -> f64 {
        match (4.0 * self.unit()) as u32 {
            0 => interval.low,
            1 => interval.high,
            _ => (interval.low + (interval.high - interval.low) * self.unit())
                .clamp(interval.low, interval.high),
        }
    }
}

/// Returns true if an interval contains a double-double number, up to an error in its last digits. The allowed error is
/// far below one rounding unit of a double.
#[must_use]
pub fn contains(interval: Interval, value: Dd) -> bool {
    let slack = value.abs() * Dd::from(1e-28);
    !(value + slack < Dd::from(interval.low)) && !(Dd::from(interval.high) < value - slack)
}
