//! Rows and columns of the table of the limits of several contacts.

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
use super::joined::JoinedTable;
use super::measure::PhysicalQuantity;
use super::setting::{AtFrequency, Frequency};
use crate::study::joined::JoinedError;

/// Limits of several contacts at one frequency, as common friction ratios.
#[derive(Clone, Debug)]
pub struct JoinedLimitsRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Limit of continuous motion: below it, all contacts slide all the time. It is NaN if no steady state shows it.
    pub continuous: f64,
    /// Limit of sliding: from it on, no contact slides. It is infinite on an undamped resonance of the stuck chain.
    pub sliding: f64,
    /// Name of the contact that slides first below the limit of sliding.
    pub slides_first: String,
}

impl TableRow for JoinedLimitsRow {
    fn omega(&self) -> f64 {
        self.frequency.omega
    }
}

impl AtFrequency for JoinedLimitsRow {
    fn frequency(&self) -> Frequency {
        self.frequency
    }
}

/// A limit: its name, its heading, the symbol of the ratio, and the function that reads it from a row.
type Limit = (
    &'static str,
    &'static str,
    &'static str,
    fn(&JoinedLimitsRow) -> f64,
);

const LIMITS: [Limit; 2] = [
    ("continuous_limit", "continuous limit", "beta_lim", |row| {
        row.continuous
    }),
    ("sliding_limit", "sliding limit", "beta*_lim", |row| {
        row.sliding
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
            continuous: at.continuous_limit()?,
            sliding: stuck.as_ref().map_or(f64::INFINITY, |stuck| stuck.limit()),
            slides_first: stuck.map_or(String::new(), |stuck| stuck.first().to_owned()),
        })
    }

    /// Returns the columns of the table of limits.
    #[must_use]
    pub fn limits_columns(&self) -> Vec<Column<'a, JoinedLimitsRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        if self.setting.measure.scale().is_some() {
            for (name, title, _, read) in LIMITS {
                let head = Head::of(name, PhysicalQuantity::Force).titled(&[title, "(N)"]);
                columns.number(head, move |row| Some(read(row)));
            }
        }
        for (name, title, symbol, read) in LIMITS {
            let head = Head::new(name).titled(&[title, symbol]);
            columns.number(head, move |row| Some(read(row)));
        }
        columns.word("slides_first", "slides_first", |row: &JoinedLimitsRow| {
            Some(row.slides_first.as_str())
        });
        columns.done()
    }
}
