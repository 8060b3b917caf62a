//! Proves one piece of a table, one interval of r after another.

use crate::candidates::candidates;
use crate::cells::{CellData, ROUNDING};
use crate::found::{Budget, IntervalProof, OF_STAGE, PieceProof};
use crate::motion::MotionProof;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, ORDER, singular};
use crate::witness::{Witness, WitnessInstant};
use crate::{certify, compare, early};
use frictiongen_kernel::Float;
use frictiongen_model::interval::Interval;
use frictiongen_model::table::building::{Exact, LimitZero};
use frictiongen_model::table::{FINEST_PROVEN, Fitted, ProofWork, Request};

/// Fraction of the accuracy by which the velocity constraint at another instant may exceed that of the `Witness`. The
/// value is tuned. The rest of the accuracy is for the error of the polynomial. The check of the tables leaves a tenth
/// of the accuracy unused.
const ELSEWHERE: f64 = 1.0 / 32.0;
/// Shortest interval of r, as a fraction of r. The value is tuned. It limits the work next to zeros and poles.
const SHORTEST: f64 = 1e-7;
/// Shortest interval of r for the proof of amplitude and phase, as a fraction of its piece of the table. The value is
/// tuned. If at this length only the proof of β_lim succeeds, amplitude and phase stay open (not proven). Otherwise
/// intervals would become much shorter.
const SHORTEST_OF_MOTION: f64 = 2e-3;
/// Shortest interval of r for the proof of amplitude and phase near a zero of β_lim, as a fraction of the distance
/// from the zero.
const SHORTEST_BESIDE_ZERO: f64 = 0.02;
/// Number of intervals of r into which the prover divides a piece of the table at first. The value is tuned. The prover
/// halves an interval that is too long.
const FIRST: f64 = 4.0;
/// Factor by which the next interval of r is longer after a proven interval. The value is tuned. Fast growth saves
/// intervals, but a failed interval is lost work.
const LONGER: f64 = 1.15;
/// Shortest interval of r that the prover tries after an open (not proven) interval. It is a fraction of the length
/// that stays open if the trial fails. The value is tuned. It limits the trials to four halvings of that length.
const FINER: f64 = 1.0 / 16.0;
/// The next interval of r covers the whole rest of a piece if the rest is shorter than this factor times the interval.
/// The value is tuned. A short last interval would take as much work as a long one.
const NO_STUB: f64 = 1.2;
/// Largest |κ| that counts as zero at a zero of β_lim, where κ is a product of cosines. It is tens of rounding units
/// of a cosine.
const VANISHES: f64 = 1e-14;

/// State of the proof of one piece of a table.
pub(crate) struct Prover<'a, 'm> {
    exact: &'a mut Exact<'m>,
    chain: &'a IntervalChain,
    request: Request,
    budget: Budget,
    found: PieceProof,
    /// Largest relative error of the table's |V|, where V is the response of the contact to the load. `None` if the
    /// proof does not include amplitude and phase.
    excitation: Option<f64>,
    /// True if a `Witness` near the start of the half period has proven the last interval of r.
    early: bool,
}

impl<'a, 'm> Prover<'a, 'm> {
    pub fn new(
        exact: &'a mut Exact<'m>,
        chain: &'a IntervalChain,
        request: Request,
        ProofWork(work): ProofWork,
        excitation: Option<f64>,
    ) -> Self {
        let (low, _) = request.r;
        Self {
            exact,
            chain,
            request,
            budget: Budget::of(work),
            found: PieceProof::nothing(low),
            excitation,
            early: true,
        }
    }

    /// Proves a piece of the table over the interval of r from `from` to `to`. `kinks` has the kinks of β_lim within
    /// the piece. `zero` is the zero of β_lim that is the origin of the piece's polynomials, if the piece has one.
    pub fn piece<S: Float>(
        mut self,
        piece: &Fitted<S>,
        (from, to): (f64, f64),
        kinks: &[f64],
        zero: Option<LimitZero>,
    ) -> PieceProof {
        if self.request.accuracy < FINEST_PROVEN || !(from < to) {
            if from < to {
                self.found.leave((from, to));
            }
            return self.found;
        }
        // A kink that is an end of the piece, up to rounding, does not divide the piece.
        let apart = ROUNDING * to;
        let within = |kink: &f64| from + apart < *kink && *kink < to - apart;
        let mut ends = vec![from];
        ends.extend(kinks.iter().copied().filter(within));
        ends.push(to);
        let beside = zero.map(|zero| if zero.at <= from { from } else { to });
        for pair in ends.windows(2) {
            let [low, high] = pair else { continue };
            // The proof begins at the zero of β_lim, because only the series of the first interval have the zero as
            // their centre.
            if beside == Some(*high) {
                self.walk(piece, *high, *low, zero);
            } else {
                let zero = zero.filter(|_| beside == Some(*low));
                self.walk(piece, *low, *high, zero);
            }
        }
        self.found.work = self.budget.spent;
        self.found
    }

