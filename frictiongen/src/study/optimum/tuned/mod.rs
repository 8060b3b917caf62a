//! The best friction together with the best value of one number of the description.

mod answer;
mod number;
mod search;
mod tried;

use super::{OptimumError, OptimumRequest};
use crate::study::system::System;
pub use answer::{TunedOptimum, TunedPoint, Tuning};
pub use number::{Tunable, UnknownTunable};
use tried::Search;

impl System {
    /// The friction and the value of one number of the description - a stiffness, a mass, a damping ratio - that together
    /// keep the largest amplitude of a motion over a band of frequencies smallest. Band, load and friction force are held in
    /// Hz, N and m, also while m₁ or k₁ moves.
    ///
    /// For 17 values, both ends among them, the best friction is looked for as [`optimum`](Self::optimum) does, over all
    /// friction, and with it the derivative of its amplitude along the number, by which friction follows. The values are in
    /// geometric steps, of an interval from 0 on in quadratic ones. Between two neighbours where the amplitude first falls and
    /// then rises its least is found: by the zero of the derivative, or where two branches cross. There friction is
    /// looked for near that of the neighbours, and over all friction once more in the end.
    ///
    /// So the result is the least of all that the scan sees. What is not seen is a valley between two neighbours at which
    /// the amplitude rises towards it or falls beyond it. Where the least is sharp, value and friction are found to 9 digits;
    /// where it is flat, to half of the digits of the amplitude. It takes about ten times as long as [`optimum`](Self::optimum).
    ///
    /// ```no_run
    /// use frictiongen::study::{FrequencyBand, OptimumRequest, System, Tuning};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // Stiffer to the wall, a block that its base drives and rubs on moves less.
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
    /// [`OptimumError`]: as of [`optimum`](Self::optimum), for an interval that makes no sense, for an end of it with which
    /// the scene makes none, and where no value has an answer.
    pub fn tuned_optimum(
        &self,
        request: &OptimumRequest,
        tuning: &Tuning,
    ) -> Result<TunedOptimum, OptimumError> {
        Search::new(self, request, *tuning)?.solved()
    }
}
