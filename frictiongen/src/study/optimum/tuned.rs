//! The best friction together with the best value of one number of the scene description.
//!
//! The best amplitude, as a function of the number, has corners and jumps, because the decisive peak and the decisive
//! bound change. The search therefore uses no derivatives: a scan brackets the minima, and golden sections with parabolas
//! narrow them.

use super::answer::{TunedNumber, TunedPoint};
use super::problem::{Found, OptimumProblem};
use super::request::{OptimumOptions, QuantityValue, Tuning};
use super::search::SearchEnd;
use super::{FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumRequest};
use crate::Of;
use crate::study::golden;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::angular_frequency;
use frictiongen_model::scene::Excitation;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of intervals of the scan over the varied number.
const STEPS: usize = 16;
/// Bounds on the work of a search at one scanned value of the number, and at the best value, in units of about 10 µs of
/// computing time.
const WORK_OF_ONE: usize = 300_000;
const WORK: usize = 1_200_000;
/// The search narrows the interval around a scanned value only if its amplitude, divided by the smallest amplitude of
/// all scanned values, is at most this number.
const WORTH: f64 = 1.5;
/// Largest number of scanned values around which the search narrows the interval.
const MOST_LOOKED_INTO: usize = 3;
/// Relative accuracy of the best value of the number.
const NEAR: f64 = 1e-9;
/// Relative accuracy of the best value, if the bound on work ends the searches over friction.
const ROUGHLY: f64 = 1e-2;
/// Distance from a bound of the interval at which the search tests if the amplitude falls, divided by the distance to
/// the next scanned value.
const INWARD: f64 = 1e-3;
/// Bounds of the friction that a search near a minimum covers, divided by the smaller and by the larger of the best
/// frictions on both sides.
const WINDOW: [f64; 2] = [0.7, 1.4];

/// Factors that convert the non-dimensional groups r, β and x̄ of the varied scene to those of the original scene. The
/// two scenes may have different m₁ and k₁.
#[derive(Clone, Copy, Debug)]
struct GroupRatios {
    pub r: f64,
    pub beta: f64,
    pub length: f64,
}

impl GroupRatios {
    fn new(request: &OptimumRequest, described: &System, varied: &System) -> Self {
        let stiffer = varied.scene().first_stiffness() / described.scene().first_stiffness();
        let (beta, length) = match described.scene().excitation {
            Excitation::Base => (stiffer, 1.0),
            Excitation::Force(_) => (1.0, 1.0 / stiffer),
        };
        let r = varied.reference / described.reference;
        // The load, velocities and accelerations refer to r = 1. The frequency at r = 1 changes with m₁ and k₁.
        let fall = request.load.map_or(0, |load| load.fall());
        let load = r.powi(-fall);
        let length = match request.size {
            MotionQuantity::Displacement if request.of.is_force() => beta,
            MotionQuantity::Displacement => length,
            MotionQuantity::Velocity => length * r,
            MotionQuantity::Acceleration => length * r * r,
            MotionQuantity::Force => beta,
            MotionQuantity::Energy => beta * length * load,
            MotionQuantity::Damping => 1.0,
        };
        Self {
            r,
            beta: beta * load,
            length: length * load,
        }
    }

    fn of(&self, mut optimum: Optimum) -> Optimum {
        optimum.beta *= self.beta;
        optimum.bracket = optimum.bracket.map(|beta| beta * self.beta);
        optimum.reference /= self.r;
        optimum.amplitude *= self.length;
        optimum.beyond_jump = optimum.beyond_jump.map(|size| size * self.length);
        for peak in &mut optimum.peaks {
            peak.r *= self.r;
            peak.amplitude *= self.length;
            peak.slope = peak.slope.map(|slope| slope * self.length / self.beta);
        }
        for tolerance in &mut optimum.tolerances {
            tolerance.from *= self.beta;
            tolerance.to *= self.beta;
        }
        optimum.unbounded_to *= self.beta;
        optimum.free_of_sticking *= self.beta;
        optimum.locked *= self.beta;
        optimum.without_friction *= self.length;
        optimum.with_contact_locked *= self.length;
        optimum
    }
}

