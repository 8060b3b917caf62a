//! Evidence for the accuracy of a table, and sentences that report it.

use super::worst::{Worst, shown};
use frictiongen_kernel::Float;

/// The evidence for the accuracy of a table: proven, partly proven or checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Evidence {
    /// The error of the table is below a bound at every r.
    Proven,
    /// The error of the table is below a bound at every r except in some intervals, where the table is only checked.
    Partly,
    /// The table was compared with exact values at many points. Between these points its error may be larger.
    Checked,
}

impl Evidence {
    /// Returns the evidence as one word.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Proven => "proven",
            Self::Partly => "partly",
            Self::Checked => "checked",
        }
    }
}

/// Permitted work of a proof, in evaluations of one mode. An evaluation takes about 0.25 µs, or 1.5 µs in code
/// without optimisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProofWork(pub usize);

impl ProofWork {
    /// Permitted work of a proof within a macro. The size of a table determines the work in advance. If a proof needs
    /// more work, the macro only checks the table.
    pub const AT_EXPANSION: Self = Self(1_700_000);
    /// Permitted work of a proof within a command: at most about four seconds of processor time.
    pub const WHOLE: Self = Self(16_000_000);
}

/// Result of a proof of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// The evidence for the accuracy: proven, partly proven or checked.
    pub evidence: Evidence,
    /// Upper bound on the relative error in the proven intervals, with the r at which this bound is largest.
    pub bound: Worst,
    /// Intervals of r without a proof, in ascending order.
    pub open: Vec<(f64, f64)>,
    /// The work that the proof took.
    pub work: ProofWork,
}

impl Proof {
    /// Returns the result for a table that is only checked.
    #[must_use]
    pub fn none((low, high): (f64, f64)) -> Self {
        Self {
            evidence: Evidence::Checked,
            bound: Worst {
                error: 0.0,
                at: low,
            },
            open: vec![(low, high)],
            work: ProofWork(0),
        }
    }

    /// Returns the total length of the intervals of r without a proof.
    #[must_use]
    pub fn open_length(&self) -> f64 {
        self.open
            .iter()
            .fold(0.0, |sum, (from, to)| sum + (to - from))
    }

    /// Returns the longest interval of r without a proof. Returns `None` if the whole range is proven.
    #[must_use]
    pub fn widest(&self) -> Option<(f64, f64)> {
        let places = self.open.iter().copied();
        places.max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
    }

    /// Returns the result of the proof in one or two sentences. Each r has the digits of `f64`.
    #[must_use]
    pub fn told(&self) -> String {
        self.told_in::<f64>()
    }

    /// Returns the result of the proof in one or two sentences. Each r has as few digits as the scalar type S of the
    /// tables needs.
    #[must_use]
    pub fn told_in<S: Float>(&self) -> String {
        let bound = format!(
            "at most {:.2e} off, the bound being largest at r = {}",
            self.bound.error,
            self.bound.place::<S>()
        );
        match (self.evidence, self.widest()) {
            (Evidence::Proven, _) => format!("Proven at every r: {bound}."),
            (Evidence::Partly, Some((from, to))) if from == to => {
                let count = self.open.len();
                let but = if count == 1 {
                    format!("r = {}, which", shown::<S>(from))
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
                let (from, to) = (shown::<S>(from), shown::<S>(to));
                format!(
                    "Proven: {bound}.  Only checked in {count}{places} of {length:.1e} in all, the widest from r = {from} to {to}."
                )
            }
            _ => "Checked, not proven: between the points an error may be larger.".to_owned(),
        }
    }
}
