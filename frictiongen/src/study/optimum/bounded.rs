//! Finds the friction ratio with the smallest amplitude, from lower bounds on the amplitude.
//!
//! An evaluation at only some frequencies of the band gives a lower bound on the largest amplitude. Between two friction
//! ratios the amplitude is at most a little lower than at both, because its relative slope is limited. The search halves
//! the interval with the lowest bound, until no bound is below the best amplitude. It then seeks the exact minimum next
//! to the best friction ratio, and evaluates the whole band there. If the whole band has a higher peak, the bound of this
//! friction ratio rises, later evaluations include the peak, and the search continues.

use super::look::sorted;
use super::minima::minimum;
use super::order::{before, stays};
use super::peaks::AmplitudeBand;
use super::scan::{Scanned, scanned_at};
use super::whole::whole_below;

/// Largest expected slope of the amplitude: its relative change, divided by the relative change of friction. A minimum
/// next to a steeper fall is found only by the search for the exact minimum.
const STEEPEST: f64 = 3.0;
/// Smallest expected amplitude in a wide interval of friction, divided by the smaller amplitude at its ends.
const LOWEST: f64 = 0.7;
/// Relative difference of amplitudes up to which the search halves no interval.
const NEARLY: f64 = 3e-3;
/// Relative difference from which on an evaluation has found a higher peak.
const HIGHER: f64 = 1e-6;
/// Largest number of friction ratios that the search adds.
const MOST: usize = 300;

/// A friction ratio with a lower bound on its largest amplitude.
struct Bounded {
    at: Scanned,
    /// Interval in which the exact minimum lies, if the search for it has found this friction ratio.
    bracket: [f64; 2],
    /// Number of frequencies that evaluations of the whole band had added before the latest evaluation.
    known: usize,
    /// True if the search has sought the exact minimum next to this friction ratio.
    polished: bool,
}

struct BoundedSearch<'b, 's> {
    band: &'b AmplitudeBand<'s>,
    /// Friction ratios in ascending order.
    all: Vec<Bounded>,
    /// The friction ratio from which on the amplitude is constant, and this amplitude.
    locked: Option<(f64, f64)>,
    /// Smallest friction ratio above 0. Widths of intervals below it are relative to it.
    least: f64,
}

/// Returns the friction ratio with the smallest amplitude over the whole band, and an interval that contains it. If the
/// search reaches its bound on work, the interval contains all friction ratios that may be better.
pub(super) fn lowest(band: &AmplitudeBand<'_>, scan: &[Scanned]) -> Option<(Scanned, [f64; 2])> {
    let positive = scan.iter().map(|at| at.beta).find(|beta| 0.0 < *beta);
    let mut search = BoundedSearch {
        band,
        all: Vec::new(),
        locked: stays(scan),
        least: positive.unwrap_or(1.0),
    };
    for at in scan {
        search.add(at.clone(), 0);
    }
    for _ in 0..MOST {
        if band.amplitude.is_spent() || !search.step()? {
            break;
        }
    }
    let whole = search.all.iter().any(|other| other.at.whole);
    let best = search.best(|at| at.whole || !whole)?;
    let bracket = if band.amplitude.is_spent() {
        search.undecided(best)?
    } else {
        search.around(best)?
    };
    let at = search.all.get(best)?.at.clone();
    at.value.is_finite().then_some((at, bracket))
}

impl BoundedSearch<'_, '_> {
    fn add(&mut self, at: Scanned, known: usize) -> usize {
        let place = self.all.partition_point(|other| other.at.beta < at.beta);
        let bounded = Bounded {
            at,
            bracket: [0.0, f64::INFINITY],
            known,
            polished: false,
        };
        self.all.insert(place, bounded);
        place
    }

    /// Takes one step towards the best friction ratio. Returns false if no step is left.
    fn step(&mut self) -> Option<bool> {
        let (band, best) = (self.band, self.best(|_| true)?);
        let Bounded {
            at,
            known,
            polished,
            ..
        } = self.all.get(best)?;
        let (beta, value) = (at.beta, at.value);
        if !at.whole && (!at.complete || *known < band.learned()) {
            let found = scanned_at(band, beta, self.second(best));
            self.raise(best, found)?;
        } else if let Some(middle) = self.promising(value) {
            self.add(scanned_at(band, middle, value), band.learned());
        } else if 0.0 < value && !*polished {
            let found = self.beside(best);
            self.all.get_mut(best)?.polished = true;
            if let Some((at, bracket)) = found.filter(|(at, _)| at.value < value) {
                let place = self.add(at, band.learned());
                let added = self.all.get_mut(place)?;
                (added.bracket, added.polished) = (bracket, true);
            }
        } else if !at.whole {
            let found = whole_below(band, beta, self.second(best));
            let peaks = found.peaks.clone();
            if self.raise(best, found)? {
                band.learn_largest(&peaks);
            }
        } else {
            return Some(false);
        }
        Some(true)
    }

