//! Maps over frequency and friction. Each point has the pattern of the contact's motion: regime, stops, reversals and
//! period. A search locates the boundaries between patterns.

mod boundary;
mod lines;

pub use boundary::Boundary;
pub use lines::LimitLines;

use super::response::SystemResponse;
use super::system::System;
use crate::{Error, Given, Limits, Of, OutOfDomain, Regime};
use rayon::prelude::*;

/// A request for a map: the grid of points, and the motions.
#[derive(Clone, Debug, PartialEq)]
pub struct MapRequest {
    /// Frequency ratios r of the columns, in the order of the request.
    pub r: Vec<f64>,
    /// Friction ratios β of the points, in the order of the request.
    pub beta: Vec<f64>,
    /// The motions whose amplitudes each point contains.
    pub of: Vec<Of>,
}

/// The pattern of the contact's motion: regime, stops, reversals and period.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pattern {
    /// Regime of the motion: continuous, stick-slip or stuck.
    pub regime: Regime,
    /// Number of stops of the contact in one period of the motion. It is 0 if the motion does not settle.
    pub stops: usize,
    /// Number of reversals in one period: changes of the sliding direction without a stop. It is 0 if the motion does
    /// not settle.
    pub reversals: usize,
    /// Number of cycles of the excitation after which the motion repeats. It is 0 if the motion does not settle.
    pub period: u32,
}

/// The response at one point of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPoint {
    /// Pattern of the contact's motion.
    pub pattern: Pattern,
    /// Fraction of the period during which the contact sticks.
    pub stuck_fraction: f64,
    /// True if the steady state is stable: no small deviation grows.
    pub stable: bool,
    /// True if the steady state belongs to a continuum of steady states, or is the end of a continuum.
    pub marginal: bool,
    /// True if the motion from rest ends in this state. False if the motion from rest does not settle, and this state
    /// is another steady state.
    pub from_rest: bool,
    /// Offset of the contact, divided by P/k₁ (by Y for base motion), as
    /// [`SystemResponse::offset`](crate::study::response::SystemResponse::offset) defines it.
    pub offset: f64,
    /// The requested amplitudes, in the order of the request, divided by P/k₁ (by Y for base motion).
    pub amplitudes: Vec<f64>,
}

/// A column of a map: the responses at one frequency ratio, one for each friction ratio.
#[derive(Clone, Debug)]
pub struct MapColumn {
    /// Frequency ratio r = ω√(m₁/k₁) of the excitation.
    pub r: f64,
    /// The limits β_lim and β*_lim at this frequency ratio.
    pub limits: Limits<f64>,
    /// The response for each friction ratio β of the map, or the reason why there is none.
    pub points: Vec<Result<MapPoint, Error>>,
}

/// A map: the responses over a grid of frequency ratios and friction ratios.
#[derive(Clone, Debug)]
pub struct Map {
    /// Friction ratios β of the points, in the order of the request. If the amplitude of the load depends on frequency,
    /// these are the friction ratios at r = 1.
    pub beta: Vec<f64>,
    /// Exponent n of the load's amplitude, which is proportional to r⁻ⁿ. It is 0 for a load of constant amplitude.
    pub fall: i32,
    /// The computed columns, in the order of the request. Columns are missing only if the caller has cancelled the map.
    pub columns: Vec<MapColumn>,
}

impl Pattern {
    /// Returns the pattern of a response.
    #[must_use]
    pub fn of(response: &SystemResponse<'_>) -> Self {
        let (stops, reversals, period) = match response {
            // In the closed form, the contact reverses twice in a cycle.
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
        })
    }
}

