//! A checked request for the best friction, and the complete result for a friction.

use super::answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak, Tolerance};
use super::band::{Band, BandPeak, Closely, KeepGoing, Look, Merit};
use super::evaluator::{Evaluator, FrictionAmount, Goal, OneContact, Quotient, SeveralContacts};
use super::objective::Objective;
use super::request::{FrequencyBand, OptimumError, OptimumOptions, OptimumRequest, QuantityValue};
use super::search::{Least, NEARLY_EQUAL, Range, SearchEnd, insert};
use crate::Regime;
use crate::study::joined::Joined;
use crate::study::parameter::{OperatingPoint, Parameter};
use crate::study::physical::ResponseSensitivities;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::{Load, angular_frequency};

/// Default bound on the work of a search for the best friction, in units of about 10 µs of computing time. With several
/// quantities the bound is this number times [`SEVERAL`].
const WORK: usize = 1_200_000;
const SEVERAL: usize = 4;
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
/// Largest relative difference at which two quotients count as equal.
const BALANCE: f64 = 1e-3;
/// A bound counts as reached if the quantity, divided by its bound, is at least this number.
const DECISIVE: f64 = 1.0 - 1e-6;
/// The search aims at bounds that are smaller by this fraction. Rounding and a finer grid then do not lift a quantity above
/// its bound.
const BELOW: f64 = 5e-7;

/// A request for the best friction after all checks, with the system and the band of frequencies.
pub(super) struct OptimumProblem<'s> {
    system: &'s System,
    /// The minimised quantities with their divisors, and the bounded quantities with their bounds.
    goal: Goal,
    /// True if the request has quantities with divisors.
    is_weighted: bool,
    /// The solver of a scene with several contacts or dashpots.
    joined: Option<Joined<'s>>,
    load: Option<Load>,
    /// Lower and upper bound of the band, as frequency ratios r.
    ends: [f64; 2],
    /// Bound on the work of a search over all frictions.
    pub work: usize,
    watch: Option<KeepGoing<'s>>,
}

/// The best friction with the band of frequencies in which the search has found it.
pub(super) struct Found<'s> {
    pub band: Band<'s>,
    range: Range,
    pub least: Least,
    /// True if a bound excluded a better friction.
    is_bounded: bool,
    /// Largest value over the band of each bounded quantity.
    largest: Vec<f64>,
}

impl Found<'_> {
    /// Returns true if this friction is better than another one.
    pub fn is_better_than(&self, other: &Self) -> bool {
        self.least.at.merit < other.least.at.merit
    }

    /// Returns this friction with the scan and the number of evaluations of another search.
    pub fn with_scan_of(mut self, other: Self) -> Self {
        let asked = other.band.asked.get();
        self.band.asked.set(self.band.asked.get() + asked);
        self.least.scan = other.least.scan;
        self
    }
}

impl<'s> OptimumProblem<'s> {
    /// Checks a request. The problem does not take over the function `watch` of the options.
    pub fn new(
        system: &'s System,
        request: &OptimumRequest,
        options: &OptimumOptions<'_>,
    ) -> Result<Self, OptimumError> {
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
        let valid = |one: &QuantityValue| 0.0 < one.value && one.value.is_finite();
        if !options.weighted.iter().all(valid) {
            return Err(OptimumError::Weight);
        }
        let is_weighted = !options.weighted.is_empty();
        if is_weighted && !(options.kept.is_empty() && options.vary.is_empty()) {
            return Err(OptimumError::SingleQuantity);
        }
        let (of, size, value) = (request.of, request.size, 1.0);
        let own = [QuantityValue { of, size, value }];
        let minimised = if is_weighted { options.weighted } else { &own };
        let fall = request.load.map_or(0, |load| load.fall());
        let quotients = |all: &[QuantityValue]| {
            let checked = all.iter().map(|one| -> Result<Quotient, OptimumError> {
                let (of, size) = (one.of, one.size);
                let objective = Objective { of, size, fall };
                check(system, &objective)?;
                Ok((objective, one.value))
            });
            checked.collect::<Result<Vec<_>, _>>()
        };
        let goal = Goal {
            minimised: quotients(minimised)?,
            bounded: quotients(options.kept)?,
        };
        let scale = request.load.map(|load| system.load_scale(load));
        let scale = scale.transpose()?;
        let joined = match system.scene().has_joined_states() {
            true => Some(system.joined()?),
            false => None,
        };
        if let Some(joined) = &joined {
            match scale {
                Some(scale) => joined.with_length(scale.length()).at_any(from)?,
                None => joined.at_any(from)?,
            };
        }
        let several = is_weighted || !goal.bounded.is_empty();
        let work = if several { SEVERAL * WORK } else { WORK };
        Ok(Self {
            system,
            goal,
            is_weighted,
            joined,
            load: request.load,
            ends,
            work: options.work.unwrap_or(work),
            watch: None,
        })
    }

