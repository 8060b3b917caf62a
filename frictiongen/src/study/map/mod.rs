//! Maps over frequency and friction: what the contact does at every point, and where that changes.

mod boundary;
mod lines;

pub use boundary::Boundary;
pub use lines::LimitLines;

use super::response::SystemResponse;
use super::system::System;
use crate::{Error, Limits, Of, OutOfDomain, Regime};
use rayon::prelude::*;

/// What is asked of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapRequest {
    /// The frequency ratios r.
    pub r: Vec<f64>,
    /// The friction ratios β.
    pub beta: Vec<f64>,
    /// Whose amplitudes.
    pub of: Vec<Of>,
}

/// What the contact does, as far as it can be counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pattern {
    /// The regime.
    pub regime: Regime,
    /// How often the contact stops in a period.
    pub stops: usize,
    /// How often it changes its direction of sliding in a period without a stop.
    pub reversals: usize,
    /// After how many cycles of the excitation the motion repeats; 0 where it does not settle.
    pub period: u32,
}

/// The response at one point of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPoint {
    /// What the contact does.
    pub pattern: Pattern,
    /// The part of the period for which it sticks.
    pub stuck_fraction: f64,
    /// Whether small deviations die.
    pub stable: bool,
    /// Whether the state is a member of a continuum, or at its end.
    pub marginal: bool,
    /// Whether motion from rest ends in it; false for another state, where motion from rest does not settle.
    pub from_rest: bool,
    /// The middle of the contact's motion, over P/k₁, for base motion over Y.
    pub offset: f64,
    /// The amplitudes asked for, in their order: over P/k₁, for base motion over Y.
    pub amplitudes: Vec<f64>,
    /// The amplitudes about each motion's own middle, in the same order.
    pub centred: Vec<f64>,
}

/// The responses at one frequency ratio.
#[derive(Clone, Debug)]
pub struct MapColumn {
    /// r.
    pub r: f64,
    /// Both limits there.
    pub limits: Limits<f64>,
    /// The response for each β, or why there is none.
    pub points: Vec<Result<MapPoint, Error>>,
}

/// Responses over frequency and friction.
#[derive(Clone, Debug)]
pub struct Map {
    /// The friction ratios β.
    pub beta: Vec<f64>,
    /// The columns that were computed, in the order of the request: all, unless it was cancelled.
    pub columns: Vec<MapColumn>,
}

impl Pattern {
    /// Of a response.
    #[must_use]
    pub fn of(response: &SystemResponse<'_>) -> Self {
        let (stops, reversals, period) = match response {
            // It turns twice.
            SystemResponse::Continuous(_) => (0, 2, 1),
            SystemResponse::StickSlip(orbit) if orbit.is_settled() => {
                (orbit.stops(), orbit.reversals(), orbit.period())
            }
            SystemResponse::StickSlip(_) => (0, 0, 0),
            SystemResponse::Stuck(_) => (0, 0, 1),
        };
        Self {
            regime: response.regime(),
            stops,
            reversals,
            period,
        }
    }
}

impl MapPoint {
    fn of(response: &SystemResponse<'_>, of: &[Of]) -> Option<Self> {
        let (stuck_fraction, stable, marginal) = match response {
            SystemResponse::Continuous(_) => (0.0, true, false),
            SystemResponse::StickSlip(orbit) => (
                orbit.stuck_fraction(),
                orbit.is_stable(),
                orbit.is_marginal(),
            ),
            SystemResponse::Stuck(_) => (1.0, true, true),
        };
        let amplitude = |of: &Of| Some(response.swing(*of)?.amplitude);
        Some(Self {
            pattern: Pattern::of(response),
            stuck_fraction,
            stable,
            marginal,
            from_rest: response.is_from_rest(),
            offset: response.offset(),
            amplitudes: of.iter().map(amplitude).collect::<Option<_>>()?,
            centred: of
                .iter()
                .map(|of| response.centred_amplitude(*of))
                .collect::<Option<_>>()?,
        })
    }
}

