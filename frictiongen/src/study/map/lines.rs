//! Computes the limits β_lim and β*_lim over frequency. The points are close together where the limits bend.

use crate::study::system::System;
use crate::{Limits, OutOfDomain};

/// Number of intervals in the first grid of frequency ratios.
const PLACES: usize = 400;
/// Largest number of odd sub-harmonics of one resonance that become points of a limit line. The odd sub-harmonics are
/// the resonance divided by 3, 5, 7, …. Without damping β_lim is 0 at these sub-harmonics.
const MOST_SUBHARMONICS: usize = 25;
/// Smallest relative width of an interval of r that the code still halves.
const NARROW: f64 = 1e-9;

/// The limits β_lim and β*_lim over frequency, as lines through points.
#[derive(Clone, Debug)]
pub struct LimitLines {
    /// Pairs of the frequency ratio r and the limits β_lim and β*_lim, in ascending order of r. A limit may be
    /// infinite.
    pub points: Vec<(f64, Limits<f64>)>,
}

impl LimitLines {
    /// Returns the limits in the units that the load has at r = 1. The amplitude of the load is proportional to r⁻ⁿ
    /// with n = `fall`.
    #[must_use]
    pub fn at_reference(&self, fall: i32) -> Self {
        let points = self.points.iter();
        let points = points.map(|(r, limits)| (*r, super::scaled(*limits, r.powi(-fall))));
        Self {
            points: points.collect(),
        }
    }
}

impl System {
    /// Returns β_lim and β*_lim over a range of frequency ratios. Straight lines between neighbouring points deviate
    /// from the limits by at most `accuracy`. The deviation is measured in β/(1 + β), which is 1 for an infinite
    /// limit.
    ///
    /// # Errors
    /// [`OutOfDomain`] unless 0 ≤ from < to < ∞.
    pub fn limit_lines(
        &self,
        from: f64,
        to: f64,
        accuracy: f64,
    ) -> Result<LimitLines, OutOfDomain> {
        if !(0.0 <= from && from < to && to.is_finite()) {
            return Err(OutOfDomain::Range);
        }
        let step = (to - from) / PLACES as f64;
        let mut places: Vec<f64> = (0..PLACES).map(|i| from + step * i as f64).collect();
        places.push(to);
        for resonance in self.resonances() {
            let orders = (0..=MOST_SUBHARMONICS).map(|i| (2 * i + 1) as f64);
            places.extend(orders.map(|order| resonance / order));
        }
        places.retain(|r| from <= *r && *r <= to);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut points = Vec::new();
        for r in places {
            let right = (r, self.at(r)?.limits());
            if let Some(left) = points.last().copied() {
                self.between(left, right, accuracy.max(1e-12), false, &mut points)?;
            }
            points.push(right);
        }
        Ok(LimitLines { points })
    }

    fn between(
        &self,
        left: (f64, Limits<f64>),
        right: (f64, Limits<f64>),
        accuracy: f64,
        was_straight: bool,
        points: &mut Vec<(f64, Limits<f64>)>,
    ) -> Result<(), OutOfDomain> {
        let r = 0.5 * (left.0 + right.0);
        if !(left.0 < r && r < right.0) || right.0 - left.0 <= NARROW * right.0 {
            return Ok(());
        }
        let middle = (r, self.at(r)?.limits());
        let strays = |read: fn(&Limits<f64>) -> f64| {
            let [a, m, b] = [left, middle, right].map(|(_, limits)| share(read(&limits)));
            accuracy < (m - 0.5 * (a + b)).abs()
        };
        let straight = !strays(|limits| limits.continuous) && !strays(|limits| limits.sliding);
        // The middle of an interval may be on the straight line by chance, so that one test may miss a kink. The code
        // therefore stops only after two successive tests.
        let done = straight && was_straight;
        if !done {
            self.between(left, middle, accuracy, straight, points)?;
        }
        points.push(middle);
        if !done {
            self.between(middle, right, accuracy, straight, points)?;
        }
        Ok(())
    }
}

/// Returns β/(1 + β), which is 1 for an infinite limit.
fn share(beta: f64) -> f64 {
    1.0 - 1.0 / (1.0 + beta)
}
