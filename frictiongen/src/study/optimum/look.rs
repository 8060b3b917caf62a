//! Looks at a band. A look evaluates the amplitude over the band at one friction ratio and finds its local maxima.
//!
//! The first look at a friction ratio takes some places only. A whole look takes all of them.

use super::amplitude::Friction;
use super::peaks::{PLACE, Peak};
use super::places::Place;

/// Largest ratio of two friction ratios for which the second number, a factor, bounds the expected change of amplitude.
const FIRST: [f64; 2] = [1.5, 2.0];
/// The same two numbers as in `FIRST`, for a whole look.
const WHOLE: [f64; 2] = [1.1, 4.0];
/// Factor for an amplitude that is known only at a more distant friction ratio.
const UNKNOWN: f64 = 5.0;

/// The precision of a look at a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closely {
    /// Enough to compare friction ratios.
    First,
    /// All places, with each maximum to rounding.
    Whole,
}

/// The result of a look at a band.
#[derive(Clone, Debug)]
pub(super) struct Look {
    /// The local maxima found, in descending order.
    pub peaks: Vec<Peak>,
    /// True if the look was completed. Otherwise the largest amplitude exceeds the cutoff, or the work was spent.
    pub complete: bool,
}

/// The amplitude at a place that is known before the motion is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// The friction ratio of the last followed motion at this place. NaN before the first.
    pub beta: f64,
    /// The amplitude of that motion. Before the first, it is the larger amplitude of the chain without friction and
    /// with its contact stuck.
    pub value: f64,
}

impl Known {
    /// Returns the largest amplitude that is expected at another friction ratio.
    pub fn promise(self, friction: Friction, closely: Closely) -> f64 {
        let Friction::Ratio(beta) = friction else {
            return self.value;
        };
        let whole = closely == Closely::Whole;
        let [near, factor] = if whole { WHOLE } else { FIRST };
        if self.beta.is_nan() {
            self.value * if whole { UNKNOWN * factor } else { UNKNOWN }
        } else if beta <= near * self.beta && self.beta <= near * beta {
            self.value * factor
        } else {
            self.value * UNKNOWN
        }
    }
}

/// A place with its amplitude, NaN before the motion is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub place: Place,
    pub value: f64,
    pub closed: bool,
}

/// A band at one friction ratio, before any motion is followed.
pub(super) struct Open {
    pub friction: Friction,
    pub seen: Vec<Seen>,
    pub peaks: Vec<Peak>,
    /// The largest amplitude of the closed form, a lower bound on the largest of all.
    pub floor: f64,
    /// Estimate of the largest amplitude. It is the larger of `floor` and the stuck amplitudes at places where a stuck
    /// state exists.
    pub expected: f64,
}

impl Open {
    /// Returns the largest known amplitude.
    pub fn most(&self) -> f64 {
        let values = self.seen.iter().map(|seen| seen.value);
        values.fold(0.0, f64::max)
    }
}

/// A local maximum: the two places that enclose it, `None` on a plateau, and its own place with the value.
pub(super) type Top = (Option<[f64; 2]>, (f64, f64));

/// Returns the local maxima of at least `least`. With `closed` they are those between closed forms, otherwise the
/// others.
pub(super) fn tops(seen: &[Seen], least: f64, closed: bool) -> Vec<Top> {
    let mut found = Vec::new();
    for (index, own) in seen.iter().enumerate() {
        let neighbour = |place: Option<usize>| place.and_then(|place| seen.get(place)).copied();
        let sides = [neighbour(index.checked_sub(1)), neighbour(Some(index + 1))];
        let all_closed = own.closed && sides.iter().flatten().all(|side| side.closed);
        let below = |side: &Option<Seen>| side.is_none_or(|other| !(own.value < other.value));
        if all_closed != closed || !(least <= own.value) || !sides.iter().all(below) {
            continue;
        }
        let level = |side: &Option<Seen>| side.is_some_and(|other| other.value == own.value);
        let ends = sides.map(|side| side.map_or(own.place.r, |side| side.place.r));
        let plateau = sides.iter().all(level);
        found.push(((!plateau).then_some(ends), (own.place.r, own.value)));
    }
    found
}

/// Returns the peaks in descending order, without duplicates.
pub(super) fn sorted(mut peaks: Vec<Peak>) -> Vec<Peak> {
    peaks.retain(|peak| !peak.value.is_nan());
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    let mut kept: Vec<Peak> = Vec::new();
    for peak in peaks {
        let known = |other: &Peak| (other.r - peak.r).abs() <= 64.0 * PLACE * peak.r;
        if !kept.iter().any(known) {
            kept.push(peak);
        }
    }
    kept
}