    /// Sets the caller's function that can stop every search of this problem.
    pub fn watched_by(self, watch: Option<KeepGoing<'s>>) -> Self {
        Self { watch, ..self }
    }

    /// Replaces the shares of several contacts.
    pub fn with_shares(self, shares: &[f64]) -> Self {
        let joined = self.joined.map(|joined| joined.with_shares(shares));
        Self { joined, ..self }
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

    /// Returns the goal under the first bounds of the list, with bounds that are slightly smaller.
    pub fn goal(&self, bounds: usize) -> Goal {
        let bounded = self.goal.bounded.iter().take(bounds);
        Goal {
            minimised: self.goal.minimised.clone(),
            bounded: bounded
                .map(|(objective, most)| (*objective, most * (1.0 - BELOW)))
                .collect(),
        }
    }

    /// Returns the friction ratio up to which the amplitude at an undamped resonance of the band is unbounded, or 0.
    fn unbounded_to(&self) -> f64 {
        let (system, [from, to]) = (self.system, self.ends);
        let zetas = system.modal().damping_ratios.iter();
        let modes = zetas.zip(system.resonances());
        let modes = modes.zip(system.resonance_thresholds());
        modes
            .filter(|((zeta, r), _)| zeta.is_zero() && from <= **r && **r <= to)
            .filter_map(|((_, r), threshold)| Some(threshold? / r.powi(self.goal.fall())))
            .fold(0.0, f64::max)
    }

    /// Finds the friction with which the goal is reached best, within a bound on work. `window` restricts the search to
    /// an interval of friction.
    fn minimum(
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
        Ok(Found {
            band,
            range,
            least,
            is_bounded: false,
            largest: Vec::new(),
        })
    }

    /// Finds the best friction without regard to the bounds.
    pub fn free(&self) -> Result<Found<'s>, OptimumError> {
        self.minimum(self.goal(0), self.work, None)
    }

