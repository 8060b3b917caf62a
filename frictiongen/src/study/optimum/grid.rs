//! Searches a fine grid of the band for peaks that are not near any resonance, sub-harmonic or limit.
//!
//! With μ > 1 motion from rest may end in different steady states at neighbouring frequencies. The amplitude jumps
//! between these frequencies. Only a computation of the motion reveals these jumps.

use super::amplitude::FrictionAmount;
use super::look::{BandPeak, Look, sorted};
use super::peaks::AmplitudeBand;

/// Relative distance of neighbouring frequencies of the grid. It is a third of the narrowest known range of stick-slip
/// states, which occurs in a frame of three storeys with μ = 1.2.
const FINE: f64 = 0.0025;
/// Largest number of intervals of the grid.
const MOST_INTERVALS: f64 = 1500.0;
/// Smallest amplitude of a peak of the grid that the search adds, as a fraction of the largest known amplitude.
const WORTH: f64 = 0.98;
/// Largest number of peaks that one search adds.
const MOST: usize = 3;
/// Number of grid points on each side of a peak that the search adds to all later evaluations. They are necessary
/// because the peak moves with friction.
const SIDE: i32 = 4;

impl AmplitudeBand<'_> {
    /// Adds the frequency ratio of a peak and its neighbours on the grid to all later first evaluations of the band.
    pub(super) fn learn_around(&self, r: f64) {
        let [from, to] = self.ends();
        for index in -SIDE..=SIDE {
            self.learn((r * (1.0 + FINE * f64::from(index))).clamp(from, to));
        }
    }

    /// Adds the largest local maxima on the grid to the peaks of an evaluation. If the work ends before the grid does,
    /// the evaluation stays incomplete.
    pub(super) fn add_grid(&self, look: &mut Look, friction: FrictionAmount) {
        let [from, to] = self.ends();
        let width = (to / from).ln();
        let intervals = (width / FINE).min(MOST_INTERVALS).ceil();
        let mut most = look.peaks.first().map_or(0.0, |peak| peak.value);
        let mut seen: Vec<BandPeak> = Vec::new();
        for index in 0..=intervals as u32 {
            if self.amplitude.is_spent() {
                look.complete = false;
                break;
            }
            let r = (from * (width * f64::from(index) / intervals).exp()).min(to);
            let value = self.amplitude.followed(r, friction);
            if value.is_finite() {
                most = most.max(value);
                seen.push(self.peak(r, value));
            }
        }
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
        look.peaks = sorted(look.peaks.iter().copied().chain(found).collect());
    }
}
