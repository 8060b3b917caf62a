//! Results of a proof so far, and the budget of its work.

use crate::compare::ComparedLimit;
use frictiongen_model::table::Worst;
use frictiongen_model::table::{Evidence, Proof, ProofWork};

/// Largest permitted work of a proof, and the work spent so far, both in evaluations of one mode.
pub(crate) struct Budget {
    most: usize,
    pub spent: usize,
}

/// Estimated work of one evaluation of `ChainStage` over an interval of r, for each mode. The estimate serves only to
/// limit the work of a proof.
pub(crate) const OF_STAGE: usize = 20;

impl Budget {
    pub fn of(work: usize) -> Self {
        Self {
            most: work,
            spent: 0,
        }
    }
    pub fn spend(&mut self, work: usize) {
        self.spent += work;
    }
    pub fn is_spent(&self) -> bool {
        self.most <= self.spent
    }
}

/// Results of a proof so far for one function of a table: its largest error, and the intervals of r that are not
/// proven (open).
pub(crate) struct FunctionProof {
    bound: Worst,
    pub open: Vec<(f64, f64)>,
    looked: bool,
}

impl FunctionProof {
    pub fn nothing(at: f64) -> Self {
        Self {
            bound: Worst { error: 0.0, at },
            open: Vec::new(),
            looked: false,
        }
    }

    pub fn seen(&mut self, worst: Worst) {
        self.looked = true;
        if worst.error > self.bound.error {
            self.bound = worst;
        }
    }

    /// Adds the results for the next piece of the table.
    pub fn and(&mut self, next: Self) {
        if next.looked {
            self.seen(next.bound);
        }
        self.open.extend(next.open);
    }

    /// Returns the results as the proof of one function, with the work that it took. Neighbouring intervals that are
    /// not proven become one.
    pub fn finished(mut self, work: usize) -> Proof {
        self.open.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut open: Vec<(f64, f64)> = Vec::new();
        for (from, to) in self.open {
            match open.last_mut() {
                Some(last) if from <= last.1 => last.1 = last.1.max(to),
                _ => open.push((from, to)),
            }
        }
        let evidence = match (self.looked, open.is_empty()) {
            (false, _) => Evidence::Checked,
            (true, true) => Evidence::Proven,
            (true, false) => Evidence::Partly,
        };
        Proof {
            evidence,
            bound: self.bound,
            open,
            work: ProofWork(work),
        }
    }
}

/// Results of the proof of a table's piece: for β_lim, for amplitude and phase, and the work.
pub(crate) struct PieceProof {
    pub limit: FunctionProof,
    pub motion: FunctionProof,
    pub work: usize,
}

impl PieceProof {
    pub fn nothing(at: f64) -> Self {
        Self {
            limit: FunctionProof::nothing(at),
            motion: FunctionProof::nothing(at),
            work: 0,
        }
    }

    /// Records an interval of r as not proven, both for β_lim and for amplitude and phase.
    pub fn leave(&mut self, part: (f64, f64)) {
        self.limit.open.push(part);
        self.motion.open.push(part);
    }

    /// Adds the results of the proof of the next piece.
    pub fn and(&mut self, next: Self) {
        self.limit.and(next.limit);
        self.motion.and(next.motion);
        self.work += next.work;
    }
}

/// Bounds on the errors of the tables over an interval of r. `limit` has the error of β_lim. `motion` has the error of
/// amplitude and phase, or `None` without a proof of amplitude and phase.
pub(crate) struct IntervalProof {
    pub limit: ComparedLimit,
    pub motion: Option<Worst>,
}
