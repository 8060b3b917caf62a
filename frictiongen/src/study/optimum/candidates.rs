//! Friction ratios that may be the best, and where between those of a scan others may lie.

use super::creep::meeting;
use super::scan::Scanned;
use std::cmp::Ordering;

/// A place between two of the scan is looked into if their tangents meet below this share of the best.
const WORTH: f64 = 1.05;
/// So many of them are looked into, those that promise most.
const MOST_LOOKED_INTO: usize = 6;
/// No minimum is expected below this share of the values beside it.
const SHARE: f64 = 0.7;
/// A closer look finds no more if it is by less than this share.
pub(super) const HOLDS: f64 = 1e-9;

/// A friction ratio that may be the best.
#[derive(Clone, Debug)]
pub(super) struct Candidate {
    pub at: Scanned,
    pub bracket: [f64; 2],
    /// Whether it was not looked for between friction ratios of the scan.
    pub of_scan: bool,
}

pub(super) fn of_scan(scan: &[Scanned]) -> Vec<Candidate> {
    let beside = |place: Option<usize>| place.and_then(|place| scan.get(place));
    let complete = scan.iter().enumerate();
    let complete = complete.filter(|(_, at)| at.complete && at.value.is_finite());
    let candidate = |(index, at): (usize, &Scanned)| Candidate {
        at: at.clone(),
        bracket: [index.checked_sub(1), Some(index + 1)]
            .map(|place| beside(place).map_or(at.beta, |beside| beside.beta)),
        of_scan: true,
    };
    complete.map(candidate).collect()
}

/// The least friction ratio of the scan from which on nothing changes, with the amplitude there.
pub(super) fn stays(scan: &[Scanned]) -> Option<(f64, f64)> {
    let last = scan.last().filter(|last| last.complete)?;
    let same = |scanned: &&Scanned| {
        scanned.complete && (scanned.value - last.value).abs() <= HOLDS * last.value
    };
    let first = scan.iter().rev().take_while(same).last()?;
    // Held by so much that no more changes anything, or by the last of the scan alone.
    Some((if last.whole { last.beta } else { first.beta }, last.value))
}

/// Of equal ones first that from which on nothing changes, then that of the least friction.
pub(super) fn before(a: &Candidate, b: &Candidate, stays: Option<(f64, f64)>) -> Ordering {
    let rank = |candidate: &Candidate| {
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

/// Neighbours of the scan between which there is a minimum that may be the least.
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
                // Beyond the friction that bounds a resonance.
                return Some((0.0, (below.clone(), above.clone())));
            }
            let falls = below.slope < 0.0;
            // Where steady states change, a slope of a place says nothing of the next.
            let least = SHARE * below.value.min(above.value);
            // Where the tangents do not meet between, the amplitude is not convex there, and they tell nothing.
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

/// Friction ratios of the scan that are no worse than their neighbours and promise to be the best.
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
