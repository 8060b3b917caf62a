//! A checked request for the best friction, and the complete result for a friction.

use super::answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance};
use super::band::{Band, BandPeak, Closely, KeepGoing, Look, Merit};
use super::evaluator::{Evaluator, FrictionAmount, Goal, OneContact, SeveralContacts};
use super::objective::Objective;
use super::request::{FrequencyBand, OptimumError, OptimumRequest};
use super::search::{Least, NEARLY_EQUAL, Range, SearchEnd, insert};
use crate::Regime;
use crate::study::joined::{Combination, Joined};
use crate::study::parameter::{OperatingPoint, Parameter};
use crate::study::physical::ResponseSensitivities;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::{Load, angular_frequency};

/// Bound on the work of completing the result of a search, in units of about 10 µs of computing time.
const WORK_OF_A_REPORT: usize = 120_000;
/// Bound on the work of one evaluation of the whole band, in units of about 10 µs of computing time.
const WORK_OF_A_CHECK: usize = 500_000;
/// Excesses (amplitude − best amplitude)/best amplitude for which the result has an interval of friction.
const EXCESSES: [f64; 3] = [0.01, 0.05, 0.1];
/// Largest relative slope at which a peak counts as stationary: the relative change of the amplitude, divided by the
/// relative change of friction.
const STATIONARY: f64 = 1e-4;
/// Relative distance from the best friction at which the search looks for a jump of the amplitude.
const BESIDE: f64 = 1e-5;
/// Largest number of checks of the lower bound of an interval of friction with the same amplitude.
const MOST_EDGES: usize = 8;
/// Smallest relative distance of two peaks in the result.
const SEPARATE: f64 = 0.01;
/// Smallest relative width of an interval of friction that counts as flat.
const WIDE: f64 = 1e-6;

/// A request for the best friction after all checks, with the system and the band of frequencies.
pub(super) struct OptimumProblem<'s> {
    pub system: &'s System,
    pub objective: Objective,
    /// The solver of a scene with several contacts or dashpots.
    pub joined: Option<Joined<'s>>,
    load: Option<Load>,
    /// Lower and upper bound of the band, as frequency ratios r.
    ends: [f64; 2],
    pub watch: Option<KeepGoing<'s>>,
}

/// The best friction with the band of frequencies in which the search has found it.
pub(super) struct Found<'s> {
    pub band: Band<'s>,
    pub range: Range,
    pub least: Least,
}

impl<'s> OptimumProblem<'s> {
    pub fn new(system: &'s System, request: &OptimumRequest) -> Result<Self, OptimumError> {
        let ends = match request.band {
            FrequencyBand::Ratio(from, to) => [from, to],
            FrequencyBand::Hertz(from, to) => {
                [from, to].map(|hertz| system.frequency_ratio(angular_frequency(hertz)))
            }
        };
        let [from, to] = ends;
        if !(ends.iter().all(|end| 0.0 < *end && end.is_finite())) {
            return Err(OptimumError::Band);
        }
        if !(from < to) {
            return Err(OptimumError::Width);
        }
        let objective = Objective {
            of: request.of,
            size: request.size,
            fall: request.load.map_or(0, |load| load.fall()),
        };
        if !system.has_motion(request.of) {
            return Err(OptimumError::NoSuchMotion(request.of));
        }
        if let Some(load) = request.load {
            system.load_scale(load)?;
        }
        let joined = match system.scene().has_joined_states() {
            true => Some(checked(system, &objective, request.load, from)?),
            false => {
                check_single(system, &objective)?;
                None
            }
        };
        Ok(Self {
            system,
            objective,
            joined,
            load: request.load,
            ends,
            watch: None,
        })
    }

    /// Sets the caller's function that can stop every search of this problem.
    pub fn watched_by(self, watch: KeepGoing<'s>) -> Self {
        let watch = Some(watch);
        Self { watch, ..self }
    }

