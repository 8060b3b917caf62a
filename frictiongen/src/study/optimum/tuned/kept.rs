//! Finds the best value of one number of the scene description together with the best friction that keeps other
//! quantities within bounds.
//!
//! The best amplitude at a value of the number is the smallest amplitude within the bounds. The best amplitude is
//! infinite if no friction satisfies all bounds. As a function of the value, the best amplitude has corners, because
//! the decisive bound and the decisive peak change. The search therefore uses no derivatives.

use super::answer::{TunedOptimum, TunedPoint};
use super::search::on_all_cores;
use super::tried::{GroupRatios, TunedSearch};
use crate::study::optimum::amplitude::KeepGoing;
use crate::study::optimum::kept::{KeptProblem, KeptQuantity, bounded};
use crate::study::optimum::search::WORK_OF_ONE;
use crate::study::optimum::{Optimum, OptimumEnd, OptimumError, WORK, line};
use crate::study::system::System;
use std::sync::atomic::Ordering;

/// The search narrows the interval around a scanned value only if its amplitude, divided by the smallest amplitude of
/// all scanned values, is at most this number.
const WORTH: f64 = 1.5;
/// Largest number of scanned values around which the search narrows the interval.
const MOST_LOOKED_INTO: usize = 3;
/// Relative accuracy of the best value of the number.
const NEAR: f64 = 1e-7;
/// Distance from a bound of the interval at which the search tests if the amplitude falls, divided by the distance to
/// the next scanned value.
const INWARD: f64 = 1e-3;
/// A bound counts as reached if the quantity, divided by its bound, is at least this number. The bound then determines
/// the best friction.
const DECISIVE: f64 = 1.0 - 1e-6;

/// A search for the best value of a number together with the best friction within bounds.
pub(super) struct KeptTunedSearch<'s> {
    tuned: &'s TunedSearch<'s>,
    kept: &'s [KeptQuantity],
    watch: KeepGoing<'s>,
}

/// The best friction within the bounds at one value of the number. Its groups β and x̄ refer to m₁ and k₁ of the
/// original scene.
#[derive(Clone, Copy, Debug)]
struct Trial {
    value: f64,
    /// The largest amplitude over the band. It is infinite if no friction satisfies all bounds, and NaN if the search
    /// ended before it found any friction.
    amplitude: f64,
    beta: f64,
}

/// A scanned value of the number, and the two values between which the search looks for a minimum.
struct Valley {
    start: Trial,
    ends: [f64; 2],
}

impl<'s> KeptTunedSearch<'s> {
    pub(super) fn new(
        tuned: &'s TunedSearch<'s>,
        kept: &'s [KeptQuantity],
        watch: KeepGoing<'s>,
    ) -> Self {
        Self { tuned, kept, watch }
    }

    pub(super) fn solved(&self) -> Result<(TunedOptimum, Vec<f64>), OptimumError> {
        let (best, scan) = self.best()?;
        let scan = scan.iter().map(|trial| TunedPoint {
            value: trial.value,
            beta: trial.beta,
            amplitude: trial.amplitude,
        });
        let scan = scan.collect();
        let varied = self.tuned.with(best.value)?;
        let (optimum, largest) = self.told(&varied)?;
        let tuning = self.tuned.tuning;
        let tuned = TunedOptimum {
            value: best.value,
            at_end: [tuning.from, tuning.to].contains(&best.value),
            optimum,
            scan,
            evaluations: self.tuned.asked.load(Ordering::Relaxed),
            system: varied,
        };
        Ok((tuned, largest))
    }

    /// Returns the complete result for the best friction of the scene with the best value of the number, and the
    /// largest values of the quantities with bounds.
    fn told(&self, varied: &System) -> Result<(Optimum, Vec<f64>), OptimumError> {
        // The search with more work fails if the caller has stopped the search. The code then repeats the shorter
        // search of the scan, without the caller's function. The shorter search found this friction before.
        let unwatched: KeepGoing<'_> = &|| true;
        let problem = self.problem(varied, self.watch)?;
        let found = match problem.found(WORK) {
            Ok(found) => found,
            Err(_) => self.problem(varied, unwatched)?.found(WORK_OF_ONE)?,
        };
        let optimum = problem.told(&found)?;
        self.tuned.count(found.asked);
        let factors = self.factors(varied);
        let largest = found.largest.iter().zip(factors);
        let largest: Vec<f64> = largest.map(|(largest, factor)| largest * factor).collect();
        let decides = |(largest, kept): (&f64, &KeptQuantity)| DECISIVE * kept.most <= *largest;
        let mut optimum = if largest.iter().zip(self.kept).any(decides) {
            bounded(optimum)
        } else {
            optimum
        };
        if !self.tuned.goes_on() {
            optimum.end = OptimumEnd::Stopped;
        }
        let groups = GroupRatios::new(self.tuned.request, self.tuned.described, varied);
        Ok((groups.of(optimum), largest))
    }

