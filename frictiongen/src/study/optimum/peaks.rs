//! The largest amplitude over a band of frequencies at one friction ratio.
//!
//! The band is looked at where an amplitude can bend: closely about the resonances of the chain and of the chain with its
//! contact stuck and about their sub-harmonics, on both sides of where the regime changes, and on a grid between.  Every
//! local maximum that may be the largest is refined to rounding.

use super::amplitude::{Amplitude, Friction};
use super::line;
use crate::Of;
use crate::study::system::System;

/// Places of the grid.
const GRID: usize = 96;
/// Sub-harmonics of a resonance that are looked at: up to this part of it.
const MOST_SUBHARMONICS: u32 = 9;
/// A local maximum of the places below this share of the largest is not refined.
const WORTH: f64 = 0.7;
/// How near to the place of a maximum a search goes: its value is then right to rounding.
const PLACE: f64 = 2e-9;
/// Where a maximum moves along, its first bracket.
const NEIGHBOUR: f64 = 2e-3;
/// An amplitude from which on it is no finite one.
const POLE: f64 = 1e9;
/// Steps in which a bound between regimes is found.
const HALVINGS: usize = 44;

/// A local maximum over the band.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct Peak {
    pub r: f64,
    pub value: f64,
    /// Whether it is at an end of the band.
    pub edge: bool,
}

/// A band of frequencies.
pub(in crate::study) struct Band<'s> {
    pub amplitude: Amplitude<'s>,
    from: f64,
    to: f64,
    /// Where it is looked at whatever the friction is, ascending.
    places: Vec<f64>,
    /// Both limits there.
    limits: Vec<[f64; 2]>,
}

impl<'s> Band<'s> {
    pub(in crate::study) fn new(system: &'s System, of: Of, [from, to]: [f64; 2]) -> Self {
        let places = places(system, from, to);
        let limits = places.iter().map(|r| limits(system, *r)).collect();
        Self {
            amplitude: Amplitude::new(system, of),
            from,
            to,
            places,
            limits,
        }
    }

