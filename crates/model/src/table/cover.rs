//! Covers a range of r with polynomial pieces, each as long as the accuracy allows.

use super::check;
use super::digits::to_decimals;
use super::errors::Comparison;
use super::fit::{Fitted, fit};
use super::split::LimitZero;
use super::worst::Worst;
use frictiongen_kernel::Float;

/// The search for the longest piece ends if the shortest length that was too long, divided by the longest acceptable
/// length, is at most this ratio. More fits would reduce the number of pieces by at most a tenth.
const LONGEST: f64 = 1.1;
/// Step to which the code rounds the end of a polynomial piece for readers, as a fraction of the piece's length. An
/// end at a kink of β_lim or at a bound of the range is not rounded.
const END: f64 = 0.02;
/// Error of a piece, divided by the allowed error, from which the piece probably contains a kink. The search then
/// locates the kink. The error of a piece with a kink is proportional to its length. The error of a smooth piece
/// falls with a high power of its length.
const KINK: f64 = 30.0;
/// The search for a kink ends if the shortest length of a piece that was too long, divided by the longest acceptable
/// length, is at most this ratio.
const KINK_FOUND: f64 = 1.0 + 1e-3;
/// Largest number of polynomial pieces that the code fits a second time, after the check found too large an error.
/// Each repetition adds a point at which later fits are compared. With more repetitions the construction would
/// probably never end, so it fails.
const MOST_AGAIN: usize = 1000;
/// Length of the shortest polynomial piece, as a fraction of r. It is a few hundred rounding units of double
/// precision.
const SHORTEST: f64 = 1e-13;
/// First length that the search tries for a piece, as a multiple of the length of the previous piece. The factor is
/// large, so that the first length is often too long. A length that is too long is an upper bound on the length of the
/// piece.
const LONGER: f64 = 1.5;
/// Largest number of fits in the search for the longest polynomial piece from one start.
const MOST_FITS: usize = 200;
/// Error at which the search aims with its next length, as a fraction of the allowed error. This value applies after a
/// length with an acceptable error.
const AIM: f64 = 0.8;
/// Error at which the search aims with its next length, as a fraction of the allowed error. This value applies after a
/// length that was too long.
const AIM_AGAIN: f64 = 0.7;
/// Error of a fit, divided by the allowed error, from which the code extrapolates the next length. A smaller error
/// gives no information about the best length.
const TINY: f64 = 1e-6;
/// Bounds on the factor by which the tried length grows after a fit with an acceptable error. The factor comes from a
/// power law, which is only approximate.
const LONGER_BY: [f64; 2] = [1.05, 2.0];
/// Bounds on the factor by which the tried length shrinks after a piece that was too long.
const SHORTER_BY: [f64; 2] = [0.2, 0.95];

/// Returns a value, limited to the interval [least, most].
fn clamped(value: f64, [least, most]: [f64; 2]) -> f64 {
    value.clamp(least, most)
}

/// State of the construction that covers a range of r with polynomial pieces, and its settings.
pub(super) struct Cover<'a, 'm, S> {
    /// Exact values with which each polynomial piece is compared, and the errors that a fit may have.
    pub comparison: Comparison<'a, 'm, S>,
    /// Kinks of β_lim, as frequency ratios in ascending order.
    pub kinks: Vec<f64>,
    /// Errors that the check allows: first that of β_lim, then that of the amplitude and the phase of the contact.
    pub whole: (f64, f64),
    /// Largest number of pieces that the construction may make.
    pub most_pieces: usize,
    /// Length of the last polynomial piece, from which the first length for the next piece follows.
    pub last: f64,
}

/// Failure to cover a range of r: no piece that contains the frequency ratio `at` meets the accuracy.
#[derive(Clone, Copy, Debug)]
pub(super) struct NotCovered {
    pub at: f64,
}

impl<S: Float> Cover<'_, '_, S> {
    /// Returns polynomial pieces that cover a range of r, after a check at points that the fits did not use. The second
    /// result has the largest error, divided by the allowed error, and its r. The third is the number of compared
    /// points.
    ///
    /// If the error of a piece is too large, the function replaces the piece: it fits new pieces to its interval. Every
    /// later fit is also compared with the exact value at the r of this error.
    pub fn checked(
        &mut self,
        low: f64,
        high: f64,
    ) -> Result<(Vec<Fitted<S>>, Worst, usize), NotCovered> {
        let (limit, motion) = (self.comparison.limit, self.comparison.motion);
        let mut waiting = self.range(low, high)?;
        waiting.reverse();
        let (mut pieces, mut points, mut again) = (Vec::new(), 0, 0);
        let mut worst = Worst {
            error: 0.0,
            at: low,
        };
        while let Some(piece) = waiting.pop() {
            let from = piece.from.to_f64().max(low);
            let to = waiting
                .last()
                .map_or(high, |next: &Fitted<S>| next.from.to_f64());
            (self.comparison.limit, self.comparison.motion) = self.whole;
            let (seen, looked) = check::piece(&mut self.comparison, &piece, (from, to));
            (self.comparison.limit, self.comparison.motion) = (limit, motion);
            points += looked;
            if seen.error <= 1.0 {
                if seen.error > worst.error {
                    worst = seen;
                }
                // If several pieces have the same start after rounding, the code uses only the last of these pieces.
                if pieces
                    .last()
                    .is_some_and(|last: &Fitted<S>| last.from == piece.from)
                {
                    pieces.pop();
                }
                pieces.push(piece);
                continue;
            }
            again += 1;
            if again > MOST_AGAIN {
                return Err(NotCovered { at: seen.at });
            }
            self.comparison.landmarks.look_at(seen.at);
            let zero = self.comparison.zero_of(&piece);
            let left = zero.filter(|zero| zero.at <= from);
            let right = zero.filter(|zero| zero.at > from);
            self.last = to - from;
            let mut anew = Vec::new();
            self.between((from, to), left, right, &mut anew)?;
            waiting.extend(anew.into_iter().rev());
        }
        Ok((pieces, worst, points))
    }

