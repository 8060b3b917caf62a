//! Finds other instants whose velocity constraint is close to the constraint of the witness. The *witness* is the
//! instant that the proof assumes for the largest constraint. Near a kink of β_lim, two instants have almost equal
//! constraints.

use crate::cells::{BENT, Flank, HalfPeriodCells, ROUNDING};
use crate::force;
use crate::found::{Budget, OF_STAGE};
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, ORDER};
use crate::witness::polynomial;
use frictiongen_kernel::Scalar;
use frictiongen_model::interval::Interval;
use std::f64::consts::PI;

/// Largest number of Newton steps towards a minimum of D, the function of [`HalfPeriodCells`] that must be positive.
/// The value is tuned. It limits the work if Newton's method does not converge.
const STEPS: usize = 8;
/// Newton's method has converged if a step is shorter than this value, in half-turns. The value is tuned. Convergence
/// is quadratic, so that the next step would be far below a rounding unit.
const FOUND: f64 = 1e-9;
/// Largest shift of an instant, in half-turns, by Newton's method or over an interval of r. An instant that shifts by
/// more belongs to another minimum of D, the function of [`HalfPeriodCells`].
const JUMP: f64 = 0.1;
/// Number of subintervals of r in which the code bounds D, the function of [`HalfPeriodCells`] that must be positive.
/// The value is tuned. More subintervals give narrower bounds, but take more work.
const PARTS: usize = 6;

/// A range of instants, in half-turns, about a local minimum of the function D of [`HalfPeriodCells`]. D is proven
/// positive in this range, for all r of an interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PositiveRegion {
    from: f64,
    to: f64,
}

impl PositiveRegion {
    /// Returns the position at which this range of instants ends, before or after the witness (`side`). Returns `None`
    /// unless the range contains the instants at the position `share`. A position is 0 at an end of the half period and
    /// 1 at the witness, which is an instant near the largest velocity constraint.
    pub fn reach(&self, side: Flank, share: f64, path: Interval) -> Option<f64> {
        let (begins, end) = match side {
            Flank::Before => (
                self.from <= share * path.low * (1.0 - ROUNDING),
                self.to / path.high,
            ),
            Flank::After => (
                1.0 - (1.0 - path.high) * share * (1.0 - ROUNDING) <= self.to,
                (1.0 - self.from) / (1.0 - path.low),
            ),
        };
        let end = end * (1.0 - ROUNDING);
        (begins && share < end).then_some(end)
    }
}

impl HalfPeriodCells<'_> {
    /// Returns a range of instants about the local minimum of D near the instant t, in which D is positive. D is the
    /// function of [`HalfPeriodCells`] that must be positive. Returns `None` if no minimum is found, or if the bounds
    /// do not prove that D is positive.
    pub fn region(&self, t: f64, budget: &mut Budget) -> Option<PositiveRegion> {
        let part = self.part;
        let (low, high) = (part.away.low, part.away.high);
        let places = [0.0, if high > -low { high } else { low }];
        let places = [places[0], 0.5 * places[1], places[1]];
        // The code finds the minimum at three r, beginning at the centre of the interval.
        let mut own = t;
        let mut instants = [0.0; 3];
        for (place, instant) in places.iter().zip(&mut instants) {
            budget.spend(STEPS * part.chain.modes.len());
            let stage = self.shifted(*place);
            let level = self.level_at_away(*place);
            own = least(&stage, level, own)?;
            *instant = own;
        }
        let jump = (instants[0] - t)
            .abs()
            .max((instants[2] - instants[0]).abs());
        if jump > JUMP {
            return None;
        }
        // A parabola in r through the instants of the minimum at three r gives the instant at every r.
        let [a, b, c] = instants;
        let step = places[1];
        let slope = (4.0 * b - 3.0 * a - c) / (2.0 * step);
        let bend = (a - 2.0 * b + c) / (2.0 * step * step);
        let coefficients = [a, slope, bend];
        let path =
            |away: Interval| polynomial::<ORDER>(&coefficients, IntervalSeries::variable(away));
        let (path_at, path_over) = (path(Interval::ZERO), path(part.away));
        let t = path_over.value();
        if !(0.0 < t.low && t.high < 1.0) {
            return None;
        }
        budget.spend(OF_STAGE * part.chain.modes.len());
        let (value_at, rise_at) = seen(part.at, &self.full_at, &path_at);
        let (value_over, rise_over) = seen(part.over, &self.full_over, &path_over);
        let curve = self.bend(t, budget);
        if !(0.0 < curve.low) {
            return None;
        }
        let (reach, bent) = self.widened(t, curve, BENT, budget);
        let value = IntervalSeries::joined(&value_at, &value_over);
        let rise = IntervalSeries::joined(&rise_at, &rise_over);
        let twice = Interval::point(bent) + Interval::point(bent);
        for k in 0..PARTS {
            let share = |k: usize| low + (high - low) * (k as f64 / PARTS as f64);
            let end = if k + 1 < PARTS { share(k + 1) } else { high };
            let away = Interval::new(share(k), end);
            let spare = value.range(away) - rise.range(away).squared() / twice;
            if !(0.0 < spare.low) {
                return None;
            }
        }
        let [before, after] = reach;
        let (from, to) = (
            t.high - before * (1.0 - ROUNDING),
            t.low + after * (1.0 - ROUNDING),
        );
        (from < to).then_some(PositiveRegion { from, to })
    }

    /// Returns an approximate value of the level N, a number slightly above the velocity constraint of the witness.
    /// `away` is the distance of r from the centre of the interval of r.
    fn level_at_away(&self, away: f64) -> f64 {
        value_at(&self.full_at, away)
    }

    /// Returns the chain at the distance `away` from the centre of the interval of r, approximated by its series.
    fn shifted(&self, away: f64) -> ChainStage<1> {
        let mut stage = self.part.at.truncated::<1>();
        for (mode, full) in stage.modes.iter_mut().zip(&self.part.at.modes) {
            let of = |series: &IntervalSeries<ORDER>| {
                IntervalSeries::fixed(Interval::point(value_at(series, away)))
            };
            (mode.x, mode.slow) = (of(&full.x), of(&full.slow));
            (mode.free, mode.forced_slope) = (of(&full.free), of(&full.forced_slope));
        }
        stage
    }
}