impl System {
    /// Returns the response at every pair of a frequency ratio and a friction ratio, computed on all cores.
    ///
    /// Each point has the state in which the motion from rest ends, as
    /// [`SystemAt::response`](super::SystemAt::response) returns it. A point does not depend on its neighbours. Other
    /// steady states may exist at the same point if μ > 1.
    ///
    /// ```
    /// use frictiongen::study::map::MapRequest;
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
    /// // The contact is stuck where β ≥ r².
    /// assert_eq!(stuck.count(), 265);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// After each column the map calls `go_on` with the number of finished columns, from any thread. If `go_on` returns
    /// `false`, the map does not contain the remaining columns.
    ///
    /// # Errors
    /// [`OutOfDomain`] for a frequency ratio or a friction ratio that is negative, NaN or infinite, and for a mass or
    /// a spring that the scene does not have. [`Unsupported::FrictionLaw`](crate::Unsupported::FrictionLaw) for
    /// `friction: stribeck`. A point without a response contains the reason.
    pub fn map(
        &self,
        request: &MapRequest,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Map, OutOfDomain> {
        self.map_under(request, 0, go_on)
    }

    /// Returns a map as [`map`](Self::map) does, under a load whose amplitude P or Y is proportional to r⁻ⁿ with n =
    /// `fall`. The friction ratios of the request are those at r = 1. At another r the friction ratios are multiplied
    /// by rⁿ, so that the friction force is the same at every frequency. The amplitudes of a point are multiples of
    /// P/k₁ (of Y for base motion) with P and Y at the frequency of the point.
    ///
    /// # Errors
    /// Same errors as [`map`](Self::map).
    pub fn map_under(
        &self,
        request: &MapRequest,
        fall: i32,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Map, OutOfDomain> {
        self.constant_force()?;
        let usable = |value: &f64| 0.0 <= *value && value.is_finite();
        if let Some(r) = request.r.iter().find(|r| !usable(r)) {
            return Err(OutOfDomain::FrequencyRatio(Given::of(*r)));
        }
        if let Some(beta) = request.beta.iter().find(|beta| !usable(beta)) {
            return Err(OutOfDomain::FrictionRatio(Given::of(*beta)));
        }
        if !request.of.iter().all(|of| self.has_motion(*of)) {
            return Err(OutOfDomain::Mass);
        }
        let done = std::sync::atomic::AtomicUsize::new(0);
        let stopped = std::sync::atomic::AtomicBool::new(!go_on(0));
        let relaxed = std::sync::atomic::Ordering::Relaxed;
        let column = |r: &f64| {
            let column = self.column(*r, (request, fall), || !stopped.load(relaxed))?;
            if column.is_some() && !go_on(done.fetch_add(1, relaxed) + 1) {
                stopped.store(true, relaxed);
            }
            Ok(column)
        };
        // The work varies widely between distant columns, but little between neighbouring ones. Each core therefore
        // computes one column at a time, so that no core is idle.
        let columns = request.r.par_iter().with_max_len(1).map(column);
        let columns: Vec<Option<MapColumn>> = columns.collect::<Result<_, OutOfDomain>>()?;
        Ok(Map {
            beta: request.beta.clone(),
            fall,
            columns: columns.into_iter().flatten().collect(),
        })
    }

    /// Returns a column of the map, or `None` if the caller has cancelled the map. Fails if [`at`](Self::at) fails at
    /// this frequency ratio.
    fn column(
        &self,
        r: f64,
        (request, fall): (&MapRequest, i32),
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
                .response(beta * r.powi(fall))
                .map(|response| MapPoint::of(&response, &request.of));
            points.push(point.and_then(|point| point.ok_or(OutOfDomain::Mass.into())));
        }
        Ok(Some(MapColumn { r, limits, points }))
    }
}

impl Map {
    /// Returns all points of the map, column by column, each with its r and β. If the amplitude of the load depends on
    /// frequency, β is the friction ratio at this frequency.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64, &Result<MapPoint, Error>)> {
        self.columns.iter().flat_map(|column| {
            let points = self.beta.iter().zip(&column.points);
            points.map(|(beta, point)| (column.r, self.ratio(column.r, *beta), point))
        })
    }

    /// Returns the friction ratio at the frequency ratio r for the friction force whose friction ratio at r = 1 is
    /// `beta`. The amplitude of the load may depend on r.
    pub(super) fn ratio(&self, r: f64, beta: f64) -> f64 {
        beta * r.powi(self.fall)
    }

    /// Returns the map in the units that the load has at r = 1. A picture needs the same units at all frequencies.
    #[must_use]
    pub fn at_reference(&self) -> Self {
        let columns = self.columns.iter().map(|column| {
            let factor = column.r.powi(-self.fall);
            let mut column = column.clone();
            column.limits = scaled(column.limits, factor);
            for point in column.points.iter_mut().flatten() {
                point.offset *= factor;
                point.amplitudes.iter_mut().for_each(|size| *size *= factor);
            }
            column
        });
        Self {
            beta: self.beta.clone(),
            fall: 0,
            columns: columns.collect(),
        }
    }
}

/// Returns limits of the friction in another unit of force. An infinite limit stays infinite.
fn scaled(limits: Limits<f64>, factor: f64) -> Limits<f64> {
    Limits {
        continuous: limits.continuous * factor,
        sliding: limits.sliding * factor,
    }
}
