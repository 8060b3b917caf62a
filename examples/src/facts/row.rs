//! A row of the table: the printed numbers, the computed ones, and the verdict.

/// One printed statement of a row, with the computed number that it is compared with.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name of the number within its row.
    pub what: String,
    /// Printed text. It is empty if the thesis prints nothing.
    pub printed: String,
    /// Computed number. `None` for a statement in words.
    pub value: Option<f64>,
    /// Computed result as text.
    pub computed: String,
    /// True if the printed statement is right, or if nothing is printed.
    pub agrees: bool,
}

/// Result of comparing a row with the thesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every printed number equals the computed one to its printed digits.
    Agrees,
    /// At least one printed number differs. The text gives the reason.
    Corrected(&'static str),
    /// At least one printed number differs, and no reason is given.
    Unexplained,
}

/// A row of the table: printed numbers on one subject, compared with computed ones.
#[derive(Clone, Debug)]
pub struct Row {
    /// Identifier of the row: F01, F02, ….
    pub id: &'static str,
    /// Scene and quantity that the row is about.
    pub claim: &'static str,
    /// Section, equation or figure of the thesis.
    pub place: &'static str,
    /// Printed and computed numbers of the row.
    pub entries: Vec<Entry>,
    /// Reason why a printed number is wrong. It is empty if no printed number is wrong.
    pub reason: &'static str,
}

impl Row {
    /// Decides the verdict by comparing the numbers. A row whose numbers all agree is not corrected, even if a reason
    /// is given.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.entries.iter().all(|entry| entry.agrees) {
            Verdict::Agrees
        } else if self.reason.is_empty() {
            Verdict::Unexplained
        } else {
            Verdict::Corrected(self.reason)
        }
    }

    /// Returns the computed numbers, in the order of the entries.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        self.entries
            .iter()
            .filter_map(|entry| entry.value)
            .collect()
    }
}

/// Relative tolerance for closed forms in double precision. They are rounded a few times, and lose some digits next
/// to a pole.
pub const ROUNDING: f64 = 1e-12;

/// Parses a printed decimal number. Returns the number, and half a unit of its last digit.
#[must_use]
pub fn printed_number(text: &str) -> Option<(f64, f64)> {
    let number = text.trim_start_matches("about ");
    let value: f64 = number.parse().ok()?;
    let decimals = number.split_once('.').map_or(0, |(_, digits)| digits.len());
    Some((value, 0.5 * 10_f64.powi(-i32::try_from(decimals).ok()?)))
}

/// Compares a computed number with a printed decimal, which may begin with "about". The two numbers agree if the
/// computed number rounds to the printed number.
#[must_use]
pub fn number(what: &str, printed: &str, value: f64, decimals: usize) -> Entry {
    // If the computed number is halfway between two decimals, rounding noise would decide. The decimal below and the
    // decimal above the number therefore count as right.
    let agrees = printed_number(printed)
        .is_some_and(|(want, half)| (value - want).abs() <= half * (1.0 + 1e-9));
    Entry {
        what: what.into(),
        printed: printed.into(),
        value: Some(value),
        computed: format!("{value:.decimals$}"),
        agrees,
    }
}

/// Compares a computed number with a printed formula. They agree within the relative tolerance `tolerance`.
#[must_use]
pub fn formula(
    what: &str,
    (printed, want): (&str, f64),
    value: f64,
    tolerance: f64,
    decimals: usize,
) -> Entry {
    Entry {
        what: what.into(),
        printed: printed.into(),
        value: Some(value),
        computed: format!("{value:.decimals$}"),
        agrees: (value - want).abs() <= tolerance * want.abs(),
    }
}

/// Compares a printed formula with computed numbers at many points, each `(printed, computed)`. The entry shows the
/// first point.
#[must_use]
pub fn formula_at(
    what: &str,
    printed: &str,
    points: &[(f64, f64)],
    tolerance: f64,
    decimals: usize,
) -> Entry {
    let value = points.first().map_or(f64::NAN, |(_, computed)| *computed);
    let holds = |(want, got): &(f64, f64)| (got - want).abs() <= tolerance * want.abs();
    Entry {
        what: what.into(),
        printed: printed.into(),
        value: Some(value),
        computed: format!("{value:.decimals$}"),
        agrees: !points.is_empty() && points.iter().all(holds),
    }
}

/// Returns an entry for a printed statement about a number, such as a bound. `agrees` is true if the statement is true.
#[must_use]
pub fn claim(what: &str, printed: &str, value: f64, decimals: usize, agrees: bool) -> Entry {
    Entry {
        what: what.into(),
        printed: printed.into(),
        value: Some(value),
        computed: format!("{value:.decimals$}"),
        agrees,
    }
}

/// Returns an entry for a printed statement in words. `agrees` is true if the statement is true.
#[must_use]
pub fn words(what: &str, printed: &str, computed: String, agrees: bool) -> Entry {
    Entry {
        what: what.into(),
        printed: printed.into(),
        value: None,
        computed,
        agrees,
    }
}

/// Returns an entry for a computed number that the thesis does not print.
#[must_use]
pub fn added(what: &str, value: f64, decimals: usize) -> Entry {
    Entry {
        what: what.into(),
        printed: String::new(),
        value: Some(value),
        computed: format!("{value:.decimals$}"),
        agrees: true,
    }
}