    pub fn band(&self, goal: Goal) -> Band<'s> {
        let band = Band::new(self.evaluator(goal, None), self.ends);
        band.watch.set(self.watch);
        band
    }

    /// Returns the evaluator of this problem's scene. `shares` replaces the shares of several contacts.
    pub fn evaluator(&self, goal: Goal, shares: Option<&[f64]>) -> Box<dyn Evaluator + 's> {
        let Some(joined) = &self.joined else {
            return Box::new(OneContact::new(self.system, goal));
        };
        let joined = shares.map_or_else(|| joined.clone(), |shares| joined.with_shares(shares));
        let scale = self.load.and_then(|load| self.system.load_scale(load).ok());
        Box::new(SeveralContacts::new((self.system, joined), goal, scale))
    }

    /// Returns the friction ratio up to which the amplitude at an undamped resonance of the band is unbounded, or 0.
    fn unbounded_to(&self) -> f64 {
        let (system, [from, to]) = (self.system, self.ends);
        let zetas = system.modal().damping_ratios.iter();
        let modes = zetas.zip(system.resonances());
        let modes = modes.zip(system.resonance_thresholds());
        modes
            .filter(|((zeta, r), _)| zeta.is_zero() && from <= **r && **r <= to)
            .filter_map(|((_, r), threshold)| Some(threshold? / r.powi(self.objective.fall)))
            .fold(0.0, f64::max)
    }

    /// Finds the friction with which the goal is reached best, within a bound on work. `window` restricts the search to
    /// an interval of friction.
    pub fn found(
        &self,
        goal: Goal,
        work: usize,
        window: Option<[f64; 2]>,
    ) -> Result<Found<'s>, OptimumError> {
        let band = self.band(goal);
        let range = band.range();
        let least = band
            .least((range, self.unbounded_to()), window, work)
            .ok_or_else(|| {
                if band.stopped.get() {
                    OptimumError::Stopped
                } else if band.is_spent() {
                    OptimumError::TooLong
                } else {
                    OptimumError::Unbounded
                }
            })?;
        Ok(Found { band, range, least })
    }

    pub fn solved(&self, work: usize) -> Result<Optimum, OptimumError> {
        let goal = Goal::one(self.objective);
        self.told(self.found(goal, work, None)?, true)
    }

    /// Evaluates the whole band of this problem's quantity at one friction.
    pub fn whole(&self, beta: f64) -> Look {
        let band = self.band(Goal::one(self.objective));
        band.check(beta, Merit::WORST, WORK_OF_A_CHECK)
    }

    /// Returns the complete result: peaks, limits, intervals of friction and derivatives. `is_minimum` is false if a
    /// bound, or another quantity, determines the friction.
    pub fn told(&self, found: Found<'s>, is_minimum: bool) -> Result<Optimum, OptimumError> {
        let Found {
            band,
            range,
            mut least,
        } = found;
        band.watch.set(None);
        let stopped = band.stopped.replace(false);
        band.allow(WORK_OF_A_REPORT);
        let own = self.band(Goal::one(self.objective));
        own.watch.set(None);
        let largest = |friction| {
            let look = own.look(friction, Merit::WORST, Closely::Grid);
            look.merit.value
        };
        let without_friction = largest(FrictionAmount::Ratio(0.0));
        if without_friction == 0.0 && self.objective.size != MotionQuantity::Force {
            return Err(OptimumError::AtRest);
        }
        let with_contact_locked = largest(FrictionAmount::Locked);
        let kind = if is_minimum {
            self.kind(&band, range, &mut least)
        } else {
            OptimumKind::SinglePeak
        };
        let beta = least.at.beta;
        let peaks = peaks(&band, &least.at);
        let beyond_jump = (kind == OptimumKind::SinglePeak && is_minimum)
            .then(|| beyond(&band, &least.at, &peaks))
            .flatten();
        let end = match least.end {
            SearchEnd::Spent if stopped => OptimumEnd::Stopped,
            SearchEnd::Spent => OptimumEnd::WorkSpent,
            SearchEnd::Unconfirmed => OptimumEnd::Unconfirmed,
            SearchEnd::Converged if beyond_jump.is_some() => OptimumEnd::Jump,
            SearchEnd::Converged => OptimumEnd::Converged,
        };
        // If the search has reached its bound on work, its frictions are not checked. An interval between two such
        // frictions would not be reliable.
        let checked = EXCESSES
            .iter()
            .filter(|_| is_minimum && least.end != SearchEnd::Spent);
        let tolerances = checked.map_while(|excess| {
            let [from, to] = band.tolerance(&least, range, *excess);
            let excess = *excess;
            (!band.is_spent()).then_some(Tolerance { excess, from, to })
        });
        let tolerances = tolerances.collect();
        let sensitivities = match end {
            OptimumEnd::Converged if is_minimum => self.sensitivities(beta, &peaks),
            _ => None,
        };
        Ok(Optimum {
            beta,
            amplitude: least.at.merit.value,
            reference: self.system.angular_frequency(1.0),
            kind,
            end,
            bracket: least.bracket,
            beyond_jump,
            tolerances,
            peaks,
            unbounded_to: self.unbounded_to(),
            free_of_sticking: range.free_to,
            locked: range.locked_from,
            without_friction,
            with_contact_locked,
            sensitivities: sensitivities.unwrap_or_default(),
            evaluations: band.asked.get(),
            unsettled: least.at.unsettled,
            unanswered: band.silent.get(),
        })
    }

    /// Returns the reason why the friction is the best one. On an interval of friction with the same amplitude, this
    /// function moves the result to the lower bound of the interval.
    fn kind(&self, band: &Band<'_>, range: Range, least: &mut Least) -> OptimumKind {
        let value = least.at.merit.value;
        let mut highest = least.at.peaks.iter();
        let is_stuck = highest
            .next()
            .is_none_or(|peak| peak.regime == Regime::Stuck);
        if least.at.beta > 0.0 && (is_stuck || value == 0.0) {
            let level = least.at.merit.times(1.0 + STATIONARY * STATIONARY);
            let checked = |beta: f64| {
                let unanswered = band.silent.get();
                let check = band.check(beta, level, WORK_OF_A_CHECK);
                (band.silent.get() == unanswered, check)
            };
            // The motion from rest may stick at the smallest friction at which all contacts can stick.
            if range.locked_from < least.at.beta
                && let (true, check) = checked(range.locked_from)
                && check.complete
            {
                let merit = least.at.merit;
                least.at = Look { merit, ..check };
            }
            let mut to = least.at.beta;
            // The tolerance follows only known peaks. A check of the whole band may find a higher peak at its bound.
            for _ in 0..MOST_EDGES {
                let from;
                [from, to] = band.tolerance(least, range, 0.0);
                if least.at.beta <= from || band.is_spent() {
                    break;
                }
                let (is_answered, check) = checked(from);
                if check.complete && is_answered {
                    let merit = least.at.merit;
                    least.at = Look { merit, ..check };
                    break;
                }
                let merit = Merit {
                    value: f64::INFINITY,
                    ..check.merit
                };
                let merit = if check.complete { merit } else { check.merit };
                insert(&mut least.scan, Look { merit, ..check });
            }
            let beta = least.at.beta;
            least.bracket = [beta, to.max(beta)];
            if band.evaluator.locks() && range.locked_from <= beta {
                let rests = value == 0.0 || self.objective.rests_if_stuck(self.system);
                return if rests {
                    OptimumKind::Trivial
                } else {
                    OptimumKind::Stuck
                };
            }
            if value > 0.0 && beta * (1.0 + WIDE) < to {
                return OptimumKind::Flat;
            }
            least.bracket = [beta; 2];
        }
        let rests = self.objective.rests_if_stuck(self.system);
        if value == 0.0 || (rests && range.locked_from <= least.at.beta) {
            OptimumKind::Trivial
        } else if least.at.beta == 0.0 {
            OptimumKind::NoFriction
        } else if let Some(two) = band.crossing(&least.at) {
            // The two peaks of equal height come first.
            let rank = |peak: &BandPeak| two.iter().position(|one| one.r == peak.r).unwrap_or(2);
            least.at.peaks.sort_by_key(rank);
            OptimumKind::EqualPeaks
        } else {
            OptimumKind::SinglePeak
        }
    }

    /// Returns the relative derivatives d ln X/d ln p of the best amplitude X with respect to each parameter p. For one
    /// peak they are the derivatives of the peak. For two equal peaks they are the derivatives of the common height,
    /// while the friction changes so that the peaks stay equal.
    fn sensitivities(&self, beta: f64, peaks: &[OptimumPeak]) -> Option<Vec<(Parameter, f64)>> {
        if !self.objective.has_derivatives() || self.joined.is_some() {
            return None;
        }
        let (system, load) = (self.system, self.load?);
        let friction = system.load_scale(load).ok()?.friction(beta);
        let of = |peak: &OptimumPeak| {
            let hertz = system.hertz(peak.r);
            let point = OperatingPoint::Physical {
                hertz,
                friction,
                load,
            };
            system.response_sensitivities(point, self.objective.of).ok()
        };
        let all = peaks.iter().map(of).collect::<Option<Vec<_>>>()?;
        let relative = |of: &ResponseSensitivities, parameter: Parameter| {
            let mut found = of.parameters.iter();
            let found = found.find(|of| of.parameter == parameter)?;
            found.amplitude.relative(found.value)
        };
        let weights = match all.as_slice() {
            [_] => vec![1.0],
            [a, b] => {
                let [a, b] = [a, b].map(|of| relative(of, Parameter::Friction));
                let (a, b) = (a?, b?);
                vec![b / (b - a), -a / (b - a)]
            }
            _ => return None,
        };
        let parameters = all.first()?.parameters.iter().map(|of| of.parameter);
        let kept = parameters
            .filter(|parameter| !matches!(parameter, Parameter::Friction | Parameter::Frequency));
        let derivatives = kept.map(|parameter| {
            let parts = weights.iter().zip(&all);
            let parts = parts.map(|(weight, all)| Some(weight * relative(all, parameter)?));
            Some((parameter, parts.sum::<Option<f64>>()?))
        });
        derivatives.collect()
    }
}

