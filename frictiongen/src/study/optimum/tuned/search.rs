//! Finds the value of one number of the scene description with which the best friction gives the smallest amplitude.

use super::answer::{TunedOptimum, TunedPoint, Tuning};
use super::tried::{GroupRatios, Tried, TunedSearch, near};

use crate::study::optimum::OptimumError;
use crate::study::optimum::problem::OptimumProblem;
use crate::study::optimum::search::{Least, SearchEnd, WORK_OF_ONE};
use std::sync::atomic::Ordering;

/// Number of intervals of the scan over the varied number.
const STEPS: usize = 16;
/// The search examines an interval between two scanned values of the number only if its estimated amplitude, divided
/// by the best amplitude, is at most this number. The estimate is the amplitude at which the tangents at the two
/// values meet.
const WORTH: f64 = 1.05;
/// Largest number of intervals between scanned values that the search examines, beginning with the smallest expected
/// amplitude.
const MOST_LOOKED_INTO: usize = 3;
/// Largest number of steps of the search towards one minimum.
const MOST_STEPS: usize = 40;
/// Tolerance of the position of a minimum, divided by the length of the interval between two scanned values.
const NEAR: f64 = 1e-10;
/// Smallest relative reduction of the amplitude by a step. After a smaller reduction the search ends.
const GAIN: f64 = 2e-13;
/// Largest number of repetitions of the search. The search is repeated if a search over all frictions finds a better
/// friction at the best value.
const AGAIN: usize = 3;

impl TunedSearch<'_> {
    pub(super) fn solved(&self) -> Result<TunedOptimum, OptimumError> {
        let mut tried = self.scan()?;
        let scan = tried.iter().map(|tried| TunedPoint {
            value: tried.value,
            beta: tried.beta,
            amplitude: tried.amplitude,
        });
        let scan = scan.collect();
        for again in 0..=AGAIN {
            let best = self.best(&tried).ok_or_else(|| {
                if self.goes_on() {
                    OptimumError::Unbounded
                } else {
                    OptimumError::Stopped
                }
            })?;
            let varied = self.with(best.value)?;
            let problem = OptimumProblem::new(&varied, &self.request_for(&varied))?;
            let problem = problem.watched_by(self.watch);
            let band = problem.band();
            // This search covers all frictions. The earlier search covered only frictions near the best frictions of
            // the neighbouring values.
            let mut least = match (OptimumProblem::least(&band, WORK_OF_ONE), &best.found) {
                (Err(OptimumError::Stopped), Some(found)) => Least {
                    end: SearchEnd::Spent,
                    ..found.clone()
                },
                (least, _) => least?,
            };
            self.count(band.amplitude.asked.get());
            if let Some(found) = best.found.clone()
                && found.at.value < least.at.value
            {
                least = Least {
                    scan: least.scan,
                    locked_from: least.locked_from,
                    free_to: least.free_to,
                    end: if self.goes_on() {
                        found.end
                    } else {
                        SearchEnd::Spent
                    },
                    ..found
                };
            }
            let groups = GroupRatios::new(self.request, self.described, &varied);
            let gained = least.at.value * groups.length < best.amplitude * (1.0 - 1e-9);
            if gained && again < AGAIN && self.goes_on() {
                tried.push(self.tried(best.value, None)?);
                tried.sort_by(|a, b| a.value.total_cmp(&b.value));
                continue;
            }
            let before = band.amplitude.asked.get();
            let optimum = problem.told(&band, &least)?;
            self.count(band.amplitude.asked.get() - before);
            return Ok(TunedOptimum {
                value: best.value,
                at_end: [self.tuning.from, self.tuning.to].contains(&best.value),
                optimum: groups.of(optimum),
                scan,
                evaluations: self.asked.load(Ordering::Relaxed),
                system: varied,
            });
        }
        Err(OptimumError::TooLong)
    }

    /// Returns the values of the number that the scan evaluates, including both bounds of the interval.
    pub(super) fn values(&self) -> Vec<f64> {
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

    fn scan(&self) -> Result<Vec<Tried>, OptimumError> {
        let all = on_all_cores(self.values(), |value| self.tried(value, None));
        let mut tried = Vec::new();
        let mut wrong = None;
        for found in all {
            match found {
                Ok(found) => tried.push(found),
                Err(error) => wrong = wrong.or(Some(error)),
            }
        }
        match wrong {
            Some(error) if tried.iter().all(|tried| !tried.amplitude.is_finite()) => Err(error),
            _ => Ok(tried),
        }
    }

    /// Returns the best result among all scanned values and the minima between neighbouring scanned values.
    fn best(&self, tried: &[Tried]) -> Option<Tried> {
        let finite = tried.iter().filter(|tried| tried.amplitude.is_finite());
        let mut best = finite
            .min_by(|a, b| a.amplitude.total_cmp(&b.amplitude))?
            .clone();
        if best.amplitude == 0.0 {
            return Some(best);
        }
        let pairs = tried.windows(2).filter_map(|pair| match pair {
            [below, above] => Some((below, above)),
            _ => None,
        });
        let mut promising: Vec<(f64, &Tried, &Tried)> = pairs
            .filter(|(below, above)| falls(below) && rises(above))
            .map(|(below, above)| (promised(below, above), below, above))
            .filter(|(low, ..)| *low <= WORTH * best.amplitude)
            .collect();
        promising.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        for (_, below, above) in promising.into_iter().take(MOST_LOOKED_INTO) {
            let found = self.crept(below.clone(), above.clone());
            if found.amplitude < best.amplitude {
                best = found;
            }
        }
        Some(best)
    }

    /// Returns the minimum between two values of the number. The amplitude must fall at the first value and rise at the
    /// second.
    fn crept(&self, mut below: Tried, mut above: Tried) -> Tried {
        let width = above.value - below.value;
        let mut best = if below.amplitude < above.amplitude {
            &below
        } else {
            &above
        }
        .clone();
        let mut stale = 0_u32;
        let mut beyond = 0.0;
        let mut last: Option<bool> = None;
        for step in 0..MOST_STEPS {
            let left = above.value - below.value;
            let met = meeting(&below, &above);
            let enough = met.is_some_and(|(_, low)| best.amplitude - low <= GAIN * best.amplitude);
            if left <= NEAR * width || enough || !self.goes_on() {
                break;
            }
            // If the peaks at both bounds of the bracket are the same, the minimum is at the zero of the derivative. If
            // the peaks differ, the minimum is at the crossing of two branches. If one bound of the bracket does not
            // move, the step goes slightly beyond the crossing.
            let one = below.peaks.len() == above.peaks.len()
                && below
                    .peaks
                    .iter()
                    .zip(&above.peaks)
                    .all(|(a, b)| (a - b).abs() <= 0.02 * a);
            let zero = below.value - below.slope * left / (above.slope - below.slope);
            let crossing = met.map(|(value, _)| value + beyond);
            let guess = if one && step % 3 < 2 {
                Some(zero)
            } else {
                crossing
            };
            let middle = 0.5 * (below.value + above.value);
            let inside = |value: &f64| below.value < *value && *value < above.value;
            let value = guess.filter(|_| stale < 3).filter(inside).unwrap_or(middle);
            let Ok(here) = self.tried(value, Some(near(&below, &above))) else {
                break;
            };
            if here.amplitude < best.amplitude {
                best = here.clone();
            }
            if here.slope == 0.0 {
                break;
            }
            let side = here.slope < 0.0 || !here.amplitude.is_finite();
            if side {
                below = here;
            } else {
                above = here;
            }
            // After two steps on the same side of the minimum, the next step goes beyond the meeting point of the
            // tangents. The excess is the distance between the last value and this meeting point.
            beyond = match meeting(&below, &above) {
                Some((next, _)) if last == Some(side) => next - value,
                _ => 0.0,
            };
            last = Some(side);
            stale = if above.value - below.value < 0.5 * left {
                0
            } else {
                stale + 1
            };
            if stale > 3 {
                stale = 0;
            }
        }
        best
    }
}

