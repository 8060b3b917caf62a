//! A proof that a table of β_lim is within its accuracy at every r, not only where it was looked at.
//!
//! The range is gone through in parts.  In each a *witness* is chosen, an instant that is about where the velocity
//! constraint is largest, as a polynomial in r; [`certify`] shows that no other instant has a constraint larger by more
//! than a small share, so that β_lim is known from both sides as a smooth function; [`compare`] shows that the
//! polynomial of the table, with all roundings of its evaluation, is near that function.  Both are done in intervals
//! with outward rounding.  [`motion`] shows the same of amplitude and phase of the contact.  A part that cannot be decided
//! is halved, and in the end left open: there the table is checked, not proven.
//!
//! Products over zeros and poles, β*_lim and |V|, are another matter: [`product`].

mod asked;
mod candidates;
mod cells;
mod certify;
mod compare;
mod early;
mod ends;
mod evidence;
mod force;
mod found;
mod motion;
mod product;
mod ridge;
mod stage;
mod witness;

#[cfg(test)]
mod moved;
#[cfg(test)]
pub(super) mod tests;

use super::exact::Exact;
use super::fit::Fitted;
use super::request::{FINEST_PROVEN, Request};
use super::split::Edge;
use crate::interval::{Interval, Series};
use candidates::candidates;
use cells::Part as Asked;
pub use evidence::{Evidence, Proof, Work};
use found::{Budget, Found, OF_STAGE, Part};
use frictiongen_kernel::Float;
use motion::Moving;
pub(super) use product::Receptances;
use stage::{Chain, ORDER, Stage, singular};
use witness::{Seen, Witness};

/// Of the accuracy the share that a larger constraint elsewhere may take.
const ELSEWHERE: f64 = 1.0 / 32.0;
/// A piece may take so many times its share of the work.
const FAIR: usize = 8;
/// A part is not halved below this share of r.
const SHORTEST: f64 = 1e-7;
/// For the motion a part is not halved below this share of its piece, or of its distance from a piece's zero; and a piece
/// is given up after so many such.
const SHORTEST_OF_MOTION: f64 = 2e-3;
const SHORTEST_BESIDE_ZERO: f64 = 0.02;
const MOST_MISSED: usize = 6;
/// The first part is tried at this fraction of the range, the one after a part that is shown at so many times its length.
const FIRST: f64 = 32.0;
const LONGER: f64 = 1.25;
/// A part takes all that is left where that is at most so many times its length.
const NO_STUB: f64 = 1.2;
/// At a zero of β_lim κ is below this if it vanishes there.
const VANISHES: f64 = 1e-14;

/// A table about to be proven.
pub(super) struct Prover<'a, 'm> {
    exact: &'a mut Exact<'m>,
    chain: Chain,
    request: Request,
    budget: Budget,
    /// The work that one piece may take.
    share: usize,
    /// The length of the last part.
    last: f64,
    of_limit: Found,
    of_motion: Found,
    /// By how much |V| may be off, where the motion is looked at.
    excitation: Option<f64>,
    /// Parts of a piece whose motion could not be shown.
    missed: usize,
}

impl<'a, 'm> Prover<'a, 'm> {
    pub fn new(
        exact: &'a mut Exact<'m>,
        request: Request,
        Work(work): Work,
        pieces: usize,
        excitation: Option<f64>,
    ) -> Self {
        let chain = Chain::of(exact.modal);
        let (low, high) = request.r;
        Self {
            exact,
            chain,
            request,
            share: FAIR * work / pieces.max(1),
            budget: Budget::of(work),
            last: (high - low) / FIRST,
            of_limit: Found::nothing(low),
            of_motion: Found::nothing(low),
            excitation,
            missed: 0,
        }
    }

    /// What was proven of β_lim, and of the motion.
    pub fn finished(self) -> [Proof; 2] {
        let work = self.budget.spent;
        [self.of_limit, self.of_motion].map(|found| found.finished(work))
    }

    /// Not shown, neither of β_lim nor of the motion.
    fn leave(&mut self, part: (f64, f64)) {
        self.of_limit.open.push(part);
        self.of_motion.open.push(part);
    }

    /// One piece from an r to another, with the kinks of β_lim within and the zero that it counts from.
    pub fn piece<S: Float>(
        &mut self,
        piece: &Fitted<S>,
        (from, to): (f64, f64),
        kinks: &[f64],
        zero: Option<Edge>,
    ) {
        if self.request.accuracy < FINEST_PROVEN || !(from < to) {
            if from < to {
                self.leave((from, to));
            }
            return;
        }
        self.budget.of_piece = self.budget.spent + self.share;
        self.missed = 0;
        let mut ends = vec![from];
        ends.extend(
            kinks
                .iter()
                .copied()
                .filter(|kink| from < *kink && *kink < to),
        );
        ends.push(to);
        let beside = zero.map(|zero| if zero.at <= from { from } else { to });
        for pair in ends.windows(2) {
            let [low, high] = pair else { continue };
            // From the zero away.
            if beside == Some(*high) {
                self.walk(piece, *high, *low, zero);
            } else {
                let zero = zero.filter(|_| beside == Some(*low));
                self.walk(piece, *low, *high, zero);
            }
        }
    }

