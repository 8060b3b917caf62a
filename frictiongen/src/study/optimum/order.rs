//! Orders friction ratios by their largest amplitudes.

use super::scan::Scanned;
use std::cmp::Ordering;

/// Largest relative difference at which two amplitudes are treated as equal.
const SAME: f64 = 1e-9;

/// Returns the smallest scanned friction ratio from which on the largest amplitude over the band is constant, and this
/// amplitude.
pub(super) fn stays(scan: &[Scanned]) -> Option<(f64, f64)> {
    let last = scan.last().filter(|last| last.complete)?;
    let same = |scanned: &&Scanned| {
        scanned.complete && (scanned.value - last.value).abs() <= SAME * last.value
    };
    let first = scan.iter().rev().take_while(same).last()?;
    // If the flag `whole` of the last point is true, the friction of this point keeps the contact stuck over the whole
    // band. Otherwise the function returns the first of the points with equal amplitudes.
    Some((if last.whole { last.beta } else { first.beta }, last.value))
}

/// Orders candidates by amplitude. Among equal amplitudes, the friction above which the amplitude is constant comes
/// first. The remaining candidates of this amplitude follow in ascending order of friction.
pub(super) fn before(a: &Scanned, b: &Scanned, stays: Option<(f64, f64)>) -> Ordering {
    let rank = |scanned: &Scanned| {
        let Scanned { beta, value, .. } = *scanned;
        match stays {
            Some((from, last)) if value <= last && (last - value) <= SAME * last => {
                (last, beta != from, beta)
            }
            Some((from, last)) if beta == from && value <= last * (1.0 + SAME) => {
                (last, false, beta)
            }
            _ => (value, true, beta),
        }
    };
    let (a, b) = (rank(a), rank(b));
    let order = a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    order.then(a.2.total_cmp(&b.2))
}
