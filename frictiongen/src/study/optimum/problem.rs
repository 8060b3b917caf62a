//! A checked request for the best friction, and the complete result for a friction.

use super::amplitude::{FrictionAmount, KeepGoing};
use super::answer::{Optimum, OptimumEnd, OptimumKind, OptimumPeak};
use super::flat;
use super::objective::Objective;
use super::peaks::AmplitudeBand;
use super::request::{FrequencyBand, OptimumError, OptimumRequest};
use super::scan::{self, Scanned};
use super::search::{self, Least, MinimumKind, SearchEnd};
use crate::Regime;
use crate::study::parameter::{OperatingPoint, Parameter, Slope};
use crate::study::physical::ResponseSensitivities;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::{Load, angular_frequency};

/// Bound on the work of completing the result of a search for the best friction, in units of about 10 µs of computing
/// time.
const WORK_OF_A_REPORT: usize = 60_000;
/// Excesses (amplitude − best amplitude)/best amplitude for which the result has an interval of friction.
const EXCESSES: [f64; 3] = [0.01, 0.05, 0.1];
/// Largest relative difference between a peak and the highest peak at which both count as equally high.
const EQUAL: f64 = 1e-9;

/// A request for the best friction after all checks, with the system and the band of frequencies.
pub(super) struct OptimumProblem<'s> {
    pub system: &'s System,
    pub objective: Objective,
    pub load: Option<Load>,
    /// Lower and upper bound of the band, as frequency ratios r.
    pub ends: [f64; 2],
    watch: Option<KeepGoing<'s>>,
}

impl<'s> OptimumProblem<'s> {
    pub(super) fn new(system: &'s System, request: &OptimumRequest) -> Result<Self, OptimumError> {
        system
            .single()
            .map_err(|_| OptimumError::Load(crate::study::units::LoadError::SeveralContacts))?;
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
        let fall = request.load.map_or(0, |load| load.fall());
        let (of, size) = (request.of, request.size);
        if !system.has_motion(of) {
            return Err(OptimumError::NoSuchMotion(of));
        }
        let objective = Objective { of, size, fall };
        if !objective.is_sound() {
            return Err(OptimumError::Size);
        }
        let modal = system.modal();
        let constants = modal.damping_ratios.iter().zip(&modal.loads);
        let mut constants = constants.zip(&modal.contacts);
        let lost = constants.position(|((zeta, load), contact)| {
            zeta.is_zero() && contact.is_zero() && !load.is_zero()
        });
        if let Some(mode) = lost {
            return Err(OptimumError::Undamped(mode));
        }
        if let Some(load) = request.load {
            system.load_scale(load)?;
        }
        Ok(Self {
            system,
            objective,
            load: request.load,
            ends,
            watch: None,
        })
    }

    /// Sets the caller's function that can stop every search of this problem.
    pub(super) fn watched_by(self, watch: Option<KeepGoing<'s>>) -> Self {
        Self { watch, ..self }
    }