    /// Returns the index of the friction ratio with the lowest bound, among those that count.
    fn best(&self, counts: impl Fn(&Scanned) -> bool) -> Option<usize> {
        let all = self.all.iter().enumerate();
        let all = all.filter(|(_, other)| counts(&other.at));
        let least = all.min_by(|(_, a), (_, b)| before(&a.at, &b.at, self.locked));
        least.map(|(index, _)| index)
    }

    /// Returns the smallest complete amplitude of all friction ratios but the best.
    fn second(&self, best: usize) -> f64 {
        let others = self.all.iter().enumerate();
        let others = others.filter(|(index, other)| *index != best && other.at.complete);
        others.fold(f64::INFINITY, |least, (_, other)| least.min(other.at.value))
    }

    /// Takes the result of another evaluation of a friction ratio. Returns true if it has a higher peak.
    fn raise(&mut self, index: usize, found: Scanned) -> Option<bool> {
        let known = self.band.learned();
        let of = self.all.get_mut(index)?;
        let bound = of.at.value;
        let is_higher = bound * (1.0 + HIGHER) < found.value;
        // The evaluation may miss the lower of two neighbouring maxima, which an earlier evaluation may have found.
        let peaks = of.at.peaks.drain(..).chain(found.peaks).collect();
        of.at = Scanned {
            value: bound.max(found.value),
            peaks: sorted(peaks),
            ..found
        };
        of.known = known;
        if is_higher {
            // The exact minimum was that of the lower bounds.
            of.bracket = [0.0, f64::INFINITY];
            of.polished = false;
        }
        Some(is_higher)
    }

    /// Returns the middle of the interval with the lowest bound, if this bound is below the best amplitude.
    fn promising(&self, best: f64) -> Option<f64> {
        let bounds = self.intervals();
        let bounds = bounds.filter(|(bound, _)| *bound < best * (1.0 - NEARLY));
        let least = bounds.min_by(|(a, _), (b, _)| a.total_cmp(b));
        least.map(|(_, [low, high])| 0.5 * (low + high))
    }

    /// Returns the intervals between neighbouring friction ratios, each with a lower bound on its amplitude.
    fn intervals(&self) -> impl Iterator<Item = (f64, [f64; 2])> {
        self.all.windows(2).filter_map(|pair| {
            let [below, above] = pair else { return None };
            let (low, high) = (&below.at, &above.at);
            let is_flat = low.complete && high.complete && low.value == high.value;
            let width = (high.beta - low.beta) / high.beta.max(self.least);
            let share = (1.0 - 0.5 * STEEPEST * width).max(LOWEST);
            let bound = share * low.value.min(high.value);
            (!is_flat).then_some((bound, [low.beta, high.beta]))
        })
    }

    /// Returns the exact minimum between the best friction ratio and its neighbour on the side on which the amplitude
    /// falls, with an interval that contains it.
    fn beside(&self, best: usize) -> Option<(Scanned, [f64; 2])> {
        let at = &self.all.get(best)?.at;
        let falls = at.slope < 0.0;
        let other = if falls {
            best + 1
        } else {
            best.checked_sub(1)?
        };
        let other = &self.all.get(other)?.at;
        let (below, above) = if falls { (at, other) } else { (other, at) };
        minimum(self.band, below.clone(), above.clone(), at.value)
    }

    /// Returns the interval between the neighbours of a friction ratio.
    fn around(&self, index: usize) -> Option<[f64; 2]> {
        let of = self.all.get(index)?;
        let beta = |index: Option<usize>| Some(self.all.get(index?)?.at.beta);
        let [low, high] = of.bracket;
        Some([
            beta(index.checked_sub(1)).unwrap_or(of.at.beta).max(low),
            beta(Some(index + 1)).unwrap_or(of.at.beta).min(high),
        ])
    }

    /// Returns an interval that contains all friction ratios whose bound is below the amplitude of the best.
    fn undecided(&self, best: usize) -> Option<[f64; 2]> {
        let value = self.all.get(best)?.at.value;
        let open = self.intervals().filter(|(bound, _)| *bound < value);
        let around = self.around(best)?;
        Some(open.fold(around, |[low, high], (_, [from, to])| {
            [low.min(from), high.max(to)]
        }))
    }
}
