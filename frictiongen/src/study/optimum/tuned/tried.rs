//! The best friction at one value of a number of the scene description, and the derivative of the best amplitude with
//! respect to that number.

use super::answer::Tuning;
use crate::Of;
use crate::study::optimum::amplitude::{FrictionAmount, KeepGoing};
use crate::study::optimum::peaks::AmplitudeBand;
use crate::study::optimum::problem::{OptimumProblem, equal_peaks, slope, weights};
use crate::study::optimum::search::{self, Least, MinimumKind};
use crate::study::optimum::{FrequencyBand, Optimum, OptimumError, OptimumRequest};
use crate::study::parameter::Parameter;
use crate::study::response::MotionQuantity;
use crate::study::system::System;
use crate::study::units::{Load, angular_frequency};
use frictiongen_model::scene::Excitation;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Largest relative slope of a peak, over frequency or friction, at which the peak counts as stationary. If the peak
/// is steeper, the code computes no exact derivative with respect to the varied number.
const STATIONARY: f64 = 1e-4;
/// Step of a finite difference with respect to the number, divided by the number's value.
const DIFFERENCE: f64 = 1e-5;
/// Smallest margin of the searched interval of friction beyond the best frictions of both neighbouring values, divided
/// by the larger of these frictions.
const MARGIN: f64 = 1e-3;

/// A checked request for the best friction together with one number of the scene description.
pub(super) struct TunedSearch<'s> {
    pub(super) described: &'s System,
    pub(super) request: &'s OptimumRequest,
    pub(super) tuning: Tuning,
    pub(super) asked: AtomicUsize,
    pub(super) watch: Option<KeepGoing<'s>>,
}

/// The best friction at one value of the varied number.
#[derive(Clone, Debug)]
pub(super) struct Tried {
    pub value: f64,
    pub amplitude: f64,
    /// Derivative of the best amplitude with respect to the varied number of the scene description. It is NaN if the
    /// derivative is not known.
    pub slope: f64,
    /// Best friction ratio β, with m₁ and k₁ of the scene description.
    pub beta: f64,
    /// Frequency ratios r of the peaks, with m₁ and k₁ of the scene description.
    pub peaks: Vec<f64>,
    pub found: Option<Least>,
}

/// Factors that convert the non-dimensional groups r, β and x̄ of the varied scene to those of the original scene. The
/// two scenes may have different m₁ and k₁.
#[derive(Clone, Copy, Debug)]
pub(super) struct GroupRatios {
    pub r: f64,
    pub beta: f64,
    pub length: f64,
}

