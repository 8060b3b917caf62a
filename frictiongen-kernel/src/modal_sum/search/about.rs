//! Closes the cells around a summit. Near the top Taylor's theorem bounds the sum. Farther away a cubic with the value
//! and slope of the next node bounds the sum (section 9 of `docs/derivation.md`).

use super::grid::{Grid, Node, Open};
use super::summit::{Cubic, REACH, Summit, beyond_cubic};
use super::{Search, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::Decay;

/// Larger of two multiples of a step within which a summit must bend down to close cells; `REACH` is the smaller. A
/// larger multiple lets a flatter summit close cells.
const FAR: f64 = 97.0;

/// Excess E of a sum over its level around a summit, or E/τ.
struct Excess<S> {
    /// Position of the summit.
    tau: S,
    cubic: Cubic<S>,
    /// Upper bound on the fourth derivative.
    fourth: S,
    /// Upper bound, negative, on the quadratic coefficient of a cell's cubic. Below it the slope at the summit no
    /// longer matters beyond the reach.
    curvature: S,
}

/// A node up to which a cell may be closed.
#[derive(Clone, Copy)]
struct Beyond<S> {
    tau: S,
    value: S,
    slope: S,
    /// Upper bound on the rounding error of the value.
    rounding: S,
}

impl<S: Float> Cubic<S> {
    /// Returns value and derivatives of the function over τ.
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
    /// Creates the excess; `None` if it is not below 0 within the reach of a step.
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

    /// Returns true if the excess stays below 0 from the summit to a node.
    fn stays_below(&self, node: &Beyond<S>) -> bool {
        let distance = node.tau - self.tau;
        self.is_near(distance) || self.is_below(node, distance)
    }

    /// Returns true if the derivatives at the summit alone prove it. At so small a distance the higher terms take at
    /// most a third of the curvature.
    fn is_near(&self, distance: S) -> bool {
        let Cubic {
            curvature, third, ..
        } = self.cubic;
        let bend = third.abs() * distance.abs() * S::constant(1.0 / 6.0)
            + self.fourth * (distance * distance) * S::constant(1.0 / 24.0);
        bend <= -curvature * S::constant(1.0 / 3.0)
    }

    /// Returns true if value and slope at the node prove it.
    fn is_below(&self, node: &Beyond<S>, distance: S) -> bool {
        let Cubic { value, slope, .. } = self.cubic;
        let there = node.value + node.rounding;
        let square = distance * distance;
        // Coefficient of the square of the distance, in the cubic that meets both.
        let curve = S::constant(3.0) * (there - value) - distance * (node.slope + slope + slope)
            + node.rounding;
        let bend = self.fourth * square * S::constant(1.0 / 24.0);
        there <= S::constant(0.0) && curve / square + bend <= self.curvature
    }
}

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// Returns the open cells around a summit that contain nothing above its level. They are closed for the sign that
    /// the summit has. A step across the end of the half period may have changed it.
    pub(super) fn about(&self, summit: &Summit<S>, grid: &Grid<S>, open: Open) -> Open {
        let zero = S::constant(0.0);
        // Before the first node the derivatives have no bounds.
        if summit.tau < grid.stretch.from {
            return [0, 0];
        }
        let over_sine = self.problem.weight == Weight::Sine;
        let level = if over_sine {
            self.signed(summit.level, summit.negative)
        } else {
            summit.level
        };
        // Coefficient of sin τ in the level, which adds to the derivatives.
        let of_sine = if over_sine { level } else { zero };
        let cubic = self.cubic_about(summit, level, of_sine);
        let starts = over_sine && grid.stretch.from.is_zero();
        let plain = Excess::new(summit.tau, cubic, grid.bounds.fourth + of_sine.abs());
        let over_tau = if starts && !summit.tau.is_zero() {
            // The fourth derivative of E/τ is at most a fifth of the fifth derivative of E.
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
        // `closed` has a cell's bit once the cell is closed. `before` is true if E stays below 0 from the summit to the
        // last visited node. `last` is the bit of the cell after that node.
        let (mut closed, mut before, mut last) = (0, false, 0_u32);
        grid.beside(among, |after, tau, node| {
            let cell = after >> 1;
            // A visited node that does not bound this cell proves nothing about it.
            let known = before && last == cell;
            let (value, slope) = self.excess_at(&node, summit.negative, level);
            let first = starts && tau.is_zero();
            let there = Beyond {
                tau,
                // The excess is exactly 0 at the start.
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

    /// Returns E around a summit, from its derivatives there. `of_sine` times sin τ is the level that is subtracted.
    fn cubic_about(&self, summit: &Summit<S>, level: S, of_sine: S) -> Cubic<S> {
        let Summit { jet, negative, .. } = summit;
        let node = Node {
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
