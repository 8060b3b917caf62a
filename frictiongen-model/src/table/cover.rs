//! A range covered by pieces, each as long as the accuracy allows.

use super::check;
use super::digits::to_decimals;
use super::errors::Comparison;
use super::fit::{Fitted, fit};
use super::split::Edge;
use super::worst::Worst;
use frictiongen_kernel::Float;

/// A piece counts as the longest when one longer by this is too long: with more fits a table would lose a tenth of its
/// pieces at most.
const LONGEST: f64 = 1.1;
/// Where nothing else ends a piece, its end is rounded to this share of it, for people who read it.
const END: f64 = 0.02;
/// What is too long by this much is so for a kink, whose place is then sought: a bend leaves an
/// error that falls with the length alone, and not with as high a power of it as there are terms.
const KINK: f64 = 30.0;
/// A kink is found to this share of a piece.
const KINK_FOUND: f64 = 1.0 + 1e-3;
/// So many pieces may be covered anew: each adds a place to look at, and what does not end by then does not end.
const MOST_AGAIN: usize = 1000;
/// No piece is shorter than this share of r, some hundreds of roundings of double precision.
const SHORTEST: f64 = 1e-13;
/// A piece is tried at so many times the length of the one before: one that is too long bounds it from above at once.
const LONGER: f64 = 1.5;
/// No piece takes more fits than this: from the whole range to [`SHORTEST`] by halves takes 44.
const MOST_FITS: usize = 200;
/// The next length is guessed for this error over what is allowed: after one that will do,
const AIM: f64 = 0.8;
/// and after one that is too long.
const AIM_AGAIN: f64 = 0.7;
/// Errors below this, over what is allowed, say nothing of a length.
const TINY: f64 = 1e-6;
/// A guess is longer, or shorter, by no less and by no more than this: errors go only nearly
/// by a power of the length.
const LONGER_BY: [f64; 2] = [1.05, 2.0];
const SHORTER_BY: [f64; 2] = [0.2, 0.95];

/// The nearest value between two.
fn clamped(value: f64, [least, most]: [f64; 2]) -> f64 {
    value.clamp(least, most)
}

/// A range about to be covered.
pub(super) struct Cover<'a, 'm, S> {
    /// What its pieces are compared with.
    pub comparison: Comparison<'a, 'm, S>,
    /// Where β_lim bends, ascending.
    pub kinks: Vec<f64>,
    /// What the check allows of β_lim, and of amplitude and phase.
    pub whole: (f64, f64),
    /// No more pieces than this.
    pub most_pieces: usize,
    /// The length of the last piece.
    pub last: f64,
}

/// Why a range could not be covered: where.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stuck {
    pub at: f64,
}

impl<S: Float> Cover<'_, '_, S> {
    /// Pieces from one end of the range to the other, checked at points that their fits did not see; and the largest
    /// error, over what is allowed.
    ///
    /// Where the check finds more than is allowed, the place is looked at from then on, and the piece is covered anew.
    pub fn checked(
        &mut self,
        low: f64,
        high: f64,
    ) -> Result<(Vec<Fitted<S>>, Worst, usize), Stuck> {
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
                // Of pieces that round to one place the last one holds.
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
                return Err(Stuck { at: seen.at });
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

    /// Pieces from one end of the range to the other.
    fn range(&mut self, low: f64, high: f64) -> Result<Vec<Fitted<S>>, Stuck> {
        let mut pieces = Vec::new();
        let zeros = self.comparison.landmarks.zeros.clone();
        let mut from = low;
        let mut left: Option<Edge> = None;
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

    /// Pieces between two zeros, or a zero and an end.
    fn between(
        &mut self,
        (low, high): (f64, f64),
        left: Option<Edge>,
        right: Option<Edge>,
        pieces: &mut Vec<Fitted<S>>,
    ) -> Result<(), Stuck> {
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
                return Err(Stuck { at: from });
            }
        }
        pieces.extend(last);
        Ok(())
    }

    /// The longest piece from `start` towards `limit`, and where it ends.
    fn longest(
        &mut self,
        start: f64,
        limit: f64,
        zero: Option<Edge>,
    ) -> Result<(Fitted<S>, f64), Stuck> {
        let most = (limit - start).abs();
        let forwards = start < limit;
        // The kinks ahead, at which a piece had better end.
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
                // A kink keeps its digits.
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
            // A zero farther off than the piece is long would make powers of its distance all alike.
            let zero = zero.filter(|zero| zero.distance(start).abs() <= length);
            let piece = fit(self.comparison.exact, between, zero, self.comparison.form)
                .ok_or(Stuck { at: start })?;
            let error = self.comparison.error(&piece, between, zero);
            if error <= 1.0 {
                (good, known) = (length, Some((piece, end)));
                if length >= most {
                    break;
                }
                if length >= stop {
                    // Beyond a kink, if it is a weak one.
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
                return Err(Stuck { at: start });
            }
        }
        self.last = good;
        known.ok_or(Stuck { at: start })
    }
}