    /// Finds the best friction that satisfies all bounds. `work` bounds the work of one search over all frictions.
    pub fn found(&self, work: usize, window: Option<[f64; 2]>) -> Result<Found<'s>, OptimumError> {
        let free = self.minimum(self.goal(0), work, window)?;
        if self.goal.bounded.is_empty() {
            return Ok(free);
        }
        self.go_on()?;
        let largest = self.largest(free.least.at.beta);
        if self.holds(&largest) {
            return Ok(Found { largest, ..free });
        }
        let found = match self.minimum(self.goal(usize::MAX), work, None) {
            Err(OptimumError::Unbounded) => return Err(self.unreachable(work)),
            found => found?,
        };
        self.go_on()?;
        let largest = self.largest(found.least.at.beta);
        if !self.holds(&largest) {
            let error = self.unreachable(work);
            self.go_on()?;
            return Err(error);
        }
        let is_bounded = true;
        Ok(Found {
            largest,
            is_bounded,
            ..found
        })
    }

    pub fn solved(&self) -> Result<Optimum, OptimumError> {
        self.told(self.found(self.work, None)?)
    }

    /// Evaluates the whole band of one quantity at one friction.
    fn whole(&self, objective: Objective, beta: f64) -> Look {
        let band = self.band(Goal::one(objective));
        band.check(beta, Merit::WORST, WORK_OF_A_CHECK)
    }

    /// Returns the largest value over the band of each bounded quantity.
    fn largest(&self, beta: f64) -> Vec<f64> {
        let bounded = self.goal.bounded.iter();
        bounded
            .map(|(objective, _)| self.whole(*objective, beta).merit.value)
            .collect()
    }

    fn holds(&self, largest: &[f64]) -> bool {
        let mut checked = largest.iter().zip(&self.goal.bounded);
        checked.all(|(largest, (_, most))| largest <= most)
    }

    /// Returns an error if the caller has stopped the search.
    fn go_on(&self) -> Result<(), OptimumError> {
        match self.watch.is_none_or(|watch| watch()) {
            true => Ok(()),
            false => Err(OptimumError::Stopped),
        }
    }

    /// Returns the error that names the first bound that no friction satisfies together with the bounds before it.
    fn unreachable(&self, work: usize) -> OptimumError {
        for (index, (objective, most)) in self.goal.bounded.iter().enumerate() {
            let goal = Goal {
                minimised: vec![(*objective, 1.0)],
                ..self.goal(index)
            };
            let beta = match self.minimum(goal, work, None) {
                Ok(found) => found.least.at.beta,
                Err(error) => return error,
            };
            let least = self.whole(*objective, beta).merit.value;
            if !(least <= *most) {
                let value = None;
                return OptimumError::Unreachable {
                    index,
                    least,
                    beta,
                    value,
                };
            }
        }
        OptimumError::TooLong
    }

    /// Returns the result of several quantities for the quantity with the largest quotient, with the index of this
    /// quantity. The third item is true if several quotients are equally large.
    fn decided(&self, found: Found<'s>) -> Result<(Found<'s>, usize, bool), OptimumError> {
        if !self.is_weighted {
            return Ok((found, 0, false));
        }
        self.go_on()?;
        let beta = found.least.at.beta;
        let all = self.goal.minimised.iter();
        let looks = all.map(|(objective, over)| (self.whole(*objective, beta), over));
        let looks: Vec<(Look, &f64)> = looks.collect();
        let largest = looks.iter().map(|(look, _)| look.merit.value).collect();
        let ratios = looks.iter().map(|(look, over)| look.merit.value / **over);
        let ratios: Vec<f64> = ratios.collect();
        let order = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let decisive = ratios.iter().enumerate().max_by(order);
        let (decisive, most) = decisive.ok_or(OptimumError::Weight)?;
        let equal = ratios
            .iter()
            .filter(|ratio| most * (1.0 - BALANCE) <= **ratio);
        let is_balanced = 1 < equal.count();
        let (at, _) = looks
            .into_iter()
            .nth(decisive)
            .ok_or(OptimumError::Weight)?;
        let band = self.band(Goal::one(self.objective(decisive)?));
        band.asked.set(found.band.asked.get());
        let least = Least { at, ..found.least };
        let found = Found {
            band,
            least,
            largest,
            ..found
        };
        Ok((found, decisive, is_balanced))
    }

    fn objective(&self, index: usize) -> Result<Objective, OptimumError> {
        let quotient = self.goal.minimised.get(index);
        Ok(quotient.ok_or(OptimumError::Weight)?.0)
    }

    /// Returns the complete result: peaks, limits, intervals of friction and derivatives.
    pub fn told(&self, found: Found<'s>) -> Result<Optimum, OptimumError> {
        let (found, decisive, is_balanced) = self.decided(found)?;
        let objective = self.objective(decisive)?;
        let Found {
            band,
            range,
            mut least,
            is_bounded,
            largest,
        } = found;
        band.watch.set(None);
        let stopped = band.stopped.replace(false);
        band.allow(WORK_OF_A_REPORT);
        let [without_friction, with_contact_locked] = self.extremes(objective)?;
        let mut kept = largest.iter().zip(&self.goal.bounded);
        let is_bounded = is_bounded && kept.any(|(largest, (_, most))| DECISIVE * most <= *largest);
        let kind = if is_bounded {
            least.bracket = [least.at.beta; 2];
            OptimumKind::Bounded
        } else if is_balanced {
            OptimumKind::Balanced
        } else {
            self.kind(&band, (range, objective), &mut least)
        };
        let is_minimum = !(is_bounded || is_balanced);
        let beta = least.at.beta;
        let peaks = peaks(&band, &least.at);
        let beyond_jump = (kind == OptimumKind::SinglePeak)
            .then(|| beyond(&band, &least.at, &peaks))
            .flatten();
        let end = match least.end {
            SearchEnd::Spent if stopped => OptimumEnd::Stopped,
            SearchEnd::Spent => OptimumEnd::WorkSpent,
            SearchEnd::Unconfirmed => OptimumEnd::Unconfirmed,
            SearchEnd::Converged if beyond_jump.is_some() => OptimumEnd::Jump,
            SearchEnd::Converged => OptimumEnd::Converged,
        };
        // Tolerances and sensitivities describe the minimum of a single quantity. If the search has reached its bound
        // on work, its frictions are not checked. An interval between two such frictions would not be reliable.
        let is_minimum = is_minimum && !self.is_weighted;
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
            OptimumEnd::Converged if is_minimum => self.sensitivities(objective, (beta, &peaks)),
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
            largest,
            decisive,
            tuned: Vec::new(),
            scan: Vec::new(),
            before: None,
        })
    }

    /// Returns the largest value of a quantity over the band without friction, and with all contacts stuck.
    fn extremes(&self, objective: Objective) -> Result<[f64; 2], OptimumError> {
        let band = self.band(Goal::one(objective));
        band.watch.set(None);
        let all = [FrictionAmount::Ratio(0.0), FrictionAmount::Locked];
        let largest = all.map(|friction| band.look(friction, Merit::WORST, Closely::Grid).merit);
        let largest = largest.map(|merit| merit.value);
        if largest.first() == Some(&0.0) && objective.size != MotionQuantity::Force {
            return Err(OptimumError::AtRest);
        }
        Ok(largest)
    }

    /// Returns the reason why the friction is the best one. On an interval of friction with the same amplitude, this
    /// function moves the result to the lower bound of the interval.
    fn kind(
        &self,
        band: &Band<'_>,
        (range, objective): (Range, Objective),
        least: &mut Least,
    ) -> OptimumKind {
        let rests = objective.rests_if_stuck(self.system);
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
                return if value == 0.0 || rests {
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
    fn sensitivities(
        &self,
        objective: Objective,
        (beta, peaks): (f64, &[OptimumPeak]),
    ) -> Option<Vec<(Parameter, f64)>> {
        if !objective.has_derivatives() || self.joined.is_some() {
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
            system.response_sensitivities(point, objective.of).ok()
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

/// Checks if the search can minimise a quantity of a scene.
fn check(system: &System, objective: &Objective) -> Result<(), OptimumError> {
    let scene = system.scene();
    if !system.has_motion(objective.of) {
        return Err(OptimumError::NoSuchMotion(objective.of));
    }
    if !objective.is_sound() {
        return Err(OptimumError::Size);
    }
    if scene.has_joined_states() {
        return Ok(());
    }
    let modal = system.modal();
    let constants = modal.damping_ratios.iter().zip(&modal.loads);
    let mut constants = constants.zip(&modal.contacts);
    let lost = constants
        .position(|((zeta, load), contact)| zeta.is_zero() && contact.is_zero() && !load.is_zero());
    lost.map_or(Ok(()), |mode| Err(OptimumError::Undamped(mode)))
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
