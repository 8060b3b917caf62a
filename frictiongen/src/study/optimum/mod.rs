//! The friction that keeps the largest amplitude over a band of frequencies smallest, over all regimes.

mod amplitude;
mod answer;
mod bounds;
mod candidates;
mod creep;
mod flat;
mod line;
mod look;
pub(in crate::study) mod peaks;
mod places;
mod problem;
mod request;
mod scan;
mod search;
mod tuned;

use super::system::System;
pub(in crate::study) use amplitude::Friction;
pub use answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance};
use problem::Problem;
pub use request::{FrequencyBand, OptimumError, OptimumRequest};
pub use tuned::{Tunable, TunedOptimum, TunedPoint, Tuning, UnknownTunable};

/// The work of a search.
const WORK: usize = 1_000_000;

impl System {
    /// The friction that keeps the largest amplitude of a motion over a band of frequencies smallest, over all regimes: the
    /// closed form where the contact slides all the time, steady states where it stops, the stuck response.
    ///
    /// The largest amplitude over the band is looked for about every resonance, of the chain and of the chain with its
    /// contact stuck, their sub-harmonics, on both sides of changes of regime and on a grid between, the least over friction by
    /// a scan between none and so much that nothing slides.  What has a closed form comes first; a friction ratio at which that
    /// exceeds the best so far is left, and motions are followed where they may be the largest.
    ///
    /// The work of a search is bounded and counted: the answer is the same on every machine.  Most frames take less than a
    /// second; those whose motions jump and do not settle take up to twenty.  Where the
    /// bound is met, or the least is at a jump to another steady state, [`Optimum::end`] says so, and
    /// [`Optimum::bracket`] between which friction ratios the least lies.
    ///
    /// With μ > 1 the search takes the closed form where β is below both limits, and follows the motion from rest at the
    /// largest peaks of the result.
    ///
    /// ```
    /// use frictiongen::study::{FrequencyBand, Load, OptimumKind, OptimumRequest, System};
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
    /// [`OptimumError`]: for a band, a motion, a load or a quantity that makes no sense, and where no friction bounds the
    /// amplitude.
    pub fn optimum(&self, request: &OptimumRequest) -> Result<Optimum, OptimumError> {
        self.optimum_within(request, WORK)
    }

    /// Searches as [`optimum`](Self::optimum) does, with another bound on the work, in units of some 10 µs.  A search that meets the
    /// bound ends with [`OptimumEnd::WorkSpent`].
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum).
    pub fn optimum_within(
        &self,
        request: &OptimumRequest,
        work: usize,
    ) -> Result<Optimum, OptimumError> {
        Problem::new(self, request)?.solved(work)
    }
}