/// A checked request for the best friction together with one number of the scene description.
pub(super) struct TunedSearch<'s> {
    described: &'s System,
    request: &'s OptimumRequest,
    tuning: Tuning,
    options: OptimumOptions<'s>,
    asked: AtomicUsize,
}

/// The best friction at one value of the number. Its groups β and x̄ refer to m₁ and k₁ of the original scene.
#[derive(Clone, Copy, Debug)]
struct Trial {
    value: f64,
    /// The largest amplitude over the band. It is infinite if no friction bounds it or satisfies all bounds, and NaN if
    /// the search ended before it found any friction.
    amplitude: f64,
    beta: f64,
    /// True if the bound on work has ended the search over friction.
    is_spent: bool,
}

/// A scanned value of the number, and the neighbours between which the search looks for a minimum.
struct Valley {
    start: Trial,
    ends: [Trial; 2],
}

impl Trial {
    fn is_valid(&self) -> bool {
        self.amplitude.is_finite()
    }
}

impl<'s> TunedSearch<'s> {
    pub fn new(
        described: &'s System,
        request: &'s OptimumRequest,
        tuning: Tuning,
        options: OptimumOptions<'s>,
    ) -> Result<Self, OptimumError> {
        tuning.check(described)?;
        // The error `Undamped` depends on the value of the number. All other faults of a request are the same for every
        // value of the number.
        if let Err(error) = OptimumProblem::new(described, request, &options)
            && !matches!(error, OptimumError::Undamped(_))
        {
            return Err(error);
        }
        Ok(Self {
            described,
            request,
            tuning,
            options,
            asked: AtomicUsize::new(0),
        })
    }

    /// Returns false if the caller has stopped the search.
    fn goes_on(&self) -> bool {
        self.options.watch.is_none_or(|watch| watch())
    }

    fn with(&self, value: f64) -> Result<System, OptimumError> {
        let described = self.described;
        let varied = described.with_value(self.tuning.of, value);
        let mut varied = varied.map_err(OptimumError::Scene)?;
        let displacement = OptimumRequest {
            of: Of::Contact,
            size: MotionQuantity::Displacement,
            ..self.request.clone()
        };
        let units = GroupRatios::new(&displacement, described, &varied);
        let start = described.start.as_ref();
        varied.start = start.map(|start| start.in_units(units.length, units.r));
        Ok(varied)
    }