impl GroupRatios {
    pub(super) fn new(request: &OptimumRequest, described: &System, varied: &System) -> Self {
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

    pub(super) fn of(&self, mut optimum: Optimum) -> Optimum {
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

impl<'s> TunedSearch<'s> {
    pub(super) fn new(
        described: &'s System,
        request: &'s OptimumRequest,
        tuning: Tuning,
    ) -> Result<Self, OptimumError> {
        let Tuning { of, from, to } = tuning;
        if !(from.is_finite() && to.is_finite() && from < to) {
            return Err(OptimumError::Interval);
        }
        for end in [from, to] {
            described.with_value(of, end).map_err(OptimumError::Scene)?;
        }
        // The error `Undamped` depends on the value of the number. All other faults of a request are the same for every
        // value of the number.
        if let Err(error) = OptimumProblem::new(described, request)
            && !matches!(error, OptimumError::Undamped(_))
        {
            return Err(error);
        }
        Ok(Self {
            described,
            request,
            tuning,
            asked: AtomicUsize::new(0),
            watch: None,
        })
    }

    /// Sets the caller's function that can stop the search.
    pub(super) fn watched_by(self, watch: KeepGoing<'s>) -> Self {
        let watch = Some(watch);
        Self { watch, ..self }
    }

    /// Returns true if the caller has not stopped the search.
    pub(super) fn goes_on(&self) -> bool {
        self.watch.is_none_or(|watch| watch())
    }

    pub(super) fn count(&self, asked: usize) {
        self.asked.fetch_add(asked, Ordering::Relaxed);
    }

    pub(super) fn with(&self, value: f64) -> Result<System, OptimumError> {
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

    /// Returns the request with the same band of frequencies in Hz, but as frequency ratios r of the varied scene.
    pub(super) fn request_for(&self, varied: &System) -> OptimumRequest {
        let groups = GroupRatios::new(self.request, self.described, varied);
        let ratio = |r: f64| r / groups.r;
        let hertz = |hertz: f64| ratio(self.described.frequency_ratio(angular_frequency(hertz)));
        let band = match self.request.band {
            FrequencyBand::Ratio(from, to) => FrequencyBand::Ratio(ratio(from), ratio(to)),
            FrequencyBand::Hertz(from, to) => FrequencyBand::Ratio(hertz(from), hertz(to)),
        };
        OptimumRequest {
            band,
            ..self.request.clone()
        }
    }

    /// Returns the requested load, or a load of amplitude 1. The optimum does not depend on this amplitude.
    fn load(&self) -> Load {
        self.request
            .load
            .unwrap_or(match self.described.scene().excitation {
                Excitation::Base => Load::Base(1.0),
                Excitation::Force(_) => Load::Force(1.0),
            })
    }

    /// Returns the best friction at a value of the number. The search covers all frictions, or only the interval
    /// `window` of friction ratios.
    pub(super) fn tried(
        &self,
        value: f64,
        window: Option<[f64; 2]>,
    ) -> Result<Tried, OptimumError> {
        let mut tried = self.height(value, window)?;
        if tried.amplitude.is_finite() && tried.slope.is_nan() {
            let Tuning { from, to, .. } = self.tuning;
            let h = DIFFERENCE * value.abs().max(1e-3 * (to - from));
            let [a, b] = [(value - h).max(from), (value + h).min(to)];
            let near = Some(near(&tried, &tried));
            let [below, above] = [a, b].map(|value| self.height(value, near));
            tried.slope = (above?.amplitude - below?.amplitude) / (b - a);
        }
        Ok(tried)
    }

    /// Returns the best friction at a value of the number, without a derivative from finite differences. The slope is
    /// NaN if no exact derivative exists.
    fn height(&self, value: f64, window: Option<[f64; 2]>) -> Result<Tried, OptimumError> {
        let mut tried = Tried {
            value,
            amplitude: f64::INFINITY,
            slope: f64::NAN,
            beta: f64::NAN,
            peaks: Vec::new(),
            found: None,
        };
        let varied = self.with(value)?;
        let problem = match OptimumProblem::new(&varied, &self.request_for(&varied)) {
            Err(OptimumError::Undamped(_)) => return Ok(tried),
            problem => problem?.watched_by(self.watch),
        };
        let groups = GroupRatios::new(self.request, self.described, &varied);
        let band = problem.band();
        let found = window
            .and_then(|window| search::near(&band, window.map(|beta| beta / groups.beta)))
            .map_or_else(|| OptimumProblem::least(&band, search::WORK_OF_ONE), Ok);
        self.count(band.amplitude.asked.get());
        let least: Least = match found {
            Err(OptimumError::Unbounded) => return Ok(tried),
            Err(OptimumError::TooLong | OptimumError::Stopped) => {
                tried.amplitude = f64::NAN;
                return Ok(tried);
            }
            found => found?,
        };
        if band.amplitude.is_stopped() {
            // A search that the caller stopped may have missed the largest peak. The amplitude of this search is then
            // only a lower bound.
            tried.amplitude = f64::NAN;
            return Ok(tried);
        }
        tried.amplitude = least.at.value * groups.length;
        tried.beta = least.at.beta * groups.beta;
        tried.peaks = {
            let equal = least.at.peaks.iter();
            let equal = equal.filter(|peak| least.at.value * (1.0 - 1e-9) <= peak.value);
            equal.map(|peak| peak.r * groups.r).collect()
        };
        tried.slope = self.slope(&problem, &band, &least).unwrap_or(f64::NAN);
        tried.found = Some(least);
        Ok(tried)
    }

    /// Returns the derivative of the best amplitude with respect to the number, while the friction stays the best.
    fn slope(
        &self,
        problem: &OptimumProblem<'_>,
        band: &AmplitudeBand<'_>,
        least: &Least,
    ) -> Option<f64> {
        let held = least.kind == MinimumKind::Held;
        let beta = least.at.beta;
        let peaks = equal_peaks(band, (&least.at, least.kind), FrictionAmount::Ratio(beta));
        // If the contact is stuck, more friction does not change the response. With twice the friction, the regime is
        // certain in spite of rounding.
        let beta = if held && least.locked_from <= beta {
            2.0 * beta
        } else {
            beta
        };
        if !problem.objective.has_derivatives() {
            return None;
        }
        let load = self.load();
        let all = problem.slopes(load, beta, &peaks)?;
        let relative = |which: usize, parameter: Parameter| {
            let (value, slope) = slope(all.get(which)?, parameter)?;
            slope.relative(value)
        };
        for (which, peak) in peaks.iter().enumerate() {
            if !peak.at_end && STATIONARY < relative(which, Parameter::Frequency)?.abs() {
                return None;
            }
        }
        let weights = weights(&all)?;
        match weights.as_slice() {
            // The slope of a single peak with respect to friction must be 0 at the minimum of the peak. Otherwise the
            // minimum is at a jump and has no derivative.
            [_] if least.kind == MinimumKind::Smooth => {
                if STATIONARY < relative(0, Parameter::Friction)?.abs() {
                    return None;
                }
            }
            [_] => {}
            // At a crossing, one peak falls with more friction and the second peak rises. The two weights are then
            // positive.
            weights if weights.iter().all(|weight| 0.0 <= *weight) => {}
            _ => return None,
        }
        let mut sum = 0.0;
        for quantity in self.tuning.of.quantities(problem.system.scene()) {
            for (weight, all) in weights.iter().zip(&all) {
                sum += weight * slope(all, Parameter::Quantity(quantity))?.1.derivative;
            }
        }
        let unit = self.described.load_scale(load).ok()?.length();
        Some(sum / unit)
    }
}

/// Returns the interval of friction that the search covers for a value of the number between two known values.
pub(super) fn near(below: &Tried, above: &Tried) -> [f64; 2] {
    let [low, high] = [below.beta.min(above.beta), below.beta.max(above.beta)];
    let margin = (0.25 * (high - low)).max(MARGIN * high);
    [(low - margin).max(0.0), high + margin]
}
