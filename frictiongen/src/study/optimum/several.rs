//! The best friction for several quantities: one quantity under bounds on others, or the largest quotient of several
//! quantities and their divisors.

use super::answer::{Optimum, OptimumEnd, OptimumKind};
use super::band::{KeepGoing, Look};
use super::evaluator::{Goal, Quotient};
use super::problem::{Found, OptimumProblem};
use super::request::{OptimumError, OptimumRequest};
use super::search::Least;
use crate::Of;
use crate::study::response::MotionQuantity;
use crate::study::system::System;

/// Bound on the work of a search with several quantities, each of which counts, in units of about 10 µs.
const WORK: usize = 4 * super::WORK;

/// Largest relative difference at which two quotients count as equal.
const BALANCE: f64 = 1e-3;
/// A bound counts as reached if the quantity, divided by its bound, is at least this number.
pub(super) const DECISIVE: f64 = 1.0 - 1e-6;
/// The search aims at bounds that are smaller by this fraction. Rounding and a finer grid then do not lift a quantity above
/// its bound.
const BELOW: f64 = 5e-7;

/// A quantity whose largest value over the band must not exceed a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeptQuantity {
    /// The motion whose quantity has a bound.
    pub of: Of,
    /// The quantity of the motion: displacement, velocity, acceleration, or a quantity of the contact.
    pub size: MotionQuantity,
    /// The bound, in the same unit as [`Optimum::amplitude`] has for this quantity.
    pub most: f64,
}

/// The best friction among those that satisfy all bounds.
#[derive(Clone, Debug)]
pub struct KeptOptimum {
    /// The best friction that satisfies all bounds, with its peaks.
    pub optimum: Optimum,
    /// The largest value over the band of each quantity with a bound, at this friction, in the order of the bounds.
    pub largest: Vec<f64>,
}

/// A quantity, and the value by which the search divides it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighted {
    /// The motion to which the quantity belongs.
    pub of: Of,
    /// The quantity of the motion, such as displacement or acceleration.
    pub size: MotionQuantity,
    /// The value that divides the quantity, above 0. It has the unit of [`Optimum::amplitude`] for this quantity.
    pub over: f64,
}

/// The best friction for several quantities.
#[derive(Clone, Debug)]
pub struct WeightedOptimum {
    /// The best friction, with the peaks of the quantity whose quotient is the largest.
    pub optimum: Optimum,
    /// Index in the request of the quantity whose quotient is the largest.
    pub decisive: usize,
    /// The largest quotient with this friction. A quotient is a quantity divided by its given value.
    pub ratio: f64,
    /// The largest value over the band of each quantity (not divided) with this friction, in the order of the request.
    pub largest: Vec<f64>,
}

impl KeptQuantity {
    /// Returns the request that minimises this quantity instead of the quantity of `request`.
    pub(super) fn request(&self, request: &OptimumRequest) -> OptimumRequest {
        OptimumRequest {
            of: self.of,
            size: self.size,
            ..request.clone()
        }
    }
}

