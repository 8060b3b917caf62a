//! Selects friction ratios that may be the best, and intervals of a scan over friction that may contain better friction
//! ratios.

use super::creep::meeting;
use super::scan::Scanned;
use std::cmp::Ordering;

/// The search examines an interval of the scan over friction only if its estimated amplitude, divided by the best
/// amplitude, is at most this number. The estimate is the amplitude at which the tangents at the interval's two bounds
/// meet.
const WORTH: f64 = 1.05;
/// Largest number of intervals of the scan over friction that the search examines, beginning with the smallest expected
/// amplitude.
const MOST_LOOKED_INTO: usize = 6;
/// Lower bound on the estimated amplitude within an interval of the scan over friction, divided by the smaller
/// amplitude at the interval's two bounds.
const SHARE: f64 = 0.7;
/// Largest relative difference at which two amplitudes are treated as equal. If a more precise evaluation of the band
/// exceeds the earlier amplitude by more than this fraction, the evaluation has found a higher peak.
pub(super) const HOLDS: f64 = 1e-9;

/// A friction ratio that may be the best, with its largest amplitude over the band.
#[derive(Clone, Debug)]
pub(super) struct FrictionCandidate {
    pub at: Scanned,
    pub bracket: [f64; 2],
}

pub(super) fn of_scan(scan: &[Scanned]) -> Vec<FrictionCandidate> {
    let beside = |place: Option<usize>| place.and_then(|place| scan.get(place));
    let complete = scan.iter().enumerate();
    let complete = complete.filter(|(_, at)| at.complete && at.value.is_finite());
    let candidate = |(index, at): (usize, &Scanned)| FrictionCandidate {
        at: at.clone(),
        bracket: [index.checked_sub(1), Some(index + 1)]
            .map(|place| beside(place).map_or(at.beta, |beside| beside.beta)),
    };
    complete.map(candidate).collect()
}

/// Returns the smallest scanned friction ratio from which on the largest amplitude over the band is constant, and this
/// amplitude.
pub(super) fn stays(scan: &[Scanned]) -> Option<(f64, f64)> {
    let last = scan.last().filter(|last| last.complete)?;
    let same = |scanned: &&Scanned| {
        scanned.complete && (scanned.value - last.value).abs() <= HOLDS * last.value
    };
    let first = scan.iter().rev().take_while(same).last()?;
    // If the flag `whole` of the last point is true, the friction of this point keeps the contact stuck over the whole
    // band. Otherwise the function returns the first of the points with equal amplitudes.
    Some((if last.whole { last.beta } else { first.beta }, last.value))
}

/// Orders candidates by amplitude. Among equal amplitudes, the friction above which the amplitude is constant comes
/// first. The remaining candidates of this amplitude follow in ascending order of friction.
pub(super) fn before(
    a: &FrictionCandidate,
    b: &FrictionCandidate,
    stays: Option<(f64, f64)>,
) -> Ordering {
    let rank = |candidate: &FrictionCandidate| {
        let Scanned { beta, value, .. } = candidate.at;
        match stays {
            Some((from, last)) if value <= last && (last - value) <= HOLDS * last => {
                (last, beta != from, beta)
            }
            Some((from, last)) if beta == from && value <= last * (1.0 + HOLDS) => {
                (last, false, beta)
            }
            _ => (value, true, beta),
        }
    };
    let (a, b) = (rank(a), rank(b));
    let order = a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    order.then(a.2.total_cmp(&b.2))
}

/// Returns pairs of neighbouring points of the scan over friction between which the amplitude may have its smallest
/// value.
pub(super) fn between(scan: &[Scanned], best: f64) -> Vec<(Scanned, Scanned)> {
    let pairs = scan.windows(2).filter_map(|pair| match pair {
        [below, above] => Some((below, above)),
        _ => None,
    });
    let mut found: Vec<(f64, (Scanned, Scanned))> = pairs
        .filter_map(|(below, above)| {
            if !(above.value.is_finite() && 0.0 <= above.slope) {
                return None;
            }
            if !below.value.is_finite() {
                // The amplitude at a resonance is unbounded at the lower friction ratio and bounded at the upper
                // friction ratio. The minimum may lie between the two friction ratios.
                return Some((0.0, (below.clone(), above.clone())));
            }
            let falls = below.slope < 0.0;
            // The steady state may change to another steady state in the interval. The slope at one point then does not
            // predict the amplitude at the next point. `least` therefore bounds the estimate from below.
            let least = SHARE * below.value.min(above.value);
            // If the tangents do not meet in the interval, the amplitude is not a convex function of friction. Its
            // tangents then give no bound.
            let low = meeting(below, above).map_or(least, |(_, value)| value.max(least));
            (falls && low <= WORTH * best).then(|| (low, (below.clone(), above.clone())))
        })
        .collect();
    found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    found
        .into_iter()
        .take(MOST_LOOKED_INTO)
        .map(|(_, pair)| pair)
        .collect()
}

/// Returns scanned friction ratios that may be the best, each with its two neighbours. The amplitude at each returned
/// friction ratio is at most that at its neighbours.
pub(super) fn valleys(scan: &[Scanned], best: f64) -> Vec<(Scanned, Scanned, Scanned)> {
    let triples = scan.windows(3).filter_map(|triple| match triple {
        [below, at, above] => {
            let lower = at.value <= below.value && at.value < above.value;
            let worth = at.complete && 0.0 < at.value && at.value <= WORTH * best;
            (lower && worth).then(|| (below.clone(), at.clone(), above.clone()))
        }
        _ => None,
    });
    let mut found: Vec<_> = triples.collect();
    found.sort_by(|(_, a, _), (_, b, _)| a.value.total_cmp(&b.value));
    found.truncate(MOST_LOOKED_INTO);
    found
}
