//! Searches a map for boundaries: friction ratios at which the pattern of the contact's motion changes. A pattern
//! consists of regime, stops, reversals and period.

use super::{Map, Pattern};
use crate::study::at::SystemAt;
use crate::study::system::System;
use crate::{Error, Limits, Regime};
use rayon::prelude::*;

/// A boundary in a map: at this frequency ratio r, the pattern of the contact's motion changes at this friction ratio
/// β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// Frequency ratio r = ω√(m₁/k₁) of the excitation.
    pub r: f64,
    /// Friction ratio β, the middle of the interval that contains the boundary.
    pub beta: f64,
    /// Width in β of the interval that contains the boundary. It is 0 if the boundary is the exact limit β_lim or
    /// β*_lim.
    pub width: f64,
    /// Pattern at less friction, or the reason why there is no response.
    pub below: Result<Pattern, Error>,
    /// Pattern at more friction, or the reason why there is no response.
    pub above: Result<Pattern, Error>,
}

impl Boundary {
    /// Returns the boundary in the units that the load has at r = 1. The amplitude of the load is proportional to r⁻ⁿ
    /// with n = `fall`.
    #[must_use]
    pub fn at_reference(&self, fall: i32) -> Self {
        let factor = self.r.powi(-fall);
        Self {
            beta: self.beta * factor,
            width: self.width * factor,
            ..*self
        }
    }
}

impl System {
    /// Returns the boundaries in a map, at each of its frequency ratios.
    ///
    /// A boundary of the continuous or of the stuck regime is the exact limit. Between β_lim and β*_lim the contact
    /// alternately sticks and slides. In this range the search also evaluates the middle and the quarters of each
    /// interval between two neighbouring β of the map. If the patterns at the bounds of an interval differ, the search
    /// halves the interval until it knows the boundary to `digits` significant digits. If the middle has a third
    /// pattern, the search continues in both halves.
    ///
    /// The search finds all boundaries that are more than a quarter of the map's step in β apart. It can miss two
    /// boundaries of one region within a quarter of a step. It can also miss a boundary whose distance from a limit is
    /// less than a/64. Here a is the part of a step in which the contact alternately sticks and slides. A finer map
    /// has smaller steps. In a cascade of period doublings, the search may meet a third pattern more than six times
    /// between two neighbouring β. In this case the search finds only the lowest boundaries of the cascade.
    ///
    /// Close to a boundary a motion settles slowly. More digits therefore take much longer.
    ///
    /// ```
    /// use frictiongen::study::map::MapRequest;
    /// use frictiongen::System;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - base,
    ///     excitation: base,
    /// }"
    /// .parse()?;
    /// let request = MapRequest { r: vec![0.9], beta: vec![0.2, 0.6, 0.7, 0.75, 0.79, 1.0], of: Vec::new() };
    /// let map = block.map(&request, |_| true)?;
    /// let boundaries = block.boundaries(&map, 10);
    /// let top = boundaries.last().ok_or("none")?;
    /// assert!((top.beta - 0.81).abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn boundaries(&self, map: &Map, digits: u32) -> Vec<Boundary> {
        let precision = 10_f64.powi(-(digits.clamp(1, 15) as i32));
        let columns = map.columns.par_iter().map(|column| {
            let Ok(at) = self.at(column.r) else {
                return Vec::new();
            };
            let patterns = column.points.iter().map(|point| match point {
                Ok(point) => Ok(point.pattern),
                Err(error) => Err(*error),
            });
            let betas = map.beta.iter().map(|beta| map.ratio(column.r, *beta));
            let known: Vec<_> = betas.zip(patterns).collect();
            let pairs = known.windows(2).map(|pair| match pair {
                &[below, above] if below.0 < above.0 => {
                    let mut trace = Trace {
                        at: &at,
                        r: column.r,
                        precision,
                        branches: MOST_BRANCHES,
                        found: Vec::new(),
                    };
                    trace.step(&column.limits, below, above);
                    trace.found
                }
                _ => Vec::new(),
            });
            pairs.flatten().collect::<Vec<Boundary>>()
        });
        columns.flatten().collect()
    }
}

