//! What a look at a band sees at one friction ratio.

use super::amplitude::Friction;
use super::peaks::{PLACE, Peak};
use super::places::Place;

/// Up to this ratio of two friction ratios an amplitude is expected to change by this factor at most:
const FIRST: [f64; 2] = [1.5, 2.0];
/// the same where the whole band is looked at,
const WHOLE: [f64; 2] = [1.1, 4.0];
/// and by this one where less is known.
const UNKNOWN: f64 = 5.0;

/// How closely a band is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closely {
    /// Enough to compare friction ratios.
    First,
    /// At all places, each maximum to rounding.
    Whole,
}

/// What a look at a band saw.
#[derive(Clone, Debug)]
pub(super) struct Look {
    /// From the largest down.
    pub peaks: Vec<Peak>,
    /// Whether these are all; otherwise the largest is larger than what was asked for, or the work was spent.
    pub complete: bool,
}

/// What is known of the amplitude at a place before the motion is followed there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// The friction ratio at which it was followed last; NaN before.
    pub beta: f64,
    /// The amplitude there; before, the larger one of those without friction and with the contact stuck.
    pub value: f64,
}

impl Known {
    /// The largest amplitude that is to be expected at another friction ratio.
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

/// A place with its value.
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
    /// The largest amplitude of the closed form: the largest of all is no smaller.
    pub floor: f64,
    /// The same with places at which a stuck state exists as if it were reached.
    pub expected: f64,
}

impl Open {
    /// The largest value.
    pub fn most(&self) -> f64 {
        let values = self.seen.iter().map(|seen| seen.value);
        values.fold(0.0, f64::max)
    }
}

/// Between which places there is a maximum, none along a plateau; and the place with its value.
pub(super) type Top = (Option<[f64; 2]>, (f64, f64));

/// Local maxima of at least so much: with `closed` those between closed forms, otherwise the others.
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

/// From the largest down, each once.
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
