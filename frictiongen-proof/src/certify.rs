//! Proves that no instant of the half period has a velocity constraint above that of the witness by more than a small
//! margin.
//!
//! D(τ, r) = N(r) sin τ − F(τ, r) must be positive on 0 < τ < π. Cells cover the half period. Their ends shift with the
//! witness as r changes. In each cell the value, the slope and a bound on the second derivative give a lower bound on
//! D. About the witness, where D nearly vanishes, a single parabola is the lower bound.

use crate::cells::{BENT, CellData, Flank, HalfPeriodCells, ROUNDING};
use crate::force;
use crate::found::Budget;
use crate::ridge::PositiveRegion;
use crate::series::IntervalSeries;
use crate::stage::{ModeStage, ORDER};
use crate::witness::Witness;
use frictiongen_model::interval::Interval;
use std::f64::consts::PI;

/// Length of the first cell of a side, in radians of the fastest mode. The value is tuned. A longer cell has wider
/// bounds of D″.
const CELL: f64 = 1.0;
/// N counts as far above the witness's constraint if their relative difference exceeds this value. The value is tuned.
/// D is then clearly positive at the witness.
const FAR_ABOVE: f64 = 0.01;
/// Larger fraction of D″ for the region about the witness, which the code tries if `BENT` does not suffice. The value
/// is tuned. It gives a steeper parabola in a narrower region.
const MORE_BENT: f64 = 0.5;
/// Shortest cell, as a fraction of its side. The value is tuned. It limits the work on a side whose proof fails. The
/// prover then halves the interval of r.
const SHORTEST: f64 = 1e-3;
/// The code searches for another instant with nearly the witness's constraint if a cell becomes shorter than this
/// length, in radians of the fastest mode. The value is tuned. Cells become short where D is small.
const COMPETE: f64 = 0.1;
/// Largest number of searches for another instant with nearly the same constraint as the witness. The value is tuned.
/// It limits the work of the searches.
const MOST_TRIED: usize = 4;
/// After a proven cell, the next cell is longer by this factor. The value is tuned. Fast growth saves cells, but a
/// failed cell is lost work.
const LONGER: f64 = 1.4;
/// First trial length of the range that a single bound covers from the start of the half period. The unit is a radian
/// of the fastest mode. The value is tuned. A longer range saves cells, but its bound is wider.
const EARLY: f64 = 0.3;
/// Largest number of times that the code shortens the range of [`EARLY`] after a failed bound. The value is tuned. The
/// last range is about an eighth of the first.
const EARLY_STEPS: usize = 6;
/// Factor by which the code shortens the range of [`EARLY`] after a failed bound. The value is tuned together with
/// `EARLY_STEPS`.
const EARLY_STEP: f64 = 0.7;

/// Returns true if the proof succeeds: over the interval of r, every velocity constraint is below the witness's
/// constraint plus the margin.
pub(crate) fn certified(part: &CellData<'_>, budget: &mut Budget) -> bool {
    // Without damping and with every x ≤ 2, the velocity constraint is largest at the start of the half period.
    let slow = |mode: &ModeStage<ORDER>| mode.x.value().high <= 2.0;
    let is_start = matches!(part.witness, Witness::BreakAway);
    if is_start && part.chain.all_undamped && part.over.modes.iter().all(slow) {
        return true;
    }
    let cells = HalfPeriodCells::of(part);
    // Margin of N above the break-away term. This term limits β_lim as a velocity constraint does.
    let spare = IntervalSeries::joined(
        &(cells.full_at - part.at.break_away),
        &(cells.full_over - part.over.break_away),
    );
    // With μ = 1 the break-away term equals the velocity constraint at the start of the half period. The proof for a
    // witness near the start includes this constraint.
    let one = part.chain.stiction == Interval::ONE;
    let is_early = matches!(part.witness, Witness::Early(_));
    let seen = is_start || (is_early && one);
    let kappa = part.over.kappa.map_or(Interval::ONE, |kappa| kappa.value());
    if !seen && (kappa.holds_zero() || !(0.0 < spare.range(part.away).low)) {
        // If κ may be 0, its sign is unknown. The squares are compared in this case.
        let spare = cells.level_over.value().squared() - part.over.break_away.value().squared();
        if !(0.0 < spare.low) {
            return false;
        }
    }
    if is_early {
        return cells
            .early(budget)
            .is_some_and(|after| cells.side(Flank::After, after, budget));
    }
    let Some([before, after]) = cells.tube(budget) else {
        return false;
    };
    cells.side(Flank::Before, before, budget) && cells.side(Flank::After, after, budget)
}

