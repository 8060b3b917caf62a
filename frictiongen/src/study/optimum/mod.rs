//! Finds the best friction, which makes the largest amplitude over a band of frequencies smallest. The search covers
//! all regimes.

mod amplitude;
mod answer;
mod bounds;
mod candidates;
mod creep;
mod flat;
mod grid;
mod kept;
mod line;
mod look;
mod minima;
mod objective;
pub(in crate::study) mod peaks;
mod places;
mod problem;
mod request;
mod resonance;
mod scan;
mod search;
mod tuned;
mod verified;
mod weighted;
mod whole;

use super::system::System;
pub(in crate::study) use amplitude::FrictionAmount;
pub use answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance};
#[doc(hidden)]
pub use kept::{KeptOptimum, KeptQuantity};
pub(in crate::study) use objective::Objective;
use problem::OptimumProblem;
pub use request::{FrequencyBand, OptimumError, OptimumRequest};
pub use tuned::{Tunable, TunedOptimum, TunedPoint, Tuning, UnknownTunable};
#[doc(hidden)]
pub use weighted::{Weighted, WeightedOptimum};

/// Default bound on the work of a search for the best friction, in units of about 10 µs of computing time.
const WORK: usize = 2_000_000;

impl System {
    /// Returns the friction with which the largest amplitude of a motion over a band of frequencies is smallest. If the
    /// contact slides all the time, the amplitude is that of the closed form. Otherwise it is that of the steady state
    /// with stops, or of the stuck response.
    ///
    /// The search scans friction ratios from zero to a value above which more friction no longer reduces the
    /// amplitude. At each friction ratio the search evaluates the amplitude near the resonances of the chain with a
    /// free and with a stuck contact, and near the sub-harmonics of these resonances. Further frequencies are on a
    /// grid and on both sides of regime changes. The search evaluates closed forms first. If the closed forms exceed
    /// the best amplitude so far by a margin, the search rejects the friction ratio. The search computes motions in
    /// time only at frequencies at which the amplitude may be the largest.
    ///
    /// The search counts its work and ends at a bound. Because the bound is not a time limit, the result is the same
    /// on every machine. Motions that do not settle take most of the work. [`Optimum::end`] says if the search reached
    /// the bound, or ended at a friction at which the motion jumps to another steady state. [`Optimum::bracket`] then
    /// contains the best friction ratio.
    ///
    /// If static exceeds kinetic friction (μ > 1), several steady states may exist at one frequency. The first
    /// comparison of friction ratios uses the closed form where β is less than β_lim and β*_lim. At the friction
    /// ratios that seem best, the search then computes the motion from rest over a fine grid of the band. The
    /// amplitude of the result is the largest on that grid. Grid points are 0.25 % apart, and 0.0025 % around the
    /// largest peak. A peak between two grid points may be higher.
    ///
    /// ```
    /// use frictiongen::study::{System, optimum::{FrequencyBand, OptimumKind, OptimumRequest}, response::MotionQuantity,
    /// units::Load};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { lower: 3.27, upper: 3.25 },                     // kg
    ///     springs: { base - lower: 1190.0, lower - upper: 1323.0 }, // N/m
    ///     contact: upper - wall,
    ///     excitation: base,
    ///     damping: modal[0.010, 0.012],
    /// }"
    /// .parse()?;
    /// let request = OptimumRequest {
    ///     of: frame.motion_named("upper")?,
    ///     size: MotionQuantity::Displacement,
    ///     band: FrequencyBand::Hertz(1.5, 3.0),
    ///     load: Some(Load::Base(0.003)), // m
    /// };
    /// let optimum = frame.optimum(&request)?;
    /// assert!(optimum.amplitude < 0.5 * optimum.without_friction);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`OptimumError`] for an invalid band, motion, load or quantity, and if no friction bounds the amplitude.
    pub fn optimum(&self, request: &OptimumRequest) -> Result<Optimum, OptimumError> {
        self.optimum_within(request, WORK)
    }

    /// Searches as [`optimum`](Self::optimum) does, but with a given bound on the work, in units of about 10 µs of
    /// computing time. A search that reaches the bound ends with [`OptimumEnd::WorkSpent`].
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum).
    pub fn optimum_within(
        &self,
        request: &OptimumRequest,
        work: usize,
    ) -> Result<Optimum, OptimumError> {
        OptimumProblem::new(self, request)?.solved(work)
    }

    /// Searches as [`optimum`](Self::optimum) does, and calls `watch` after each evaluation. If `watch` returns false,
    /// the search ends with the best friction so far and [`OptimumEnd::Stopped`].
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum), and [`OptimumError::Stopped`] if no friction was found before the
    /// stop.
    #[doc(hidden)]
    pub fn optimum_watched(
        &self,
        request: &OptimumRequest,
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<Optimum, OptimumError> {
        let problem = OptimumProblem::new(self, request)?;
        problem.watched_by(Some(watch)).solved(WORK)
    }
}
