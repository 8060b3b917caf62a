//! Finds the best friction among those that keep other quantities within bounds.
//!
//! The scan over friction shows which friction ratios satisfy all bounds. Between a friction ratio that satisfies all
//! bounds and a friction ratio that violates a bound, bisection finds the limit. The result satisfies every bound over
//! the whole band.

use super::amplitude::KeepGoing;
use super::answer::{Optimum, OptimumEnd, OptimumKind};
use super::minima::narrowed;
use super::peaks::AmplitudeBand;
use super::problem::OptimumProblem;
use super::request::{OptimumError, OptimumRequest};
use super::scan::{Scanned, scanned_at};
use super::search::Least;
use super::whole::{OF_ALL_CHECKS, whole};
use crate::Of;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use std::cell::Cell;

/// Largest number of bisections between a friction ratio that satisfies all bounds and one that does not.
const HALVINGS: usize = 36;
/// Relative width of an interval of friction at which the bisection of this interval ends.
const NARROW: f64 = 1e-9;
/// Largest number of friction ratios whose bounds the search checks over the whole band. If a check finds a violated
/// bound, the search continues.
const CHECKS: usize = 12;
/// The search examines a scan point only if its amplitude, divided by the smallest amplitude of all scan points that
/// satisfy the bounds, is at most this number.
const NEARLY: f64 = 1.5;
/// Largest number of points of the scan over friction that the search examines.
const MOST_POINTS: usize = 6;

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

/// The best friction among those that satisfy all bounds.
#[derive(Clone, Debug)]
pub struct KeptOptimum {
    /// The best friction that satisfies all bounds, with its peaks.
    pub optimum: Optimum,
    /// The largest value over the band of each quantity with a bound, at this friction, in the order of the bounds.
    pub largest: Vec<f64>,
}

impl System {
    /// Finds the best friction for the quantity of `request`, among the frictions that satisfy all bounds in `kept`
    /// over the whole band. With the best friction, the largest value of the quantity over the band is smallest.
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
        let found = problem.found(super::WORK)?;
        let optimum = problem.told(&found)?;
        let largest = found.largest;
        Ok(KeptOptimum { optimum, largest })
    }
}

/// A checked request for the best friction under bounds.
pub(super) struct KeptProblem<'s> {
    own: OptimumProblem<'s>,
    others: Vec<OptimumProblem<'s>>,
    most: Vec<f64>,
    watch: KeepGoing<'s>,
}

/// The best friction under bounds, and its frequency band.
pub(super) struct Kept<'s> {
    pub least: Least,
    band: AmplitudeBand<'s>,
    /// True if a bound excluded a better friction.
    bounded: bool,
    /// The largest value over the band of each quantity with a bound, in the order of the bounds.
    pub largest: Vec<f64>,
    /// Number of amplitudes that the search has computed.
    pub asked: usize,
}

impl<'s> KeptProblem<'s> {
    pub(super) fn new(
        system: &'s System,
        request: &OptimumRequest,
        kept: &[KeptQuantity],
        watch: KeepGoing<'s>,
    ) -> Result<Self, OptimumError> {
        let own = OptimumProblem::new(system, request)?.watched_by(Some(watch));
        let others = kept.iter().map(|kept| {
            let problem = OptimumProblem::new(system, &kept.request(request))?;
            Ok(problem.watched_by(Some(watch)))
        });
        let others = others.collect::<Result<Vec<_>, OptimumError>>()?;
        let most = kept.iter().map(|kept| kept.most).collect();
        Ok(Self {
            own,
            others,
            most,
            watch,
        })
    }

    /// Finds the best friction that satisfies all bounds. `work` is the bound on the work of one search over all
    /// frictions. All checks of the whole band together may take twice this work.
    pub(super) fn found(&self, work: usize) -> Result<Kept<'s>, OptimumError> {
        let (left, asked) = (Cell::new(OF_ALL_CHECKS * work), Cell::new(0));
        let search = KeptSearch {
            band: self.own.band(),
            others: self.others.iter().map(OptimumProblem::band).collect(),
            most: self.most.clone(),
            watch: self.watch,
            work,
            left: &left,
            asked: &asked,
        };
        let least = OptimumProblem::least(&search.band, work)?;
        search.go_on()?;
        let (at, bounded) = search.best(&self.others, &least)?;
        left.set(OF_ALL_CHECKS * work);
        let largest = search.largest(at.beta);
        let largest = largest.iter().map(|scanned| scanned.value).collect();
        search.go_on()?;
        search.count();
        let least = if bounded {
            Least {
                bracket: [at.beta; 2],
                at,
                ..least
            }
        } else {
            least
        };
        Ok(Kept {
            least,
            band: search.band,
            bounded,
            largest,
            asked: asked.get(),
        })
    }

    /// Returns the complete result for the best friction under bounds, with peaks and limits.
    pub(super) fn told(&self, found: &Kept<'_>) -> Result<Optimum, OptimumError> {
        let optimum = self.own.told(&found.band, &found.least)?;
        Ok(if found.bounded {
            bounded(optimum)
        } else {
            optimum
        })
    }
}

