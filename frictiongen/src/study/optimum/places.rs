//! Places of a band: frequency ratios at which its amplitude is evaluated. A place is closed where the response has a
//! closed form. Elsewhere a motion has to be followed.
//!
//! The first look at a friction ratio follows motions only at some of the places.

use super::amplitude::Friction;
use crate::study::system::System;

/// Smallest relative distance at which the test for a pole evaluates a function. At a pole the value is ten times that
/// at ten times the distance.
const BESIDE: f64 = 1e-9;
/// A smaller value at this distance is rounding and not a pole.
const DRIVEN: f64 = 1e-3;
/// Number of intervals of the grid.
const GRID: usize = 96;
/// Largest order of the sub-harmonics of a resonance that become places.
const MOST_SUBHARMONICS: u32 = 9;
/// Relative distance of the places at which the first look follows motions. It also follows motions at all resonances.
const APART: f64 = 0.01;

/// A frequency ratio of a band, with both limits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub r: f64,
    /// Limits β_lim and β*_lim at r.
    pub limits: [f64; 2],
    /// True if the first look takes this place even where the motion has to be followed.
    pub first: bool,
}

impl Place {
    pub(super) fn new(system: &System, r: f64, first: bool) -> Self {
        let limits = limits(system, r);
        Self { r, limits, first }
    }

    /// Returns true if the response is known without following a motion. The contact then slides all the time, or
    /// cannot slide.
    pub(super) fn is_closed(&self, friction: Friction) -> bool {
        let [continuous, sliding] = self.limits;
        match friction {
            Friction::Locked => true,
            Friction::Ratio(beta) => beta == 0.0 || beta < continuous.min(sliding),
        }
    }
}

/// Returns β_lim and β*_lim. Both are NaN where the system has no limits.
pub(super) fn limits(system: &System, r: f64) -> [f64; 2] {
    let limits = |r: f64| {
        system.at(r).map_or([f64::NAN; 2], |at| {
            let limits = at.limits();
            [limits.continuous, limits.sliding]
        })
    };
    let [continuous, sliding] = limits(r);
    if sliding == f64::INFINITY {
        // The place is a resonance of the stuck chain. The limit is finite if the load does not drive it.
        return [continuous, beside(r, |r| limits(r)[1])];
    }
    [continuous, sliding]
}

/// Returns the limit of a function at a resonance on which it has no value. It is infinite if the function grows
/// towards the resonance.
pub(super) fn beside(r: f64, function: impl Fn(f64) -> f64) -> f64 {
    let at = |distance: f64| function(r * (1.0 + distance));
    let (far, near) = (at(10.0 * BESIDE), at(BESIDE));
    if DRIVEN < near && 5.0 * far < near {
        f64::INFINITY
    } else {
        near
    }
}

/// Returns the places of a band that do not depend on the friction, ascending.
pub(super) fn places(system: &System, from: f64, to: f64) -> Vec<Place> {
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
    // The resonances of the system are equal to those of its results, to the last bit.
    places.extend(system.resonances().iter().map(|r| (*r, true)));
    for (resonance, zeta) in free.chain(held) {
        places.push((resonance, true));
        if zeta < 1.0 {
            // Damping shifts the maximum to this place.
            let damped = resonance * (1.0 - 2.0 * zeta * zeta).max(0.0).sqrt();
            places.push((damped, false));
            let mut width = 0.25 * zeta.max(2e-4);
            while width < 0.3 {
                places.extend([1.0 - width, 1.0 + width].map(|share| (damped * share, false)));
                width *= 2.0;
            }
        }
        // On a sub-harmonic itself an undamped chain has a continuum of steady states, so the places are next to it.
        for order in 2..=MOST_SUBHARMONICS {
            let place = resonance / f64::from(order);
            places.extend([0.9803, 0.9957, 1.0043, 1.0197].map(|share| (place * share, false)));
        }
    }
    places.retain(|(r, _)| from <= *r && *r <= to);
    // Equal places are sorted so that the one for the first look remains.
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    places.dedup_by(|a, b| a.0 == b.0);
    let mut last = 0.0;
    let placed = places.into_iter().map(|(r, key)| {
        let first = key || last * (1.0 + APART) <= r;
        if first {
            last = r;
        }
        Place::new(system, r, first)
    });
    placed.collect()
}
