//! Finds the best friction, which makes the largest amplitude over a band of frequencies smallest. The search covers
//! all regimes.

mod answer;
mod band;
mod evaluator;
mod number;
mod objective;
mod problem;
mod request;
mod search;
mod shares;
mod tuned;

use super::system::System;
pub use answer::{
    Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance, TunedNumber, TunedPoint,
};
pub(in crate::study) use band::Band;
pub use number::{Tunable, UnknownTunable};
use problem::OptimumProblem;
pub use request::{
    FrequencyBand, OptimumError, OptimumOptions, OptimumRequest, QuantityValue, Tuning,
};
use tuned::TunedSearch;

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
        self.optimum_with(request, &OptimumOptions::default())
    }

    /// Searches as [`optimum`](Self::optimum) does, with further conditions: bounds on other quantities, several
    /// quantities with divisors, numbers of the scene description that vary too, a bound on the work, and a function
    /// that can stop the search.
    ///
    /// **A varied number.** The number is a mass, a stiffness, a dashpot, a damping ratio, a damping factor, μ, or a
    /// number of one of several contacts. Band, load and friction force keep their values in Hz, N and m, even if m₁ or
    /// k₁ varies. The search evaluates 17 values of the number, including both bounds of its interval. The values are
    /// in geometric steps, or in quadratic steps if the interval starts at 0 or below. For each value the search finds
    /// the best of all frictions. It then narrows the intervals around the best values, with the frictions near those
    /// of the neighbouring values. At the end it searches among all frictions at the best value. The search misses a
    /// minimum between two values that has no lower amplitude at a scanned value.
    ///
    /// **Shares of contacts.** The search begins at the best common friction with the shares of the description. It
    /// changes friction and shares by factors, as long as that reduces the largest amplitude. The result is a local
    /// minimum.
    ///
    /// ```no_run
    /// use frictiongen::study::{System, optimum::{FrequencyBand, OptimumOptions, OptimumRequest, Tuning},
    /// response::MotionQuantity};
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
    /// let vary = [Tuning { of: block.tunable_named("k block - wall")?, from: 1.0, to: 2.0 }];
    /// let options = OptimumOptions { vary: &vary, ..OptimumOptions::default() };
    /// let tuned = block.optimum_with(&request, &options)?;
    /// assert!(tuned.tuned[0].at_end && tuned.tuned[0].value == 2.0);
    /// assert!(tuned.amplitude < block.optimum(&request)?.amplitude);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Same errors as [`optimum`](Self::optimum). [`OptimumError`] also for invalid conditions, for a scene that is
    /// invalid at a bound of an interval, and for bounds that no friction satisfies. [`OptimumError::Stopped`] if the
    /// function `watch` stopped the search before it found a friction, or if it stopped a search with several
    /// quantities.
    pub fn optimum_with(
        &self,
        request: &OptimumRequest,
        options: &OptimumOptions<'_>,
    ) -> Result<Optimum, OptimumError> {
        match options.vary {
            [] => OptimumProblem::new(self, request, options)?
                .watched_by(options.watch)
                .solved(),
            [tuning] if tuning.of.share().is_none() => {
                TunedSearch::new(self, request, *tuning, *options)?.solved()
            }
            _ => shares::best(self, request, options),
        }
    }
}
