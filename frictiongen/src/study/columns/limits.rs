//! Rows and columns of the table of the limits β_lim and β*_lim.

use super::builder::Columns;
use super::column::{Column, Head, TableRow};
use super::measure::{Measure, PhysicalQuantity};
use super::setting::{Frequency, Setting, at};
use crate::OutOfDomain;

/// The limits of friction that the table contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitsAsked {
    /// The table contains the exact limits β_lim and β*_lim.
    Exact,
    /// The table contains the exact limits, an upper bound on β_lim that needs no search, and a lower bound from the
    /// single modes.
    All,
    /// The table contains the limit β*_lim, and an upper bound on β_lim that needs no search. The exact β_lim uses the
    /// maximum S of a function of τ over the half cycle. The bound uses the value of this function for τ → 0 instead.
    WithoutSearch,
}

/// A row of the table: the limits at one frequency, as friction ratios. A limit is `None` if the request does not
/// include it.
#[derive(Clone, Copy, Debug)]
pub struct LimitsRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Limit of continuous motion β_lim.
    pub continuous: Option<f64>,
    /// Upper bound on β_lim that needs no search. The exact β_lim uses the maximum S of a function of τ over the half
    /// cycle. The bound uses the value of this function for τ → 0 instead.
    pub without_search: Option<f64>,
    /// Lower bound on β_lim. The exact β_lim uses the maximum S, over the half cycle, of a sum over the modes. The
    /// bound uses the sum of the maxima of the single modes instead.
    pub per_mode: Option<f64>,
    /// Limit of sliding β*_lim.
    pub sliding: f64,
}

/// The table of β_lim and β*_lim over frequency.
#[derive(Clone, Copy)]
pub struct LimitsTable<'a> {
    /// System and units of the table.
    pub setting: Setting<'a>,
    /// The limits that the table contains.
    pub asked: LimitsAsked,
}

at!(LimitsRow);

/// A limit: its name, its heading, the symbol of the ratio, and the function that reads it from a row.
pub(super) type Limit<R> = (
    &'static str,
    &'static str,
    &'static str,
    fn(&R) -> Option<f64>,
);

/// The limits in the order of their columns.
const LIMITS: [Limit<LimitsRow>; 4] = [
    ("continuous_limit", "continuous limit", "beta_lim", |row| {
        row.continuous
    }),
    (
        "continuous_limit_without_search",
        "without search",
        "beta_lim",
        |row| row.without_search,
    ),
    ("continuous_limit_per_mode", "per mode", "beta_lim", |row| {
        row.per_mode
    }),
    ("sliding_limit", "sliding limit", "beta*_lim", |row| {
        Some(row.sliding)
    }),
];

impl LimitsAsked {
    /// Returns true if the table contains the limit with this index.
    fn has(self, index: usize) -> bool {
        match self {
            Self::Exact => matches!(index, 0 | 3),
            Self::All => true,
            Self::WithoutSearch => matches!(index, 1 | 3),
        }
    }
}

impl<'a> LimitsTable<'a> {
    /// Computes the row at a frequency.
    ///
    /// # Errors
    /// Same errors as [`System::at`](crate::study::System::at).
    pub fn row(&self, frequency: Frequency) -> Result<LimitsRow, OutOfDomain> {
        let system = self.setting.system;
        if self.asked == LimitsAsked::WithoutSearch {
            let limits = system.limits_without_search(frequency.r)?;
            return Ok(LimitsRow {
                frequency,
                continuous: None,
                without_search: Some(limits.continuous),
                per_mode: None,
                sliding: limits.sliding,
            });
        }
        let at = system.at(frequency.r)?;
        let limits = at.limits();
        let all = self.asked == LimitsAsked::All;
        Ok(LimitsRow {
            frequency,
            continuous: Some(limits.continuous),
            without_search: all.then(|| at.continuous_limit_without_search()),
            per_mode: all.then(|| at.continuous_limit_per_mode()),
            sliding: limits.sliding,
        })
    }

    /// Returns the columns of the table, from left to right.
    #[must_use]
    pub fn columns(&self) -> Vec<Column<'a, LimitsRow>> {
        let measure = self.setting.measure;
        let mut columns = Columns::new(&measure);
        self.setting.frequency(&mut columns);
        let asked = LIMITS.iter().enumerate();
        let asked = asked.filter(|(index, _)| self.asked.has(*index));
        let asked: Vec<_> = asked.map(|(_, limit)| *limit).collect();
        add_limits(&mut columns, &measure, &asked);
        columns.done()
    }
}

/// Adds a column for each limit: in N if the load is known, and as a ratio.
pub(super) fn add_limits<'a, R: TableRow + 'a>(
    columns: &mut Columns<'a, R>,
    measure: &Measure,
    limits: &[Limit<R>],
) {
    if measure.scale().is_some() {
        for (name, title, _, read) in limits {
            let head = Head::of(*name, PhysicalQuantity::Force).titled(&[title, "(N)"]);
            columns.number(head, *read);
        }
    }
    for (name, title, symbol, read) in limits {
        columns.number(Head::new(*name).titled(&[title, symbol]), *read);
    }
}
