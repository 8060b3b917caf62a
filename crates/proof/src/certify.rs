//! Proves that no instant of the half period has a velocity constraint that exceeds the constraint of the witness by
//! more than a small margin. The witness is an instant near the largest constraint.
//!
//! The function D(τ, r) = N(r) sin τ − F(τ, r) must be positive on 0 < τ < π. Here F/sin τ is the velocity constraint,
//! and N a level above the constraint of the witness. Cells, which are intervals of τ, cover the half period. The ends
//! of the cells shift with the witness as r changes. In each cell a lower bound on D follows from its value, its slope
//! and a bound on its second derivative. About the witness, where D nearly vanishes, a single parabola is the lower
//! bound.

use crate::cells::{BENT, CellData, Flank, HalfPeriodCells, ROUNDING};
use crate::force;
use crate::found::Budget;
use crate::ridge::PositiveRegion;
use crate::series::IntervalSeries;
use crate::stage::{ModeStage, ORDER};
use crate::witness::Witness;
use frictiongen_model::interval::Interval;
use std::f64::consts::PI;

/// Length of the first cell (an interval of τ) before and after the `Witness`, as a phase of the fastest mode in rad.
/// The value is tuned. A longer cell gives wider bounds of D″, where D(τ) is the function that must be positive
/// ([`HalfPeriodCells`]).
const CELL: f64 = 1.0;
/// Smallest (N − Q)/N at which the level N is far above Q, the velocity constraint of the witness. The value is tuned.
/// With this difference, the function D of [`HalfPeriodCells`] is clearly positive at the witness.
const FAR_ABOVE: f64 = 0.01;
/// Smallest D″ in a narrower interval of τ about the `Witness`, as a fraction of D″ at the witness. The code tries this
/// interval if the fraction `BENT` does not suffice. D(τ) is the function that must be positive ([`HalfPeriodCells`]).
/// The value is tuned. A larger fraction gives a steeper parabola in a narrower interval.
const MORE_BENT: f64 = 0.5;
/// Shortest cell (an interval of τ), as a fraction of the half period before or after the `Witness`. The value is
/// tuned. It limits the work of a proof that fails. The prover then halves the interval of r.
const SHORTEST: f64 = 1e-3;
/// Length of a cell (an interval of τ), as a phase of the fastest mode in rad. If a cell becomes shorter, the code
/// searches for another instant whose velocity constraint is nearly that of the witness. The value is tuned. Cells
/// become short where the function D of [`HalfPeriodCells`] is small.
const COMPETE: f64 = 0.1;
/// Largest number of searches, before or after the `Witness`, for another instant with nearly the same velocity
/// constraint. The value is tuned. It limits the work of the searches.
const MOST_TRIED: usize = 4;
/// Factor by which the next cell (an interval of τ) is longer after a proven cell. The value is tuned. Fast growth
/// saves cells, but a failed cell is lost work.
const LONGER: f64 = 1.4;
/// First length of a range of τ from the start of the half period, as a phase of the fastest mode in rad. A single
/// bound on D‴ covers the range, where D is the function of [`HalfPeriodCells`]. The value is tuned. A longer range
/// saves cells, but its bound is wider.
const EARLY: f64 = 0.3;
/// Largest number of lengths that the code tries for the range of [`EARLY`]. The value is tuned. The last length is
/// about a sixth of the first length.
const EARLY_STEPS: usize = 6;
/// Factor by which the code shortens the range of [`EARLY`] if its bound fails. The value is tuned together with
/// `EARLY_STEPS`.
const EARLY_STEP: f64 = 0.7;