    pub(super) fn ends(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    /// The largest of the band: from the largest local maximum down.
    pub(in crate::study) fn peaks(&self, friction: Friction) -> Vec<Peak> {
        let mut places = self.places.clone();
        if let Friction::Ratio(beta) = friction {
            places.extend(self.bounds(beta));
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        let values: Vec<f64> = places
            .iter()
            .map(|r| self.amplitude.at(*r, friction))
            .collect();
        let most = values.iter().copied().fold(0.0, f64::max);
        let seen: Vec<(f64, f64)> = places.into_iter().zip(values).collect();
        // On a resonance of the stuck chain that nothing damps its own rounding is all that bounds it.
        let pole = friction == Friction::Locked && POLE <= most;
        if most.is_infinite() || pole {
            let poles = seen.iter().filter(|(_, value)| *value == most);
            return poles
                .map(|(r, _)| Peak {
                    r: *r,
                    value: f64::INFINITY,
                    edge: self.is_edge(*r),
                })
                .collect();
        }
        let mut peaks: Vec<Peak> = Vec::new();
        for (index, (r, value)) in seen.iter().enumerate() {
            let neighbour = |place: Option<usize>| place.and_then(|place| seen.get(place)).copied();
            let before = neighbour(index.checked_sub(1));
            let after = neighbour(Some(index + 1));
            let below = |side: Option<(f64, f64)>| side.is_none_or(|(_, other)| !(*value < other));
            if !(WORTH * most <= *value) || !below(before) || !below(after) {
                continue;
            }
            let level = |side: Option<(f64, f64)>| side.is_some_and(|(_, other)| other == *value);
            if level(before) && level(after) {
                // All along a plateau one place is as good.
                if peaks.is_empty() {
                    peaks.push(Peak {
                        r: *r,
                        value: *value,
                        edge: false,
                    });
                }
                continue;
            }
            let ends = [before.map_or(*r, |(r, _)| r), after.map_or(*r, |(r, _)| r)];
            peaks.push(self.climbed(ends, (*r, *value), friction));
        }
        sorted(peaks)
    }

    /// The same from where local maxima were at another friction ratio near by, and both ends.
    pub(super) fn followed(&self, friction: Friction, seeds: &[f64]) -> Vec<Peak> {
        let value = |r: f64| self.amplitude.at(r, friction);
        let mut peaks: Vec<Peak> = [self.from, self.to]
            .map(|r| Peak {
                r,
                value: value(r),
                edge: true,
            })
            .to_vec();
        for seed in seeds.iter().filter(|seed| !self.is_edge(**seed)) {
            // Uphill until there is a lower place on both sides.
            let (mut middle, mut width) = (*seed, NEIGHBOUR * seed);
            let mut own = value(middle);
            let mut ends = [middle, middle];
            for _ in 0..24 {
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
            if own.is_nan() {
                continue;
            }
            peaks.push(self.climbed(ends, (middle, own), friction));
        }
        sorted(peaks)
    }

    fn climbed(&self, ends: [f64; 2], start: (f64, f64), friction: Friction) -> Peak {
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
            (r, value) = line::largest(f, ends, start, PLACE);
        }
        Peak {
            r,
            value,
            edge: self.is_edge(r),
        }
    }

    fn is_edge(&self, r: f64) -> bool {
        let near = |end: f64| (r - end).abs() <= 4.0 * PLACE * end;
        near(self.from) || near(self.to)
    }

    /// Both sides of where the regime changes at β.
    fn bounds(&self, beta: f64) -> Vec<f64> {
        let system = self.amplitude.system;
        let mut bounds = Vec::new();
        let pairs = self.places.windows(2).zip(self.limits.windows(2));
        for (places, limits) in pairs {
            let ([low, high], [at_low, at_high]) = (places, limits) else {
                continue;
            };
            for which in [0, 1] {
                let below =
                    |limits: &[f64; 2]| limits.get(which).is_some_and(|limit| *limit < beta);
                if below(at_low) == below(at_high) {
                    continue;
                }
                let (mut low, mut high) = (*low, *high);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if below(&self::limits(system, middle)) == below(at_low) {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                bounds.extend([low, high]);
            }
        }
        bounds
    }

    /// The smallest friction ratio of the band at which the contact stops somewhere, and the smallest at which it is stuck
    /// all over the band.
    pub(super) fn limits(&self) -> [f64; 2] {
        let system = self.amplitude.system;
        let extreme = |sign: f64, of: &dyn Fn(&[f64; 2]) -> f64| {
            let value = |limits: &[f64; 2]| sign * of(limits);
            let mut best = f64::NEG_INFINITY;
            for (index, (r, here)) in self.places.iter().zip(&self.limits).enumerate() {
                let own = value(here);
                let side = |place: Option<usize>| {
                    let place = place?;
                    Some((*self.places.get(place)?, value(self.limits.get(place)?)))
                };
                let sides = [side(index.checked_sub(1)), side(Some(index + 1))];
                let lower = |side: &Option<(f64, f64)>| side.is_none_or(|(_, other)| other <= own);
                if !sides.iter().all(lower) {
                    continue;
                }
                best = best.max(own);
                let ends = sides.map(|side| side.map_or(*r, |(r, _)| r));
                let [a, b] = ends;
                if own.is_finite() && a < b {
                    let f = |r: f64| value(&self::limits(system, r));
                    best = best.max(line::largest(f, ends, (*r, own), PLACE).1);
                }
            }
            sign * best
        };
        let bounded = |limit: f64| if POLE < limit { f64::INFINITY } else { limit };
        [
            extreme(-1.0, &|[continuous, sliding]| continuous.min(*sliding)),
            bounded(extreme(1.0, &|[_, sliding]| *sliding)),
        ]
    }
}

/// From the largest down, each once.
fn sorted(mut peaks: Vec<Peak>) -> Vec<Peak> {
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

/// β_lim and β*_lim; neither where there are none.
fn limits(system: &System, r: f64) -> [f64; 2] {
    system.at(r).map_or([f64::NAN; 2], |at| {
        let limits = at.limits();
        [limits.continuous, limits.sliding]
    })
}

/// Where a band is looked at whatever the friction is.
fn places(system: &System, from: f64, to: f64) -> Vec<f64> {
    let mut places = vec![from, to];
    let steps = GRID as f64;
    let ratio = (to / from).ln();
    for place in 1..GRID {
        let share = place as f64 / steps;
        places.push(from + (to - from) * share);
        if 3.0 < to / from {
            places.push(from * (ratio * share).exp());
        }
    }
    let modal = system.modal();
    let free = modal.resonances.iter().zip(&modal.damping_ratios);
    let free = free.map(|(resonance, zeta)| (resonance.to_f64(), zeta.to_f64()));
    let held = system.dynamics().held.iter();
    let held = held.map(|mode| (mode.frequency, mode.zeta));
    // The resonances as the answers know them, to the bit.
    places.extend(system.resonances());
    for (resonance, zeta) in free.chain(held) {
        places.push(resonance);
        if zeta < 1.0 {
            // Where damping takes the place of a maximum.
            let damped = resonance * (1.0 - 2.0 * zeta * zeta).max(0.0).sqrt();
            places.push(damped);
            let mut width = 0.25 * zeta.max(2e-4);
            while width < 0.3 {
                places.extend([damped * (1.0 - width), damped * (1.0 + width)]);
                width *= 2.0;
            }
        }
        // Beside them: on a sub-harmonic itself an undamped chain has a continuum of steady states.
        for order in 2..=MOST_SUBHARMONICS {
            let place = resonance / f64::from(order);
            places.extend([0.9803, 0.9957, 1.0043, 1.0197].map(|share| place * share));
        }
    }
    places.retain(|r| from <= *r && *r <= to);
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}
