//! Selects the frequency ratios of a band at which the search evaluates the amplitude, called *places*. A place is
//! *closed* if the response at this frequency ratio has a closed form. Every other place requires a motion in time.
//!
//! The first evaluation of the band at a friction ratio computes motions in time at only some of the places.

use super::amplitude::FrictionAmount;
use super::objective::Objective;
use crate::study::system::System;

/// Number of intervals of the grid of frequency ratios.
const GRID: usize = 96;
/// Largest order of the sub-harmonics of a resonance near which the search evaluates the amplitude.
const MOST_SUBHARMONICS: u32 = 9;
/// Smallest relative distance of the frequencies at which the first evaluation of the band computes motions in time.
/// In addition, the first evaluation computes motions at all resonances and at both bounds of the band.
const APART: f64 = 0.01;

/// A frequency ratio of a band, with its limits β_lim and β*_lim.
#[derive(Clone, Copy, Debug)]
pub(super) struct BandPlace {
    pub r: f64,
    /// The limits β_lim and β*_lim at this frequency ratio, as friction forces divided by the amplitude P that the load
    /// has at r = 1 (by k₁Y for base motion).
    pub limits: [f64; 2],
    /// True if the first evaluation of the band includes this frequency ratio in any case, even if it must compute a
    /// motion in time.
    pub first: bool,
}

impl BandPlace {
    pub(super) fn new(system: &System, objective: &Objective, r: f64, first: bool) -> Self {
        let limits = objective.limits(system, r);
        Self { r, limits, first }
    }

    /// Returns true if the response has a closed form with this amount of friction. The contact then slides all the
    /// time, or cannot slide.
    pub(super) fn is_closed(&self, friction: FrictionAmount) -> bool {
        let [continuous, sliding] = self.limits;
        match friction {
            FrictionAmount::Locked => true,
            FrictionAmount::Ratio(beta) => beta == 0.0 || beta < continuous.min(sliding),
        }
    }
}

/// Returns the frequencies of a band at which the search evaluates the amplitude for every friction, in ascending
/// order.
pub(super) fn places(
    system: &System,
    objective: &Objective,
    [from, to]: [f64; 2],
) -> Vec<BandPlace> {
    let mut places = vec![(from, true), (to, true)];
    let steps = GRID as f64;
    let ratio = (to / from).ln();
    for place in 1..GRID {
        let share = place as f64 / steps;
        places.push((from + (to - from) * share, false));
        if 3.0 < to / from {
            places.push((from * (ratio * share).exp(), false));
        }
    }
    let modal = system.modal();
    let free = modal.resonances.iter().zip(&modal.damping_ratios);
    let free = free.map(|(resonance, zeta)| (resonance.to_f64(), zeta.to_f64()));
    let held = system.dynamics().held.iter();
    let held = held.map(|mode| (mode.frequency, mode.zeta));
    // The code uses the resonances of the system itself, because these values agree to the last bit with the resonances
    // in the closed forms of the system.
    places.extend(system.resonances().iter().map(|r| (*r, true)));
    for (resonance, zeta) in free.chain(held) {
        places.push((resonance, true));
        if zeta < 1.0 {
            // Damping shifts the maximum of the amplitude from the resonance to this frequency.
            let damped = resonance * (1.0 - 2.0 * zeta * zeta).max(0.0).sqrt();
            places.push((damped, false));
            let mut width = 0.25 * zeta.max(2e-4);
            while width < 0.3 {
                places.extend([1.0 - width, 1.0 + width].map(|share| (damped * share, false)));
                width *= 2.0;
            }
        }
        // Exactly on a sub-harmonic, an undamped chain has a continuum of steady states. The selected frequency ratios
        // are therefore next to the sub-harmonic.
        for order in 2..=MOST_SUBHARMONICS {
            let place = resonance / f64::from(order);
            places.extend([0.9803, 0.9957, 1.0043, 1.0197].map(|share| (place * share, false)));
        }
    }
    places.retain(|(r, _)| from <= *r && *r <= to);
    // If a frequency occurs twice, the sort puts the place with the flag `true` (for the first evaluation) before the
    // other place. `dedup_by` keeps the place that comes first.
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    places.dedup_by(|a, b| a.0 == b.0);
    let mut last = 0.0;
    let placed = places.into_iter().map(|(r, key)| {
        let first = key || last * (1.0 + APART) <= r;
        if first {
            last = r;
        }
        BandPlace::new(system, objective, r, first)
    });
    placed.collect()
}