/// Returns series in r for D = N sin τ − F and for its slope in τ, at the instant t = τ/π. The instant is itself a
/// series in r. F is a sum over the modes, and N is `level`. A positive D proves that F/sin τ is below N there.
fn seen(
    stage: &ChainStage<ORDER>,
    level: &IntervalSeries<ORDER>,
    t: &IntervalSeries<ORDER>,
) -> (IntervalSeries<ORDER>, IntervalSeries<ORDER>) {
    let (sine, cosine) = t.sine_cosine();
    let motions = force::motions(stage, t);
    (
        *level * sine - force::value(stage, &motions, &cosine),
        *level * cosine - force::slope(stage, &motions, &sine),
    )
}

/// Returns the approximate value of a series at the distance `away` from its centre.
fn value_at<const N: usize>(series: &IntervalSeries<N>, away: f64) -> f64 {
    let terms = series.terms.iter().rev();
    terms.fold(0.0, |sum, term| sum * away + term.middle())
}

/// Returns the instant of the local minimum of D = N sin τ − F near the instant t, by Newton's method. F/sin τ is the
/// velocity constraint, and N is `level`.
fn least(stage: &ChainStage<1>, level: f64, mut t: f64) -> Option<f64> {
    for _ in 0..STEPS {
        let at = IntervalSeries::<1>::fixed(Interval::point(t));
        let (sine, cosine) = t.sin_cos_pi();
        let motions = force::motions(stage, &at);
        let [first, second, _] = force::derivatives(
            stage,
            &motions,
            (Interval::point(sine), Interval::point(cosine)),
        );
        let slope = level * cosine - first.middle();
        let bend = -level * sine - second.middle();
        if !(bend > 0.0) {
            return None;
        }
        let step = slope / bend / PI;
        t -= step;
        if !(0.0 < t && t < 1.0) {
            return None;
        }
        if step.abs() < FOUND {
            break;
        }
    }
    Some(t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use frictiongen_model::samples::random;

    /// Checks the position that `PositiveRegion::reach` returns, before and after the witness. The witness is an
    /// instant near the largest velocity constraint. A position is 0 at an end of the half period and 1 at the witness.
    /// Up to the returned position, all instants must lie in the region, for every witness in `path`. Just beyond, some
    /// instant must lie outside.
    #[test]
    fn within_the_region() {
        let (mut state, mut told) = (9, 0);
        for _ in 0..20_000 {
            let mut number = || random(&mut state);
            let (from, width) = (number(), 0.5 * number());
            let region = PositiveRegion {
                from,
                to: (from + width).min(1.0),
            };
            let low = 0.02 + 0.9 * number();
            let path = Interval::new(low, low + (0.99 - low) * 0.3 * number());
            let share = number();
            for side in [Flank::Before, Flank::After] {
                let instant = |share: f64, end: f64| match side {
                    Flank::Before => share * end,
                    Flank::After => 1.0 - (1.0 - end) * share,
                };
                let Some(reach) = region.reach(side, share, path) else {
                    continue;
                };
                assert!(share < reach);
                let ends = [path.low, path.middle(), path.high];
                for (end, share) in ends
                    .into_iter()
                    .flat_map(|end| [(end, share), (end, reach)])
                {
                    let t = instant(share, end);
                    assert!(
                        region.from <= t && t <= region.to,
                        "{t} in {region:?}, {share} of {path:?}"
                    );
                }
                let further = ends.map(|end| instant(reach * (1.0 + 1e-6), end));
                let is_out = |t: f64| !(region.from <= t && t <= region.to);
                assert!(further.into_iter().any(is_out), "{region:?}, {path:?}");
                told += 1;
            }
        }
        assert!(told > 2000, "{told}");
    }
}
