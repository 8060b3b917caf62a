//! Covers a range of r with polynomial pieces, each as long as the accuracy allows.

use super::check;
use super::digits::to_decimals;
use super::errors::Comparison;
use super::fit::{Fitted, fit};
use super::split::LimitZero;
use super::worst::Worst;
use frictiongen_kernel::Float;

/// The search for the longest piece ends if the shortest length that is too long is at most this multiple of the
/// longest acceptable length. More fits would reduce the number of pieces by at most a tenth.
const LONGEST: f64 = 1.1;
/// Step to which the code rounds the end of a polynomial piece for human readers, as a fraction of the length of the
/// piece. The code does not round the end at a kink of β_lim or at a bound of the range.
const END: f64 = 0.02;
/// A piece probably contains a kink if its error exceeds the allowed error by this factor. The search then locates the
/// kink. The error of a piece with a kink is proportional to its length. The error of a smooth piece falls with a high
/// power of the length.
const KINK: f64 = 30.0;
/// The search for a kink ends if the shortest length that is too long is at most this multiple of the longest
/// acceptable length.
const KINK_FOUND: f64 = 1.0 + 1e-3;
/// Largest number of polynomial pieces that the code fits again after the check. Each repetition adds a point at which
/// later fits are compared. After this number of repetitions the construction fails, because it would probably never
/// end.
const MOST_AGAIN: usize = 1000;
/// Length of the shortest polynomial piece, as a fraction of r. This length is a few hundred rounding units of double
/// precision.
const SHORTEST: f64 = 1e-13;
/// First trial length of a polynomial piece, as a multiple of the length of the previous piece. The factor is large so
/// that the first trial is often too long, which immediately gives an upper bound on the length.
const LONGER: f64 = 1.5;
/// Largest number of fits in the search for the longest polynomial piece from one start.
const MOST_FITS: usize = 200;
/// Target error of the next trial, divided by the allowed error, if the last trial was within the allowed error.
const AIM: f64 = 0.8;
/// Target error of the next trial, divided by the allowed error, if the last trial was too long.
const AIM_AGAIN: f64 = 0.7;
/// The code extrapolates the next trial length only if the error of a fit exceeds this fraction of the allowed error. A
/// smaller error gives no information about the best length.
const TINY: f64 = 1e-6;
/// Bounds on the factor by which the trial length of a piece grows after a fit within the allowed error. The factor
/// comes from a power law, which is only approximate.
const LONGER_BY: [f64; 2] = [1.05, 2.0];
/// Bounds on the factor by which the trial length of a piece shrinks after a piece that was too long.
const SHORTER_BY: [f64; 2] = [0.2, 0.95];

/// Returns a value, limited to the interval [least, most].
fn clamped(value: f64, [least, most]: [f64; 2]) -> f64 {
    value.clamp(least, most)
}

/// Approximation of the tabulated functions by polynomial pieces in a range of r: settings and state of the
/// construction.
pub(super) struct Cover<'a, 'm, S> {
    /// Exact values with which each polynomial piece is compared, and the allowed errors of the fit.
    pub comparison: Comparison<'a, 'm, S>,
    /// Kinks of β_lim, as frequency ratios in ascending order.
    pub kinks: Vec<f64>,
    /// Allowed errors of the check: the first for β_lim, the second for the amplitude and the phase of the contact.
    pub whole: (f64, f64),
    /// Largest number of pieces that the construction may make.
    pub most_pieces: usize,
    /// Length of the last polynomial piece. The first trial length of the next piece follows from it.
    pub last: f64,
}

/// Failure to cover a range: no piece that contains the frequency ratio `at` meets the accuracy.
#[derive(Clone, Copy, Debug)]
pub(super) struct NotCovered {
    pub at: f64,
}

impl<S: Float> Cover<'_, '_, S> {
    /// Returns polynomial pieces that cover the range. The function checks them at points that the fits did not use.
    /// The result also contains the largest error divided by the allowed error, and the number of compared points.
    ///
    /// If the check finds a larger error than allowed, later fits are also compared at the r of this error. The
    /// function then covers the interval of the piece again.
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
                // If several pieces have the same start after rounding, only the last piece is used.
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

    /// Returns polynomial pieces that cover the range, before the check.
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

    /// Appends the pieces between two zeros of β_lim, or between a zero and a bound of the range.
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

    /// Returns the longest polynomial piece that meets the accuracy, from `start` towards `limit`, and the r at which
    /// the piece ends.
    fn longest(
        &mut self,
        start: f64,
        limit: f64,
        zero: Option<LimitZero>,
    ) -> Result<(Fitted<S>, f64), NotCovered> {
        let most = (limit - start).abs();
        let forwards = start < limit;
        // If a kink lies ahead, the piece should end there, because a polynomial cannot follow a kink.
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
            // The zero is used only if its distance is at most the length of the piece. At a larger distance, the
            // powers of the distance to the zero would be nearly equal.
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
                    // The kink is weak, so the piece may extend beyond it without harm.
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
