//! Steady states under any periodic load. The load is a table of one period, or a list of harmonics.
//!
//! The stepper advances the motion in time. It is exact for loads that are polynomials between samples. Newton's
//! method finds the state that repeats after a whole number of periods of the load. The closed forms of this crate
//! require a load that is a cosine in time. For other periodic loads there are therefore no limits β_lim and β*_lim,
//! no friction ratio and no phase.

mod answer;
mod error;
mod load;
mod search;
mod walk;

#[cfg(test)]
mod tests;

pub use answer::{PeriodicState, PeriodicTrack};
pub use error::PeriodicError;
pub use load::{BaseTable, Harmonic, PeriodicLoad};

use crate::Of;
use crate::study::System;

/// A request for the steady state under a periodic load.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicRequest {
    /// The load over one of its periods.
    pub load: PeriodicLoad,
    /// The kinetic friction force F, in the scene's unit of force.
    pub friction: f64,
    /// The motions and spring forces that the result contains.
    pub of: Vec<Of>,
}

impl System {
    /// Returns the steady state in which the motion from rest ends, under a periodic force on the excited mass or
    /// under a periodic motion of the base.
    ///
    /// The load is a table of one period or a sum of harmonics. Between the samples of a table, forces change
    /// linearly, or stay constant with `input: hold`. In a table of the base's motion, velocities and accelerations
    /// change linearly, and displacements follow a cubic spline. The stepper is exact for these loads. For a sum of
    /// harmonics, the code takes at least 1024 samples in a cycle of the highest order, and cubics between them. The
    /// cubics differ from the sum by at most 4e-12 of its amplitude.
    ///
    /// The search follows the motion from rest until Newton's method finds a state that repeats. Central differences
    /// give the matrix of Newton's method. The result is a steady state that the motion from rest approaches. No
    /// Floquet multiplier of the result lies outside the unit circle. The period of the result is at most 64 periods of
    /// the load.
    ///
    /// ```
    /// use frictiongen::{Of, System};
    /// use frictiongen::study::periodic::{PeriodicLoad, PeriodicRequest};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block { masses: { m: 2 }, springs: { base - m: 800 },
    ///     contact: m - wall, excitation: m, damping: modal(0.02) }".parse()?;
    /// // A triangle of 30 N in a period of 0.8 s.
    /// let load = PeriodicLoad::forces(0.2, &[0.0, 30.0, 0.0, -30.0, 0.0])?;
    /// let request = PeriodicRequest { load, friction: 6.0, of: vec![Of::Mass(0)] };
    /// let state = block.periodic(&request)?;
    /// assert!(state.is_stable() && state.period() == 1);
    /// let work = state.work();
    /// assert!((work.load - work.friction - work.damping).abs() < 1e-10 * work.load);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`PeriodicError`] for a load that does not close or does not fit the excitation, and if the search finds no
    /// steady state.
    pub fn periodic(&self, request: &PeriodicRequest) -> Result<PeriodicState, PeriodicError> {
        search::steady(self, request)
    }
}
