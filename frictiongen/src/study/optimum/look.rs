//! Evaluates the amplitude over a band of frequencies at one friction ratio, and finds its local maxima. This
//! evaluation is called a *look*.
//!
//! The first look at a friction ratio computes motions in time at only some frequencies of the band. A whole look
//! computes motions at all frequencies of the band.

use super::amplitude::FrictionAmount;
use super::places::BandPlace;

/// Relative tolerance in r of a refined maximum of the amplitude. The amplitude at the maximum is then exact to
/// rounding.
pub(super) const PLACE: f64 = 2e-9;
/// Expected change of the amplitude with friction, in a first look (an evaluation at only some frequencies of the
/// band). If the friction ratio changes by at most the first factor, the search expects the amplitude to change by at
/// most the second factor.
const FIRST: [f64; 2] = [1.5, 2.0];
/// Expected change of the amplitude with friction, in a whole look (an evaluation at all frequencies of the band). If
/// the friction ratio changes by at most the first factor, the search expects the amplitude to change by at most the
/// second factor.
const WHOLE: [f64; 2] = [1.1, 4.0];
/// Factor on the expected amplitude at a frequency if the search does not know the amplitude at a similar friction
/// ratio. Two friction ratios are similar if their quotient is at most the first factor of `FIRST` or `WHOLE`.
const UNKNOWN: f64 = 5.0;

/// A local maximum of the amplitude over the band.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct BandPeak {
    pub r: f64,
    pub value: f64,
    /// True if the maximum is at the lower or upper bound of the band.
    pub edge: bool,
}

/// Precision of an evaluation of the amplitude over a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closely {
    /// The evaluation is sufficient for a comparison of friction ratios. The evaluation includes a frequency without a
    /// closed form only if [`BandPlace::first`] is true for this frequency. The evaluation finds the maxima roughly.
    First,
    /// The evaluation includes all frequencies of the band, and finds each maximum to rounding.
    Whole,
}

/// Result of a look, which is an evaluation of the amplitude over a band at one friction ratio.
#[derive(Clone, Debug)]
pub(super) struct Look {
    /// The local maxima that were found, in descending order.
    pub peaks: Vec<BandPeak>,
    /// True if the evaluation of the band is complete. False if the largest amplitude exceeds the cutoff, or if the
    /// evaluation reached its bound on work.
    pub complete: bool,
}

/// The latest known amplitude at one frequency. The search estimates the amplitude for another friction ratio from this
/// known amplitude.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownAmplitude {
    /// The friction ratio of the latest motion at this frequency. It is NaN if no motion has been computed yet.
    pub beta: f64,
    /// The amplitude of the latest motion. If no motion has been computed yet, it is the larger of two amplitudes:
    /// without friction, and with the contact stuck.
    pub value: f64,
}

impl KnownAmplitude {
    /// Returns the largest amplitude that the search expects at another amount of friction.
    pub fn promise(self, friction: FrictionAmount, closely: Closely) -> f64 {
        let FrictionAmount::Ratio(beta) = friction else {
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

/// A frequency of the band with its amplitude. The amplitude is NaN if the motion at this frequency has not been
/// computed yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeenFrequency {
    pub place: BandPlace,
    pub value: f64,
    pub closed: bool,
}

/// The amplitude over a band at one friction ratio, from closed forms only. The search has not yet computed motions in
/// time.
pub(super) struct OpenBand {
    pub friction: FrictionAmount,
    pub seen: Vec<SeenFrequency>,
    pub peaks: Vec<BandPeak>,
    /// The largest amplitude from closed forms. It is a lower bound on the largest amplitude over the band.
    pub floor: f64,
    /// Estimate of the largest amplitude over the band. The estimate is the largest of `floor` and the stuck amplitudes
    /// at all frequencies at which a stuck state exists.
    pub expected: f64,
}

impl OpenBand {
    /// Returns the largest known amplitude at any frequency of the band.
    pub fn most(&self) -> f64 {
        let values = self.seen.iter().map(|seen| seen.value);
        values.fold(0.0, f64::max)
    }
}

/// A local maximum of the amplitude. The first item has the two frequency ratios that enclose the maximum, or `None` on
/// a plateau. The second item has the frequency ratio and the amplitude of the maximum.
pub(super) type Top = (Option<[f64; 2]>, (f64, f64));

/// Returns the local maxima whose amplitude is at least `least`. If `closed` is true, the result contains the maxima
/// between frequencies with a closed form. Otherwise it contains all other maxima.
pub(super) fn tops(seen: &[SeenFrequency], least: f64, closed: bool) -> Vec<Top> {
    let mut found = Vec::new();
    for (index, own) in seen.iter().enumerate() {
        let neighbour = |place: Option<usize>| place.and_then(|place| seen.get(place)).copied();
        let sides = [neighbour(index.checked_sub(1)), neighbour(Some(index + 1))];
        let all_closed = own.closed && sides.iter().flatten().all(|side| side.closed);
        let below =
            |side: &Option<SeenFrequency>| side.is_none_or(|other| !(own.value < other.value));
        if all_closed != closed || !(least <= own.value) || !sides.iter().all(below) {
            continue;
        }
        let level =
            |side: &Option<SeenFrequency>| side.is_some_and(|other| other.value == own.value);
        let ends = sides.map(|side| side.map_or(own.place.r, |side| side.place.r));
        let plateau = sides.iter().all(level);
        found.push(((!plateau).then_some(ends), (own.place.r, own.value)));
    }
    found
}

/// Returns the peaks in descending order of amplitude, without duplicates and without NaN.
pub(super) fn sorted(mut peaks: Vec<BandPeak>) -> Vec<BandPeak> {
    peaks.retain(|peak| !peak.value.is_nan());
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    let mut kept: Vec<BandPeak> = Vec::new();
    for peak in peaks {
        let known = |other: &BandPeak| (other.r - peak.r).abs() <= 64.0 * PLACE * peak.r;
        if !kept.iter().any(known) {
            kept.push(peak);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::{Closely, FrictionAmount, KnownAmplitude};

    /// Checks that the largest expected amplitude is never below the known amplitude. If it were, a look would leave out
    /// motions that may be the largest.
    #[test]
    fn no_estimate_is_below_the_known_amplitude() {
        let known = KnownAmplitude {
            beta: 0.4,
            value: 3.0,
        };
        for closely in [Closely::First, Closely::Whole] {
            for factor in [0.01, 0.7, 0.95, 1.0, 1.05, 1.4, 100.0] {
                let friction = FrictionAmount::Ratio(factor * known.beta);
                assert!(known.value <= known.promise(friction, closely), "{factor}");
            }
            let unknown = KnownAmplitude {
                beta: f64::NAN,
                ..known
            };
            let friction = FrictionAmount::Ratio(known.beta);
            assert!(known.value <= unknown.promise(friction, closely));
        }
    }
}
