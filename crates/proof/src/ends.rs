//! Proves the first and the last cell (interval of τ) of the half period. The function D of [`HalfPeriodCells`], which
//! must be positive, vanishes at both ends of the half period.

use crate::cells::{Flank, HalfPeriodCells};
use crate::force;
use crate::found::Budget;
use crate::series::IntervalSeries;
use crate::stage::ORDER;
use crate::witness::{Witness, WitnessInstant};
use frictiongen_model::interval::Interval;

impl HalfPeriodCells<'_> {
    /// Returns true if D/τ is proven positive in the first cell, where D is the function of [`HalfPeriodCells`]. The
    /// proof uses D = D′(0)τ + D″(0)τ²/2 + D‴τ³/6, where D‴ is taken at some instant of the cell.
    pub fn first(&self, share: f64, budget: &mut Budget) -> bool {
        budget.spend(4 * self.wide.modes.len());
        let part = self.part;
        let (t, _, _) = self.instant(Flank::Before, Interval::new(0.0, share));
        let t = Interval::new(0.0, t.high);
        let ([_, second, third], (sine, cosine)) = self.derivatives(t);
        let level = self.level_over.value();
        let (at, over) = if matches!(part.witness, Witness::BreakAway) {
            // D′(0) is N − m* − H_c, computed as the sum of N − μm* − H_c and (μ − 1)m*. N is `level`, and μm* + H_c
            // the break-away term. m* is the inverse effective mass of the contact. H_c is the contribution of damping
            // to the acceleration of the contact at a reversal.
            let more = Interval::point(part.share);
            let more = more + more + more * more;
            let above = |seen: &WitnessInstant<ORDER>, level: &IntervalSeries<ORDER>| {
                seen.size.times(more) / (*level + seen.constraint)
            };
            (
                above(part.seen_at, &self.full_at) + part.at.break_away - part.at.start,
                above(part.seen_over, &self.full_over) + part.over.break_away - part.over.start,
            )
        } else {
            (
                self.full_at - part.at.start,
                self.full_over - part.over.start,
            )
        };
        let away = part.away;
        let start = IntervalSeries::joined(&at, &over).range(away);
        if !(0.0 < start.low) {
            return false;
        }
        // If D″ ≥ 0 in the cell, D′(0) > 0 suffices. Otherwise a parabola with the smallest D″ may suffice.
        let bend = -(level * sine) - second;
        let reach = t * Interval::pi();
        if 0.0 <= bend.low {
            return true;
        }
        let half = Interval::point(0.5);
        if 0.0 < (start + Interval::point(bend.low) * Interval::point(reach.high) * half).low {
            return true;
        }
        let third = -(level * cosine) - third;
        let curve = Interval::point(third.low) / Interval::point(6.0);
        if !(0.0 < curve.low) {
            return false;
        }
        // The parabola D′(0) + D″(0)τ/2 + `curve`·τ² is a lower bound on D/τ, because `curve` is a lower bound on D‴/6.
        // The code bounds the smallest value of this parabola in the cell as a function of r.
        let bends = [part.at, part.over].map(|stage| force::bend_at_start(stage).times(-half));
        let [bend_at, bend_over] = bends;
        let bend = IntervalSeries::joined(&bend_at, &bend_over).range(away);
        if 0.0 <= bend.low {
            return true;
        }
        let four = Interval::point(4.0);
        let lowest = |start: &IntervalSeries<ORDER>, bend: &IntervalSeries<ORDER>| {
            *start - bend.squared().times(Interval::ONE / (four * curve))
        };
        let (low_at, low_over) = (lowest(&at, &bend_at), lowest(&over, &bend_over));
        if 0.0 < IntervalSeries::joined(&low_at, &low_over).range(away).low {
            return true;
        }
        let turn = Interval::pi() * Interval::point(share);
        let at_end = |start: &IntervalSeries<ORDER>,
                      bend: &IntervalSeries<ORDER>,
                      path: &IntervalSeries<ORDER>| {
            let end = path.times(turn);
            (
                *start + *bend * end + end.squared().times(curve),
                *bend + end.times(curve + curve),
            )
        };
        let (value_at, slope_at) = at_end(&at, &bend_at, &part.seen_at.t);
        let (value_over, slope_over) = at_end(&over, &bend_over, &part.seen_over.t);
        IntervalSeries::joined(&slope_at, &slope_over)
            .range(away)
            .high
            <= 0.0
            && 0.0
                < IntervalSeries::joined(&value_at, &value_over)
                    .range(away)
                    .low
    }

    /// Returns true if D/(π − τ) is proven positive in the last cell, where D is the function of [`HalfPeriodCells`].
    /// The cell ends at τ = π.
    pub fn last(&self, share: f64, budget: &mut Budget) -> bool {
        budget.spend(2 * self.wide.modes.len());
        let level = self.level_over.value();
        let ([slope, _, _], _) = self.derivatives(Interval::ONE);
        let start = level + slope;
        let (t, _, _) = self.instant(Flank::After, Interval::new(0.0, share));
        let ([_, second, _], (sine, _)) = self.derivatives(Interval::new(t.low, 1.0));
        let bend = -(level * sine) - second;
        let reach = (Interval::ONE - Interval::point(t.low)) * Interval::pi();
        let half = Interval::point(0.5);
        let spare = start + Interval::point(bend.low.min(0.0)) * reach * half;
        0.0 < start.low && 0.0 < spare.low
    }
}