impl System {
    /// The response at every pair of a frequency ratio and a friction ratio, on all cores.
    ///
    /// Each point has the state that motion from rest ends in, as [`SystemAt::response`](super::SystemAt::response) gives it,
    /// whatever its neighbours are.  With μ > 1 other steady states may exist beside it.
    ///
    /// ```
    /// use frictiongen::study::MapRequest;
    /// use frictiongen::{Of, Regime, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    /// }"
    /// .parse()?;
    /// let grid = |step: f64, count: u32| (1..=count).map(|i| step * f64::from(i)).collect();
    /// let request = MapRequest { r: grid(0.1, 25), beta: grid(0.2, 20), of: vec![Of::Mass(0)] };
    /// let map = block.map(&request, |_| true)?;
    /// let stuck = map.points().filter(|(_, _, point)| {
    ///     point.as_ref().is_ok_and(|point| point.pattern.regime == Regime::Stuck)
    /// });
    /// // β ≥ r².
    /// assert_eq!(stuck.count(), 265);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// `go_on` is told after each column how many are done, from any thread; where it says `false` the rest is left out.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a frequency ratio or a friction ratio that is negative, NaN or infinite, for a mass that the
    /// scene does not have, and ("stribeck") for `friction: stribeck`.  Where a point has no response, its result says why.
    pub fn map(
        &self,
        request: &MapRequest,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Map, OutOfDomain> {
        let usable = |value: &f64| 0.0 <= *value && value.is_finite();
        let masses = self.scene().masses.len();
        let known = |of: &Of| !matches!(of, Of::Mass(index) if masses <= *index);
        for (good, argument) in [
            (request.r.iter().all(usable), "r"),
            (request.beta.iter().all(usable), "beta"),
            (request.of.iter().all(known), "mass"),
        ] {
            if !good {
                return Err(OutOfDomain { argument });
            }
        }
        let done = std::sync::atomic::AtomicUsize::new(0);
        let stopped = std::sync::atomic::AtomicBool::new(!go_on(0));
        let relaxed = std::sync::atomic::Ordering::Relaxed;
        let column = |r: &f64| {
            let column = self.column(*r, request, || !stopped.load(relaxed))?;
            if column.is_some() && !go_on(done.fetch_add(1, relaxed) + 1) {
                stopped.store(true, relaxed);
            }
            Ok(column)
        };
        // Neighbouring columns cost alike, and some a hundred times as much: one at a time.
        let columns = request.r.par_iter().with_max_len(1).map(column);
        let columns: Vec<Option<MapColumn>> = columns.collect::<Result<_, OutOfDomain>>()?;
        Ok(Map {
            beta: request.beta.clone(),
            columns: columns.into_iter().flatten().collect(),
        })
    }

    /// A column, unless it is cancelled; an error if the scene has no answer at this frequency, whatever the friction.
    fn column(
        &self,
        r: f64,
        request: &MapRequest,
        go_on: impl Fn() -> bool,
    ) -> Result<Option<MapColumn>, OutOfDomain> {
        let at = self.at(r)?;
        let limits = at.limits();
        let mut points = Vec::with_capacity(request.beta.len());
        for beta in &request.beta {
            if !go_on() {
                return Ok(None);
            }
            let point = at
                .response(*beta)
                .map(|response| MapPoint::of(&response, &request.of));
            points
                .push(point.and_then(|point| point.ok_or(OutOfDomain { argument: "mass" }.into())));
        }
        Ok(Some(MapColumn { r, limits, points }))
    }
}

impl Map {
    /// All points, with r and β, column by column.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64, &Result<MapPoint, Error>)> {
        self.columns.iter().flat_map(|column| {
            let points = self.beta.iter().zip(&column.points);
            points.map(|(beta, point)| (column.r, *beta, point))
        })
    }
}
