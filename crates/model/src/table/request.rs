//! Requests for tables, and errors for requests that no table can meet.

use crate::scene::Side;
use core::fmt;
use frictiongen_kernel::Float;

/// Largest relative error that a request may allow. A coarser table would not be useful.
pub const COARSEST: f64 = 0.1;
/// Smallest relative error that a request may allow in double precision.
pub const FINEST: f64 = 1e-12;
/// Smallest relative error for which the generator attempts a proof of β_lim. More accurate tables are only checked.
pub const FINEST_PROVEN: f64 = 1e-6;
/// Smallest relative error that a request may allow in single precision. This error is a few rounding units of single
/// precision.
pub const FINEST_SINGLE: f64 = 2e-6;

/// A request for tables of one scene: their range, their accuracy and their content.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Smallest and largest frequency ratio r of the tables.
    pub r: (f64, f64),
    /// Largest allowed error of a result. The error is relative, except for a phase, whose error is in radians.
    pub accuracy: f64,
    /// Side of the exact limits on which the limits from the tables may lie.
    pub side: Side,
    /// True if the tables contain the motion of the contact in addition to the limits.
    pub motion: bool,
    /// True if the tables contain the responses while the contact is stuck.
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
        /// The requested accuracy, a relative error.
        value: f64,
        /// The finest accuracy that the number type allows, a relative error.
        finest: f64,
    },
    /// None of the tables that the generator tried meets the accuracy.
    NotMet {
        /// The requested accuracy, a relative error.
        accuracy: f64,
        /// The finest accuracy that a table can meet, or `None` if a table meets none. The generator tries accuracies
        /// that are 10, 100, … times as coarse as the request.
        reached: Option<f64>,
        /// The frequency ratio r at which no table meets the accuracy.
        at: f64,
    },
    /// The contact is elastic. Its response has no table.
    ElasticContact,
    /// The scene has several contacts or dashpots. Tables do not support them.
    SeveralContacts,
    /// Even the coarsest accuracy does not fit into the allowed bytes.
    TooFewBytes {
        /// The allowed number of bytes.
        bytes: usize,
        /// The number of bytes of the tables with the coarsest accuracy.
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
            Self::ElasticContact => f.write_str(
                "tables are not possible with an elastic contact (`stiffness`); compute its steady states at run time",
            ),
            Self::SeveralContacts => f.write_str(
                "tables are not possible with `contacts` or `dampers`; compute the steady states of the scene at run time",
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
    /// Checks that the range and the accuracy of the request are possible in the number type `S`.
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

/// Number between the relative rounding errors of single and of double precision. It separates the two.
const BETWEEN_PRECISIONS: f64 = 1e-10;

/// Returns true if a number type has single precision.
pub(super) fn is_single<S: Float>() -> bool {
    S::EPSILON > BETWEEN_PRECISIONS
}

/// Returns the finest accuracy of a table in a number type, as a relative error.
pub fn finest<S: Float>() -> f64 {
    if is_single::<S>() {
        FINEST_SINGLE
    } else {
        FINEST
    }
}
