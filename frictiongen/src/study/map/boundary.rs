//! Where, between two points of a map, the contact begins to do something else.

use super::{Map, Pattern};
use crate::study::at::SystemAt;
use crate::study::system::System;
use crate::{Error, Limits, Regime};
use rayon::prelude::*;

/// A point of a boundary: at r, what the contact does changes at β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// r.
    pub r: f64,
    /// β, the middle of what is left open.
    pub beta: f64,
    /// How much is left open.
    pub width: f64,
    /// What it does below, or why there is no response.
    pub below: Result<Pattern, Error>,
    /// What it does above.
    pub above: Result<Pattern, Error>,
}

impl System {
    /// The boundaries that a map shows, at each of its frequency ratios. A boundary of the continuous or of the stuck
    /// regime is its limit, exactly. Between them the contact stops and slides in turn; there two neighbouring β of the map
    /// are looked at in their middle and quarters too, and every interval at whose ends the contact does something else is
    /// halved until the boundary is known to `digits` significant digits. Where the middle is of a third kind both halves are
    /// followed.
    ///
    /// So all boundaries are found that the quarters of the map's steps tell apart, and those that halving comes upon. What
    /// can be missed are two boundaries of one region within a quarter of a step, and what lies beside a limit within a 64th
    /// of what it leaves of the step; a finer map has finer quarters. Where halving comes upon a third kind more than six
    /// times between two neighbours, as where periods double on and on, only the lowest of the others are found.
    ///
    /// Near a boundary a motion needs long to settle: ten digits take a hundred times as long as three.
    ///
    /// ```
    /// use frictiongen::study::MapRequest;
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
            let known: Vec<_> = map.beta.iter().copied().zip(patterns).collect();
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

/// Both halves are looked at however alike their ends are, so often in turn.
const LOOKS: u32 = 2;
/// In so many places between two neighbours both halves of an interval are followed.
const MOST_BRANCHES: u32 = 6;
/// How far beyond a limit the contact is looked at, of what the limit leaves of a step.
const BESIDE: f64 = 1.0 / 64.0;

/// What the contact does at β.
type Known = (f64, Result<Pattern, Error>);

/// The boundaries between two neighbouring β.
struct Trace<'s> {
    at: &'s SystemAt<'s>,
    r: f64,
    precision: f64,
    /// How often both halves may still be followed.
    branches: u32,
    found: Vec<Boundary>,
}

impl Trace<'_> {
    /// From one β of a map to the next.
    fn step(&mut self, limits: &Limits<f64>, below: Known, above: Known) {
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
            // Beside the limit a motion takes too long to settle.
            low = self.known(limit + BESIDE * left);
            self.exact(limit, below.1, low.1);
        }
        if let Some(limit) = to {
            if from.is_some_and(|from| limit <= from) {
                // No motion with stops between them.
                return self.exact(limit, below.1, above.1);
            }
            high = self.known(limit - BESIDE * left);
        }
        self.between(low, high, LOOKS);
        if let Some(limit) = to {
            self.exact(limit, high.1, above.1);
        }
    }

    fn known(&self, beta: f64) -> Known {
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

    /// The boundaries between two β, ascending.
    fn between(&mut self, low: Known, high: Known, looks: u32) {
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

fn is(known: Known, regime: Regime) -> bool {
    known.1.is_ok_and(|pattern| pattern.regime == regime)
}
