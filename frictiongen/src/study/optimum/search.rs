//! Finds the friction with which the largest amplitude over a band is smallest.
//!
//! A scan over friction brackets the minima of the largest amplitude. Golden sections narrow each bracket: the largest
//! amplitude has corners where two peaks are equally high, and jumps where the motion reaches another steady state. At
//! two equal peaks, secants then equalise the two heights. A finer grid of frequencies checks the result. If it shows a
//! higher peak, the search goes on and includes the frequency of this peak.

use super::band::{Band, BandPeak, Closely, FINELY, Look, Merit};
use super::evaluator::FrictionAmount;
use crate::study::golden::{self, GOLDEN};

/// Smallest friction of the scan, divided by the median of β*_lim over the band.
const LEAST: f64 = 0.02;
/// Largest possible friction of the scan, divided by the median of β*_lim over the band.
const MOST: f64 = 1000.0;
/// Largest quotient of two neighbouring frictions of the scan.
const STEP: f64 = 1.16;
/// Smallest number of steps of the scan.
const STEPS: f64 = 40.0;
/// Additional frictions of the scan, divided by the smallest friction with a stuck state over the whole band. The motion
/// from rest may still slide at these frictions.
const BEYOND: [f64; 6] = [1.05, 1.15, 1.3, 1.6, 2.5, 4.0];
/// Additional frictions of the scan above the friction that bounds the amplitude at all resonances, as relative
/// distances from this friction.
const BOUNDED: [f64; 6] = [1e-3, 0.01, 0.03, 0.06, 0.1, 0.2];
/// The scan evaluates a friction completely if its amplitude, divided by the best amplitude, is at most this. The widest
/// tolerance of the friction depends on all amplitudes up to 10 % above the best.
const MARGIN: f64 = 1.12;
/// Largest number of minima of the scan that the search narrows.
const MOST_VALLEYS: usize = 5;
/// Relative widths of an interval of friction at which golden sections pause for secants, and end.
const PAUSE: f64 = 1e-4;
const NARROW: f64 = 2e-7;
/// Largest relative change of the amplitude, divided by the relative change of friction, for which golden sections stay
/// in an interval whose amplitude is above another minimum.
const STEEP: f64 = 3.0;
/// Largest number of peaks that golden sections follow from each friction.
const FOLLOWED: usize = 4;
/// Golden sections follow a peak if its amplitude, divided by the largest amplitude, is at least this.
const WORTH: f64 = 0.8;
/// Largest number of golden sections.
const SECTIONS: usize = 60;
/// Largest number of checks on the finer grid.
const CHECKS: usize = 5;
/// Relative excess of a check over the search up to which the check confirms the result.
const SAME: f64 = 1e-5;
/// Factor by which a check must exceed the amplitude of another friction, so that an unfinished search prefers the other
/// friction without a check.
const CLEARLY: f64 = 1.1;
/// Relative difference of two peaks from which secants may equalise them.
pub(super) const NEARLY_EQUAL: f64 = 1e-3;
/// Relative difference of two peaks at which they count as equally high.
const EQUAL: f64 = 1e-13;
/// Relative step in friction of the finite differences of a peak.
const DIFFERENCE: f64 = 1e-6;
/// Relative tolerance of the maxima of the limits over frequency.
const PLACE: f64 = 1e-10;
/// Largest relative difference of an amplitude on an interval of friction that counts as flat.
const FLAT: f64 = 1e-9;

/// The event that ended the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SearchEnd {
    Converged,
    /// Each check on the finer grid has found a higher peak.
    Unconfirmed,
    Spent,
}

/// The best friction that a search has found.
#[derive(Clone, Debug)]
pub(super) struct Least {
    pub at: Look,
    pub end: SearchEnd,
    /// Interval of β that contains the best friction: the narrowest interval of the golden sections.
    pub bracket: [f64; 2],
    /// The scan over friction, in ascending order.
    pub scan: Vec<Look>,
}

/// The limits of friction over a band.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    /// Smallest value of β_lim and β*_lim over the band; NaN for several contacts.
    pub free_to: f64,
    /// Largest value of β*_lim. It is infinite if at some frequency no friction keeps all contacts stuck.
    pub locked_from: f64,
    /// Median of the finite values of β*_lim.
    middle: f64,
}

