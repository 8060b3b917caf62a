//! Finds sign changes of a function whose values the code can only sample. The search uses additional samples where the
//! function comes near 0.

use super::Certainty;
use crate::study::golden::reached;

/// Largest number of steps of a search for two hidden sign changes between samples. Three samples with the same sign
/// may hide two changes if the middle sample is closest to 0. Each step reduces an interval to 0.62 of its length.
const STEPS: usize = 60;

/// Returns sample points between `from` and `to`: evenly spaced in r, evenly spaced in 1/r, and close together near
/// each of `marks`.
pub(super) fn samples([from, to]: [f64; 2], count: usize, marks: &[f64]) -> Vec<f64> {
    let share = |i: usize| i as f64 / count as f64;
    let mut places = vec![from, to];
    for i in 1..count {
        places.push(from + (to - from) * share(i));
        places.push(1.0 / (1.0 / from + (1.0 / to - 1.0 / from) * share(i)));
    }
    for mark in marks {
        places.push(*mark);
        let mut width = 1e-9;
        while width < 0.02 {
            places.extend([mark * (1.0 - width), mark * (1.0 + width)]);
            width *= 4.0;
        }
    }
    places.retain(|r| from <= *r && *r <= to);
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Divides a range of r into steps of equal length in 1/r, and returns the bounds between the steps. Sub-harmonics of a
/// resonance are evenly spaced in 1/r.
pub(super) fn steps([from, to]: [f64; 2]) -> Vec<f64> {
    let count = Certainty::STEPS;
    let (first, last) = (1.0 / from, 1.0 / to);
    (1..count)
        .map(|i| 1.0 / (first + (last - first) * (f64::from(i) / f64::from(count))))
        .collect()
}

/// Adds points of `steps` to the ascending list `places`. The added points lie between the first and the last point of
/// `places`.
pub(super) fn merge(places: &mut Vec<f64>, steps: &[f64]) {
    let (Some(first), Some(last)) = (places.first().copied(), places.last().copied()) else {
        return;
    };
    places.extend(steps.iter().filter(|r| first < **r && **r < last));
    places.sort_by(f64::total_cmp);
    places.dedup();
}

/// Returns the sign changes of a function between sample points, in ascending order. Ignores samples at which the
/// function is NaN.
pub(super) fn changes(places: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
    let values: Vec<f64> = places.iter().map(|r| f(*r)).collect();
    let mut all: Vec<(f64, f64)> = places.iter().copied().zip(values).collect();
    let mut hidden = Vec::new();
    for three in all.windows(3) {
        let &[(left, a), (_, b), (right, c)] = three else {
            continue;
        };
        let sign = b.signum();
        let nearest = |other: f64| 0.0 < sign * other && sign * b <= sign * other;
        if nearest(a) && nearest(c) {
            let value = |r: f64| -sign * f(r);
            hidden.extend(reached([left, right], STEPS, value, |value| 0.0 < value));
        }
    }
    all.extend(hidden.into_iter().map(|r| (r, f(r))));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let pairs = all.windows(2).filter_map(|pair| {
        let &[(low, a), (high, b)] = pair else {
            return None;
        };
        if a * b < 0.0 {
            return Some(bisected([low, high], a, &f));
        }
        (b == 0.0).then_some(high)
    });
    pairs.collect()
}

/// Bisects the interval of a sign change down to neighbouring floating-point numbers.
fn bisected([mut low, mut high]: [f64; 2], at_low: f64, f: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return low;
        }
        if 0.0 < f(middle) * at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{changes, samples};

    /// Checks that the search finds two sign changes between two neighbouring samples. The middle one of three samples
    /// is closest to 0, and the search then looks for hidden sign changes.
    #[test]
    fn a_narrow_pair() {
        let places = samples([1.0, 2.0], 16, &[]);
        let found = changes(&places, |r| (r - 1.501).powi(2) - 1e-8);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 1.5009).abs() < 1e-12 && (found[1] - 1.5011).abs() < 1e-12);
    }

    #[test]
    fn none_where_it_jumps_to_nothing() {
        let places = samples([0.5, 4.0], 50, &[2.0]);
        let found = changes(&places, |r| if r < 2.0 { 1.0 } else { f64::NAN });
        assert!(found.is_empty());
    }
}
