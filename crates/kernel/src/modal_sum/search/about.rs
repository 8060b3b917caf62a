//! Closes grid cells around a local maximum of the modal sum. A cell is the interval between two nodes of a grid. The
//! code closes a cell once it has proven that no value in the cell exceeds the largest value found.
//!
//! Near the maximum, Taylor's theorem bounds the sum. Farther away, a cubic through the value and slope of the next
//! node bounds the sum (section 9 of `docs/derivation.md`). A *summit* is a position from which one Newton step leads
//! to the maximum.

use super::grid::{Grid, GridNode, OpenCells};
use super::summit::{Cubic, REACH, Summit, beyond_cubic};
use super::{MaximumSearch, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// First factor ρ with which the code tries to close the cells around a local maximum. A closed cell is proven to
/// contain no larger value. The proof requires that the sum is concave up to the distance of ρ Newton steps from the
/// maximum. If the proof fails with this ρ, the code tries the smaller factor `REACH`. A larger ρ can close the cells
/// around a flatter maximum.
const FAR: f64 = 97.0;

/// Difference E between a modal sum and a level, near a local maximum. E is ±sum − level. In a search of sum/sin τ, E
/// is ±sum − level·sin τ. The level is an upper bound on the local maximum. The code closes a cell of the grid once it
/// has proven E ≤ 0 in the cell.
struct Excess<S> {
    /// Phase τ near the local maximum. `cubic` gives the derivatives at this phase.
    tau: S,
    cubic: Cubic<S>,
    /// Upper bound on the fourth derivative of E = ±sum − level.
    fourth: S,
    /// Negative bound 2E″/(ρ − 1) on the quadratic coefficient of the cubic between `tau` and a node. E is ±sum −
    /// level, and ρ is the factor `FAR` or `REACH`. A coefficient below this bound outweighs the slope at `tau` at all
    /// distances of more than ρ Newton steps.
    curvature: S,
}

/// Node of a grid, with the excess E = ±sum − level at the node. If the code proves E ≤ 0 between a local maximum and
/// the node, it closes the cells between them.
#[derive(Clone, Copy)]
struct NodeExcess<S> {
    tau: S,
    value: S,
    slope: S,
    /// Upper bound on the rounding error of `value`.
    rounding: S,
}

impl<S: Float> Cubic<S> {
    /// Returns the value and the derivatives of f(τ)/τ at `tau`. `self` contains the value and the derivatives of f at
    /// `tau`.
    fn over(self, tau: S) -> Self {
        let value = self.value / tau;
        let slope = (self.slope - value) / tau;
        let curvature = (self.curvature - slope - slope) / tau;
        Self {
            value,
            slope,
            curvature,
            third: (self.third - curvature * S::constant(3.0)) / tau,
        }
    }
}

impl<S: Float> Excess<S> {
    /// Creates E = ±sum − level near a local maximum, from its value and derivatives at `tau`. Returns `None` if E may
    /// be positive within ρ times the Newton step to the maximum. The code first tries ρ = `FAR`, and then ρ = `REACH`.
    fn new(tau: S, cubic: Cubic<S>, fourth: S) -> Option<Self> {
        let step = cubic.step();
        let reach = [S::constant(FAR), S::constant(REACH)]
            .into_iter()
            .find(|&reach| {
                let top = cubic.value + cubic.rise(step) + beyond_cubic(fourth, step, reach);
                cubic.is_concave(step, reach) && top <= S::constant(0.0)
            })?;
        Some(Self {
            tau,
            cubic,
            fourth,
            curvature: cubic.curvature * S::constant(2.0) / (reach - S::constant(1.0)),
        })
    }

    /// Returns true if the code proves that E = ±sum − level is at most 0 from the local maximum to a node. The code
    /// may then close the cells between the local maximum and the node.
    fn stays_below(&self, node: &NodeExcess<S>) -> bool {
        let distance = node.tau - self.tau;
        self.is_near(distance) || self.is_below(node, distance)
    }

    /// Returns true if the derivatives of E = ±sum − level at `tau` prove that E stays below 0 up to the given
    /// distance. In the proof, the terms with the third and fourth derivative together must be at most a third of |E″|.
    fn is_near(&self, distance: S) -> bool {
        let Cubic {
            curvature, third, ..
        } = self.cubic;
        let bend = third.abs() * distance.abs() * S::constant(1.0 / 6.0)
            + self.fourth * (distance * distance) * S::constant(1.0 / 24.0);
        bend <= -curvature * S::constant(1.0 / 3.0)
    }

    /// Returns true if the code proves that E = ±sum − level stays below 0 up to a node. The proof uses the value and
    /// the slope of E at the node.
    fn is_below(&self, node: &NodeExcess<S>, distance: S) -> bool {
        let Cubic { value, slope, .. } = self.cubic;
        let there = node.value + node.rounding;
        let square = distance * distance;
        // `curve`/`square` is the quadratic coefficient of a cubic. At `tau` and at the node, the cubic has the same
        // value and slope as E = ±sum − level.
        let curve = S::constant(3.0) * (there - value) - distance * (node.slope + slope + slope)
            + node.rounding;
        let bend = self.fourth * square * S::constant(1.0 / 24.0);
        there <= S::constant(0.0) && curve / square + bend <= self.curvature
    }
}

impl<S: Float, D: Decay<S>> MaximumSearch<'_, S, D> {
    /// Returns the cells that the code proves closed around a local maximum. In these cells the sum does not exceed the
    /// level of the maximum. The function closes cells only for the sign that the sum has at the maximum. A Newton step
    /// across the end of the half period may have changed this sign.
    pub(super) fn about(&self, summit: &Summit<S>, grid: &Grid<S>, open: OpenCells) -> OpenCells {
        let zero = S::constant(0.0);
        // The bounds on the derivatives are valid only from the first node of the grid on.
        if summit.tau < grid.stretch.from {
            return [0, 0];
        }
        let over_sine = self.problem.weight == Weight::Sine;
        let level = if over_sine {
            self.signed(summit.level, summit.negative)
        } else {
            summit.level
        };
        // The product level·sin τ is part of the difference E, and therefore contributes to the derivatives of E.
        let of_sine = if over_sine { level } else { zero };
        let cubic = self.cubic_about(summit, level, of_sine);
        let starts = over_sine && grid.stretch.from.is_zero();
        let plain = Excess::new(summit.tau, cubic, grid.bounds.fourth + of_sine.abs());
        let over_tau = if starts && !summit.tau.is_zero() {
            // With E = ±sum − level·sin τ, the fourth derivative of E/τ is at most a fifth of the fifth derivative of
            // E.
            let fourth = (grid.bounds.fifth + of_sine.abs()) * S::constant(0.2);
            Excess::new(summit.tau, cubic.over(summit.tau), fourth)
        } else {
            None
        };
        if plain.is_none() && over_tau.is_none() {
            return [0, 0];
        }
        let [plus, minus] = open;
        let among = if summit.negative { minus } else { plus };
        // `closed` has one bit for each cell that is closed so far. `before` is true if E = ±sum − level stays below 0
        // from the summit to the last visited node. `last` is the bit of the cell after that node.
        let (mut closed, mut before, mut last) = (0, false, 0_u32);
        grid.beside(among, |after, tau, node| {
            let cell = after >> 1;
            // The code uses the last visited node only if it is the left node of this cell.
            let known = before && last == cell;
            let (value, slope) = self.excess_at(&node, summit.negative, level);
            let first = starts && tau.is_zero();
            let there = NodeExcess {
                tau,
                // At τ = 0 the excess is exactly 0.
                value: if first { zero } else { value },
                slope,
                rounding: if first { zero } else { grid.rounding(tau) },
            };
            let below = plain
                .as_ref()
                .is_some_and(|plain| plain.stays_below(&there))
                || over_tau
                    .as_ref()
                    .is_some_and(|over| over.is_near(tau - summit.tau));
            let left = tau - grid.stretch.width;
            let both = (known || !(left < summit.tau)) && (below || tau <= summit.tau);
            if both {
                closed |= cell;
            }
            (before, last) = (below, after);
        });
        if summit.negative {
            [0, closed]
        } else {
            [closed, 0]
        }
    }

    /// Returns the value and the first three derivatives of E = ±sum − `level` near a local maximum. For a search of
    /// sum/sin τ, the function uses E = ±sum − `of_sine`·sin τ.
    fn cubic_about(&self, summit: &Summit<S>, level: S, of_sine: S) -> Cubic<S> {
        let Summit { jet, negative, .. } = summit;
        let node = GridNode {
            value: jet.value,
            slope: jet.slope,
            sine: jet.sine,
            cosine: jet.cosine,
        };
        let (value, slope) = self.excess_at(&node, *negative, level);
        let sign = S::constant(if *negative { -1.0 } else { 1.0 });
        Cubic {
            value,
            slope,
            curvature: jet.curvature * sign + of_sine * jet.sine,
            third: jet.third * sign + of_sine * jet.cosine,
        }
    }
}
