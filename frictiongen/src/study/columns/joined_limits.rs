//! Rows and columns of the table of the limits of several contacts.

use super::builder::Columns;
use super::column::Column;
use super::joined::JoinedTable;
use super::limits::{Limit, add_limits};
use super::setting::{Frequency, at};
use crate::study::joined::JoinedError;

/// Limits of several contacts at one frequency, as common friction ratios.
#[derive(Clone, Debug)]
pub struct JoinedLimitsRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Limit of continuous motion: below it, all contacts slide all the time. `None` on an undamped resonance of the
    /// stuck chain.
    pub continuous: Option<f64>,
    /// Limit of sliding: from it on, no contact slides. It is infinite on an undamped resonance of the stuck chain.
    pub sliding: f64,
    /// Name of the contact that slides first below the limit of sliding.
    pub slides_first: String,
}

at!(JoinedLimitsRow);

const LIMITS: [Limit<JoinedLimitsRow>; 2] = [
    ("continuous_limit", "continuous limit", "beta_lim", |row| {
        row.continuous
    }),
    ("sliding_limit", "sliding limit", "beta*_lim", |row| {
        Some(row.sliding)
    }),
];

impl<'a> JoinedTable<'a> {
    /// Computes the limits at a frequency.
    ///
    /// # Errors
    /// Same errors as [`at`](Self::at).
    pub fn limits(&self, frequency: Frequency) -> Result<JoinedLimitsRow, JoinedError> {
        let at = self.at(frequency)?;
        let stuck = at.stuck().ok();
        Ok(JoinedLimitsRow {
            frequency,
            continuous: match at.continuous_limit() {
                Err(JoinedError::Resonance) => None,
                limit => Some(limit?),
            },
            sliding: stuck.as_ref().map_or(f64::INFINITY, |stuck| stuck.limit()),
            slides_first: stuck.map_or(String::new(), |stuck| stuck.first().to_owned()),
        })
    }

    /// Returns the columns of the table of limits.
    #[must_use]
    pub fn limits_columns(&self) -> Vec<Column<'a, JoinedLimitsRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        add_limits(&mut columns, &self.setting.measure, &LIMITS);
        columns.word("slides_first", "slides_first", |row: &JoinedLimitsRow| {
            Some(row.slides_first.as_str())
        });
        columns.done()
    }
}