impl Band<'_> {
    /// Returns the limits of friction over the band.
    pub(super) fn range(&self) -> Range {
        let places = self.frequencies();
        let limits: Vec<[f64; 2]> = places.iter().map(|r| self.evaluator.limits(*r)).collect();
        let sliding = limits.iter().map(|[_, sliding]| *sliding);
        let mut finite: Vec<f64> = sliding
            .filter(|limit| 0.0 < *limit && limit.is_finite())
            .collect();
        finite.sort_by(f64::total_cmp);
        let middle = finite.get(finite.len() / 2).copied().unwrap_or(1.0);
        let extreme = |of: &dyn Fn([f64; 2]) -> f64| {
            let value = |index: Option<usize>| {
                index
                    .and_then(|index| limits.get(index))
                    .map_or(f64::NEG_INFINITY, |limits| of(*limits))
            };
            let mut best = f64::NEG_INFINITY;
            for (index, r) in places.iter().enumerate() {
                let own = value(Some(index));
                let sides = [index.checked_sub(1), Some(index + 1)];
                if !own.is_finite() || sides.iter().any(|side| own < value(*side)) {
                    best = best.max(own);
                    continue;
                }
                let ends = sides.map(|side| {
                    let side = side.and_then(|side| places.get(side));
                    side.copied().unwrap_or(*r)
                });
                let f = |r: f64| of(self.evaluator.limits(r));
                best = best.max(golden::largest(f, ends, (*r, own), PLACE).1);
            }
            best
        };
        let locked_from = extreme(&|[_, sliding]| sliding);
        // The minimum of NaN and a number would be the number.
        let free_to = -extreme(&|[continuous, sliding]| match continuous < sliding {
            true => -continuous,
            false if continuous.is_nan() => f64::NAN,
            false => -sliding,
        });
        Range {
            free_to: if free_to.is_finite() {
                free_to
            } else {
                f64::NAN
            },
            locked_from: if locked_from < MOST * MOST * middle {
                locked_from
            } else {
                f64::INFINITY
            },
            middle,
        }
    }

    /// Returns the frictions of the scan in the order in which the search evaluates them. `window` restricts the scan to
    /// an interval.
    fn frictions(&self, range: Range, unbounded_to: f64, window: Option<[f64; 2]>) -> Vec<f64> {
        let middle = range.middle;
        let top = range.locked_from.min(MOST * middle).max(2.0 * unbounded_to);
        let low = (LEAST * middle).min(0.5 * top);
        let steps = ((top / low).ln() / STEP.ln()).ceil().max(STEPS);
        let step = |place: u32| low * (top / low).powf(f64::from(place) / steps);
        let mut all: Vec<f64> = (0..steps as u32).map(step).collect();
        all.extend(BOUNDED.map(|share| unbounded_to * (1.0 + share)));
        all.extend([0.0, top]);
        all.extend(Some(range.free_to).filter(|free| free.is_finite() && *free < top));
        if !self.evaluator.locks() {
            all.extend(BEYOND.map(|share| top * share));
        }
        if let Some([from, to]) = window {
            all.retain(|beta| from < *beta && *beta < to);
            all.extend([from, to]);
        }
        all.sort_by(f64::total_cmp);
        all.dedup();
        // The first frictions are those in the middle of the range: their amplitudes exclude most of the others early.
        let start = middle;
        let distance = |beta: &f64| (beta.max(1e-9 * start) / start).ln().abs();
        all.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        all
    }

    /// Evaluates the grid at some frictions. Returns the results in ascending order of friction.
    fn scanned(&self, frictions: Vec<f64>) -> Vec<Look> {
        let mut scan: Vec<Look> = Vec::new();
        let mut best = Merit::WORST;
        for beta in frictions {
            let look = self.look(
                FrictionAmount::Ratio(beta),
                best.times(MARGIN),
                Closely::Grid,
            );
            if look.complete && look.merit < best {
                best = look.merit;
            }
            scan.push(look);
            if self.is_spent() && best < Merit::WORST {
                break;
            }
        }
        scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
        scan
    }

    /// Finds the friction with which the largest amplitude over the band is smallest, within a bound on work. Returns
    /// `None` if no friction bounds the amplitude. `window` restricts the search to an interval of friction.
    pub(super) fn least(
        &self,
        (range, unbounded_to): (Range, f64),
        window: Option<[f64; 2]>,
        work: usize,
    ) -> Option<Least> {
        self.allow(work);
        let mut scan = self.scanned(self.frictions(range, unbounded_to, window));
        let mut checked: Vec<(Look, [f64; 2])> = Vec::new();
        let (mut end, mut ran_out) = (SearchEnd::Unconfirmed, false);
        for _ in 0..CHECKS {
            let Some((found, bracket)) = self.best_of(&mut scan) else {
                break;
            };
            let known = least_merit(&checked);
            let mut spent = self.is_spent();
            let check = self.check(found.beta, known.times(1.0 + SAME), work);
            let (value, expected) = (check.merit.value, found.merit.value);
            let confirmed = check.complete
                && (value - expected).abs() <= SAME * expected
                && check.merit.excess <= found.merit.excess.max(SAME);
            if check.complete {
                checked.push((check.clone(), bracket));
            } else if checked.is_empty() {
                // The check has reached its bound on work.
                let merit = if check.merit < found.merit {
                    found.merit
                } else {
                    check.merit
                };
                let look = Look {
                    merit,
                    ..check.clone()
                };
                checked.push((look, bracket));
                (spent, ran_out) = (true, true);
            }
            insert(&mut scan, check);
            if confirmed || spent || self.is_spent() {
                end = SearchEnd::Converged;
                break;
            }
            if !self.follows.replace(true) {
                // The closed forms have not led to the motion from rest. The search evaluates the best frictions again.
                for look in &mut scan {
                    look.complete = look.beta == found.beta && look.complete;
                }
            }
        }
        if self.is_spent() || ran_out {
            end = SearchEnd::Spent;
            // No work is left for the check of another friction. If the checked one is clearly worse than the scan, the
            // result is the best of the scan.
            let known = least_merit(&checked);
            let other = self.best_of(&mut scan).filter(|(look, _)| {
                let differs = checked.iter().all(|(other, _)| other.beta != look.beta);
                differs && look.merit.times(CLEARLY) < known
            });
            checked.extend(other);
        }
        let order = |a: &(Look, [f64; 2]), b: &(Look, [f64; 2])| {
            let order = a.0.merit.partial_cmp(&b.0.merit);
            order.unwrap_or(std::cmp::Ordering::Equal)
        };
        let (at, bracket) = checked.into_iter().min_by(order)?;
        let value = at.merit.value;
        value.is_finite().then_some(Least {
            at,
            end,
            bracket,
            scan,
        })
    }

    /// Returns the best friction between the points of the scan, and an interval that contains it. Evaluates the points
    /// again whose known amplitude is a lower bound near the best amplitude.
    fn best_of(&self, scan: &mut [Look]) -> Option<(Look, [f64; 2])> {
        let mut best = Merit::WORST;
        for look in scan.iter() {
            if look.complete && look.merit < best {
                best = look.merit;
            }
        }
        for look in scan.iter_mut() {
            if !look.complete && look.merit <= best.times(MARGIN) && !self.is_spent() {
                let friction = FrictionAmount::Ratio(look.beta);
                *look = self.look(friction, best.times(MARGIN), Closely::Grid);
                if look.complete && look.merit < best {
                    best = look.merit;
                }
            }
        }
        let merit = |index: Option<usize>| {
            index
                .and_then(|index| scan.get(index))
                .map_or(Merit::WORST, |look| look.merit)
        };
        let mut valleys: Vec<usize> = (0..scan.len())
            .filter(|index| {
                let own = merit(Some(*index));
                let complete = scan.get(*index).is_some_and(|look| look.complete);
                complete && own <= merit(index.checked_sub(1)) && own < merit(Some(index + 1))
                    || complete && own == best
            })
            .collect();
        valleys.sort_by(|a, b| {
            let order = merit(Some(*a)).partial_cmp(&merit(Some(*b)));
            order.unwrap_or(std::cmp::Ordering::Equal)
        });
        let mut found: Option<(Look, [f64; 2])> = None;
        for index in valleys.into_iter().take(MOST_VALLEYS) {
            let Some(at) = scan.get(index) else { continue };
            if best.times(MARGIN) < at.merit {
                break;
            }
            let end = |index: Option<usize>| {
                index
                    .and_then(|index| scan.get(index))
                    .map_or(at.beta, |look| look.beta)
            };
            let ends = [end(index.checked_sub(1)), end(Some(index + 1))];
            let around = [index.checked_sub(1), Some(index), Some(index + 1)];
            let around = around.iter().filter_map(|index| scan.get((*index)?));
            let rival = found
                .as_ref()
                .map_or(Merit::WORST, |(found, _)| found.merit);
            let narrowed = self.narrowed(seeds(around), (at.clone(), ends), rival);
            if found
                .as_ref()
                .is_none_or(|(found, _)| narrowed.0.merit < found.merit)
            {
                found = Some(narrowed);
            }
        }
        found
    }

    /// Narrows an interval of friction around the best friction. The golden sections follow only the highest peaks. If
    /// the whole grid then shows a higher peak, they start again and include this peak.
    fn narrowed(
        &self,
        mut seeds: Vec<f64>,
        (start, ends): (Look, [f64; 2]),
        rival: Merit,
    ) -> (Look, [f64; 2]) {
        if start.merit.value == 0.0 && start.merit.excess == 0.0 {
            return (start, ends);
        }
        let mut best: Option<(Look, [f64; 2])> = None;
        let mut from = start;
        for _ in 0..CHECKS {
            let (found, bracket) = self.sections(&seeds, (from, ends), (rival, PAUSE));
            let (found, bracket) = match self.equalised(&found, bracket) {
                Some(found) => found,
                None => self.sections(&seeds, (found, bracket), (rival, NARROW)),
            };
            let friction = FrictionAmount::Ratio(found.beta);
            let check = self.look(friction, Merit::WORST, Closely::Grid);
            if !check.complete {
                return best.unwrap_or((found, bracket));
            }
            let higher = found.merit.times(1.0 + SAME) < check.merit;
            for peak in check.peaks.iter().take(FOLLOWED) {
                add_seed(&mut seeds, peak.r);
            }
            if best
                .as_ref()
                .is_none_or(|(best, _)| check.merit < best.merit)
            {
                best = Some((check.clone(), bracket));
            }
            from = check;
            if !higher || self.is_spent() {
                break;
            }
        }
        best.unwrap_or((from, ends))
    }

    /// Narrows an interval of friction by golden sections, up to a relative width.
    fn sections(
        &self,
        seeds: &[f64],
        (mut at, [mut low, mut high]): (Look, [f64; 2]),
        (rival, width): (Merit, f64),
    ) -> (Look, [f64; 2]) {
        for _ in 0..SECTIONS {
            let relative = (high - low) / high;
            if relative <= width
                || rival.times(1.0 + STEEP * relative) < at.merit
                || self.is_spent()
            {
                break;
            }
            let side = if high - at.beta < at.beta - low {
                low
            } else {
                high
            };
            let beta = at.beta + (1.0 - GOLDEN) * (side - at.beta);
            let look = match self.evaluator.has_bounds() {
                true => self.look(FrictionAmount::Ratio(beta), at.merit, Closely::Grid),
                false => self.tracked(beta, seeds, at.merit),
            };
            let worse = if look.complete && look.merit < at.merit {
                std::mem::replace(&mut at, look).beta
            } else {
                beta
            };
            if worse < at.beta {
                low = worse;
            } else {
                high = worse;
            }
        }
        (at, [low, high])
    }

    /// Equalises two peaks of nearly the same height by secants, if one falls and the other rises with friction.
    fn equalised(&self, at: &Look, bracket: [f64; 2]) -> Option<(Look, [f64; 2])> {
        let seeds = self.crossing(at)?.map(|peak| peak.r);
        let apart = |beta: f64| match self.near(beta, &seeds, FINELY).as_slice() {
            [a, b] => ((a.value - b.value) / a.value, a.value.max(b.value)),
            _ => (f64::NAN, f64::NAN),
        };
        let (mut last, mut beta) = (at.beta * (1.0 + DIFFERENCE), at.beta);
        let (mut before, mut here) = (apart(last), apart(beta));
        for _ in 0..12 {
            let next = beta - here.0 * (beta - last) / (here.0 - before.0);
            if here.0.abs() <= EQUAL || !next.is_finite() || self.is_spent() {
                break;
            }
            (last, before) = (beta, here);
            (beta, here) = (next, apart(next));
        }
        let is_close = (beta / at.beta - 1.0).abs() < NEARLY_EQUAL && here.0.abs() <= 10.0 * EQUAL;
        let [low, high] = bracket;
        let merit = Merit {
            value: here.1,
            ..at.merit
        };
        let found = Look {
            beta,
            merit,
            ..at.clone()
        };
        is_close.then_some((found, [low.min(beta), high.max(beta)]))
    }

    /// Returns two peaks of nearly the same height, of which one falls and the other rises with friction.
    pub(super) fn crossing(&self, at: &Look) -> Option<[BandPeak; 2]> {
        let top = at.peaks.first()?;
        let slope = self.slope(at.beta, top)?;
        let mut others = at.peaks.iter().skip(1);
        let other = others.find(|peak| {
            top.value * (1.0 - NEARLY_EQUAL) <= peak.value
                && self
                    .slope(at.beta, peak)
                    .is_some_and(|other| other * slope < 0.0)
        })?;
        Some([*top, *other])
    }

    /// Returns the derivative of a peak's amplitude with respect to friction. Returns `None` if the amplitude jumps, or
    /// is not bounded.
    pub(super) fn slope(&self, beta: f64, peak: &BandPeak) -> Option<f64> {
        let step = DIFFERENCE * beta;
        let [below, above] = [beta - step, beta + step].map(|beta| {
            let found = self.near(beta, &[peak.r], FINELY);
            found.first().map_or(f64::NAN, |peak| peak.value)
        });
        let bent = |value: f64| (value - peak.value).abs() <= NEARLY_EQUAL * peak.value;
        let slope = (above - below) / (2.0 * step);
        (slope.is_finite() && bent(below) && bent(above)).then_some(slope)
    }

    /// Returns the interval of friction around the best friction in which the amplitude exceeds the best amplitude by at
    /// most the fraction `excess`. Its upper bound is infinite if no point of the scan exceeds this.
    pub(super) fn tolerance(&self, least: &Least, range: Range, excess: f64) -> [f64; 2] {
        let best = &least.at;
        let level = best.merit.value * (1.0 + excess.max(FLAT));
        let below = least.scan.iter().rev().filter(|look| look.beta < best.beta);
        let above = least.scan.iter().filter(|look| best.beta < look.beta);
        let from = self.edge(best, below, level).unwrap_or(0.0);
        let to = self.edge(best, above, level).unwrap_or(f64::INFINITY);
        let (locked, accuracy) = (range.locked_from, self.evaluator.accuracy());
        let near =
            |beta: f64| locked.is_finite() && (beta - locked).abs() <= 2.0 * accuracy * locked;
        [from, to].map(|beta| if near(beta) { locked } else { beta })
    }

    /// Returns the friction at which the largest amplitude reaches `level`, from the best friction outwards. Returns
    /// `None` if no scanned amplitude exceeds the level.
    fn edge<'l>(
        &self,
        best: &'l Look,
        mut outwards: impl Iterator<Item = &'l Look>,
        level: f64,
    ) -> Option<f64> {
        let mut inside = best;
        let outside = loop {
            let look = outwards.next()?;
            if level < look.merit.value || 0.0 < look.merit.excess {
                break look;
            }
            inside = look;
        };
        let seeds = seeds([inside, outside, best].into_iter());
        let above = |beta: f64| self.highest_near(beta, &seeds) - level;
        let (mut a, mut at_a) = (inside.beta, inside.merit.value - level);
        let (mut b, mut at_b) = (outside.beta, above(outside.beta));
        // Regula falsi with the Illinois rule; bisection if an amplitude is infinite.
        for _ in 0..40 {
            if (b - a).abs() <= self.evaluator.accuracy() * b.abs() || self.is_spent() {
                break;
            }
            let mut middle = b - at_b * (b - a) / (at_b - at_a);
            if !(middle.is_finite() && (middle - a) * (middle - b) < 0.0) {
                middle = 0.5 * (a + b);
            }
            let value = above(middle);
            if value <= 0.0 {
                at_b *= 0.5;
                (a, at_a) = (middle, value);
            } else {
                at_a *= 0.5;
                (b, at_b) = (middle, value);
            }
        }
        Some(a)
    }
}