/// Number of times that the search halves an interval although both bounds have the same pattern.
const LOOKS: u32 = 2;
/// Number of times between two neighbouring β that the search may continue in both halves of an interval. The search
/// continues in both halves if the pattern at the middle differs from the patterns at both bounds (a third pattern).
const MOST_BRANCHES: u32 = 6;
/// Distance from a limit at which the search begins, divided by the length of the interval in which it searches. This
/// interval is the part of one step of the map that lies between the limits.
const BESIDE: f64 = 1.0 / 64.0;

/// A friction ratio β with the pattern of the contact.
type KnownPattern = (f64, Result<Pattern, Error>);

/// The search for boundaries between two neighbouring β of a map.
struct Trace<'s> {
    at: &'s SystemAt<'s>,
    r: f64,
    precision: f64,
    /// Number of times that the search may still continue in both halves of an interval.
    branches: u32,
    found: Vec<Boundary>,
}

impl Trace<'_> {
    /// Finds the boundaries from one β of a map to the next.
    fn step(&mut self, limits: &Limits<f64>, below: KnownPattern, above: KnownPattern) {
        if [Regime::Continuous, Regime::Stuck]
            .iter()
            .any(|regime| is(below, *regime) && is(above, *regime))
        {
            return;
        }
        let (mut low, mut high) = (below, above);
        let inside = |limit: f64| below.0 <= limit && limit <= above.0;
        let starts = is(below, Regime::Continuous) && !is(above, Regime::Continuous);
        let ends = is(above, Regime::Stuck) && !is(below, Regime::Stuck);
        let from = (starts && inside(limits.continuous)).then_some(limits.continuous);
        let to = (ends && inside(limits.sliding)).then_some(limits.sliding);
        let left = to.unwrap_or(above.0) - from.unwrap_or(below.0);
        if let Some(limit) = from
            && to.is_none_or(|to| limit < to)
        {
            // The search begins at this distance from the limit. Closer to the limit, a motion would take too long to
            // settle.
            low = self.known(limit + BESIDE * left);
            self.exact(limit, below.1, low.1);
        }
        if let Some(limit) = to {
            if from.is_some_and(|from| limit <= from) {
                // β_lim is not below β*_lim. No interval therefore remains in which the contact alternately sticks and
                // slides.
                return self.exact(limit, below.1, above.1);
            }
            high = self.known(limit - BESIDE * left);
        }
        self.between(low, high, LOOKS);
        if let Some(limit) = to {
            self.exact(limit, high.1, above.1);
        }
    }

    fn known(&self, beta: f64) -> KnownPattern {
        let response = self.at.response(beta);
        (beta, response.map(|response| Pattern::of(&response)))
    }

    fn exact(&mut self, beta: f64, below: Result<Pattern, Error>, above: Result<Pattern, Error>) {
        self.push(beta, 0.0, below, above);
    }

    fn push(
        &mut self,
        beta: f64,
        width: f64,
        below: Result<Pattern, Error>,
        above: Result<Pattern, Error>,
    ) {
        let r = self.r;
        self.found.push(Boundary {
            r,
            beta,
            width,
            below,
            above,
        });
    }

    /// Finds the boundaries between two friction ratios β, in ascending order.
    fn between(&mut self, low: KnownPattern, high: KnownPattern, looks: u32) {
        if low.1 == high.1 && looks == 0 {
            return;
        }
        let middle = 0.5 * (low.0 + high.0);
        let width = high.0 - low.0;
        if width <= self.precision * high.0 || !(low.0 < middle && middle < high.0) {
            if low.1 != high.1 {
                self.push(middle, width, low.1, high.1);
            }
            return;
        }
        let middle = self.known(middle);
        let third = low.1 != middle.1 && middle.1 != high.1;
        let looks = looks.saturating_sub(1);
        self.between(low, middle, looks);
        if third {
            if self.branches == 0 {
                return;
            }
            self.branches -= 1;
        }
        self.between(middle, high, looks);
    }
}

fn is(known: KnownPattern, regime: Regime) -> bool {
    known.1.is_ok_and(|pattern| pattern.regime == regime)
}