    /// Returns one factor for each quantity with a bound. The factor converts the quantity from the groups of the
    /// varied scene, with its m₁ and k₁, to the groups of the original scene.
    fn factors(&self, varied: &System) -> Vec<f64> {
        let (request, described) = (self.tuned.request, self.tuned.described);
        let factor = |kept: &KeptQuantity| {
            GroupRatios::new(&kept.request(request), described, varied).length
        };
        self.kept.iter().map(factor).collect()
    }

    /// Returns the checked request for the best friction within the bounds, for the scene with another value of the
    /// number.
    fn problem<'v>(
        &self,
        varied: &'v System,
        watch: KeepGoing<'v>,
    ) -> Result<KeptProblem<'v>, OptimumError> {
        let kept = self.kept.iter().zip(self.factors(varied));
        let kept: Vec<KeptQuantity> = kept
            .map(|(kept, factor)| KeptQuantity {
                most: kept.most / factor,
                ..*kept
            })
            .collect();
        KeptProblem::new(varied, &self.tuned.request_for(varied), &kept, watch)
    }

    /// Returns the best friction within the bounds at one value of the number.
    fn trial(&self, value: f64) -> Result<Trial, OptimumError> {
        let none = |amplitude: f64| Trial {
            value,
            amplitude,
            beta: f64::NAN,
        };
        let varied = self.tuned.with(value)?;
        let found = self
            .problem(&varied, self.watch)
            .and_then(|problem| problem.found(WORK_OF_ONE));
        let found = match found {
            Err(
                OptimumError::Undamped(_)
                | OptimumError::Unbounded
                | OptimumError::Unreachable { .. },
            ) => return Ok(none(f64::INFINITY)),
            Err(OptimumError::TooLong | OptimumError::Stopped) => return Ok(none(f64::NAN)),
            found => found?,
        };
        self.tuned.count(found.asked);
        let groups = GroupRatios::new(self.tuned.request, self.tuned.described, &varied);
        Ok(Trial {
            value,
            amplitude: found.least.at.value * groups.length,
            beta: found.least.at.beta * groups.beta,
        })
    }

    /// Returns the best value of the number with its best friction, and the results at all scanned values.
    fn best(&self) -> Result<(Trial, Vec<Trial>), OptimumError> {
        let mut scan = Vec::new();
        let mut wrong = None;
        for trial in on_all_cores(self.tuned.values(), |value| self.trial(value)) {
            match trial {
                Ok(trial) => scan.push(trial),
                Err(error) => wrong = wrong.or(Some(error)),
            }
        }
        let scanned = scan.clone();
        if !scan.iter().any(Trial::is_valid) {
            if let Some(error) = wrong {
                return Err(error);
            }
            scan.push(self.reachable(&scan)?);
            scan.sort_by(|a, b| a.value.total_cmp(&b.value));
        }
        let least = |trials: Vec<Trial>| {
            let valid = trials.into_iter().filter(Trial::is_valid);
            valid.min_by(|a, b| a.amplitude.total_cmp(&b.amplitude))
        };
        let best = least(scan.clone()).ok_or_else(|| self.none())?;
        if best.amplitude == 0.0 {
            return Ok((best, scanned));
        }
        let valleys = self.valleys(&scan, WORTH * best.amplitude);
        let mut found = on_all_cores(valleys, |valley| self.narrowed(&valley));
        found.push(best);
        let best = least(found).unwrap_or(best);
        Ok((best, scanned))
    }

    /// Returns the error for a search in which no value of the number has a result.
    fn none(&self) -> OptimumError {
        if self.tuned.goes_on() {
            OptimumError::TooLong
        } else {
            OptimumError::Stopped
        }
    }

    /// Returns a value of the number at which some friction satisfies all bounds, with its best friction. The search
    /// calls this function if no scanned value has such a friction.
    ///
    /// # Errors
    /// [`OptimumError::Unreachable`] names the first bound that no value and no friction satisfy together with all
    /// earlier bounds in the list.
    fn reachable(&self, scan: &[Trial]) -> Result<Trial, OptimumError> {
        if !scan.iter().any(|trial| trial.amplitude == f64::INFINITY) || !self.tuned.goes_on() {
            return Err(self.none());
        }
        let mut found = None;
        for (index, kept) in self.kept.iter().enumerate() {
            let request = kept.request(self.tuned.request);
            let (described, tuning) = (self.tuned.described, self.tuned.tuning);
            let tuned = TunedSearch::new(described, &request, tuning)?.watched_by(self.watch);
            let before = self.kept.get(..index).unwrap_or_default();
            let search = KeptTunedSearch::new(&tuned, before, self.watch);
            let best = search.best();
            self.tuned.count(tuned.asked.load(Ordering::Relaxed));
            let (best, _) = best?;
            if !self.tuned.goes_on() {
                return Err(OptimumError::Stopped);
            }
            if !(best.amplitude <= kept.most) {
                return Err(OptimumError::Unreachable {
                    index,
                    least: best.amplitude,
                    beta: best.beta,
                    value: Some(best.value),
                });
            }
            found = Some(best.value);
        }
        // If the list of bounds is empty, `found` is `None`. The amplitude is then infinite because no friction bounds
        // it.
        let value = found.ok_or(OptimumError::Unbounded)?;
        let trial = self.trial(value)?;
        trial.is_valid().then_some(trial).ok_or_else(|| self.none())
    }

    /// Returns the scanned values near which the amplitude may have a minimum, beginning with the smallest amplitude.
    /// The amplitude of each returned value is at most `most`.
    fn valleys(&self, scan: &[Trial], most: f64) -> Vec<Valley> {
        let higher = |other: Option<&Trial>, here: &Trial| {
            other.is_none_or(|other| !(other.amplitude < here.amplitude))
        };
        let mut valleys: Vec<Valley> = (0..scan.len())
            .filter_map(|place| {
                let start = *scan.get(place)?;
                let below = place.checked_sub(1).and_then(|below| scan.get(below));
                let above = scan.get(place + 1);
                let valley = start.amplitude <= most && higher(below, &start);
                let ends = [below, above].map(|end| end.map_or(start.value, |end| end.value));
                (valley && higher(above, &start)).then_some(Valley { start, ends })
            })
            .collect();
        valleys.sort_by(|a, b| a.start.amplitude.total_cmp(&b.start.amplitude));
        valleys.truncate(MOST_LOOKED_INTO);
        valleys
    }

    /// Returns the best trial between the two values of a valley. A trial is a value of the number with its best
    /// friction. A valley is a scanned value near a minimum.
    fn narrowed(&self, valley: &Valley) -> Trial {
        let mut best = valley.start;
        let mut height = |value: f64| {
            if !self.tuned.goes_on() {
                return f64::NEG_INFINITY;
            }
            let trial = self.trial(value).ok().filter(Trial::is_valid);
            if let Some(trial) = trial.filter(|trial| trial.amplitude < best.amplitude) {
                best = trial;
            }
            trial.map_or(f64::NEG_INFINITY, |trial| -trial.amplitude)
        };
        let [from, to] = valley.ends;
        let start = valley.start.value;
        // A scanned value at a bound of the interval has only one neighbour. A single step inwards then shows if the
        // amplitude falls.
        let inward = if from == start {
            Some(start + INWARD * (to - start))
        } else if to == start {
            Some(start - INWARD * (start - from))
        } else {
            None
        };
        let from_start = (start, -valley.start.amplitude);
        let begin = match inward.map(|inward| (inward, height(inward))) {
            None => Some(from_start),
            Some(inside) => (from_start.1 < inside.1).then_some(inside),
        };
        if let Some(begin) = begin {
            line::largest(&mut height, valley.ends, begin, NEAR);
        }
        best
    }
}

impl Trial {
    /// Returns true if some friction satisfies all bounds at this value of the number.
    fn is_valid(&self) -> bool {
        self.amplitude.is_finite()
    }
}