/// Returns the least merit of the checked frictions.
fn least_merit(checked: &[(Look, [f64; 2])]) -> Merit {
    let merits = checked.iter().map(|(look, _)| look.merit);
    merits.fold(
        Merit::WORST,
        |best, merit| if merit < best { merit } else { best },
    )
}

/// Returns the frequency ratios of the highest peaks at some frictions.
fn seeds<'l>(looks: impl Iterator<Item = &'l Look>) -> Vec<f64> {
    let mut all = Vec::new();
    for look in looks {
        let worth = look.peaks.iter().take(FOLLOWED);
        for peak in worth.filter(|peak| WORTH * look.merit.value <= peak.value) {
            add_seed(&mut all, peak.r);
        }
    }
    all
}

/// Adds a frequency ratio, unless a search from a known one would probably lead to the same peak.
fn add_seed(seeds: &mut Vec<f64>, r: f64) {
    if !seeds.iter().any(|seed| (seed - r).abs() <= 1e-3 * r) {
        seeds.push(r);
    }
}

/// Inserts a point into the scan. It replaces a point with the same friction.
pub(super) fn insert(scan: &mut Vec<Look>, look: Look) {
    let place = scan.partition_point(|other| other.beta < look.beta);
    match scan.get_mut(place).filter(|other| other.beta == look.beta) {
        Some(known) => *known = look,
        None => scan.insert(place, look),
    }
}
