//! What is asked of tables, and why it cannot be had.

use crate::scene::Side;
use frictiongen_kernel::Float;

/// The coarsest accuracy that means anything.
pub const COARSEST: f64 = 0.1;
/// The finest accuracy of a table in double precision.
pub const FINEST: f64 = 1e-12;
/// The finest accuracy that a proof of β_lim is tried for: below it a table is checked.
pub const FINEST_PROVEN: f64 = 1e-6;
/// The finest accuracy of a table in single precision: some of its roundings.
pub const FINEST_SINGLE: f64 = 2e-6;

/// What tables are asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Smallest and largest frequency ratio.
    pub r: (f64, f64),
    /// The largest relative error of an answer; of a phase in radians.
    pub accuracy: f64,
    /// On which side of the exact limits the tabled ones may be.
    pub side: Side,
    /// Whether the contact's motion is tabled besides the limits.
    pub motion: bool,
    /// Whether the responses while the contact is stuck are.
    pub stuck: bool,
}

/// Why there is no table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// The range is empty, reversed, or holds r = 0 or infinity.
    #[error("a table needs a range of frequency ratios 0 < a < b, both finite, not {0:?}..{1:?}")]
    Range(f64, f64),
    /// An accuracy that is none.
    #[error("an accuracy lies from {finest:?} to 0.1, not at {value:?}")]
    Accuracy {
        /// What was asked.
        value: f64,
        /// The finest that the scalar allows.
        finest: f64,
    },
    /// Nothing that was tried meets the accuracy.
    #[error("{}", not_met(.accuracy, .reached, .at))]
    NotMet {
        /// What was asked.
        accuracy: f64,
        /// The finest of the accuracies 10, 100, … times as coarse that can be met.
        reached: Option<f64>,
        /// Where it fails.
        at: f64,
    },
    /// Not even the coarsest accuracy fits into so many bytes.
    #[error(
        "no table fits into {bytes} bytes; the coarsest takes {least}: allow more, or narrow the range"
    )]
    TooFewBytes {
        /// What was allowed.
        bytes: usize,
        /// What the coarsest table takes.
        least: usize,
    },
}

fn not_met(accuracy: &f64, reached: &Option<f64>, at: &f64) -> String {
    let closest = match reached {
        Some(reached) => format!("{reached:?} can be met"),
        None => "nor can 0.1".to_owned(),
    };
    format!(
        "no table meets the accuracy {accuracy:?} at r = {at:?}; {closest}: ask for less, or leave this r out of the range"
    )
}

impl Request {
    /// Whether it makes sense in a scalar.
    ///
    /// # Errors
    /// [`TableError::Range`] and [`TableError::Accuracy`].
    pub fn check<S: Float>(&self) -> Result<(), TableError> {
        let (low, high) = self.r;
        let smallest = S::constant(low) > S::constant(0.0);
        if !(smallest && S::constant(low) < S::constant(high) && S::constant(high).is_finite()) {
            return Err(TableError::Range(low, high));
        }
        let finest = finest::<S>();
        if !(finest <= self.accuracy && self.accuracy <= COARSEST) {
            return Err(TableError::Accuracy {
                value: self.accuracy,
                finest,
            });
        }
        Ok(())
    }
}

/// Between the roundings of single and of double precision.
const BETWEEN_PRECISIONS: f64 = 1e-10;

/// Whether a scalar has single precision.
pub(super) fn is_single<S: Float>() -> bool {
    S::EPSILON > BETWEEN_PRECISIONS
}

/// The finest accuracy of a table in a scalar.
pub fn finest<S: Float>() -> f64 {
    if is_single::<S>() {
        FINEST_SINGLE
    } else {
        FINEST
    }
}
