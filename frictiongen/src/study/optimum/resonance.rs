//! Computes the value of a function at a resonance, from its values next to the resonance. The function may be
//! undefined at the resonance itself.

use crate::study::system::System;

/// Smallest relative distance from a pole at which the code evaluates a function to detect the pole. At a pole, the
/// value at this distance is ten times the value at ten times the distance.
const BESIDE: f64 = 1e-9;
/// Value up to which the code assumes that a function has no pole. The code evaluates the function at the relative
/// distance `BESIDE` from the possible pole. A value of this size is only a rounding error.
const DRIVEN: f64 = 1e-3;

/// Returns β_lim and β*_lim at the frequency ratio r, or NaN if they are not defined.
pub(super) fn limits(system: &System, r: f64) -> [f64; 2] {
    let limits = |r: f64| {
        system.at(r).map_or([f64::NAN; 2], |at| {
            let limits = at.limits();
            [limits.continuous, limits.sliding]
        })
    };
    let [continuous, sliding] = limits(r);
    if sliding == f64::INFINITY {
        // r is a resonance of the chain with its contact stuck. The limit is finite if the load does not drive this
        // resonance.
        return [continuous, beside(r, |r| limits(r)[1])];
    }
    [continuous, sliding]
}

/// Returns the value that a function approaches towards a resonance at which the function is undefined. The result is
/// infinite if the function grows towards the resonance.
pub(super) fn beside(r: f64, function: impl Fn(f64) -> f64) -> f64 {
    let at = |distance: f64| function(r * (1.0 + distance));
    let (far, near) = (at(10.0 * BESIDE), at(BESIDE));
    if DRIVEN < near && 5.0 * far < near {
        f64::INFINITY
    } else {
        near
    }
}
