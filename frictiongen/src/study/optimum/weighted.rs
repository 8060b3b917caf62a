//! Finds the best friction for several quantities. Each quantity is divided by a given value. The best friction makes
//! the largest of these quotients smallest.

use super::amplitude::KeepGoing;
use super::answer::{Optimum, OptimumEnd, OptimumKind};
use super::minima::narrowed_by;
use super::peaks::AmplitudeBand;
use super::problem::OptimumProblem;
use super::request::{OptimumError, OptimumRequest};
use super::scan::{Scanned, scanned_at};
use super::search::{Least, SearchEnd};
use super::whole::{WORK_OF_ALL_CHECKS, whole};
use crate::Of;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use std::cell::Cell;

/// Largest number of friction ratios that the search checks over the whole band. If a check finds a higher peak, the
/// search continues.
const CHECKS: usize = 12;
/// Bound on the work between two checks, for all quantities together, in units of about 10 µs of computing time.
const WORK_OF_A_ROUND: usize = super::WORK / 2;
/// The search examines a friction ratio only if its largest quotient, divided by the smallest one of all friction
/// ratios so far, is at most this number. A quotient is a quantity of a motion, divided by its given value.
const NEARLY: f64 = 1.5;
/// Largest number of friction ratios around which the search examines intervals.
const MOST_POINTS: usize = 6;
/// Tolerance of the check over the whole band. The check confirms a result if the largest quotient over the whole band
/// exceeds the earlier largest quotient by at most this fraction.
const SAME: f64 = 1e-6;
/// Largest relative difference at which the result treats two quotients as equal. A quotient is a quantity divided by
/// its given value.
const BALANCE: f64 = 1e-3;

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

impl System {
    /// Returns the best friction for several quantities. Each quantity is divided by its value in `weighted`. With the
    /// best friction, the largest of these quotients over the band is smallest. The call takes the band and the load
    /// from `request`, and ignores the quantity in `request`.
    ///
    /// The search finds the best friction of each quantity alone. Then it searches between all friction ratios
    /// evaluated so far, and checks the result over the whole band. The search calls `watch` after each evaluation. If
    /// `watch` returns false once, it must return false from then on.
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
        let problems = weighted.iter().map(|weighted| {
            let (of, size) = (weighted.of, weighted.size);
            let request = OptimumRequest {
                of,
                size,
                ..request.clone()
            };
            Ok(OptimumProblem::new(self, &request)?.watched_by(Some(watch)))
        });
        let problems = problems.collect::<Result<Vec<_>, OptimumError>>()?;
        let left = Cell::new(WORK_OF_ALL_CHECKS);
        let search = WeightedSearch {
            bands: problems.iter().map(OptimumProblem::band).collect(),
            over: weighted.iter().map(|weighted| weighted.over).collect(),
            watch,
            left: &left,
        };
        search.solved(&problems)
    }
}

/// The quotients at one friction ratio. A quotient is a quantity of a motion, such as a displacement, divided by its
/// given value.
struct Quotients {
    /// The largest quotient. The quantity that has this quotient is the decisive one. The peaks are those of the
    /// decisive quantity, in the unit of this quantity.
    at: Scanned,
    decisive: usize,
    values: Vec<f64>,
}

/// A search for the best friction for several quantities. It has one frequency band for each quantity.
struct WeightedSearch<'s> {
    bands: Vec<AmplitudeBand<'s>>,
    /// For each quantity, the value by which the search divides it.
    over: Vec<f64>,
    watch: KeepGoing<'s>,
    /// Work that remains for the checks of the whole band, in units of about 10 µs of computing time.
    left: &'s Cell<usize>,
}