fn falls(tried: &Tried) -> bool {
    tried.slope < 0.0 || tried.amplitude == f64::INFINITY
}

fn rises(tried: &Tried) -> bool {
    0.0 < tried.slope
}

/// Returns the value of the number at which the tangents of two scanned values meet, and the amplitude at that value.
fn meeting(below: &Tried, above: &Tried) -> Option<(f64, f64)> {
    let rise = below.slope - above.slope;
    let sum =
        above.amplitude - below.amplitude + below.slope * below.value - above.slope * above.value;
    let value = sum / rise;
    let low = below.amplitude + below.slope * (value - below.value);
    (below.value < value && value < above.value).then_some((value, low))
}

/// Estimates the smallest amplitude between two scanned values of the varied number. The estimate is the amplitude at
/// which the tangents of the curve of amplitudes at the two values meet, but at least half of the smaller amplitude. If
/// the tangents do not meet between the two values, the estimate is this half.
fn promised(below: &Tried, above: &Tried) -> f64 {
    let least = 0.5 * below.amplitude.min(above.amplitude);
    meeting(below, above).map_or(least, |(_, low)| low.max(least))
}

/// Applies a function to each value on all cores. The results keep the order of the values.
#[cfg(feature = "desk")]
pub(super) fn on_all_cores<V: Send, T: Send>(
    values: Vec<V>,
    f: impl Fn(V) -> T + Sync + Send,
) -> Vec<T> {
    use rayon::prelude::*;
    values.into_par_iter().with_max_len(1).map(f).collect()
}

/// Applies a function to each value, in the order of the values.
#[cfg(not(feature = "desk"))]
pub(super) fn on_all_cores<V, T>(values: Vec<V>, f: impl Fn(V) -> T) -> Vec<T> {
    values.into_iter().map(f).collect()
}
