//! Whether points of a curve may be joined by straight lines.

use super::point::CurvePoint;
use crate::Regime;
use crate::study::response::Swing;
use std::f64::consts::PI;

/// What counts as straight.
#[derive(Clone, Debug)]
pub(super) struct Straight {
    /// How far a straight line may stray, relative to the curve.
    pub accuracy: f64,
    /// The amplitudes that count, for each motion.
    pub scales: Vec<f64>,
    /// True if the offset of a stuck contact jumps by a slip from place to place, which happens with μ > 1 or without damping:
    /// no point more would mend that, and the centred amplitude counts.
    pub offsets_jump: bool,
}

impl Straight {
    /// Whether a straight line from a to b passes m as closely as is asked.
    pub(super) fn is_straight(&self, a: &CurvePoint, m: &CurvePoint, b: &CurvePoint) -> bool {
        let accuracy = self.accuracy;
        self.swings([a, m, b]).all(|([a, m, b], scale)| {
            let stray = (m.amplitude - 0.5 * (a.amplitude + b.amplitude)).abs();
            let bends = accuracy * m.amplitude.abs().max(scale);
            // A phase counts as its motion does, which vanishes with the amplitude.
            let phases = match (a.phase, m.phase, b.phase) {
                (Some(a), Some(m), Some(b)) => 0.5 * (turn(a, m) + turn(b, m)).abs(),
                _ => 0.0,
            };
            let counted = m.amplitude.min(a.amplitude.max(b.amplitude));
            stray <= bends && (phases <= 2.0 * PI * accuracy || counted <= scale)
        })
    }

    /// Whether two points next to each other are of one curve.
    pub(super) fn touch(&self, a: &CurvePoint, b: &CurvePoint) -> bool {
        let reach = 100.0 * self.accuracy;
        self.swings([a, b]).all(|([a, b], scale)| {
            let size = a.amplitude.max(b.amplitude).max(scale);
            (a.amplitude - b.amplitude).abs() <= reach * size
        })
    }

    /// Motion by motion, the swings at several points, and the amplitude that counts.
    fn swings<'p, const N: usize>(
        &'p self,
        points: [&'p CurvePoint; N],
    ) -> impl Iterator<Item = ([Swing; N], f64)> + 'p {
        self.scales
            .iter()
            .enumerate()
            .filter_map(move |(index, scale)| {
                let mut swings = [Swing::REST; N];
                for (swing, point) in swings.iter_mut().zip(points) {
                    let movement = point.movements.get(index)?;
                    *swing = movement.swing;
                    if self.offsets_jump && point.regime == Regime::Stuck {
                        swing.amplitude = movement.centred;
                    }
                }
                Some((swings, *scale))
            })
    }
}

/// Whether the contact does the same at three points.
pub(super) fn alike(points: [&CurvePoint; 3]) -> bool {
    let pattern = |point: &CurvePoint| (point.stops, point.period, point.settled);
    points
        .iter()
        .all(|point| pattern(point) == pattern(points[0]))
}

/// Phase differences in (−π, π].
fn turn(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference - 2.0 * PI * (difference / (2.0 * PI)).round()
}