    /// Returns the checked request for a varied scene, with the same band of frequencies in Hz and the same bounds.
    fn problem<'v>(&self, varied: &'v System) -> Result<OptimumProblem<'v>, OptimumError> {
        let groups = GroupRatios::new(self.request, self.described, varied);
        let ratio = |r: f64| r / groups.r;
        let hertz = |hertz: f64| ratio(self.described.frequency_ratio(angular_frequency(hertz)));
        let band = match self.request.band {
            FrequencyBand::Ratio(from, to) => FrequencyBand::Ratio(ratio(from), ratio(to)),
            FrequencyBand::Hertz(from, to) => FrequencyBand::Ratio(hertz(from), hertz(to)),
        };
        let request = OptimumRequest {
            band,
            ..self.request.clone()
        };
        let kept = self.options.kept.iter().zip(self.factors(varied));
        let kept = kept.map(|(kept, factor)| QuantityValue {
            value: kept.value / factor,
            ..*kept
        });
        let options = OptimumOptions {
            kept: &kept.collect::<Vec<_>>(),
            ..self.options
        };
        OptimumProblem::new(varied, &request, &options)
    }

    /// Returns one factor for each quantity with a bound. The factor converts the quantity from the groups of the
    /// varied scene to the groups of the original scene.
    fn factors(&self, varied: &System) -> Vec<f64> {
        let factor = |kept: &QuantityValue| {
            GroupRatios::new(&kept.request(self.request), self.described, varied).length
        };
        self.options.kept.iter().map(factor).collect()
    }

    /// Returns the best friction at one value of the number: the best of all frictions, or of an interval of friction.
    fn trial(&self, value: f64, window: Option<[f64; 2]>) -> Result<Trial, OptimumError> {
        let none = |amplitude: f64| Trial {
            value,
            amplitude,
            beta: f64::NAN,
            is_spent: false,
        };
        let varied = self.with(value)?;
        let groups = GroupRatios::new(self.request, self.described, &varied);
        let window = window.map(|window| window.map(|beta| beta / groups.beta));
        let found = self.problem(&varied).and_then(|problem| {
            let problem = problem.watched_by(self.options.watch);
            Ok(self.counted(problem.found(self.work_of_one(), window)?))
        });
        match found {
            Err(
                OptimumError::Undamped(_)
                | OptimumError::Unbounded
                | OptimumError::Unreachable { .. },
            ) => Ok(none(f64::INFINITY)),
            Err(OptimumError::TooLong | OptimumError::Stopped) => Ok(none(f64::NAN)),
            Err(error) => Err(error),
            Ok(_) if !self.goes_on() => Ok(none(f64::NAN)),
            Ok(found) => Ok(Trial {
                value,
                amplitude: found.least.at.merit.value * groups.length,
                beta: found.least.at.beta * groups.beta,
                is_spent: found.least.end == SearchEnd::Spent,
            }),
        }
    }

    /// Returns the bound on the work of a search at one value of the number.
    fn work_of_one(&self) -> usize {
        self.options.work.unwrap_or(WORK_OF_ONE)
    }

    /// Adds the number of evaluations of a search to the total.
    fn counted<'v>(&self, found: Found<'v>) -> Found<'v> {
        self.asked
            .fetch_add(found.band.asked.get(), Ordering::Relaxed);
        found
    }

    pub fn solved(&self) -> Result<Optimum, OptimumError> {
        let (best, scan) = self.best()?;
        let varied = self.with(best.value)?;
        let groups = GroupRatios::new(self.request, self.described, &varied);
        // If the caller has stopped the search, the shorter search of the scan is repeated without the caller's
        // function.
        let stopped = !self.goes_on();
        let watch = self.options.watch.filter(|_| !stopped);
        let problem = self.problem(&varied)?.watched_by(watch);
        let found = if stopped {
            problem.found(self.work_of_one(), None)?
        } else {
            let near = best.beta / groups.beta;
            let window = WINDOW.map(|share| share * near);
            let work = self.options.work.unwrap_or(WORK);
            let all = problem.found(work, None)?;
            match problem.found(work, Some(window)) {
                Ok(near) if 0.0 < best.beta && near.is_better_than(&all) => near.with_scan_of(all),
                _ => all,
            }
        };
        let found = self.counted(found);
        let mut optimum = groups.of(problem.told(found)?);
        for (largest, factor) in optimum.largest.iter_mut().zip(self.factors(&varied)) {
            *largest *= factor;
        }
        if stopped || !self.goes_on() {
            optimum.end = OptimumEnd::Stopped;
        }
        let points = scan.iter().map(|trial| TunedPoint {
            value: trial.value,
            beta: trial.beta,
            amplitude: trial.amplitude,
        });
        optimum.scan = points.collect();
        optimum.tuned = vec![TunedNumber {
            of: self.tuning.of,
            value: best.value,
            at_end: [self.tuning.from, self.tuning.to].contains(&best.value),
        }];
        optimum.evaluations = self.asked.load(Ordering::Relaxed);
        Ok(optimum)
    }

    /// Returns the values of the number that the scan evaluates, including both bounds of the interval.
    fn values(&self) -> Vec<f64> {
        let Tuning { from, to, .. } = self.tuning;
        let value = |place: usize| {
            let share = place as f64 / STEPS as f64;
            match place {
                0 => from,
                STEPS => to,
                _ if 0.0 < from => from * (to / from).powf(share),
                _ => from + (to - from) * share * share,
            }
        };
        let mut values: Vec<f64> = (0..=STEPS).map(value).collect();
        values.dedup();
        values
    }

    /// Returns the best value of the number with its best friction, and the results at all scanned values.
    fn best(&self) -> Result<(Trial, Vec<Trial>), OptimumError> {
        let mut scan = Vec::new();
        let mut wrong = None;
        for trial in on_all_cores(self.values(), |value| self.trial(value, None)) {
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
        if best.amplitude == 0.0 || !self.goes_on() {
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
        match self.goes_on() {
            true => OptimumError::TooLong,
            false => OptimumError::Stopped,
        }
    }

    /// Returns a value of the number at which some friction satisfies all bounds, with its best friction. The search
    /// calls this function if no scanned value has such a friction.
    ///
    /// # Errors
    /// [`OptimumError::Unreachable`] names the first bound that no value and no friction satisfy together with all
    /// earlier bounds in the list.
    fn reachable(&self, scan: &[Trial]) -> Result<Trial, OptimumError> {
        if !scan.iter().any(|trial| trial.amplitude == f64::INFINITY) || !self.goes_on() {
            return Err(self.none());
        }
        let mut found = None;
        for (index, kept) in self.options.kept.iter().enumerate() {
            let request = kept.request(self.request);
            let options = OptimumOptions {
                kept: self.options.kept.get(..index).unwrap_or_default(),
                ..self.options
            };
            let search = TunedSearch::new(self.described, &request, self.tuning, options)?;
            let best = search.best();
            self.asked
                .fetch_add(search.asked.load(Ordering::Relaxed), Ordering::Relaxed);
            let (best, _) = best?;
            if !self.goes_on() {
                return Err(OptimumError::Stopped);
            }
            if !(best.amplitude <= kept.value) {
                return Err(OptimumError::Unreachable {
                    index,
                    least: best.amplitude,
                    beta: best.beta,
                    value: Some(best.value),
                });
            }
            found = Some(best.value);
        }
        // If the list of bounds is empty, the amplitude is infinite because no friction bounds it.
        let value = found.ok_or(OptimumError::Unbounded)?;
        let trial = self.trial(value, None)?;
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
                let ends = [below, above].map(|end| *end.unwrap_or(&start));
                (valley && higher(above, &start)).then_some(Valley { start, ends })
            })
            .collect();
        valleys.sort_by(|a, b| a.start.amplitude.total_cmp(&b.start.amplitude));
        valleys.truncate(MOST_LOOKED_INTO);
        valleys
    }

    /// Returns the best trial between the two ends of a valley.
    fn narrowed(&self, valley: &Valley) -> Trial {
        let mut best = valley.start;
        let betas = [valley.start, valley.ends[0], valley.ends[1]].map(|trial| trial.beta);
        let window = if betas.iter().all(|beta| 0.0 < *beta && beta.is_finite()) {
            let least = betas.iter().copied().fold(f64::INFINITY, f64::min);
            let most = betas.iter().copied().fold(0.0, f64::max);
            Some([WINDOW[0] * least, WINDOW[1] * most])
        } else {
            None
        };
        let mut height = |value: f64| {
            if !self.goes_on() {
                return f64::NEG_INFINITY;
            }
            let trial = self.trial(value, window).ok().filter(Trial::is_valid);
            if let Some(trial) = trial.filter(|trial| trial.amplitude < best.amplitude) {
                best = trial;
            }
            trial.map_or(f64::NEG_INFINITY, |trial| -trial.amplitude)
        };
        let ends = valley.ends.map(|end| end.value);
        let start = valley.start.value;
        // A scanned value at a bound of the interval has only one neighbour. A single step inwards then shows if the
        // amplitude falls.
        let inward = ends.iter().find(|end| **end != start);
        if ends.contains(&start)
            && let Some(other) = inward
            && !(-valley.start.amplitude < height(start + INWARD * (other - start)))
        {
            return best;
        }
        let near = if valley.start.is_spent { ROUGHLY } else { NEAR };
        golden::largest(height, ends, (start, -valley.start.amplitude), near);
        best
    }
}

/// Applies a function to each value on all cores. The results keep the order of the values.
#[cfg(feature = "desk")]
fn on_all_cores<V: Send, T: Send>(values: Vec<V>, f: impl Fn(V) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    values.into_par_iter().with_max_len(1).map(f).collect()
}

/// Applies a function to each value, in the order of the values.
#[cfg(not(feature = "desk"))]
fn on_all_cores<V, T>(values: Vec<V>, f: impl Fn(V) -> T) -> Vec<T> {
    values.into_iter().map(f).collect()
}
