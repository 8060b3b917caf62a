//! What is known of a table, and how it is told.

use super::super::worst::Worst;

/// What is known of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Evidence {
    /// Its error is below a bound at every r.
    Proven,
    /// The same but in some places, where it is checked.
    Partly,
    /// It was compared with exact values at many points; between them its error may be larger.
    Checked,
}

impl Evidence {
    /// In a word.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Proven => "proven",
            Self::Partly => "partly",
            Self::Checked => "checked",
        }
    }
}

/// How much work a proof may take, in evaluations of one mode: of a processor a quarter of a microsecond each, one and a half where
/// nothing is optimised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work(pub usize);

impl Work {
    /// What a macro spends.  A table that needs more is told from its size, and left checked.
    pub const AT_EXPANSION: Self = Self(1_700_000);
    /// What a command spends: four seconds of a processor at most.
    pub const WHOLE: Self = Self(16_000_000);
}

/// What is proven of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// How much is.
    pub evidence: Evidence,
    /// What the relative error cannot exceed where it is proven, and where this bound is largest.
    pub bound: Worst,
    /// Where it is not proven, ascending.
    pub open: Vec<(f64, f64)>,
    /// The work that it took.
    pub work: Work,
}

impl Proof {
    /// Of what is only checked.
    #[must_use]
    pub fn none((low, high): (f64, f64)) -> Self {
        Self {
            evidence: Evidence::Checked,
            bound: Worst {
                error: 0.0,
                at: low,
            },
            open: vec![(low, high)],
            work: Work(0),
        }
    }

    /// How much of r is open.
    #[must_use]
    pub fn open_length(&self) -> f64 {
        self.open
            .iter()
            .fold(0.0, |sum, (from, to)| sum + (to - from))
    }

    /// The widest place that is open.
    #[must_use]
    pub fn widest(&self) -> Option<(f64, f64)> {
        let places = self.open.iter().copied();
        places.max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
    }

    /// In a sentence or two.
    #[must_use]
    pub fn told(&self) -> String {
        let bound = format!(
            "at most {:.2e} off, the bound being largest at r = {}",
            self.bound.error, self.bound.at
        );
        match (self.evidence, self.widest()) {
            (Evidence::Proven, _) => format!("Proven at every r: {bound}."),
            (Evidence::Partly, Some((from, to))) if from == to => {
                let count = self.open.len();
                let but = if count == 1 {
                    format!("r = {from}, which")
                } else {
                    format!("{count} numbers each of which")
                };
                format!(
                    "Proven at every r but {but} is a zero or a pole to the last digit: {bound}."
                )
            }
            (Evidence::Partly, Some((from, to))) => {
                let (count, length) = (self.open.len(), self.open_length());
                let places = if count == 1 { "one place" } else { "places" };
                let count = if count == 1 {
                    String::new()
                } else {
                    format!("{count} ")
                };
                format!(
                    "Proven: {bound}.  Only checked in {count}{places} of {length:.1e} in all, the widest from r = {from} to {to}."
                )
            }
            _ => "Checked, not proven: between the points an error may be larger.".to_owned(),
        }
    }
}