/// Returns the result for a friction ratio that a bound determines, and that is not a minimum.
pub(super) fn bounded(optimum: Optimum) -> Optimum {
    Optimum {
        kind: OptimumKind::Bounded,
        end: OptimumEnd::Converged,
        beyond_jump: None,
        // Tolerances and sensitivities describe a minimum. If a bound determines the friction ratio, this friction
        // ratio is not a minimum.
        tolerances: Vec::new(),
        sensitivities: Vec::new(),
        ..optimum
    }
}

/// A search for the best friction under bounds. It has one frequency band for each quantity.
struct KeptSearch<'s, 'k> {
    band: AmplitudeBand<'s>,
    others: Vec<AmplitudeBand<'s>>,
    most: Vec<f64>,
    watch: KeepGoing<'s>,
    /// Bound on the work of one search over all frictions, in units of about 10 µs.
    work: usize,
    /// Work that remains for the checks of the whole band, in units of about 10 µs.
    left: &'k Cell<usize>,
    /// Number of amplitudes that finished searches have computed.
    asked: &'k Cell<usize>,
}

impl<'s> KeptSearch<'s, '_> {
    /// Adds the amplitudes that this search has computed to those of finished searches.
    fn count(&self) {
        let bands = [&self.band].into_iter().chain(&self.others);
        let asked: usize = bands.map(|band| band.amplitude.asked.get()).sum();
        self.asked.set(self.asked.get() + asked);
    }

    /// Returns an error if the caller has stopped the search.
    fn go_on(&self) -> Result<(), OptimumError> {
        if (self.watch)() {
            Ok(())
        } else {
            Err(OptimumError::Stopped)
        }
    }

    /// Returns the best friction that satisfies all bounds, and a flag. The flag is true if a bound excluded a better
    /// friction.
    fn best(
        &self,
        others: &[OptimumProblem<'s>],
        least: &Least,
    ) -> Result<(Scanned, bool), OptimumError> {
        if self.holds(least.at.beta) {
            return Ok((least.at.clone(), false));
        }
        let mut points: Vec<f64> = least.scan.iter().map(|point| point.beta).collect();
        points.push(least.at.beta);
        if !points.iter().any(|beta| self.seems_to_hold(*beta)) {
            points.extend(self.reachable(others)?);
        }
        points.sort_by(f64::total_cmp);
        points.dedup();
        let mut known: Vec<(f64, bool)> = points
            .iter()
            .map(|beta| (*beta, self.seems_to_hold(*beta)))
            .collect();
        self.band.amplitude.allow(self.work);
        for _ in 0..CHECKS {
            self.go_on()?;
            let Some(found) = self.refined(&known) else {
                break;
            };
            if self.holds(found.beta) {
                return Ok((whole(&self.band, found.beta, self.left), true));
            }
            // The check of the whole band may have found a new peak, which later evaluations include. A friction ratio
            // that satisfied the bounds before may now violate a bound.
            for (beta, holds) in &mut known {
                *holds = *holds && self.seems_to_hold(*beta);
            }
            let beta = found.beta;
            known.retain(|(other, _)| *other != beta);
            known.push((beta, false));
            known.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        self.go_on()?;
        let fallback = self.reachable(others)?;
        let holds = fallback.filter(|beta| self.holds(*beta));
        let beta = holds.ok_or(OptimumError::TooLong)?;
        Ok((whole(&self.band, beta, self.left), true))
    }

    /// Returns the best friction ratio near the known friction ratios. Each has a flag, which is true if the friction
    /// ratio satisfies all bounds.
    fn refined(&self, known: &[(f64, bool)]) -> Option<Scanned> {
        let value = |beta: f64| scanned_at(&self.band, beta, f64::INFINITY);
        let mut all: Vec<(usize, Scanned)> = known
            .iter()
            .enumerate()
            .filter(|(_, (_, holds))| *holds)
            .map(|(place, (beta, _))| (place, value(*beta)))
            .collect();
        all.sort_by(|a, b| a.1.value.total_cmp(&b.1.value));
        let top = all.first()?.1.value;
        let mut best: Option<Scanned> = None;
        let mut note = |found: Scanned| {
            if best.as_ref().is_none_or(|best| found.value < best.value) {
                best = Some(found);
            }
        };
        for (place, here) in all
            .into_iter()
            .filter(|(_, here)| here.value <= NEARLY * top)
            .take(MOST_POINTS)
        {
            let sides = [place.checked_sub(1), Some(place + 1)];
            let ends = sides.map(|side| {
                let (beta, holds) = side.and_then(|side| known.get(side)).copied()?;
                let end = if holds {
                    beta
                } else {
                    self.edge(here.beta, beta)
                };
                Some(value(end))
            });
            for end in ends.iter().flatten() {
                if self.seems_to_hold(end.beta) {
                    note(end.clone());
                }
            }
            let [below, above] = ends.map(|end| end.unwrap_or_else(|| here.clone()));
            if below.beta < above.beta {
                let found = narrowed(&self.band, (&below, &above), Some(here.clone())).at;
                if self.seems_to_hold(found.beta) {
                    note(found);
                }
            }
            note(here);
        }
        best
    }

    /// Returns a friction ratio that satisfies all bounds and lies next to a friction ratio that violates a bound.
    /// `holds` is a friction ratio that satisfies all bounds, and `violates` is a friction ratio that violates a bound.
    fn edge(&self, mut holds: f64, mut violates: f64) -> f64 {
        for _ in 0..HALVINGS {
            if (holds - violates).abs() <= NARROW * holds.max(violates) {
                break;
            }
            let middle = 0.5 * (holds + violates);
            if self.seems_to_hold(middle) {
                holds = middle;
            } else {
                violates = middle;
            }
        }
        holds
    }

    /// Returns a friction ratio that satisfies all bounds. The search calls this function if no point of the scan over
    /// friction satisfies all bounds.
    ///
    /// # Errors
    /// [`OptimumError::Unreachable`] names the first bound that cannot be satisfied together with all earlier bounds in
    /// the list.
    fn reachable(&self, others: &[OptimumProblem<'s>]) -> Result<Option<f64>, OptimumError> {
        let mut found = None;
        for (index, problem) in others.iter().enumerate() {
            let before = others.get(..index).unwrap_or_default();
            let search = KeptSearch {
                band: problem.band(),
                others: before.iter().map(OptimumProblem::band).collect(),
                most: self.most.iter().take(index).copied().collect(),
                watch: self.watch,
                work: self.work,
                left: self.left,
                asked: self.asked,
            };
            let least = OptimumProblem::least(&search.band, self.work)?;
            let (at, _) = search.best(before, &least)?;
            let value = whole(&search.band, at.beta, self.left).value;
            self.go_on()?;
            search.count();
            let most = self.most.get(index).copied().unwrap_or(f64::INFINITY);
            if !(value <= most) {
                return Err(OptimumError::Unreachable {
                    index,
                    least: value,
                    beta: at.beta,
                    value: None,
                });
            }
            found = Some(at.beta);
        }
        // The friction ratio of the last iteration satisfies all bounds.
        Ok(found)
    }

    /// Returns true if all quantities satisfy their bounds at the frequencies of a first, incomplete evaluation of the
    /// band.
    fn seems_to_hold(&self, beta: f64) -> bool {
        self.others.iter().zip(&self.most).all(|(band, most)| {
            let found = scanned_at(band, beta, *most);
            found.complete && found.value <= *most
        })
    }

    /// Returns true if all quantities satisfy their bounds over the whole band.
    fn holds(&self, beta: f64) -> bool {
        let largest = self.largest(beta);
        let mut checked = largest.iter().zip(&self.most);
        checked.all(|(found, most)| found.complete && found.value <= *most)
    }

    /// Returns the largest value over the band of each quantity with a bound.
    fn largest(&self, beta: f64) -> Vec<Scanned> {
        let bands = self.others.iter();
        bands.map(|band| whole(band, beta, self.left)).collect()
    }
}
