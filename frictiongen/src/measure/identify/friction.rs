//! Finds the friction force if it is the only unknown. The code scans the sum of squared residuals over the whole
//! range of forces.

use super::answer::{Estimate, Explained, Identified, Verdict};
use super::data::Weighed;
use super::model::{self, Along, Direction};
use super::observation::{Observation, Using};
use super::request::IdentifyRequest;
use crate::measure::MeasureError;
use crate::measure::statistics::{CHI, excess, is_chance};
use crate::study::System;
use crate::study::golden::smallest;
use crate::{Complex, Regime};
use std::convert::Infallible;

/// Number of intervals into which the scan divides the range of friction forces. The intervals are shorter near the
/// start of the range.
pub(super) const PLACES: u32 = 96;
/// Number of steps of a golden-section search for the friction force. The steps narrow an interval of forces to 1e-9 of
/// its width.
const SECTIONS: usize = 44;
/// Number of steps of a bisection for a bound of the friction force. The steps narrow an interval of forces to 1e-12 of
/// its width.
const HALVINGS: usize = 40;
/// The measurement determines the friction force if the width of its 95 % interval, divided by the force, is at most
/// this number.
const WIDE: f64 = 1.0;

/// The measurements of an identification, and the scene with which the fit compares them.
pub(super) struct IdentifyProblem<'a> {
    pub(super) system: &'a System,
    pub(super) observations: &'a [Observation],
    pub(super) using: Using,
    /// Range of friction forces that the code scans, in N.
    pub(super) range: (f64, f64),
    /// True if every friction force above the range of the scan gives the same response.
    pub(super) stuck_beyond: bool,
}

impl<'a> IdentifyProblem<'a> {
    pub(super) fn new(
        system: &'a System,
        observations: &'a [Observation],
        request: &IdentifyRequest,
    ) -> Result<Self, MeasureError> {
        if observations.iter().all(|seen| seen.motions.is_empty()) {
            return Err(MeasureError::NoObservation);
        }
        for seen in observations {
            system.constant_scale(seen.load)?;
            system.at(system.frequency_ratio_at_hertz(seen.hertz))?;
            let known = system.scene().masses.len();
            if seen.motions.iter().any(|datum| known <= datum.mass) {
                return Err(MeasureError::Asked(
                    "an observation names a mass that the scene does not have",
                ));
            }
            let usable = |datum: &super::Datum| {
                0.0 < datum.deviation
                    && datum.deviation.is_finite()
                    && datum.value.norm().is_finite()
            };
            if !seen.motions.iter().all(usable) || !(0.0 <= seen.load_deviation) {
                return Err(MeasureError::Asked(
                    "a measured value must be finite, and its deviation above 0",
                ));
            }
        }
        let limits = observations
            .iter()
            .filter_map(|seen| model::sticks_from(system, seen));
        let (stuck, sought) = limits.fold((0.0_f64, 0.0_f64), |(stuck, sought), limit| {
            (stuck.max(limit.0), sought.max(limit.1))
        });
        let range = request.range.unwrap_or((0.0, 1.02 * sought));
        if !(0.0 <= range.0 && range.0 < range.1 && range.1.is_finite()) {
            return Err(MeasureError::Asked(
                "the range of friction forces must begin at 0 or above, and end above its start",
            ));
        }
        Ok(Self {
            system,
            observations,
            using: request.using,
            range,
            stuck_beyond: stuck <= range.1,
        })
    }

