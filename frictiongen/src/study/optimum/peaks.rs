//! Finds the largest amplitude over a band of frequencies at one friction ratio.
//!
//! The search evaluates the amplitude at frequencies near which the amplitude can change quickly. The frequencies are
//! close together near the resonances of the chain with a free contact and with a stuck contact, and near the
//! sub-harmonics of all these resonances. Further frequencies are on both sides of every frequency at which β_lim or
//! β*_lim equals β, and on a grid.
//!
//! An evaluation of the band begins with closed forms. If a closed form exceeds the cutoff, the search computes no
//! motion in time. The search refines every local maximum that may be the largest.

use super::amplitude::{Amplitude, FrictionAmount};
use super::line;
use super::look::{
    BandPeak, Closely, KnownAmplitude, Look, OpenBand, PLACE, SeenFrequency, Top, sorted, tops,
};
use super::objective::Objective;
use super::places::{BandPlace, places};
use crate::study::system::System;
use std::cell::{Cell, RefCell};

/// The search refines only maxima whose amplitude, divided by the largest amplitude, is at least this.
const WORTH: f64 = 0.7;
/// The search refines a maximum precisely if its amplitude, divided by the largest amplitude, is at least this. The
/// search refines lower maxima only roughly.
const WORTH_FINELY: f64 = 0.95;
/// Largest number of local maxima that the search refines at frequencies at which it must compute a motion in time.
const MOST_TOPS: usize = 8;
/// Relative tolerance in r of a maximum of the amplitude, if the search only compares friction ratios.
const NEARLY: f64 = 1e-5;
/// Relative tolerance in r of a maximum of the amplitude, as long as the largest maximum is not known.
const ROUGHLY: f64 = 1e-3;
/// First step in r, divided by r, of the search for a maximum whose frequency ratio r at a similar friction ratio is
/// known.
const NEIGHBOUR: f64 = 2e-3;
/// Smallest amplitude that the search treats as infinite.
pub(super) const POLE: f64 = 1e9;

/// Largest relative difference at which two amplitudes are treated as equal.
const SAME: f64 = 1e-9;

/// A band of frequencies, with all known amplitudes in the band.
pub(in crate::study) struct AmplitudeBand<'s> {
    pub amplitude: Amplitude<'s>,
    from: f64,
    to: f64,
    /// Frequencies at which every evaluation of the band computes the amplitude, in ascending order.
    pub(super) places: Vec<BandPlace>,
    /// Amplitude at each of `places` with the contact stuck.
    held: Vec<f64>,
    /// Latest known amplitude at each of `places`.
    known: Vec<Cell<KnownAmplitude>>,
    /// Frequency ratios of peaks that a first, incomplete evaluation of the band had missed.
    learned: RefCell<Vec<f64>>,
}

impl<'s> AmplitudeBand<'s> {
    pub(in crate::study) fn new(
        system: &'s System,
        objective: Objective,
        [from, to]: [f64; 2],
    ) -> Self {
        let places = places(system, &objective, [from, to]);
        let amplitude = Amplitude::new(system, objective);
        let all = |friction: FrictionAmount| -> Vec<f64> {
            let values = places.iter();
            values
                .map(|place| amplitude.at(place.r, friction))
                .collect()
        };
        let (held, free) = (all(FrictionAmount::Locked), all(FrictionAmount::Ratio(0.0)));
        let known = held.iter().zip(&free);
        let known = known.map(|(held, free)| {
            Cell::new(KnownAmplitude {
                beta: f64::NAN,
                value: held.max(*free),
            })
        });
        Self {
            known: known.collect(),
            amplitude,
            from,
            to,
            places,
            held,
            learned: RefCell::new(Vec::new()),
        }
    }