impl<'s> WeightedSearch<'s> {
    fn solved(&self, problems: &[OptimumProblem<'s>]) -> Result<WeightedOptimum, OptimumError> {
        let each = super::WORK / self.bands.len().max(1);
        let alone = self
            .bands
            .iter()
            .map(|band| OptimumProblem::least(band, each))
            .collect::<Result<Vec<Least>, _>>()?;
        let (found, bracket, confirmed) = self.best(&alone)?;
        let missing = || OptimumError::Unbounded;
        let band = self.bands.get(found.decisive).ok_or_else(missing)?;
        let problem = problems.get(found.decisive).ok_or_else(missing)?;
        let own = alone.get(found.decisive).ok_or_else(missing)?;
        let ratio = found.at.value;
        let over = self.over.get(found.decisive).copied().unwrap_or(1.0);
        let least = Least {
            bracket,
            at: Scanned {
                value: ratio * over,
                ..found.at
            },
            end: if confirmed {
                SearchEnd::Converged
            } else {
                SearchEnd::Spent
            },
            ..own.clone()
        };
        let near = ratio * (1.0 - BALANCE);
        let quotients = found.values.iter().zip(&self.over);
        let equal = quotients.filter(|(value, over)| near <= **value / **over);
        let kind = (1 < equal.count()).then_some(OptimumKind::Balanced);
        let told = problem.told(band, &least)?;
        let optimum = Optimum {
            kind: kind.unwrap_or(told.kind),
            end: if confirmed {
                OptimumEnd::Converged
            } else {
                OptimumEnd::WorkSpent
            },
            beyond_jump: None,
            // Tolerances and sensitivities describe the minimum of a single quantity.
            tolerances: Vec::new(),
            sensitivities: Vec::new(),
            ..told
        };
        Ok(WeightedOptimum {
            optimum,
            decisive: found.decisive,
            ratio,
            largest: found.values,
        })
    }

    /// Returns the quotients at the best friction ratio, an interval that contains this friction ratio, and a flag.
    /// The flag is true if a check of the whole band confirms the result.
    fn best(&self, alone: &[Least]) -> Result<(Quotients, [f64; 2], bool), OptimumError> {
        let scans = alone.iter().zip(&self.over).flat_map(|(least, over)| {
            let scan = least.scan.iter().chain([&least.at]);
            scan.map(move |scanned| (scanned.beta, scanned.value / over))
        });
        // Each point is a friction ratio with its largest quotient so far, which is a lower bound.
        let mut points: Vec<(f64, f64)> = scans.filter(|(_, value)| !value.is_nan()).collect();
        let mut best: Option<(Quotients, [f64; 2])> = None;
        for _ in 0..CHECKS {
            if !(self.watch)() {
                return Err(OptimumError::Stopped);
            }
            for band in &self.bands {
                band.amplitude
                    .allow(WORK_OF_A_ROUND / self.bands.len().max(1));
            }
            let Some((found, bracket)) = self.refined(&points) else {
                break;
            };
            let checked = self.quotients(found.beta, |band| whole(band, found.beta, self.left));
            let confirmed = checked.at.complete && checked.at.value <= found.value * (1.0 + SAME);
            points.push((found.beta, checked.at.value));
            if confirmed {
                return Ok((checked, bracket, true));
            }
            let value = |best: &(Quotients, [f64; 2])| best.0.at.value;
            if checked.at.complete
                && best
                    .as_ref()
                    .is_none_or(|best| checked.at.value < value(best))
            {
                best = Some((checked, bracket));
            }
        }
        let (found, bracket) = best.ok_or(OptimumError::TooLong)?;
        Ok((found, bracket, false))
    }

    /// Returns the best friction ratio between known friction ratios, and an interval that contains the best friction
    /// ratio. The returned quotient may be too small, because the search evaluates only some frequencies of the band.
    fn refined(&self, points: &[(f64, f64)]) -> Option<(Scanned, [f64; 2])> {
        let mut all: Vec<f64> = points.iter().map(|(beta, _)| *beta).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        // The friction ratios with the smallest known quotients come first. These quotients give a cutoff that
        // excludes most of the remaining friction ratios.
        let mut points = points.to_vec();
        points.sort_by(|a, b| a.1.total_cmp(&b.1));
        let mut top = f64::INFINITY;
        let mut seen: Vec<(usize, Scanned)> = Vec::new();
        for (beta, bound) in points {
            let place = all.partition_point(|other| *other < beta);
            if NEARLY * top < bound || seen.iter().any(|(other, _)| *other == place) {
                continue;
            }
            let here = self.seen(beta, NEARLY * top);
            if here.complete && here.value.is_finite() {
                top = top.min(here.value);
                seen.push((place, here));
            }
        }
        seen.retain(|(_, here)| here.value <= NEARLY * top);
        seen.sort_by(|a, b| a.1.value.total_cmp(&b.1.value));
        let spent = || {
            let mut bands = self.bands.iter();
            bands.any(|band| band.amplitude.is_spent())
        };
        let found = seen.into_iter().take(MOST_POINTS).map(|(place, here)| {
            let side = |place: Option<usize>| place.and_then(|place| all.get(place)).copied();
            let [below, above] = [place.checked_sub(1), Some(place + 1)].map(|place| {
                let beta = side(place).unwrap_or(here.beta);
                Scanned {
                    beta,
                    complete: false,
                    ..here.clone()
                }
            });
            let value = |beta, cutoff| self.seen(beta, cutoff);
            let found = narrowed_by(&value, &spent, (&below, &above), Some(here));
            (found.at, found.bracket)
        });
        found.min_by(|a, b| a.0.value.total_cmp(&b.0.value))
    }

    /// Returns the largest quotient at the frequencies of a first evaluation, which leaves out some frequencies. The
    /// evaluation ends early if a quotient exceeds the cutoff.
    fn seen(&self, beta: f64, cutoff: f64) -> Scanned {
        let mut largest: Option<Scanned> = None;
        for (band, over) in self.bands.iter().zip(&self.over) {
            let found = scanned_at(band, beta, cutoff * over);
            let here = Scanned {
                value: found.value / over,
                ..found
            };
            let complete = here.complete;
            if largest.as_ref().is_none_or(|top| top.value < here.value) || !complete {
                largest = Some(here);
            }
            if !complete {
                break;
            }
        }
        largest.unwrap_or_else(|| Scanned {
            beta,
            value: f64::NAN,
            slope: f64::NAN,
            peaks: Vec::new(),
            complete: false,
            whole: false,
        })
    }

    /// Returns the quotients of all quantities at one friction ratio. A quotient is a quantity divided by its given
    /// value.
    fn quotients(&self, beta: f64, largest: impl Fn(&AmplitudeBand<'s>) -> Scanned) -> Quotients {
        let all: Vec<Scanned> = self.bands.iter().map(largest).collect();
        let quotient = |index: usize| {
            let value = all.get(index).map_or(f64::NAN, |found| found.value);
            value / self.over.get(index).copied().unwrap_or(f64::NAN)
        };
        let order = |a: &usize, b: &usize| quotient(*a).total_cmp(&quotient(*b));
        let decisive = (0..all.len()).max_by(order).unwrap_or(0);
        let complete = all.iter().all(|found| found.complete);
        let top = all.get(decisive).cloned();
        Quotients {
            at: Scanned {
                beta,
                value: quotient(decisive),
                slope: f64::NAN,
                peaks: top.map_or_else(Vec::new, |top| top.peaks),
                complete,
                whole: true,
            },
            decisive,
            values: all.iter().map(|found| found.value).collect(),
        }
    }
}