    /// From one r to another, by parts.
    fn walk<S: Float>(&mut self, piece: &Fitted<S>, start: f64, end: f64, zero: Option<Edge>) {
        let forwards = start < end;
        let mut place = start;
        let mut zero = zero;
        let mut length = self.last;
        let shortest = SHORTEST * start.max(end);
        let from_zero = zero.is_some();
        while place != end {
            if self.budget.is_spent() {
                self.leave((place.min(end), place.max(end)));
                return;
            }
            let rest = (end - place).abs();
            // No short last part.
            let step = if rest < NO_STUB * length {
                rest
            } else {
                length
            };
            let next = match (step >= rest, forwards) {
                (true, _) => end,
                (false, true) => place + step,
                (false, false) => place - step,
            };
            let part = (place.min(next), place.max(next));
            let long = SHORTEST_OF_MOTION * (end - start).abs();
            let long = if from_zero {
                long.min(SHORTEST_BESIDE_ZERO * (next - start).abs())
            } else {
                long
            };
            let insists = self.missed < MOST_MISSED && step > long.max(shortest);
            match self.part(piece, part, zero, insists) {
                Some(Part { limit, motion }) => {
                    if let Some(gap) = limit.gap {
                        self.leave(gap);
                    }
                    self.of_limit.seen(limit.worst);
                    match motion {
                        Some(worst) => self.of_motion.seen(worst),
                        None => {
                            self.missed += 1;
                            self.of_motion.open.push(part);
                        }
                    }
                    place = next;
                    zero = None;
                    self.last = step;
                    length = LONGER * step;
                }
                None if step <= shortest => {
                    self.leave(part);
                    place = next;
                    zero = None;
                    length = 2.0 * step;
                }
                None => length = 0.5 * step,
            }
        }
    }

    /// A part, if the table is proven there.
    fn part<S: Float>(
        &mut self,
        piece: &Fitted<S>,
        (from, to): (f64, f64),
        zero: Option<Edge>,
        insists: bool,
    ) -> Option<Part> {
        let middle = 0.5 * (from + to);
        let centre = zero.map_or(middle, |zero| zero.at);
        let r = Interval::new(from.min(centre), to.max(centre));
        let away = Interval::point(from).hull(Interval::point(to)) - Interval::point(centre);
        let singular = singular(&self.chain, middle);
        self.budget.spend(OF_STAGE * self.chain.modes.len());
        let at = Stage::<ORDER>::over(&self.chain, Interval::point(centre), &singular);
        let over = Stage::<ORDER>::over(&self.chain, r, &singular);
        let (at, over) = self.oriented(at, over, away, zero)?;
        for witness in candidates(
            self.exact,
            &self.chain,
            (from, to),
            centre,
            &over,
            &singular,
        ) {
            let all = r - Interval::point(centre);
            let rest = if matches!(witness, Witness::Early(_)) {
                early::rest(&over, witness.path::<1>(all).value().high)
            } else {
                [Interval::ZERO; 2]
            };
            let seen_at = Seen::of(&witness, &at, Interval::ZERO, rest);
            let seen_over = Seen::of(&witness, &over, all, rest);
            self.budget.spend(OF_STAGE * self.chain.modes.len());
            // A constraint is no witness where it is negative; undamped its size is one.
            let is_one = self.chain.all_undamped || 0.0 <= seen_over.constraint.value().low;
            if !is_one {
                continue;
            }
            let share = ELSEWHERE * self.request.accuracy;
            let compared = compare::compared(
                piece,
                &self.request,
                (from, to),
                zero.map(|_| centre),
                [&at, &over],
                [&seen_at, &seen_over],
                share,
            );
            let Some(limit) = compared else { continue };
            let motion = self.excitation.and_then(|excitation| {
                let moving = Moving {
                    piece,
                    excitation,
                    accuracy: self.request.accuracy,
                    ends: (from, to),
                    centre,
                    beside_zero: zero.is_some(),
                    share,
                };
                moving.compared(&limit, [&at, &over], [&seen_at, &seen_over])
            });
            if insists && self.excitation.is_some() && motion.is_none() {
                continue;
            }
            let asked = Asked {
                chain: &self.chain,
                witness: &witness,
                away: r - Interval::point(centre),
                at: &at,
                over: &over,
                seen_at: &seen_at,
                seen_over: &seen_over,
                share,
            };
            if certify::certified(&asked, &mut self.budget) {
                return Some(Part { limit, motion });
            }
        }
        None
    }

    /// Both with κ > 0; of a wholly undamped chain either sign will do, as F(π − τ) = −F(τ).
    fn oriented(
        &self,
        at: Stage<ORDER>,
        over: Stage<ORDER>,
        away: Interval,
        zero: Option<Edge>,
    ) -> Option<(Stage<ORDER>, Stage<ORDER>)> {
        let (Some(own), Some(all)) = (at.kappa, over.kappa) else {
            return Some((at, over));
        };
        let sign = if zero.is_some() {
            // κ vanishes with β_lim, or does not; beside the zero it has the sign of its slope.
            let beside = all.value();
            let vanishes = own.value().size() < VANISHES;
            if beside.holds_zero() && !vanishes {
                return self.chain.all_undamped.then_some((at, over));
            }
            let slope = all.term(1);
            let side = Interval::point(away.middle());
            if beside.holds_zero() {
                (slope * side).sign()
            } else {
                beside.sign()
            }
        } else {
            Series::joined(&own, &all).range(away).sign()
        };
        match sign {
            1 => Some((at, over)),
            -1 => Some((at.turned(), over.turned())),
            _ => self.chain.all_undamped.then_some((at, over)),
        }
    }
}
