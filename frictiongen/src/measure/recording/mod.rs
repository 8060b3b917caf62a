//! Recordings: samples of several channels, each with its unit.

mod bare;
mod check;
mod csv;
mod named;
mod rate;
mod series;
mod table;
mod uff58;
mod unit;

pub use series::Recording;
pub(super) use table::CsvTable;
pub use table::{CsvColumn, CsvRequest};
pub(super) use unit::MOTION;
pub use unit::{Dimension, Unit};

use super::MeasureError;

/// One channel of a recording: a signal with its name, its unit and its samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the signal: `base`, `force` or the name of a mass.
    pub name: String,
    /// Unit of the channel's samples.
    pub unit: Unit,
    /// Samples of the channel, in the unit `unit`.
    pub samples: Vec<f64>,
}

impl Recording {
    /// Reads a recording from the text of a file. The call detects whether the text is a universal file (UFF58) or CSV.
    ///
    /// # Errors
    /// Same errors as [`from_csv`](Self::from_csv) and [`from_uff58`](Self::from_uff58).
    pub fn from_text(text: &str, request: &CsvRequest) -> Result<Self, MeasureError> {
        // A universal file begins with the marker `-1` of a data set.
        let first = text.lines().find(|line| !line.trim().is_empty());
        if first.is_some_and(|line| line.trim() == "-1") {
            Self::from_uff58(text, request)
        } else {
            Self::from_csv(text, request)
        }
    }
}