impl System {
    /// Finds the best friction for the quantity of `request`, among the frictions that satisfy all bounds in `kept`
    /// over the whole band.
    ///
    /// The search calls `watch` after each evaluation. If `watch` returns false once, it must return false from then
    /// on.
    ///
    /// # Errors
    /// Same errors as [`optimum`](System::optimum), [`OptimumError::Unreachable`] if no friction satisfies all bounds,
    /// and [`OptimumError::Stopped`] if `watch` returned false.
    pub fn kept_optimum(
        &self,
        request: &OptimumRequest,
        kept: &[KeptQuantity],
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<KeptOptimum, OptimumError> {
        let problem = KeptProblem::new(self, request, kept, watch)?;
        problem.told(problem.found(WORK, None)?)
    }

    /// Returns the best friction for several quantities. With the best friction, the largest quotient of a quantity and
    /// its value in `weighted` is smallest over the band. The call takes the band and the load from `request`, and
    /// ignores the quantity in `request`.
    ///
    /// The search calls `watch` after each evaluation. If `watch` returns false once, it must return false from then
    /// on.
    ///
    /// # Errors
    /// Same errors as [`optimum`](System::optimum). [`OptimumError::Weight`] for an empty list and for a value that is
    /// 0, negative, infinite or NaN, and [`OptimumError::Stopped`] if `watch` returned false.
    pub fn weighted_optimum(
        &self,
        request: &OptimumRequest,
        weighted: &[Weighted],
        watch: &(dyn Fn() -> bool + Sync),
    ) -> Result<WeightedOptimum, OptimumError> {
        let valid = |weighted: &Weighted| 0.0 < weighted.over && weighted.over.is_finite();
        if weighted.is_empty() || !weighted.iter().all(valid) {
            return Err(OptimumError::Weight);
        }
        let problems = weighted.iter().map(|one| {
            let (of, size) = (one.of, one.size);
            let request = OptimumRequest {
                of,
                size,
                ..request.clone()
            };
            Ok(OptimumProblem::new(self, &request)?.watched_by(watch))
        });
        let problems = problems.collect::<Result<Vec<_>, OptimumError>>()?;
        let quotients = problems.iter().zip(weighted);
        let goal = Goal {
            minimised: quotients
                .map(|(problem, one)| (problem.objective, one.over))
                .collect(),
            bounded: Vec::new(),
        };
        let first = problems.first().ok_or(OptimumError::Weight)?;
        let found = first.found(goal, WORK, None)?;
        if !watch() {
            return Err(OptimumError::Stopped);
        }
        let looks: Vec<Look> = problems
            .iter()
            .map(|one| one.whole(found.least.at.beta))
            .collect();
        let ratios = looks.iter().zip(weighted);
        let ratios: Vec<f64> = ratios
            .map(|(look, one)| look.merit.value / one.over)
            .collect();
        let largest = looks.iter().map(|look| look.merit.value).collect();
        let order = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let decisive = ratios.iter().enumerate().max_by(order);
        let (decisive, ratio) = decisive.map_or((0, f64::NAN), |(index, ratio)| (index, *ratio));
        let equal = ratios
            .iter()
            .filter(|other| ratio * (1.0 - BALANCE) <= **other);
        let is_balanced = 1 < equal.count();
        let (Some(problem), Some(at)) = (problems.get(decisive), looks.into_iter().nth(decisive))
        else {
            return Err(OptimumError::Weight);
        };
        let band = problem.band(Goal::one(problem.objective));
        band.asked.set(found.band.asked.get());
        let least = Least { at, ..found.least };
        // Tolerances and sensitivities describe the minimum of a single quantity.
        let told = problem.told(
            Found {
                band,
                least,
                ..found
            },
            !is_balanced,
        )?;
        let optimum = Optimum {
            kind: if is_balanced {
                OptimumKind::Balanced
            } else {
                told.kind
            },
            tolerances: Vec::new(),
            sensitivities: Vec::new(),
            ..told
        };
        Ok(WeightedOptimum {
            optimum,
            decisive,
            ratio,
            largest,
        })
    }
}

/// A checked request for the best friction under bounds.
pub(super) struct KeptProblem<'s> {
    pub own: OptimumProblem<'s>,
    kept: Vec<(OptimumProblem<'s>, f64)>,
}

/// The best friction under bounds.
pub(super) struct KeptFound<'s> {
    pub found: Found<'s>,
    /// True if a bound excluded a better friction.
    is_bounded: bool,
    largest: Vec<f64>,
}

impl<'s> KeptFound<'s> {
    /// Returns true if this friction is better than another one.
    pub fn is_better_than(&self, other: &Self) -> bool {
        self.found.least.at.merit < other.found.least.at.merit
    }

    /// Returns this friction with the scan and the number of evaluations of another search.
    pub fn with_scan_of(mut self, other: Self) -> Self {
        let asked = other.found.band.asked.get();
        self.found
            .band
            .asked
            .set(self.found.band.asked.get() + asked);
        self.found.least.scan = other.found.least.scan;
        self
    }
}

impl<'s> KeptProblem<'s> {
    pub fn new(
        system: &'s System,
        request: &OptimumRequest,
        kept: &[KeptQuantity],
        watch: KeepGoing<'s>,
    ) -> Result<Self, OptimumError> {
        let own = OptimumProblem::new(system, request)?.watched_by(watch);
        let kept = kept.iter().map(|kept| {
            let problem = OptimumProblem::new(system, &kept.request(request))?;
            Ok((problem.watched_by(watch), kept.most))
        });
        let kept = kept.collect::<Result<Vec<_>, OptimumError>>()?;
        Ok(Self { own, kept })
    }