impl HalfPeriodCells<'_> {
    /// Returns the fraction of each side that the cells must still prove. A parabola about the witness proves the rest.
    /// Returns `None` if D is not proven positive about the witness.
    fn tube(&self, budget: &mut Budget) -> Option<[f64; 2]> {
        if matches!(self.part.witness, Witness::BreakAway) {
            return Some([1.0, 1.0]);
        }
        let path = self.path_over.value();
        if !(0.0 < path.low && path.high < 1.0) {
            return None;
        }
        let curve = self.bend(path, budget);
        if !(0.0 < curve.low) {
            // D may have no minimum near the witness, for example where U exceeds S, the largest velocity constraint. N
            // is then far above all constraints. The cells alone prove D on both sides.
            return Some([1.0, 1.0]);
        }
        // The code first tries the widest region, then a narrower region with a steeper parabola.
        let tube = [BENT, MORE_BENT].into_iter().find_map(|bent| {
            let (reach, least) = self.widened(path, curve, bent, budget);
            self.is_least(least).then_some(reach)
        });
        let Some([before, after]) = tube else {
            // If N is far above the witness, the cells need no parabola about the witness.
            let far = FAR_ABOVE * self.level_over.value().high < self.above().low;
            return far.then_some([1.0, 1.0]);
        };
        // The certified regions are reduced a little, to allow for the rounding of the fractions.
        Some([
            1.0 - before * (1.0 - ROUNDING) / path.high,
            1.0 - after * (1.0 - ROUNDING) / (1.0 - path.low),
        ])
    }

    /// Returns N − Q, computed as (N² − Q²)/(N + Q). Q is the constraint of the witness.
    fn above(&self) -> Interval {
        let seen = self.part.seen_over;
        let share = Interval::point(self.part.share);
        let more = share + share + share * share;
        seen.size.value() * more / (self.level_over.value() + seen.constraint.value())
    }

    /// Returns true if D, or D/τ, is positive in the region in which its second derivative is at least `bend`. The
    /// criterion is D(τ_w) > D′(τ_w)²/(2·bend), because D ≥ D(τ_w) − D′(τ_w)²/(2·bend).
    fn is_least(&self, bend: f64) -> bool {
        let (seen_at, seen_over) = (self.part.seen_at, self.part.seen_over);
        let above = self.above();
        let value = above * seen_over.weight.value();
        let rise = IntervalSeries::joined(&seen_at.rise, &seen_over.rise).range(self.part.away);
        let rise = rise + above * seen_over.turn.value();
        let bend = Interval::point(bend);
        0.0 < bend.low && 0.0 < (value - rise.squared() / (bend + bend)).low
    }

    /// Returns the fraction of the side after the witness that the cells must still prove, for a witness near the
    /// start. Before the witness, (D/τ)″ is at least a third of the smallest D‴, because it equals ∫₀¹ s²D‴(sτ) ds.
    fn early(&self, budget: &mut Budget) -> Option<f64> {
        let path = self.part.seen_over.t;
        let path = IntervalSeries::joined(&self.part.seen_at.t, &path).range(self.part.away);
        if !(0.0 < path.low && path.high < 0.5) {
            return None;
        }
        let fastest = self.wide.modes.iter().map(|mode| mode.x.value().high);
        let mut end = (EARLY / fastest.fold(1.0, f64::max)).max(2.0 * path.high);
        for _ in 0..EARLY_STEPS {
            budget.spend(self.wide.modes.len());
            let ([_, _, third], (_, cosine)) = self.derivatives(Interval::new(0.0, end));
            let third = -(self.level_over.value() * cosine) - third;
            let bend = (Interval::point(third.low) / Interval::point(3.0)).low;
            if path.high < end && self.is_least(bend) {
                return Some((1.0 - end * (1.0 - ROUNDING)) / (1.0 - self.path_over.value().high));
            }
            end *= EARLY_STEP;
        }
        None
    }

    /// Returns true if D is proven positive on a side, from the end of the half period to the share `up_to` of this
    /// side.
    fn side(&self, side: Flank, up_to: f64, budget: &mut Budget) -> bool {
        let fastest = self.wide.modes.iter().map(|mode| mode.x.value().high);
        let fastest = fastest.fold(1.0, f64::max);
        let most = PI * self.path_at.middle();
        let mut length = (CELL / (fastest * most)).min(up_to);
        // The first cell starts at the end of the half period.
        loop {
            let share = length.min(up_to);
            let shown = match side {
                Flank::Before => self.first(share, budget),
                Flank::After => self.last(share, budget),
            };
            if shown {
                break;
            }
            length *= 0.5;
            if length < SHORTEST {
                return false;
            }
        }
        let mut from = length.min(up_to);
        let (mut region, mut tried) = (None, 0);
        while from < up_to {
            if budget.is_spent() {
                return false;
            }
            let to = (from + length).min(up_to);
            if self.cell(side, Interval::new(from, to), budget) {
                from = to;
                length *= LONGER;
            } else {
                // Near an instant with nearly the same constraint, a cell would have to be as short as the distance
                // between the two instants.
                let near = region.and_then(|region: PositiveRegion| {
                    region.reach(side, from, self.path_over.value())
                });
                if let Some(reach) = near {
                    from = reach.min(up_to);
                    continue;
                }
                length = 0.5 * (to - from);
                if region.is_none() && length * fastest * most < COMPETE && tried < MOST_TRIED {
                    tried += 1;
                    let middle = Interval::point(0.5 * (from + to));
                    let (_, _, t) = self.instant(side, middle);
                    region = self.region(t.middle(), budget);
                }
                if length < SHORTEST {
                    return false;
                }
            }
        }
        true
    }

    /// Returns true if D is proven positive in a cell of a side.
    fn cell(&self, side: Flank, share: Interval, budget: &mut Budget) -> bool {
        budget.spend(2 * self.wide.modes.len());
        let (t, t_slope, _) = self.instant(side, share);
        let (value, [first, second, _], (sine, cosine)) = self.boxed(t);
        let level = self.level_over.value();
        // D changes with r for two reasons: its own slope in r (`of_r`), and its slope in τ (`of_tau`) where the cell
        // shifts with r.
        let of_tau = level * cosine - first;
        let of_r = self.level_over.term(1) * sine - value.term(1);
        let moves = of_r + of_tau * t_slope * Interval::pi();
        let bend = -(level * sine) - second;
        // D at the centre of r is expanded about the middle of the cell.
        let middle = Interval::point(share.middle());
        let (_, _, t_at) = self.instant(side, middle);
        let (_, _, ends) = self.instant(side, share);
        let half = ((ends - t_at) * Interval::pi()).size();
        let at = IntervalSeries::<1>::fixed(t_at);
        let (sine, cosine) = at.sine_cosine();
        let motions = force::motions(&self.thin, &at);
        let value = self.level_at * sine - force::value(&self.thin, &motions, &cosine);
        let slope = self.level_at * cosine - force::slope(&self.thin, &motions, &sine);
        let least = lowest(value.value(), slope.value(), bend, half);
        let spare = least - Interval::point(moves.size()) * Interval::point(self.part.away.size());
        0.0 < spare.low
    }
}

/// Returns the minimum of value + slope·δ + bend·δ²/2 over |δ| ≤ half.
fn lowest(value: Interval, slope: Interval, bend: Interval, half: f64) -> Interval {
    let steep = Interval::point(slope.size());
    let bend = Interval::point(bend.low);
    let reach = Interval::point(half);
    let two = Interval::point(2.0);
    if 0.0 < bend.low && steep.high <= (bend * reach).low {
        value - steep.squared() / (two * bend)
    } else {
        value - steep * reach + bend * reach.squared() / two
    }
}
