//! Decides whether straight lines may join the points of a curve.

use super::point::CurvePoint;
use crate::Regime;
use crate::study::response::Swing;
use std::f64::consts::PI;

/// Criteria by which the code decides whether straight lines represent a curve.
#[derive(Clone, Debug)]
pub(super) struct Straight {
    /// The largest permitted deviation of a straight line from the curve, divided by the value of the curve.
    pub accuracy: f64,
    /// For each motion, a lower bound on the amplitude to which the tolerance is relative. The bound keeps small
    /// motions from needing many points.
    pub scales: Vec<f64>,
    /// True if μ > 1 or if the chain has no damping. The place where the motion leaves a stuck contact then depends on
    /// every earlier slip, and jumps from point to point. The criteria then use the centred amplitude, because more
    /// points would not remove the jumps.
    pub offsets_jump: bool,
    /// Exponent n of the load: its amplitude is proportional to r⁻ⁿ.
    pub fall: i32,
}

impl Straight {
    /// Returns the unit of displacement (P/k₁, or Y for base motion) at a point of the curve, divided by this unit at
    /// r = 1.
    pub(super) fn unit(&self, point: &CurvePoint) -> f64 {
        point.r.powi(-self.fall)
    }

    /// Returns true if the straight line from point `a` to point `b` passes the middle point `m` within the requested
    /// accuracy.
    pub(super) fn is_straight(&self, a: &CurvePoint, m: &CurvePoint, b: &CurvePoint) -> bool {
        let accuracy = self.accuracy;
        self.swings([a, m, b]).all(|([a, m, b], scale)| {
            let stray = (m.amplitude - 0.5 * (a.amplitude + b.amplitude)).abs();
            let bends = accuracy * m.amplitude.abs().max(scale);
            // A motion without amplitude has no phase. In this case the code compares the amplitudes only.
            let phases = match (a.phase, m.phase, b.phase) {
                (Some(a), Some(m), Some(b)) => 0.5 * (turn(a, m) + turn(b, m)).abs(),
                _ => 0.0,
            };
            let counted = m.amplitude.min(a.amplitude.max(b.amplitude));
            stray <= bends && (phases <= 2.0 * PI * accuracy || counted <= scale)
        })
    }

    /// Returns true if the amplitudes at two neighbouring points differ so little that the curve has no jump between
    /// the points.
    pub(super) fn touch(&self, a: &CurvePoint, b: &CurvePoint) -> bool {
        let reach = 100.0 * self.accuracy;
        self.swings([a, b]).all(|([a, b], scale)| {
            let size = a.amplitude.max(b.amplitude).max(scale);
            (a.amplitude - b.amplitude).abs() <= reach * size
        })
    }

    /// Returns two items for each motion: its amplitudes and phases at several points, and the lower bound on the
    /// amplitude to which the tolerance is relative.
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
                    swing.amplitude *= self.unit(point);
                }
                Some((swings, *scale))
            })
    }
}

/// Returns true if three points have the same number of stops and the same period, and if all or none of the three
/// motions settle.
pub(super) fn alike(points: [&CurvePoint; 3]) -> bool {
    let pattern = |point: &CurvePoint| (point.stops, point.period, point.settled);
    points
        .iter()
        .all(|point| pattern(point) == pattern(points[0]))
}

/// Returns the difference of two phases, reduced by whole turns to a value between −π and π.
fn turn(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference - 2.0 * PI * (difference / (2.0 * PI)).round()
}
