//! A row of the table: what the thesis prints, what comes out, and whether they agree.

/// One printed statement beside the number that it is about.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Which of the row's numbers it is.
    pub what: String,
    /// What the thesis prints; empty where it prints nothing.
    pub printed: String,
    /// The computed number; none for a statement in words.
    pub value: Option<f64>,
    /// What comes out.
    pub computed: String,
    /// Whether the printed holds; true where nothing is printed.
    pub agrees: bool,
}

/// What becomes of a printed row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every printed number is the computed one to its own digits.
    Agrees,
    /// At least one is not, for this reason.
    Corrected(&'static str),
    /// At least one is not, and nobody has said why.
    Unexplained,
}

/// A row of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// F01, ….
    pub id: &'static str,
    /// Scene and quantity.
    pub claim: &'static str,
    /// Section, equation or figure of the thesis.
    pub place: &'static str,
    /// The row's numbers.
    pub entries: Vec<Entry>,
    /// Why a printed number is off; empty where none is.
    pub reason: &'static str,
}

impl Row {
    /// Decided by comparing the numbers; a reason alone corrects nothing.
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

    /// The computed numbers, in the order of the entries.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        self.entries
            .iter()
            .filter_map(|entry| entry.value)
            .collect()
    }
}

/// Closed forms are rounded a few times in double precision; next to a pole some digits are lost.
pub const ROUNDING: f64 = 1e-12;

/// Half a unit of the last digit of a printed decimal number, and its value.
#[must_use]
pub fn printed_number(text: &str) -> Option<(f64, f64)> {
    let number = text.trim_start_matches("about ");
    let value: f64 = number.parse().ok()?;
    let decimals = number.split_once('.').map_or(0, |(_, digits)| digits.len());
    Some((value, 0.5 * 10_f64.powi(-i32::try_from(decimals).ok()?)))
}

/// A number printed as a decimal, "about" before it or not: it agrees if the computed one rounds to
/// it.
#[must_use]
pub fn number(what: &str, printed: &str, value: f64, decimals: usize) -> Entry {
    // A tie is decided by rounding noise: both neighbours are right.
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

/// A number printed as a formula: it agrees if it is the computed one to `tolerance`, relative.
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

/// A formula held at many points, `(printed, computed)` each; the first one is shown.
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

/// A printed statement about a number, such as a bound, that holds or not.
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

/// A printed statement in words.
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

/// A number of which nothing is printed.
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
