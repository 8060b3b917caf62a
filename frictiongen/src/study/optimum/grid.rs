//! Searches a fine grid of the band for peaks that are not near any resonance, sub-harmonic or change of regime.
//!
//! With μ > 1 the motions from rest may end in different steady states at neighbouring frequencies. The amplitude then
//! jumps between these frequencies. The search finds such jumps only by computing the motions.

use super::amplitude::FrictionAmount;
use super::look::{BandPeak, Look, PLACE, sorted};
use super::peaks::AmplitudeBand;

/// Relative distance of neighbouring frequencies of the fine grid. It is a third of the narrowest known range of
/// stick-slip states. This range occurs in a frame of three storeys with μ = 1.2.
const FINE: f64 = 0.0025;
/// Largest number of intervals of the fine grid.
const MOST_INTERVALS: f64 = 1500.0;
/// The search adds a peak of the grid to the known peaks only if its amplitude, divided by the largest known
/// amplitude, is at least this number.
const WORTH: f64 = 0.98;
/// Number of passes over the fine grid. Each pass evaluates every ninth frequency.
const PASSES: usize = 9;
/// The dense search around the largest peak adds a new peak only if its amplitude exceeds that of the largest peak by
/// more than this fraction.
const ANOTHER: f64 = 1e-6;
/// Number of additional frequencies on each side of the largest peak, all within one step of the grid.
const DENSE: i32 = 100;
/// Bound on the work of the evaluations close to the largest peak, in units of about 10 µs of computing time. Motions
/// that do not settle reach this bound after a few frequencies.
const WORK_BESIDE: usize = 60_000;
/// Largest number of peaks that one search of the grid adds to the known peaks.
const MOST: usize = 3;
/// All later evaluations include the frequency of a peak if its amplitude, divided by the largest amplitude, is at
/// least this number.
const LEARNED: f64 = 0.9;
/// Number of grid points on each side of a peak that the search adds to all later evaluations. The grid points are
/// necessary because the peak moves with friction.
const SIDE: i32 = 4;

impl AmplitudeBand<'_> {
    /// Adds the frequency ratios of the largest peaks of one evaluation to the frequencies that every later evaluation
    /// of the band includes.
    pub(super) fn learn_largest(&self, look: &Look) {
        let most = look.peaks.first().map_or(0.0, |peak| peak.value);
        for peak in look
            .peaks
            .iter()
            .filter(|peak| LEARNED * most <= peak.value)
        {
            self.learn_around(peak.r);
        }
    }

    /// Adds the frequency ratio of a peak and its neighbours on the grid to the frequencies that every later evaluation
    /// of the band includes.
    fn learn_around(&self, r: f64) {
        let [from, to] = self.ends();
        for index in -SIDE..=SIDE {
            self.learn((r * (1.0 + FINE * f64::from(index))).clamp(from, to));
        }
    }

    /// Adds the largest local maxima on the grid to the peaks of an evaluation. The evaluation becomes incomplete if
    /// an amplitude exceeds `cutoff`, or if the search reaches its bound on work.
    pub(super) fn add_grid(&self, look: &mut Look, friction: FrictionAmount, cutoff: f64) {
        let [from, to] = self.ends();
        let width = (to / from).ln();
        let intervals = (width / FINE).min(MOST_INTERVALS).ceil();
        let mut most = look.peaks.first().map_or(0.0, |peak| peak.value);
        let mut seen: Vec<BandPeak> = Vec::new();
        // The first pass over the band is coarse, so that it finds an amplitude above the cutoff early.
        let last = intervals as usize;
        for index in (0..PASSES).flat_map(|first| (first..=last).step_by(PASSES)) {
            if self.amplitude.is_spent() {
                look.complete = false;
                break;
            }
            let r = (from * (width * index as f64 / intervals).exp()).min(to);
            let value = self.amplitude.followed(r, friction);
            if value.is_finite() {
                most = most.max(value);
                seen.push(self.peak(r, value));
            }
            if cutoff < most {
                look.complete = false;
                break;
            }
        }
        seen.sort_by(|a, b| a.r.total_cmp(&b.r));
        let highest = |index: usize| {
            let value = |index: Option<usize>| {
                index
                    .and_then(|index| seen.get(index))
                    .map_or(0.0, |peak| peak.value)
            };
            let own = value(Some(index));
            value(index.checked_sub(1)) <= own && value(Some(index + 1)) <= own
        };
        let mut found: Vec<BandPeak> = seen
            .iter()
            .enumerate()
            .filter(|(index, peak)| WORTH * most <= peak.value && highest(*index))
            .map(|(_, peak)| *peak)
            .collect();
        found.sort_by(|a, b| b.value.total_cmp(&a.value));
        found.truncate(MOST);
        // If a peak is already known exactly, a lower grid point near it adds nothing.
        found.retain(|peak| {
            let covers = |known: &BandPeak| {
                (known.r - peak.r).abs() <= FINE * peak.r && peak.value <= known.value
            };
            !look.peaks.iter().any(covers)
        });
        look.peaks = sorted(look.peaks.iter().copied().chain(found).collect());
        if let Some(top) = look.peaks.first().copied()
            && look.complete
        {
            let denser = self.densely(top, friction);
            if top.value * (1.0 + ANOTHER) < denser.value {
                look.peaks.insert(0, denser);
            }
            look.complete = !self.amplitude.is_spent();
        }
    }

    /// Returns the largest amplitude at closely spaced frequencies around a peak. Between frequencies of the grid, the
    /// motion may end in a state with a larger amplitude.
    fn densely(&self, peak: BandPeak, friction: FrictionAmount) -> BandPeak {
        let [from, to] = self.ends();
        let most = self.amplitude.spent() + WORK_BESIDE;
        let beside = |r: f64, index: i32| {
            let share = FINE * f64::from(index) / f64::from(DENSE);
            (r * (1.0 + share)).clamp(from, to)
        };
        let mut top = peak;
        for index in (0..PASSES).flat_map(|first| (-DENSE..=DENSE).skip(first).step_by(PASSES)) {
            if most < self.amplitude.spent() {
                break;
            }
            let r = beside(peak.r, index);
            let value = self.amplitude.followed(r, friction);
            if value.is_finite() && top.value < value {
                top = self.peak(r, value);
            }
        }
        let ends = [-1, 1].map(|side| beside(top.r, side));
        self.climbed(ends, (top.r, top.value), friction, PLACE)
    }
}
