//! Requests for tables, and the errors of requests that cannot be met.

use crate::scene::Side;
use core::fmt;
use frictiongen_kernel::Float;

/// The coarsest accuracy that is useful.
pub const COARSEST: f64 = 0.1;
/// The finest accuracy of a table in double precision, relative.
pub const FINEST: f64 = 1e-12;
/// The finest accuracy for which a proof of β_lim is attempted. Finer tables are checked only.
pub const FINEST_PROVEN: f64 = 1e-6;
/// The finest accuracy of a table in single precision, relative. It is some roundings of that
/// precision.
pub const FINEST_SINGLE: f64 = 2e-6;

/// A request for tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Smallest and largest frequency ratio r of the table.
    pub r: (f64, f64),
    /// The largest relative error of an answer, or for a phase the largest error in radians.
    pub accuracy: f64,
    /// The side of the exact limits on which the table's limits may lie.
    pub side: Side,
    /// True if the table contains the motion of the contact in addition to the limits.
    pub motion: bool,
    /// True if the table contains the responses with the contact stuck.
    pub stuck: bool,
}

/// The reasons why a table cannot be built.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TableError {
    /// The range is empty or reversed, or contains r = 0 or infinity.
    Range(f64, f64),
    /// The accuracy is outside the possible range.
    Accuracy {
        /// The requested accuracy.
        value: f64,
        /// The finest accuracy of the scalar.
        finest: f64,
    },
    /// No table that was tried meets the accuracy.
    NotMet {
        /// The requested accuracy.
        accuracy: f64,
        /// The finest of the accuracies 10, 100, … times as coarse that can be met.
        reached: Option<f64>,
        /// The r at which it fails.
        at: f64,
    },
    /// Even the coarsest accuracy does not fit into the allowed bytes.
    TooFewBytes {
        /// The allowed bytes.
        bytes: usize,
        /// The bytes of the coarsest table.
        least: usize,
    },
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(low, high) => write!(
                f,
                "a table needs a range of frequency ratios 0 < a < b, both finite, not {low:?}..{high:?}"
            ),
            Self::Accuracy { value, finest } => write!(
                f,
                "an accuracy must be between {finest:?} and 0.1, not {value:?}"
            ),
            Self::NotMet {
                accuracy,
                reached,
                at,
            } => {
                let closest = match reached {
                    Some(reached) => format!("{reached:?} can be met"),
                    None => "not even 0.1 can be met".to_owned(),
                };
                write!(
                    f,
                    "no table meets the accuracy {accuracy:?} at r = {at:?}; {closest}; declare a coarser accuracy, or leave this r out of the range"
                )
            }
            Self::TooFewBytes { bytes, least } => write!(
                f,
                "no table fits into {bytes} bytes; the coarsest takes {least}; allow more, or narrow the range"
            ),
        }
    }
}

impl core::error::Error for TableError {}

impl Request {
    /// Checks that the request is possible in a scalar.
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

/// A number between the roundings of single and of double precision.
const BETWEEN_PRECISIONS: f64 = 1e-10;

/// Returns whether a scalar has single precision.
pub(super) fn is_single<S: Float>() -> bool {
    S::EPSILON > BETWEEN_PRECISIONS
}

/// Returns the finest accuracy of a table in a scalar.
pub fn finest<S: Float>() -> f64 {
    if is_single::<S>() {
        FINEST_SINGLE
    } else {
        FINEST
    }
}
