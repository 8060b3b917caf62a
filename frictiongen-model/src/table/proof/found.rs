//! What a proof has found so far, and the work that it may still take.

use super::super::worst::Worst;
use super::compare::Compared;
use super::evidence::{Evidence, Proof, Work};

/// Work that may still be done, in evaluations of one mode.
pub(super) struct Budget {
    most: usize,
    pub spent: usize,
}

/// A stage over an interval counts as so many evaluations of each mode.
pub(super) const OF_STAGE: usize = 20;

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

/// What was found of a function so far.
pub(super) struct Found {
    bound: Worst,
    pub open: Vec<(f64, f64)>,
    looked: bool,
}

impl Found {
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

    /// With what was found of the next piece.
    pub fn and(&mut self, next: Self) {
        if next.looked {
            self.seen(next.bound);
        }
        self.open.extend(next.open);
    }

    /// What was proven.
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

/// What was found of a piece: of β_lim and of the motion, and the work that it took.
pub(super) struct Piece {
    pub limit: Found,
    pub motion: Found,
    pub work: usize,
}

impl Piece {
    pub fn nothing(at: f64) -> Self {
        Self {
            limit: Found::nothing(at),
            motion: Found::nothing(at),
            work: 0,
        }
    }

    /// Not shown, neither of β_lim nor of the motion.
    pub fn leave(&mut self, part: (f64, f64)) {
        self.limit.open.push(part);
        self.motion.open.push(part);
    }

    /// With what was found of the next one.
    pub fn and(&mut self, next: Self) {
        self.limit.and(next.limit);
        self.motion.and(next.motion);
        self.work += next.work;
    }
}

/// What is proven of a part: of β_lim, and of the motion if it is.
pub(super) struct Part {
    pub limit: Compared,
    pub motion: Option<Worst>,
}
