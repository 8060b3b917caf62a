//! The best friction together with the best value of one number of the scene description.

mod answer;
mod kept;
mod number;
mod search;
mod tried;

use super::{KeptQuantity, OptimumError, OptimumRequest};
use crate::study::system::System;
pub use answer::{TunedOptimum, TunedPoint, Tuning};
use kept::KeptTunedSearch;
pub use number::{Tunable, UnknownTunable};
use tried::TunedSearch;

impl System {
    /// Returns the best friction together with the best value of one number of the scene description. With this
    /// friction and this value, the largest amplitude of a motion over a band of frequencies is smallest. The number is
    /// a stiffness, a mass, a damping ratio, a damping factor or μ. Band, load and friction force keep their values in
    /// Hz, N and m, even if m₁ or k₁ varies.
    ///
    /// The search evaluates 17 values of the number, including both bounds of its interval. The values are in geometric
    /// steps, or in quadratic steps if the interval starts at 0 or below. For each value the search finds the best of
    /// all friction ratios, as [`optimum`](Self::optimum) does. The search also computes the derivative of the best
    /// amplitude with respect to the number, while the friction stays the best.
    ///
    /// If the amplitude first falls and then rises between two neighbouring values, the search finds the minimum
    /// between them. The minimum is a zero of the derivative, or a crossing of two branches. The search first looks for
    /// the best friction near the best frictions of the neighbouring values. At the end the search looks for the best
    /// friction among all friction ratios.
    ///
    /// The result is the smallest amplitude of all evaluated values. The search misses a minimum between two
    /// neighbouring values if the amplitude rises at the lower value or falls at the higher value. If the minimum is
    /// sharp, value and friction have 9 digits. If the minimum is flat, value and friction have half as many digits as
    /// the amplitude. The call takes several times as long as [`optimum`](Self::optimum).
    ///
    /// ```no_run
    /// use frictiongen::study::{System, optimum::{FrequencyBand, OptimumRequest, Tuning}, response::MotionQuantity};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // The base drives the block and is its contact partner. A stiffer spring to the wall reduces the motion.
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1, block - wall: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    ///     damping: modal(0.05),
    /// }"
    /// .parse()?;
    /// let request = OptimumRequest {
    ///     of: block.motion_named("block")?,
    ///     size: MotionQuantity::Displacement,
    ///     band: FrequencyBand::Ratio(0.2, 1.2),
    ///     load: None,
    /// };
    /// let tuning = Tuning { of: block.tunable_named("k block - wall")?, from: 1.0, to: 2.0 };
    /// let tuned = block.tuned_optimum(&request, &tuning)?;
    /// assert!(tuned.at_end && tuned.value == 2.0);
    /// assert!(tuned.optimum.amplitude < block.optimum(&request)?.amplitude);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum). [`OptimumError`] also for an invalid interval, for a scene that is
    /// invalid at a bound of the interval, and if no value of the number has a result.
    pub fn tuned_optimum(
        &self,
        request: &OptimumRequest,
        tuning: &Tuning,
    ) -> Result<TunedOptimum, OptimumError> {
        TunedSearch::new(self, request, *tuning)?.solved()
    }

    /// Searches as [`tuned_optimum`](Self::tuned_optimum) does, and calls `watch` after each evaluation, from several
    /// threads. If `watch` returns false once, it must return false from then on. The search then ends with the best
    /// result so far.
    ///
    /// # Errors
    /// Same errors as [`tuned_optimum`](Self::tuned_optimum), and [`OptimumError::Stopped`] if the search was stopped
    /// before it found a result.
    #[doc(hidden)]
    pub fn tuned_optimum_watched(
        &self,
        request: &OptimumRequest,
        tuning: &Tuning,
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<TunedOptimum, OptimumError> {
        let search = TunedSearch::new(self, request, *tuning)?;
        search.watched_by(watch).solved()
    }

    /// Finds the best friction together with the best value of one number of the scene description, under bounds. With
    /// this friction and this value, other quantities stay within their bounds over the whole band. The result also has
    /// the largest value over the band of each quantity with a bound, in the order of the bounds.
    ///
    /// The search evaluates the same 17 values of the number as [`tuned_optimum`](Self::tuned_optimum). For each value
    /// the search finds the best friction within the bounds, as [`kept_optimum`](Self::kept_optimum) does. Around the
    /// best values, the search narrows the interval until seven digits of the value are known. If no friction satisfies
    /// the bounds at any of the 17 values, the search minimises the bounded quantities one after another.
    ///
    /// The search calls `watch` after each evaluation, from several threads. If `watch` returns false once, it must
    /// return false from then on. The search then ends with the best result so far.
    ///
    /// # Errors
    /// Same errors as [`tuned_optimum`](Self::tuned_optimum) and [`kept_optimum`](Self::kept_optimum).
    #[doc(hidden)]
    pub fn kept_tuned_optimum(
        &self,
        request: &OptimumRequest,
        tuning: &Tuning,
        kept: &[KeptQuantity],
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<(TunedOptimum, Vec<f64>), OptimumError> {
        let search = TunedSearch::new(self, request, *tuning)?.watched_by(watch);
        KeptTunedSearch::new(&search, kept, watch).solved()
    }
}