    pub(super) fn ends(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// Adds a frequency ratio that every later evaluation of the band includes, even a first, incomplete evaluation.
    pub(super) fn learn(&self, r: f64) {
        self.learned.borrow_mut().push(r);
    }

    /// Returns the number of frequency ratios that [`learn`](Self::learn) has added so far.
    pub(super) fn learned(&self) -> usize {
        self.learned.borrow().len()
    }

    /// Returns the local maxima of the amplitude over the band, in descending order.
    pub(in crate::study) fn peaks(&self, friction: FrictionAmount) -> Vec<BandPeak> {
        let open = self.open(friction);
        self.look(open, f64::INFINITY, Closely::Whole).peaks
    }

    /// Evaluates the band at one friction ratio, but only at frequencies at which the response has a closed form.
    pub(super) fn open(&self, friction: FrictionAmount) -> OpenBand {
        let seen = |place: BandPlace| {
            let closed = place.is_closed(friction);
            let value = if closed {
                self.amplitude.at(place.r, friction)
            } else {
                f64::NAN
            };
            SeenFrequency {
                place,
                value,
                closed,
            }
        };
        let (system, objective) = (self.amplitude.system, &self.amplitude.objective);
        let mut places = self.places.clone();
        let learned = self.learned.borrow();
        places.extend(
            learned
                .iter()
                .map(|r| BandPlace::new(system, objective, *r, true)),
        );
        let mut expected = 0.0_f64;
        if let FrictionAmount::Ratio(beta) = friction {
            let bounds = self.bounds(beta);
            places.extend(
                bounds
                    .into_iter()
                    .map(|r| BandPlace::new(system, objective, r, true)),
            );
            let held = self.places.iter().zip(&self.held);
            let held = held.filter(|(place, _)| place.limits[1] <= beta);
            expected = held.fold(0.0, |most, (_, held)| most.max(*held));
        }
        places.sort_by(|a, b| a.r.total_cmp(&b.r).then(b.first.cmp(&a.first)));
        places.dedup_by(|a, b| a.r == b.r);
        let seen: Vec<SeenFrequency> = places.into_iter().map(seen).collect();
        let mut open = OpenBand {
            friction,
            seen,
            peaks: Vec::new(),
            floor: 0.0,
            expected,
        };
        let most = open.most();
        open.floor = most;
        // On an undamped resonance of the chain with its contact stuck, only rounding bounds the amplitude. The code
        // treats this amplitude as infinite.
        let pole = friction == FrictionAmount::Locked && POLE <= most;
        if most.is_infinite() || pole {
            self.poles(&mut open, most);
        } else {
            for (ends, start) in tops(&open.seen, WORTH * most, true) {
                let peak = match ends {
                    Some(ends) => self.climbed(ends, start, friction, PLACE),
                    // On a plateau every frequency has the same amplitude. One peak therefore represents the plateau.
                    None if open.peaks.is_empty() => self.peak(start.0, start.1),
                    None => continue,
                };
                open.floor = open.floor.max(peak.value);
                open.peaks.push(peak);
            }
        }
        open.expected = open.expected.max(open.floor);
        open
    }

    fn poles(&self, open: &mut OpenBand, most: f64) {
        let poles = open.seen.iter().filter(|seen| seen.value == most);
        open.peaks = poles
            .map(|seen| self.peak(seen.place.r, f64::INFINITY))
            .collect();
        open.floor = f64::INFINITY;
    }

    /// Computes motions in time at frequencies without a closed form. Stops when an amplitude exceeds `cutoff`.
    pub(super) fn look(&self, mut open: OpenBand, cutoff: f64, closely: Closely) -> Look {
        let friction = open.friction;
        if open.floor.is_infinite() {
            return Look {
                peaks: open.peaks,
                complete: true,
            };
        }
        if cutoff < open.floor {
            let top = open.seen.iter().filter(|seen| seen.closed);
            let top = top.max_by(|a, b| a.value.total_cmp(&b.value));
            let top = top.map(|top| self.peak(top.place.r, top.value));
            let peaks = sorted(open.peaks.into_iter().chain(top).collect());
            return Look {
                peaks,
                complete: false,
            };
        }
        let above = |peaks: Vec<BandPeak>, peak: BandPeak| Look {
            peaks: sorted(peaks.into_iter().chain([peak]).collect()),
            complete: false,
        };
        let taken = |seen: &SeenFrequency| seen.place.first || closely == Closely::Whole;
        let mut most = open.floor;
        for (index, promise) in self.promising(&open, closely, taken) {
            let Some(seen) = open.seen.get_mut(index) else {
                continue;
            };
            if promise < most {
                // All later frequencies of the list have an expected amplitude of at most `promise`, because the list
                // is in descending order.
                break;
            }
            let r = seen.place.r;
            seen.value = self.amplitude.at(r, friction);
            most = most.max(seen.value);
            self.note(r, friction, seen.value);
            if self.amplitude.is_spent() || (cutoff < seen.value && seen.value.is_finite()) {
                let peak = self.peak(r, seen.value);
                return above(open.peaks, peak);
            }
        }
        let most = open.most().max(open.floor);
        if most.is_infinite() {
            self.poles(&mut open, most);
            return Look {
                peaks: open.peaks,
                complete: true,
            };
        }
        open.seen.retain(|seen| seen.closed || !seen.value.is_nan());
        let mut tops = tops(&open.seen, WORTH * most, false);
        tops.sort_by(|a, b| b.1.1.total_cmp(&a.1.1));
        tops.truncate(MOST_TOPS);
        let mut peaks = open.peaks;
        let finely = match closely {
            Closely::First => NEARLY,
            Closely::Whole => PLACE,
        };
        let refined = self.refined(tops, friction, finely, cutoff);
        peaks.extend(refined);
        let mut peaks = sorted(peaks);
        if closely == Closely::Whole {
            self.follow_largest(&mut peaks, friction);
        }
        let top = peaks.first().map_or(0.0, |peak| peak.value);
        Look {
            complete: top <= cutoff && !self.amplitude.is_spent(),
            peaks,
        }
    }

    /// Computes the motion from rest at the largest peaks. With μ > 1 this motion decides which steady state occurs,
    /// even if the closed form exists.
    fn follow_largest(&self, peaks: &mut Vec<BandPeak>, friction: FrictionAmount) {
        let most = peaks.first().map_or(0.0, |peak| peak.value);
        let largest = peaks.iter_mut().take(MOST_TOPS);
        for peak in largest.filter(|peak| WORTH_FINELY * most <= peak.value) {
            let value = self.amplitude.followed(peak.r, friction);
            if value.is_finite() && SAME * peak.value < (value - peak.value).abs() {
                peak.value = value;
            }
        }
        *peaks = sorted(std::mem::take(peaks));
    }

    /// Refines local maxima between their neighbouring frequencies. The method refines all maxima roughly. It then
    /// refines precisely those maxima that may be the largest.
    fn refined(
        &self,
        tops: Vec<Top>,
        friction: FrictionAmount,
        finely: f64,
        cutoff: f64,
    ) -> Vec<BandPeak> {
        let mut roughly: Vec<([f64; 2], BandPeak)> = Vec::new();
        for (ends, start) in tops {
            let Some(ends) = ends else {
                let peak = self.peak(start.0, start.1);
                roughly.push(([peak.r; 2], peak));
                continue;
            };
            let peak = self.climbed(ends, start, friction, ROUGHLY);
            let near = |end: f64, sign: f64| end * (1.0 + 3.0 * sign * ROUGHLY);
            let [a, b] = ends;
            roughly.push(([a.max(near(peak.r, -1.0)), b.min(near(peak.r, 1.0))], peak));
            if cutoff < peak.value {
                break;
            }
        }
        let most = roughly.iter().map(|(_, peak)| peak.value);
        let most = most.fold(0.0, f64::max);
        let finely = |(ends, peak): ([f64; 2], BandPeak)| {
            if WORTH_FINELY * most <= peak.value && most <= cutoff {
                self.climbed(ends, (peak.r, peak.value), friction, finely)
            } else {
                peak
            }
        };
        roughly.into_iter().map(finely).collect()
    }

    /// Returns the frequencies at which a motion in time is necessary, each with the largest amplitude to expect. The
    /// list is in descending order of this amplitude.
    fn promising(
        &self,
        open: &OpenBand,
        closely: Closely,
        taken: impl Fn(&SeenFrequency) -> bool,
    ) -> Vec<(usize, f64)> {
        let followed = open.seen.iter().enumerate();
        let followed = followed.filter(|(_, seen)| !seen.closed && taken(seen));
        // An initial state leaves a stuck contact at a place that depends on friction. The amplitude at one friction then
        // does not bound the amplitude at another friction.
        let depends_on_start = |seen: &SeenFrequency| match open.friction {
            FrictionAmount::Ratio(friction) => {
                self.amplitude.system.start.is_some() && seen.place.limits[1] <= friction
            }
            FrictionAmount::Locked => false,
        };
        let promise = |seen: &SeenFrequency| {
            let unbounded = self.amplitude.is_unbounded(seen.place.r, open.friction);
            if unbounded || depends_on_start(seen) {
                return f64::INFINITY;
            }
            let known = self.nearest(seen.place.r).map(Cell::get);
            known.map_or(f64::INFINITY, |known| known.promise(open.friction, closely))
        };
        let mut order: Vec<(usize, f64)> = followed
            .map(|(index, seen)| (index, promise(seen)))
            .collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1));
        order
    }

    fn nearest(&self, r: f64) -> Option<&Cell<KnownAmplitude>> {
        let after = self.places.partition_point(|place| place.r < r);
        self.known
            .get(after)
            .or_else(|| self.known.get(after.checked_sub(1)?))
    }

    fn note(&self, r: f64, friction: FrictionAmount, value: f64) {
        if let Some(known) = self.nearest(r)
            && let FrictionAmount::Ratio(beta) = friction
            && value.is_finite()
        {
            known.set(KnownAmplitude { beta, value });
        }
    }

    /// Returns the amplitudes at both bounds of the band, and the largest local maxima. `seeds` contains the frequency
    /// ratios of the maxima at a similar friction ratio. The search for each maximum begins at one of these frequency
    /// ratios. The call ends when an amplitude exceeds `cutoff`.
    pub(super) fn followed(
        &self,
        friction: FrictionAmount,
        seeds: &[f64],
        cutoff: f64,
    ) -> Vec<BandPeak> {
        let value = |r: f64| self.amplitude.at(r, friction);
        let mut peaks: Vec<BandPeak> = [self.from, self.to]
            .map(|r| self.peak(r, value(r)))
            .to_vec();
        let mut tops: Vec<Top> = Vec::new();
        for seed in seeds.iter().filter(|seed| !self.is_edge(**seed)) {
            // The loop moves towards larger amplitudes until the amplitude is lower on both sides.
            let (mut middle, mut width) = (*seed, NEIGHBOUR * seed);
            let mut own = value(middle);
            let mut ends = [middle, middle];
            for _ in 0..24 {
                if cutoff < own || self.amplitude.is_spent() {
                    peaks.push(self.peak(middle, own));
                    return sorted(peaks);
                }
                ends = [
                    (middle - width).max(self.from),
                    (middle + width).min(self.to),
                ];
                let [left, right] = ends.map(value);
                let [a, b] = ends;
                if own < left && !(left < right) && self.from < a {
                    (middle, own) = (a, left);
                } else if own < right && b < self.to {
                    (middle, own) = (b, right);
                } else {
                    break;
                }
                width *= 1.6;
            }
            let known = |top: &Top| top.0.is_some_and(|[a, b]| a < middle && middle < b);
            if !own.is_nan() && !tops.iter().any(known) {
                tops.push((Some(ends), (middle, own)));
            }
        }
        peaks.extend(self.refined(tops, friction, PLACE, cutoff));
        sorted(peaks)
    }

    pub(super) fn climbed(
        &self,
        ends: [f64; 2],
        start: (f64, f64),
        friction: FrictionAmount,
        near: f64,
    ) -> BandPeak {
        let f = |r: f64| {
            let value = self.amplitude.at(r, friction);
            if value.is_nan() {
                f64::NEG_INFINITY
            } else {
                value
            }
        };
        let [a, b] = ends;
        let (mut r, mut value) = start;
        if a < b && value.is_finite() {
            (r, value) = line::largest(f, ends, start, near);
        }
        self.peak(r, value)
    }

    pub(super) fn peak(&self, r: f64, value: f64) -> BandPeak {
        let edge = self.is_edge(r);
        BandPeak { r, value, edge }
    }

    fn is_edge(&self, r: f64) -> bool {
        let near = |end: f64| (r - end).abs() <= 4.0 * PLACE * end;
        near(self.from) || near(self.to)
    }
}
