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
    /// regime is its limit, exactly. Between two neighbouring β at which the contact stops in different ways the interval
    /// is halved until the boundary is known to `digits` significant digits.
    ///
    /// Of several boundaries between two neighbours one is found. Near a boundary a motion needs long to settle: ten digits
    /// take a hundred times as long as three.
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
            let pairs = known.windows(2).filter_map(|pair| match pair {
                &[below, above] if below.1 != above.1 && below.0 < above.0 => {
                    let limits = &column.limits;
                    let exact = limit(limits, below, above);
                    Some(match exact {
                        Some(beta) => Boundary {
                            r: column.r,
                            beta,
                            width: 0.0,
                            below: below.1,
                            above: above.1,
                        },
                        None => halved(&at, column.r, below, above, precision),
                    })
                }
                _ => None,
            });
            pairs.collect::<Vec<Boundary>>()
        });
        columns.flatten().collect()
    }
}

/// The limit of a regime between two points, if they are of different regimes.
fn limit(limits: &Limits<f64>, below: Known, above: Known) -> Option<f64> {
    let beta = match (below.1.ok()?.regime, above.1.ok()?.regime) {
        (Regime::Continuous, Regime::StickSlip) => limits.continuous,
        (_, Regime::Stuck) => limits.sliding,
        _ => return None,
    };
    Some(beta)
}

type Known = (f64, Result<Pattern, Error>);

fn halved(at: &SystemAt<'_>, r: f64, below: Known, above: Known, precision: f64) -> Boundary {
    let (mut low, mut high) = (below, above);
    while precision * high.0 < high.0 - low.0 {
        let beta = 0.5 * (low.0 + high.0);
        if !(low.0 < beta && beta < high.0) {
            break;
        }
        let pattern = at.response(beta).map(|response| Pattern::of(&response));
        // A third pattern between them has a boundary to both: the lower one is kept.
        if pattern == low.1 {
            low.0 = beta;
        } else {
            high = (beta, pattern);
        }
    }
    Boundary {
        r,
        beta: 0.5 * (low.0 + high.0),
        width: high.0 - low.0,
        below: low.1,
        above: high.1,
    }
}