/// Checks a request for a scene with one contact.
fn check_single(system: &System, objective: &Objective) -> Result<(), OptimumError> {
    if !objective.is_sound() {
        return Err(OptimumError::Size);
    }
    let modal = system.modal();
    let constants = modal.damping_ratios.iter().zip(&modal.loads);
    let mut constants = constants.zip(&modal.contacts);
    let lost = constants
        .position(|((zeta, load), contact)| zeta.is_zero() && contact.is_zero() && !load.is_zero());
    lost.map_or(Ok(()), |mode| Err(OptimumError::Undamped(mode)))
}

/// Checks a request for a scene with several contacts or dashpots, and returns its solver.
fn checked<'s>(
    system: &'s System,
    objective: &Objective,
    load: Option<Load>,
    r: f64,
) -> Result<Joined<'s>, OptimumError> {
    if Combination::of(system.scene(), objective.of, objective.size).is_none() {
        return Err(OptimumError::OnlyMotions);
    }
    let joined = system.joined()?;
    match load.map(|load| system.load_scale(load)).transpose()? {
        Some(scale) => joined.with_length(scale.length()).at_any(r)?,
        None => joined.at_any(r)?,
    };
    Ok(joined)
}

/// Returns the peaks that are as high as the highest peak, within a thousandth.
fn peaks(band: &Band<'_>, at: &Look) -> Vec<OptimumPeak> {
    let equal = at.peaks.iter();
    let equal = equal.filter(|peak| at.merit.value * (1.0 - NEARLY_EQUAL) <= peak.value);
    // A stuck contact may move with the base at all frequencies of a range. One peak then represents the range. One peak
    // also represents a peak whose top is uneven.
    let mut separate: Vec<&BandPeak> = Vec::new();
    for peak in equal {
        let is_same = |other: &&BandPeak| {
            let stuck = [peak, *other]
                .iter()
                .all(|peak| peak.regime == Regime::Stuck);
            stuck || (peak.r - other.r).abs() <= SEPARATE * peak.r
        };
        if !separate.iter().any(is_same) {
            separate.push(peak);
        }
    }
    let told = separate.into_iter().take(8).map(|peak| {
        let moves = peak.regime != Regime::Stuck && 0.0 < at.beta;
        OptimumPeak {
            r: peak.r,
            amplitude: peak.value,
            regime: peak.regime,
            at_end: peak.edge,
            slope: moves.then(|| band.slope(at.beta, peak)).flatten(),
        }
    });
    told.collect()
}

/// Returns the largest amplitude just beyond a jump at the best friction. Returns `None` if the amplitude does not jump.
fn beyond(band: &Band<'_>, at: &Look, peaks: &[OptimumPeak]) -> Option<f64> {
    let slope = peaks.first().and_then(|peak| peak.slope);
    if slope.is_some_and(|slope| (slope * at.beta).abs() <= STATIONARY * at.merit.value) {
        return None;
    }
    let sides = [1.0 - BESIDE, 1.0 + BESIDE].map(|share| {
        let friction = FrictionAmount::Ratio(share * at.beta);
        band.look(friction, Merit::WORST, Closely::Grid).merit.value
    });
    let most = sides.into_iter().fold(0.0, f64::max);
    (at.merit.value * (1.0 + NEARLY_EQUAL) < most).then_some(most)
}