    /// Returns polynomial pieces that cover a range of r. They are not yet checked.
    fn range(&mut self, low: f64, high: f64) -> Result<Vec<Fitted<S>>, NotCovered> {
        let mut pieces = Vec::new();
        let zeros = self.comparison.landmarks.zeros.clone();
        let mut from = low;
        let mut left: Option<LimitZero> = None;
        for zero in zeros {
            let to = zero.at.min(high);
            if from < to {
                self.between((from, to), left, Some(zero), &mut pieces)?;
            }
            from = zero.at.max(low);
            left = Some(zero);
        }
        if from < high {
            self.between((from, high), left, None, &mut pieces)?;
        }
        Ok(pieces)
    }

    /// Appends the pieces between two neighbouring zeros of β_lim, or between a zero and a bound of the range.
    fn between(
        &mut self,
        (low, high): (f64, f64),
        left: Option<LimitZero>,
        right: Option<LimitZero>,
        pieces: &mut Vec<Fitted<S>>,
    ) -> Result<(), NotCovered> {
        let (mut from, mut to) = (low, high);
        let middle = 0.5 * (low + high);
        if left.is_some() {
            let reach = if right.is_some() { middle } else { high };
            let (piece, end) = self.longest(low, reach, left)?;
            pieces.push(piece);
            from = end;
        }
        let mut last = None;
        if right.is_some() {
            let (piece, end) = self.longest(high, from, right)?;
            last = Some(piece);
            to = end;
        }
        while from < to {
            let (piece, end) = self.longest(from, to, None)?;
            pieces.push(piece);
            from = end;
            if pieces.len() > self.most_pieces {
                return Err(NotCovered { at: from });
            }
        }
        pieces.extend(last);
        Ok(())
    }

    /// Returns the longest polynomial piece from `start` towards `limit` that meets the accuracy, and the r at which
    /// it ends.
    fn longest(
        &mut self,
        start: f64,
        limit: f64,
        zero: Option<LimitZero>,
    ) -> Result<(Fitted<S>, f64), NotCovered> {
        let most = (limit - start).abs();
        let forwards = start < limit;
        // If a kink of β_lim is ahead, the piece should end at the kink, because a polynomial cannot follow it.
        let ahead = self
            .kinks
            .iter()
            .map(|kink| if forwards { kink - start } else { start - kink });
        let mut stops: Vec<f64> = ahead
            .filter(|ahead| SHORTEST * start < *ahead && *ahead < most)
            .collect();
        stops.sort_by(f64::total_cmp);
        stops.push(most);
        let end_of = |length: f64| {
            if length >= most {
                limit
            } else {
                let end = if forwards {
                    start + length
                } else {
                    start - length
                };
                let rounded = to_decimals(end, END * length);
                // An end at a kink is not rounded.
                let kink = stops.contains(&length);
                if kink { end } else { rounded }
            }
        };
        let mut next = stops.iter().copied();
        let mut stop = next.next().unwrap_or(most);
        let mut length = (LONGER * self.last).min(stop);
        let (mut known, mut good, mut too_long, mut excess) = (None, 0.0, f64::INFINITY, 0.0);
        let order = 1.0 / self.comparison.form.terms as f64;
        for _ in 0..MOST_FITS {
            let end = end_of(length);
            let between = if forwards { (start, end) } else { (end, start) };
            // The fit uses the zero only if its distance is at most the length of the piece. At a larger distance,
            // the powers of the distance from the zero would be nearly equal.
            let zero = zero.filter(|zero| zero.distance(start).abs() <= length);
            let piece = fit(self.comparison.exact, between, zero, self.comparison.form)
                .ok_or(NotCovered { at: start })?;
            let error = self.comparison.error(&piece, between, zero);
            if error <= 1.0 {
                (good, known) = (length, Some((piece, end)));
                if length >= most {
                    break;
                }
                if length >= stop {
                    // The kink is weak, so the piece may extend past it without harm.
                    stop = next.next().unwrap_or(most);
                }
                let guess = length * clamped((AIM / error.max(TINY)).powf(order), LONGER_BY);
                length = guess.min(stop);
            } else {
                let at_kink = stops.contains(&good);
                (too_long, excess) = (length, error);
                if good > 0.0 && at_kink {
                    break;
                }
                let guess = length * clamped((AIM_AGAIN / error).powf(order), SHORTER_BY);
                length = if good < guess {
                    guess
                } else {
                    0.5 * (good + too_long)
                };
            }
            if length >= too_long {
                length = 0.5 * (good + too_long);
            }
            let enough = if excess > KINK { KINK_FOUND } else { LONGEST };
            if good > 0.0 && too_long <= good * enough {
                break;
            }
            if length <= SHORTEST * start {
                return Err(NotCovered { at: start });
            }
        }
        self.last = good;
        known.ok_or(NotCovered { at: start })
    }
}