    /// Finds the best friction that satisfies all bounds. `work` is the bound on the work of one search over all
    /// frictions.
    pub fn found(
        &self,
        work: usize,
        window: Option<[f64; 2]>,
    ) -> Result<KeptFound<'s>, OptimumError> {
        let free = self
            .own
            .found(Goal::one(self.own.objective), work, window)?;
        if self.kept.is_empty() {
            let (is_bounded, largest) = (false, Vec::new());
            return Ok(KeptFound {
                found: free,
                is_bounded,
                largest,
            });
        }
        self.go_on()?;
        let largest = self.largest(free.least.at.beta);
        if self.holds(&largest) {
            return Ok(KeptFound {
                found: free,
                is_bounded: false,
                largest,
            });
        }
        let found = match self.within(&self.own, self.kept.len(), work) {
            Ok(found) => found,
            Err(OptimumError::Unbounded) => return Err(self.unreachable(work)),
            Err(error) => return Err(error),
        };
        self.go_on()?;
        let largest = self.largest(found.least.at.beta);
        if !self.holds(&largest) {
            let error = self.unreachable(work);
            self.go_on()?;
            return Err(error);
        }
        Ok(KeptFound {
            found,
            is_bounded: true,
            largest,
        })
    }

    /// Minimises a quantity under the first bounds of the list.
    fn within(
        &self,
        problem: &OptimumProblem<'s>,
        bounds: usize,
        work: usize,
    ) -> Result<Found<'s>, OptimumError> {
        let bounded = self.kept.iter().take(bounds);
        let bounded = bounded
            .map(|(problem, most)| -> Quotient { (problem.objective, *most * (1.0 - BELOW)) });
        let goal = Goal {
            minimised: vec![(problem.objective, 1.0)],
            bounded: bounded.collect(),
        };
        problem.found(goal, work, None)
    }

    /// Returns the error that names the first bound that no friction satisfies together with the bounds before it.
    fn unreachable(&self, work: usize) -> OptimumError {
        for (index, (problem, most)) in self.kept.iter().enumerate() {
            let found = match self.within(problem, index, work) {
                Ok(found) => found,
                Err(error) => return error,
            };
            let least = problem.whole(found.least.at.beta).merit.value;
            if !(least <= *most) {
                return OptimumError::Unreachable {
                    index,
                    least,
                    beta: found.least.at.beta,
                    value: None,
                };
            }
        }
        OptimumError::TooLong
    }

    /// Returns the largest value over the band of each quantity with a bound.
    fn largest(&self, beta: f64) -> Vec<f64> {
        let kept = self.kept.iter();
        kept.map(|(problem, _)| problem.whole(beta).merit.value)
            .collect()
    }

    fn holds(&self, largest: &[f64]) -> bool {
        let mut checked = largest.iter().zip(&self.kept);
        checked.all(|(largest, (_, most))| largest <= most)
    }

    /// Returns an error if the caller has stopped the search.
    fn go_on(&self) -> Result<(), OptimumError> {
        match self.own.watch.is_none_or(|watch| watch()) {
            true => Ok(()),
            false => Err(OptimumError::Stopped),
        }
    }

    /// Returns the complete result for the best friction under bounds.
    pub fn told(&self, found: KeptFound<'s>) -> Result<KeptOptimum, OptimumError> {
        let KeptFound {
            found,
            is_bounded,
            largest,
        } = found;
        let reached = largest.iter().zip(&self.kept);
        let reached = reached.filter(|(largest, (_, most))| DECISIVE * most <= **largest);
        let is_bounded = is_bounded && 0 < reached.count();
        let mut optimum = self.own.told(found, !is_bounded)?;
        if is_bounded {
            optimum.kind = OptimumKind::Bounded;
            optimum.bracket = [optimum.beta; 2];
            if optimum.end == OptimumEnd::Jump {
                optimum.end = OptimumEnd::Converged;
            }
        }
        Ok(KeptOptimum { optimum, largest })
    }
}
