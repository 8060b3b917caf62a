//! Finds the best friction, which makes the largest amplitude over a band of frequencies smallest. The search covers
//! all regimes.

mod answer;
mod band;
mod evaluator;
mod line;
mod number;
mod objective;
mod problem;
mod request;
mod search;
mod several;
mod shares;
mod tuned;

use super::system::System;
pub use answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance};
pub(in crate::study) use band::Band;
pub use number::{Tunable, UnknownTunable};
use problem::OptimumProblem;
pub use request::{FrequencyBand, OptimumError, OptimumRequest};
#[doc(hidden)]
pub use several::{KeptOptimum, KeptQuantity, Weighted, WeightedOptimum};
pub use shares::{ShareRange, SharesOptimum};
pub use tuned::{TunedOptimum, TunedPoint, Tuning};

/// Default bound on the work of a search for the best friction, in units of about 10 µs of computing time.
const WORK: usize = 1_200_000;

impl System {
    /// Returns the friction with which the largest amplitude of a motion over a band of frequencies is smallest, for one
    /// contact or for several. The friction of several contacts is their common friction, which multiplies the share of
    /// each contact.
    ///
    /// The search scans the friction from zero to a value from which all contacts are stuck. At each friction it
    /// evaluates the amplitude on a grid of frequencies, which is closer near the resonances of the chain with every set
    /// of stuck contacts, and refines the largest maxima. It leaves a friction as soon as one amplitude is too large.
    /// Golden sections narrow the best intervals of the scan, and secants equalise two equal peaks. The search then
    /// checks the best friction on a finer grid with steps of 0.25 %. If the check finds a higher peak, the search
    /// includes its frequency and goes on. The amplitude of the result is the largest found. A narrower peak between two
    /// frequencies of the finer grid may be higher.
    ///
    /// The search counts its work and ends at a bound. Because the bound is not a time limit, the result is the same
    /// on every machine. Motions that do not settle take most of the work. [`Optimum::end`] says if the search converged
    /// or reached the bound, or ended at a friction at which the motion jumps to another steady state.
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
        problem.watched_by(watch).solved(WORK)
    }
}
