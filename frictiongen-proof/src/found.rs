//! Results of a proof so far, and its remaining work.

use crate::compare::ComparedLimit;
use frictiongen_model::table::Worst;
use frictiongen_model::table::{Evidence, Proof, Work};

/// Remaining work, in evaluations of one mode.
pub(crate) struct Budget {
    most: usize,
    pub spent: usize,
}

/// Work of a stage over an interval, in evaluations of each mode. It is an estimate and only counts work.
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

/// Results for one function so far.
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

    /// Adds the results of the next piece.
    pub fn and(&mut self, next: Self) {
        if next.looked {
            self.seen(next.bound);
        }
        self.open.extend(next.open);
    }

    /// Returns the finished proof.
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
            work: Work(work),
        }
    }
}

/// Results for a piece: for β_lim, for the motion, and the work.
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

    /// Leaves an interval open, for β_lim and for the motion.
    pub fn leave(&mut self, part: (f64, f64)) {
        self.limit.open.push(part);
        self.motion.open.push(part);
    }

    /// Adds the results of the next piece.
    pub fn and(&mut self, next: Self) {
        self.limit.and(next.limit);
        self.motion.and(next.motion);
        self.work += next.work;
    }
}

/// Proven results over an interval: for β_lim, and for the motion if it is proven.
pub(crate) struct IntervalProof {
    pub limit: ComparedLimit,
    pub motion: Option<Worst>,
}