    /// Returns the compared quantities of all observations, weighted by their errors. An error of the load also
    /// changes the computed motion, because it changes β. The code computes this change at the friction force
    /// `friction`, in N, and neglects it for `None`.
    pub(super) fn weighed(
        &self,
        system: &System,
        friction: Option<f64>,
    ) -> Result<Vec<Weighed<'a>>, MeasureError> {
        let along = friction.and_then(|_| Along::new(system, Direction::Friction));
        let weighed = self.observations.iter().map(|seen| {
            let slopes = friction.zip(along.as_ref()).and_then(|(friction, along)| {
                let slopes = along.slopes(seen, friction)?;
                let sizes = self.sizes(system, seen, friction)?;
                let slopes = slopes.into_iter().zip(sizes);
                Some(
                    slopes
                        .map(|(slope, size)| slope * (friction * size))
                        .collect::<Vec<_>>(),
                )
            });
            Weighed::new(seen, self.using, slopes.as_deref())
        });
        weighed
            .collect::<Option<Vec<_>>>()
            .ok_or(MeasureError::NoFit)
    }

    /// Returns a factor for each motion, by which the code multiplies the derivatives of the computed motion. If the
    /// amplitude was measured, the factor is 1. Otherwise it is the modulus of the measured value divided by the
    /// computed amplitude.
    fn sizes(&self, system: &System, seen: &Observation, friction: f64) -> Option<Vec<f64>> {
        if self.using != Using::PhaseAlone {
            return Some(vec![1.0; seen.motions.len()]);
        }
        let answer = model::answer(system, seen, friction)?;
        let pairs = seen.motions.iter().zip(&answer.values);
        let sizes = pairs.map(|(datum, value)| datum.value.norm() / value.norm());
        Some(
            sizes
                .map(|size| if size.is_finite() { size } else { 0.0 })
                .collect(),
        )
    }

    /// Returns the sum of squared residuals at a friction force in N. Returns infinity if the scene has no response at
    /// this force.
    fn squares(&self, weighed: &[Weighed<'_>], friction: f64) -> f64 {
        let sums = self
            .observations
            .iter()
            .zip(weighed)
            .map(|(seen, weights)| {
                let answer = model::answer(self.system, seen, friction)?;
                Some(weights.residuals(&answer.values)?.norm_squared())
            });
        sums.sum::<Option<f64>>().unwrap_or(f64::INFINITY)
    }

    /// Finds the friction force and its 95 % interval. The force is the only unknown.
    pub(super) fn friction(&self) -> Result<Alone, MeasureError> {
        let weighed = self.weighed(self.system, None)?;
        let data: usize = weighed.iter().map(Weighed::len).sum();
        if data == 0 {
            return Err(MeasureError::TooFewData { data, unknowns: 1 });
        }
        let (low, high) = self.range;
        let place = |i: u32| {
            let share = f64::from(i) / f64::from(PLACES);
            low + (high - low) * share * share
        };
        let scanned: Vec<(f64, f64)> = (0..=PLACES)
            .map(|i| (place(i), self.squares(&weighed, place(i))))
            .collect();
        let best = self.lowest(&weighed, &scanned)?;
        // The effect of the load's error depends on the friction force. The second pass therefore uses the force that
        // the first pass has found.
        let weighed = self.weighed(self.system, Some(best))?;
        let scanned: Vec<(f64, f64)> = scanned
            .iter()
            .map(|(force, _)| (*force, self.squares(&weighed, *force)))
            .collect();
        let minima = self.minima(&weighed, &scanned);
        let least = minima
            .iter()
            .map(|(_, squares)| *squares)
            .fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return Err(MeasureError::NoFit);
        }
        let freedom = data - 1;
        let misfit = (freedom > 0).then(|| least / freedom as f64);
        let most = least + CHI * excess(misfit, freedom);
        let mut levels: Vec<(Estimate, f64)> = Vec::new();
        for (force, squares) in minima.into_iter().filter(|(_, squares)| *squares <= most) {
            if let Some((known, lowest)) = levels.iter_mut().find(|(known, _)| known.holds(force)) {
                if squares < *lowest {
                    (known.value, *lowest) = (force, squares);
                }
                continue;
            }
            let estimate = Estimate {
                value: force,
                from: self.edge(&weighed, force, most, -1.0),
                to: self.edge(&weighed, force, most, 1.0),
            };
            levels.push((estimate, squares));
        }
        Ok(Alone {
            levels,
            misfit,
            freedom,
        })
    }

    fn lowest(&self, weighed: &[Weighed<'_>], scanned: &[(f64, f64)]) -> Result<f64, MeasureError> {
        let minima = self.minima(weighed, scanned);
        let best = minima.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        best.map(|(force, _)| force).ok_or(MeasureError::NoFit)
    }

    /// Returns the local minima of the scanned sum of squares, each refined by a golden-section search.
    fn minima(&self, weighed: &[Weighed<'_>], scanned: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let mut found = Vec::new();
        for (index, (force, squares)) in scanned.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|place| scanned.get(place));
            let after = scanned.get(index + 1);
            let lower = |other: Option<&(f64, f64)>| other.is_none_or(|other| *squares <= other.1);
            if squares.is_finite() && lower(before) && lower(after) {
                let from = before.map_or(*force, |other| other.0);
                let to = after.map_or(*force, |other| other.0);
                let squares_at = |force| Ok::<_, Infallible>(self.squares(weighed, force));
                let Ok(sharp) = smallest((from, to), (SECTIONS, 0.0), squares_at);
                found.push(if sharp.1 < *squares {
                    sharp
                } else {
                    (*force, *squares)
                });
            }
        }
        found
    }

    /// Returns the friction force at which the sum of squared residuals reaches `most`. The search starts at the
    /// minimum `force`. It goes upwards if `side` is positive, and downwards otherwise.
    fn edge(&self, weighed: &[Weighed<'_>], force: f64, most: f64, side: f64) -> f64 {
        let end = if side < 0.0 {
            self.range.0
        } else {
            self.range.1
        };
        let mut inside = force;
        let mut step = 1e-6 * (self.range.1 - self.range.0);
        let outside = loop {
            let next = force + side * step;
            let beyond = side * (next - end) >= 0.0;
            let next = if beyond { end } else { next };
            if most < self.squares(weighed, next) {
                break next;
            }
            inside = next;
            if beyond {
                return if 0.0 < side && self.stuck_beyond {
                    f64::INFINITY
                } else {
                    end
                };
            }
            step *= 2.0;
        };
        let mut outside = outside;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if most < self.squares(weighed, middle) {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        inside
    }
}

/// Result of the search with the friction force as the only unknown.
pub(super) struct Alone {
    /// Friction forces that fit the measurement, in ascending order, each with its sum of squared residuals.
    pub(super) levels: Vec<(Estimate, f64)>,
    misfit: Option<f64>,
    freedom: usize,
}

impl Alone {
    pub(super) fn best(&self) -> Result<Estimate, MeasureError> {
        let best = self.levels.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        best.map(|(estimate, _)| *estimate)
            .ok_or(MeasureError::NoFit)
    }

    /// Returns an error if the best friction force does not explain the measurement.
    pub(super) fn checked(&self, problem: &IdentifyProblem<'_>) -> Result<(), MeasureError> {
        problem.explains(self.best()?.value)
    }

    pub(super) fn answer(self, problem: &IdentifyProblem<'_>) -> Result<Identified, MeasureError> {
        let mut friction = self.best()?;
        let explained = problem.explained(problem.system, friction.value)?;
        let mut verdict = verdict(&friction, self.levels.len(), &explained);
        if matches!(verdict, Verdict::Determined | Verdict::NotDetermined) && problem.doubts_unit()
        {
            verdict = Verdict::AlmostStuck;
        }
        if verdict == Verdict::Stuck {
            // Every friction force above the lower bound fits equally well. The lower bound is therefore the answer.
            friction.value = friction.from;
        }
        if !is_chance(self.misfit, self.freedom) {
            verdict = Verdict::NotExplained;
        }
        Ok(Identified {
            condition: condition(problem, &friction, &explained),
            differences: 0,
            friction,
            levels: self.levels.into_iter().map(|(level, _)| level).collect(),
            verdict,
            unknowns: Vec::new(),
            misfit: self.misfit,
            freedom: self.freedom,
            explained,
            system: problem.system.clone(),
        })
    }
}

/// Returns the conclusion about the friction force. It follows from the interval of the force, the number of forces
/// that fit, and the regimes of the contact.
pub(super) fn verdict(friction: &Estimate, levels: usize, explained: &[Explained]) -> Verdict {
    let stuck = explained.iter().all(|point| point.regime == Regime::Stuck);
    let width = friction.to - friction.from;
    if 1 < levels {
        Verdict::SeveralLevels
    } else if stuck && friction.to.is_infinite() && 0.0 < friction.from {
        Verdict::Stuck
    } else if WIDE * friction.value < width {
        Verdict::NotDetermined
    } else {
        Verdict::Determined
    }
}

/// Returns the condition number of the identification: a relative change of the friction force, divided by the relative
/// change of the motion that it causes.
fn condition(problem: &IdentifyProblem<'_>, friction: &Estimate, explained: &[Explained]) -> f64 {
    let Some(along) = Along::new(problem.system, Direction::Friction) else {
        return f64::INFINITY;
    };
    let norm = |values: &[Complex<f64>]| values.iter().map(|value| value.norm_sqr()).sum::<f64>();
    let (mut moved, mut all) = (0.0, 0.0);
    for (seen, point) in problem.observations.iter().zip(explained) {
        let slopes = along.slopes(seen, friction.value).unwrap_or_default();
        moved += norm(&slopes) * friction.value * friction.value;
        all += norm(&point.model);
    }
    (all / moved).sqrt()
}