/// Returns true if the proof over an interval of r succeeds. The proof shows that the velocity constraint at every
/// instant is below the constraint at the `Witness` plus the margin.
pub(crate) fn certified(part: &CellData<'_>, budget: &mut Budget) -> bool {
    // Without damping, the velocity constraint is largest at the start of the half period if every x ≤ 2. Here x is a
    // natural frequency divided by the excitation frequency.
    let slow = |mode: &ModeStage<ORDER>| mode.x.value().high <= 2.0;
    let is_start = matches!(part.witness, Witness::BreakAway);
    if is_start && part.chain.all_undamped && part.over.modes.iter().all(slow) {
        return true;
    }
    let cells = HalfPeriodCells::of(part);
    // `spare` is the margin of N above the break-away term. N is a number slightly above the velocity constraint of
    // the `Witness`. The break-away term limits β_lim as a velocity constraint does, so N must exceed this term too.
    let spare = IntervalSeries::joined(
        &(cells.full_at - part.at.break_away),
        &(cells.full_over - part.over.break_away),
    );
    // With μ = 1 the break-away term equals the velocity constraint at the start of the half period. The proof for a
    // `Witness` near the start also covers the start itself.
    let one = part.chain.stiction == Interval::ONE;
    let is_early = matches!(part.witness, Witness::Early(_));
    let seen = is_start || (is_early && one);
    let kappa = part.over.kappa.map_or(Interval::ONE, |kappa| kappa.value());
    if !seen && (kappa.holds_zero() || !(0.0 < spare.range(part.away).low)) {
        // κ is the common factor of all functions. If κ may be 0, its sign is unknown, and the code compares squares.
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
    /// Returns the fractions of the half period before and after the `Witness` that the cells must still prove. A
    /// parabola about the witness proves the rest of the half period. Returns `None` if D is not proven positive about
    /// the witness. [`HalfPeriodCells`] defines D.
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
            // D may have no minimum near the `Witness`. An example is a U larger than S, the largest velocity
            // constraint. U is the part of the contact's velocity at a reversal that friction causes. N is then far
            // above all constraints, and the cells alone prove that D is positive before and after the witness.
            return Some([1.0, 1.0]);
        }
        // The code first tries the widest interval of τ, then a narrower interval with a steeper parabola.
        let tube = [BENT, MORE_BENT].into_iter().find_map(|bent| {
            let (reach, least) = self.widened(path, curve, bent, budget);
            self.is_least(least).then_some(reach)
        });
        let Some([before, after]) = tube else {
            // If N is far above the velocity constraint of the `Witness`, the cells need no parabola about the witness.
            let far = FAR_ABOVE * self.level_over.value().high < self.above().low;
            return far.then_some([1.0, 1.0]);
        };
        // The code shortens the proven intervals of τ a little, to allow for the rounding of the fractions.
        Some([
            1.0 - before * (1.0 - ROUNDING) / path.high,
            1.0 - after * (1.0 - ROUNDING) / (1.0 - path.low),
        ])
    }

    /// Returns N − Q, computed without cancellation as (N² − Q²)/(N + Q). Q is the velocity constraint of the
    /// `Witness`, and N is a number slightly above Q.
    fn above(&self) -> Interval {
        let seen = self.part.seen_over;
        let share = Interval::point(self.part.share);
        let more = share + share + share * share;
        seen.size.value() * more / (self.level_over.value() + seen.constraint.value())
    }

    /// Returns true if D is proven positive in an interval of τ about the instant τ_w of the `Witness`. For a witness
    /// near the start of the half period, D/τ takes the place of D. In the interval the second derivative is at least
    /// `bend`, so D ≥ D(τ_w) − D′(τ_w)²/(2·bend). The function tests whether this bound is positive.
    /// [`HalfPeriodCells`] defines D.
    fn is_least(&self, bend: f64) -> bool {
        let (seen_at, seen_over) = (self.part.seen_at, self.part.seen_over);
        let above = self.above();
        let value = above * seen_over.weight.value();
        let rise = IntervalSeries::joined(&seen_at.rise, &seen_over.rise).range(self.part.away);
        let rise = rise + above * seen_over.turn.value();
        let bend = Interval::point(bend);
        0.0 < bend.low && 0.0 < (value - rise.squared() / (bend + bend)).low
    }

    /// Returns the fraction of the half period after the `Witness` that the cells must still prove, for a witness near
    /// the start of the half period. The proof about the witness needs (D/τ)″, where D is the function that must be
    /// positive ([`HalfPeriodCells`]). (D/τ)″ = ∫₀¹ s²D‴(sτ) ds is at least a third of the smallest D‴.
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

    /// Returns true if D is proven positive before or after the `Witness` (`side`). The proof runs from the end of the
    /// half period (τ = 0 or τ = π) to the position `up_to`, which would be 1 at the witness. [`HalfPeriodCells`]
    /// defines D.
    fn side(&self, side: Flank, up_to: f64, budget: &mut Budget) -> bool {
        let fastest = self.wide.modes.iter().map(|mode| mode.x.value().high);
        let fastest = fastest.fold(1.0, f64::max);
        let most = PI * self.path_at.middle();
        let mut length = (CELL / (fastest * most)).min(up_to);
        // The first cell starts at an end of the half period (τ = 0 or τ = π). D vanishes there, so the cell needs a
        // proof of its own.
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
                // Another instant may have nearly the velocity constraint of the `Witness`. Near it, cells would become
                // as short as their distance from that instant.
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

    /// Returns true if D is proven positive in a cell. The cell is the interval `share` of positions before or after
    /// the `Witness` (`side`). [`HalfPeriodCells`] defines D.
    fn cell(&self, side: Flank, share: Interval, budget: &mut Budget) -> bool {
        budget.spend(2 * self.wide.modes.len());
        let (t, t_slope, _) = self.instant(side, share);
        let (value, [first, second, _], (sine, cosine)) = self.boxed(t);
        let level = self.level_over.value();
        // D in the cell changes with r for two reasons. D has a slope in r (`of_r`). The cell shifts with r, so D also
        // changes by its slope in τ (`of_tau`).
        let of_tau = level * cosine - first;
        let of_r = self.level_over.term(1) * sine - value.term(1);
        let moves = of_r + of_tau * t_slope * Interval::pi();
        let bend = -(level * sine) - second;
        // D at the centre of the interval of r is expanded about the middle of the cell.
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

/// Returns a lower bound on the parabola `value` + `slope`·δ + `bend`·δ²/2 for |δ| up to `half`.
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