    /// Proves the part of a piece between two r, one interval of r after another. The proof runs from `start` to `end`,
    /// which may be the smaller r.
    fn walk<S: Float>(&mut self, piece: &Fitted<S>, start: f64, end: f64, zero: Option<LimitZero>) {
        let forwards = start < end;
        let mut place = start;
        let mut zero = zero;
        let mut length = (end - start).abs() / FIRST;
        let shortest = SHORTEST * start.max(end);
        let mut skip = shortest;
        // After a failure, amplitude and phase stay unproven over the length `skip_motion`. An interval must prove them
        // only if its distance from `start` is at least `again`.
        let (mut skip_motion, mut again) = (0.0_f64, 0.0_f64);
        let from_zero = zero.is_some();
        while place != end {
            if self.budget.is_spent() {
                self.found.leave((place.min(end), place.max(end)));
                return;
            }
            let rest = (end - place).abs();
            // If a step would leave a short last interval, the step covers the whole rest.
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
            let long = if from_zero && zero.is_none() {
                long.min(SHORTEST_BESIDE_ZERO * (next - start).abs())
            } else {
                long
            };
            let close = long.max(shortest).max(FINER * skip_motion);
            let insists = again <= (place - start).abs() && close < step;
            match self.part(piece, part, zero, insists) {
                Some(IntervalProof { limit, motion }) => {
                    if let Some(gap) = limit.gap {
                        self.found.leave(gap);
                    }
                    self.found.limit.seen(limit.worst);
                    match motion {
                        Some(worst) => {
                            self.found.motion.seen(worst);
                            skip_motion *= 0.5;
                        }
                        None => {
                            self.found.motion.open.push(part);
                            skip_motion = 2.0 * skip_motion.max(step);
                            again = (next - start).abs() + skip_motion;
                        }
                    }
                    place = next;
                    zero = None;
                    length = LONGER * step;
                    skip = shortest.max(0.5 * skip);
                }
                // The prover does not halve a failed interval down to the rounding of r. It leaves the interval open
                // (not proven). Each failure doubles the length that stays open.
                None if step <= shortest.max(FINER * skip) => {
                    let far = skip.max(step).min(rest);
                    let next = if forwards { place + far } else { place - far };
                    let next = if far < rest { next } else { end };
                    self.found.leave((place.min(next), place.max(next)));
                    place = next;
                    zero = None;
                    length = far;
                    skip = 2.0 * far;
                }
                None => length = 0.5 * step,
            }
        }
    }

    /// Returns the error bounds that the proof finds over an interval of r, or `None` if the proof fails. If `insists`
    /// is true, an interval without a proof of amplitude and phase fails, unless `excitation` is `None`.
    fn part<S: Float>(
        &mut self,
        piece: &Fitted<S>,
        (from, to): (f64, f64),
        zero: Option<LimitZero>,
        insists: bool,
    ) -> Option<IntervalProof> {
        let middle = 0.5 * (from + to);
        let centre = zero.map_or(middle, |zero| zero.at);
        let r = Interval::new(from.min(centre), to.max(centre));
        let away = Interval::point(from).hull(Interval::point(to)) - Interval::point(centre);
        let all = r - Interval::point(centre);
        let singular = singular(self.chain, middle);
        self.budget.spend(OF_STAGE * self.chain.modes.len());
        let at = ChainStage::<ORDER>::over(self.chain, Interval::point(centre), &singular);
        let mut over = ChainStage::<ORDER>::over(self.chain, r, &singular);
        over.refine(&at, all);
        let (at, over) = self.oriented(at, over, away, zero)?;
        let mut witnesses =
            candidates(self.exact, self.chain, (from, to), centre, &over, &singular);
        if !self.early {
            // The prover first tries the kind of `Witness` that has proven the last interval of r, because this kind
            // will probably succeed.
            witnesses.reverse();
        }
        for witness in witnesses {
            let rest = if matches!(witness, Witness::Early(_)) {
                early::rest(&over, witness.path::<1>(all).value().high)
            } else {
                [Interval::ZERO; 2]
            };
            let seen_at = WitnessInstant::of(&witness, &at, Interval::ZERO, rest);
            let mut seen_over = WitnessInstant::of(&witness, &over, all, rest);
            seen_over.refine(&seen_at, all);
            self.budget.spend(OF_STAGE * self.chain.modes.len());
            // A `Witness` with a negative velocity constraint is not valid. In an undamped chain the modulus of the
            // constraint is valid, because F occurs with both signs. F is the sum of the velocity constraint over the
            // modes.
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
                let moving = MotionProof {
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
            let asked = CellData {
                chain: self.chain,
                witness: &witness,
                away: all,
                at: &at,
                over: &over,
                seen_at: &seen_at,
                seen_over: &seen_over,
                share,
            };
            if certify::certified(&asked, &mut self.budget) {
                self.early = matches!(witness, Witness::Early(_));
                return Some(IntervalProof { limit, motion });
            }
        }
        None
    }

    /// Returns the functions of the chain at the centre and over the interval of r, multiplied by −1 if κ is negative.
    /// κ is the common factor of these functions, a product of cosines. Returns `None` if the sign of κ is unknown.
    ///
    /// In a chain without damping an unknown sign is allowed, because both signs are valid. F, the sum of the velocity
    /// constraint over the modes, then satisfies F(π − τ) = −F(τ).
    fn oriented(
        &self,
        at: ChainStage<ORDER>,
        over: ChainStage<ORDER>,
        away: Interval,
        zero: Option<LimitZero>,
    ) -> Option<(ChainStage<ORDER>, ChainStage<ORDER>)> {
        let (Some(own), Some(all)) = (at.kappa, over.kappa) else {
            return Some((at, over));
        };
        let sign = if zero.is_some() {
            // Near the zero of β_lim, κ may vanish together with β_lim. κ then has the sign of its slope times the
            // distance from the zero.
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
            IntervalSeries::joined(&own, &all).range(away).sign()
        };
        match sign {
            1 => Some((at, over)),
            -1 => Some((at.turned(), over.turned())),
            _ => self.chain.all_undamped.then_some((at, over)),
        }
    }
}