    pub(super) fn band(&self) -> AmplitudeBand<'s> {
        let band = AmplitudeBand::new(self.system, self.objective, self.ends);
        band.amplitude.watched_by(self.watch);
        band
    }

    /// Returns the friction with which the largest amplitude is smallest. The search covers all frictions, within a
    /// bound on work.
    pub(super) fn least(band: &AmplitudeBand<'_>, work: usize) -> Result<Least, OptimumError> {
        search::least(band, work).ok_or_else(|| {
            if band.amplitude.is_stopped() {
                OptimumError::Stopped
            } else if band.amplitude.is_spent() {
                OptimumError::TooLong
            } else {
                OptimumError::Unbounded
            }
        })
    }

    pub(super) fn solved(&self, work: usize) -> Result<Optimum, OptimumError> {
        let band = self.band();
        let least = Self::least(&band, work)?;
        self.told(&band, &least)
    }

    /// Returns the complete result for a friction: peaks, limits, intervals of friction and derivatives.
    pub(super) fn told(
        &self,
        band: &AmplitudeBand<'_>,
        least: &Least,
    ) -> Result<Optimum, OptimumError> {
        let stopped = band.amplitude.end_watch();
        let largest = |friction: FrictionAmount| {
            let peaks = band.peaks(friction);
            peaks.first().map_or(f64::NAN, |peak| peak.value)
        };
        let without_friction = largest(FrictionAmount::Ratio(0.0));
        if without_friction == 0.0 && self.objective.size != MotionQuantity::Force {
            return Err(OptimumError::AtRest);
        }
        let beta = least.at.beta;
        band.amplitude.allow(WORK_OF_A_REPORT);
        let locked = band.amplitude.locks() && least.locked_from <= beta;
        let friction = if least.kind == MinimumKind::Held && locked {
            FrictionAmount::Locked
        } else {
            FrictionAmount::Ratio(beta)
        };
        let peaks = equal_peaks(band, (&least.at, least.kind), friction);
        let smooth = self.objective.has_derivatives();
        let sensitivities = match least.end {
            SearchEnd::Converged if smooth => self.sensitivities(beta, &peaks).unwrap_or_default(),
            // Derivatives exist only for a minimum that moves smoothly with a parameter. A minimum at a jump of the
            // amplitude has no derivatives.
            _ => Vec::new(),
        };
        // If the search has reached its bound on work, its friction ratios are not verified. An interval between two
        // such friction ratios would not be reliable.
        let verified = EXCESSES.iter().filter(|_| least.end != SearchEnd::Spent);
        let tolerances = verified
            .map(|excess| flat::tolerance(band, least, *excess))
            .collect();
        let with_contact_locked = largest(FrictionAmount::Locked);
        let beyond_jump = (least.end == SearchEnd::Jump)
            .then(|| beyond(band, least))
            .flatten();
        Ok(Optimum {
            beta,
            amplitude: least.at.value,
            reference: self.system.angular_frequency(1.0),
            kind: match least.kind {
                MinimumKind::Held
                    if self.objective.rests_if_stuck(self.system) && least.locked_from <= beta =>
                {
                    OptimumKind::Trivial
                }
                MinimumKind::Held | MinimumKind::Without if least.at.value == 0.0 => {
                    OptimumKind::Trivial
                }
                MinimumKind::Crossing => OptimumKind::EqualPeaks,
                MinimumKind::Smooth => OptimumKind::SinglePeak,
                MinimumKind::Without => OptimumKind::NoFriction,
                MinimumKind::Held => OptimumKind::Stuck,
            },
            end: match least.end {
                SearchEnd::Converged => OptimumEnd::Converged,
                SearchEnd::Jump => OptimumEnd::Jump,
                SearchEnd::Spent if stopped => OptimumEnd::Stopped,
                SearchEnd::Spent => OptimumEnd::WorkSpent,
            },
            bracket: least.bracket,
            beyond_jump,
            tolerances,
            peaks,
            unbounded_to: scan::unbounded_to(band),
            free_of_sticking: least.free_to,
            locked: least.locked_from,
            without_friction,
            with_contact_locked,
            sensitivities,
            evaluations: band.amplitude.asked.get(),
            unanswered: band.amplitude.silent.get(),
        })
    }

    /// Returns the relative derivatives d ln X/d ln p of the best amplitude X with respect to each parameter p. For one
    /// peak they are the derivatives of the peak. For two equal peaks they are the derivatives of the common height,
    /// while the friction changes so that the peaks stay equal.
    fn sensitivities(&self, beta: f64, peaks: &[OptimumPeak]) -> Option<Vec<(Parameter, f64)>> {
        let all = self.slopes(self.load?, beta, peaks)?;
        let weights = weights(&all)?;
        let parameters = all.first()?.parameters.iter().map(|of| of.parameter);
        let kept = parameters
            .filter(|parameter| !matches!(parameter, Parameter::Friction | Parameter::Frequency));
        kept.map(|parameter| {
            let parts = weights.iter().zip(&all);
            let parts = parts.map(|(weight, all)| {
                let (value, slope) = slope(all, parameter)?;
                Some(weight * slope.relative(value)?)
            });
            Some((parameter, parts.sum::<Option<f64>>()?))
        })
        .collect()
    }

    /// Returns the derivatives of the amplitude at each peak with respect to all parameters, under a load.
    pub(super) fn slopes(
        &self,
        load: Load,
        beta: f64,
        peaks: &[OptimumPeak],
    ) -> Option<Vec<ResponseSensitivities>> {
        let system = self.system;
        let scale = system.load_scale(load).ok()?;
        let of = |peak: &OptimumPeak| {
            let point = OperatingPoint::Physical {
                hertz: system.hertz(peak.r),
                friction: scale.friction(beta),
                load,
            };
            system.response_sensitivities(point, self.objective.of).ok()
        };
        peaks.iter().map(of).collect()
    }
}

/// Returns the largest amplitude at the two bounds of the interval (bracket) that contains the best friction. Returns
/// `None` if this amplitude does not exceed the best amplitude. Otherwise one of the bounds is beyond the jump.
fn beyond(band: &AmplitudeBand<'_>, least: &Least) -> Option<f64> {
    let others = least
        .bracket
        .into_iter()
        .filter(|beta| *beta != least.at.beta);
    let values = others.map(|beta| scan::scanned_at(band, beta, f64::INFINITY).value);
    let most = values.fold(f64::NAN, f64::max);
    (least.at.value < most).then_some(most)
}

/// Returns two results: the value of `parameter`, and a peak's amplitude with its derivative with respect to
/// `parameter`.
pub(super) fn slope(of: &ResponseSensitivities, parameter: Parameter) -> Option<(f64, Slope)> {
    let mut found = of.parameters.iter();
    let found = found.find(|of| of.parameter == parameter)?;
    Some((found.value, found.amplitude))
}

/// Returns the weight of each peak in the derivative of the common height of two equal peaks. For this derivative, the
/// friction changes so that the peaks stay equal. A single peak has the weight 1.
pub(super) fn weights(all: &[ResponseSensitivities]) -> Option<Vec<f64>> {
    let along_friction = |of: &ResponseSensitivities| {
        let (value, slope) = slope(of, Parameter::Friction)?;
        slope.relative(value)
    };
    match all {
        [_] => Some(vec![1.0]),
        [a, b] => {
            let (a, b) = (along_friction(a)?, along_friction(b)?);
            Some(vec![b / (b - a), -a / (b - a)])
        }
        _ => None,
    }
}

/// Returns the peaks that are as high as the highest peak to rounding.
pub(super) fn equal_peaks(
    band: &AmplitudeBand<'_>,
    (at, kind): (&Scanned, MinimumKind),
    friction: FrictionAmount,
) -> Vec<OptimumPeak> {
    // A stuck contact may move with the base at all frequencies of a range. The amplitude is then the same in the whole
    // range, and one peak represents the range.
    let most = if kind == MinimumKind::Held { 1 } else { 8 };
    let equal = at.peaks.iter();
    let equal = equal.filter(|peak| at.value * (1.0 - EQUAL) <= peak.value);
    equal
        .take(most)
        .map(|peak| {
            let regime = band.amplitude.regime(peak.r, friction);
            let slope = scan::slope(band, at.beta, peak);
            OptimumPeak {
                r: peak.r,
                amplitude: peak.value,
                regime,
                at_end: peak.edge,
                slope: (slope.is_finite() && regime != Regime::Stuck).then_some(slope),
            }
        })
        .collect()
}
