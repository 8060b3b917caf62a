//! Finds summits of a modal sum. A *summit* is a position from which one Newton step leads to a local maximum. From the
//! highest node of a grid, the search usually needs two evaluations to reach a summit.

use super::grid::{Grid, GridNode, OpenCells};
use super::{Maximiser, MaximumSearch, Weight};
use crate::modal_sum::wave::SumDerivatives;
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};

/// Largest number of evaluations of the modal sum in one search for a local maximum by Newton's method.
pub(super) const EVALUATIONS: u32 = 5;
/// Distance from the present position, in Newton steps, within which the terms that a Newton step neglects must be
/// small. If these terms are not small, another Newton step follows.
pub(super) const REACH: f64 = 7.0;

/// Position from which one Newton step leads to a local maximum, with the modal sum and its derivatives at this
/// position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Summit<S> {
    pub tau: S,
    pub negative: bool,
    pub jet: SumDerivatives<S>,
    /// Upper bound on the local maximum to which the Newton step leads.
    pub level: S,
}

/// Value and first three derivatives of a function at a position. The four numbers define the function's Taylor
/// polynomial of third degree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cubic<S> {
    pub value: S,
    pub slope: S,
    pub curvature: S,
    pub third: S,
}

#[cfg(test)]
impl<S: Float> Summit<S> {
    /// Returns the upper bound on a local maximum. The flag is true for a maximum of the negative of the sum.
    pub fn height(&self) -> (S, bool) {
        (self.level, self.negative)
    }
}

impl<S: Float> Cubic<S> {
    /// Returns the estimated signed distance to the local maximum: a Newton step with a correction by the third
    /// derivative.
    pub fn step(&self) -> S {
        let half = S::constant(0.5);
        let newton = -(self.slope / self.curvature);
        let bend = self.third * newton * half / self.curvature;
        newton * (S::constant(1.0) - bend.max(-half).min(half))
    }

    /// Returns the value at the local maximum minus the value at the present position. `step` is the signed distance to
    /// the maximum.
    pub fn rise(&self, step: S) -> S {
        let bend = self.curvature * S::constant(0.5) + self.third * step * S::constant(1.0 / 6.0);
        (self.slope + bend * step) * step
    }

    /// Returns true if the third derivative changes the curvature by less than half, up to the distance `reach` times
    /// `step`. The function is then concave up to this distance.
    pub fn is_concave(&self, step: S, reach: S) -> bool {
        (self.third * step).abs() * (reach + reach) < -self.curvature
    }
}

/// Returns the largest contribution of the fourth derivative to the value of a function, up to the distance `reach`
/// times `step`.
pub(super) fn beyond_cubic<S: Float>(fourth: S, step: S, reach: S) -> S {
    let far = step * reach;
    let square = far * far;
    fourth * square * square * S::constant(1.0 / 24.0)
}

impl<S: Float, D: Decay<S>> MaximumSearch<'_, S, D> {
    /// Returns the modal sum and its derivative at a node. In a search of sum/sin τ, the function returns the quotient
    /// sum/sin τ and its derivative instead.
    fn quotient_node(&self, node: &GridNode<S>) -> (S, S) {
        match self.problem.weight {
            Weight::One => (node.value, node.slope),
            Weight::Sine => {
                let value = node.value / node.sine;
                (value, (node.slope - value * node.cosine) / node.sine)
            }
        }
    }

    /// Estimates the position of the highest local maximum in the open cells. The estimate is the maximum of the cubic
    /// in the cell next to the highest node. Returns `None` if the open cells have no suitable node.
    pub(super) fn highest(&self, grid: &Grid<S>, open: OpenCells) -> Option<Maximiser<S>> {
        let zero = S::constant(0.0);
        let over_sine = self.problem.weight == Weight::Sine;
        let starts = over_sine && grid.stretch.from.is_zero();
        let mut best: Option<(S, bool, u32, S)> = None;
        let [plus, minus] = open;
        grid.beside(plus | minus, |bit, tau, node| {
            let cells = bit | (bit >> 1);
            if over_sine && !(zero < node.sine && zero < tau) {
                return;
            }
            for (&negative, open) in self.signs().iter().zip(open) {
                if open & cells == 0 {
                    continue;
                }
                let (value, _) = self.quotient_node(&node);
                let value = if negative {
                    -value - self.signed(zero, true)
                } else {
                    value
                };
                if best.is_none_or(|(known, ..)| known < value) {
                    best = Some((value, negative, bit, tau));
                }
            }
        });
        let bounds = grid.bounds;
        if starts && open[0] & 1 != 0 && zero < bounds.second && bounds.third < zero {
            // For small τ, sum/sin τ is close to second·τ/2 + third·τ²/6, where `second` and `third` are derivatives of
            // the sum at τ = 0.
            let tau = -(bounds.second * S::constant(1.5)) / bounds.third;
            let in_first = tau < grid.stretch.width * S::constant(0.5);
            if in_first && best.is_none_or(|(known, ..)| known < zero) {
                return Some(Maximiser {
                    tau,
                    negative: false,
                });
            }
        }
        let (_, negative, bit, tau) = best?;
        let index = bit.trailing_zeros() as usize;
        let node = grid.node(index)?;
        let here = self.quotient_node(&node);
        let rising = (zero < here.1) != negative;
        if !over_sine {
            // A motion continues after the half period with the opposite sign.
            let end = self.problem.end;
            let outside = if rising { !(tau < end) } else { tau.is_zero() };
            if outside {
                return Some(Maximiser {
                    tau: if rising { zero } else { end },
                    negative: !negative,
                });
            }
        }
        let other = if rising {
            Some(index + 1)
        } else {
            index.checked_sub(1)
        };
        let there = match other.and_then(|other| grid.node(other)) {
            Some(_) if starts && other == Some(0) => Some((zero, bounds.second * S::constant(0.5))),
            Some(node) if !over_sine || zero < node.sine => Some(self.quotient_node(&node)),
            _ => None,
        };
        let width = if rising {
            grid.stretch.width
        } else {
            -grid.stretch.width
        };
        let sign = if negative { -width } else { width };
        let share = there.map_or(zero, |there| {
            let rise = if negative {
                here.0 - there.0
            } else {
                there.0 - here.0
            };
            top_between(here.1 * sign, there.1 * sign, rise)
        });
        Some(Maximiser {
            tau: tau + width * share,
            negative,
        })
    }

    /// Finds a local maximum near a position by Newton's method. Records the maximum if it is the largest so far.
    /// Returns `None` if the method does not converge from this position.
    pub(super) fn summit(&mut self, place: &Maximiser<S>, grid: &Grid<S>) -> Option<Summit<S>> {
        let (fourth, width) = (grid.bounds.fourth, grid.stretch.width);
        // The code computes the maximum to rounding accuracy, even if the tolerance of the search is larger.
        let four = S::constant(4.0 * S::EPSILON);
        let Maximiser {
            mut tau,
            mut negative,
        } = *place;
        let mut seen = None;
        for evaluation in 1..=EVALUATIONS {
            let (inside, flipped) = self.moved(tau);
            if inside != tau && self.problem.weight == Weight::Sine {
                return None;
            }
            (tau, negative) = (inside, negative != flipped);
            self.peak.evaluations += 1;
            let jet = self.sum.jet(&Instant::new(tau * S::inverse_pi()));
            let (best, quotient) = self.quotient_jet(&jet, negative);
            let step = quotient.step();
            let near = step.abs() < width + width;
            seen = Some((best, quotient.value, Maximiser { tau, negative }));
            if !(quotient.curvature < S::constant(0.0) && near) {
                break;
            }
            let size = self.problem.start + self.peak.value.max(best);
            let spare = four * size;
            let weight = match self.problem.weight {
                Weight::One => S::constant(1.0),
                Weight::Sine => jet.sine,
            };
            let left = beyond_cubic(fourth + self.level(), step, S::constant(REACH));
            // The phase (lag) of a motion requires an accurate position of the maximum. An accurate value alone is not
            // enough.
            let placed = self.problem.weight == Weight::Sine
                || (fourth * step * step * step).abs() <= four * quotient.curvature.abs()
                || evaluation == EVALUATIONS;
            let (at_top, flipped) = self.moved(tau + step);
            // If the Newton step crosses the end of the half period, the friction force changes its sign, and the
            // curvature of the motion changes. The code then makes another Newton step.
            let crossed = flipped && four < at_top.min(self.problem.end - at_top);
            if quotient.is_concave(step, S::constant(REACH))
                && left <= spare * weight
                && placed
                && !crossed
            {
                let rise = quotient.rise(step);
                let top = Maximiser {
                    tau: at_top,
                    negative: negative != flipped,
                };
                self.keep(best + rise, quotient.value + rise, top);
                let tolerance = self.problem.tolerance.max(four);
                return Some(Summit {
                    tau,
                    negative,
                    jet,
                    // If the terms of the modes nearly cancel, rounding errors exceed the tolerance. The level
                    // therefore includes their bound.
                    level: quotient.value + rise + tolerance * size + self.rounding,
                });
            }
            tau = tau + step;
        }
        let (best, value, place) = seen?;
        if self.peak.value < best {
            self.keep(best, value, place);
        }
        None
    }

    /// Returns the modal sum, or sum/sin τ, from the sum's derivatives at an instant. The first result is the value
    /// minus its possible rounding error, and serves for comparisons. The second result contains the value and three
    /// derivatives.
    fn quotient_jet(&self, jet: &SumDerivatives<S>, negative: bool) -> (S, Cubic<S>) {
        let SumDerivatives {
            sine,
            cosine,
            value,
            slope,
            curvature,
            third,
        } = *jet;
        let (best, whole) = self.quotient_at(value, sine, cosine, negative);
        let sign = S::constant(if negative { -1.0 } else { 1.0 });
        let [slope, curvature, third] = match self.problem.weight {
            Weight::One => [slope, curvature, third],
            Weight::Sine => {
                // The sum F is Q sin τ, with the quotient Q. The code computes the derivatives of Q from the
                // derivatives of F.
                let over = |value: S| value / sine;
                let q0 = over(value);
                let q1 = over(slope - q0 * cosine);
                let q2 = over(curvature + value - (q1 + q1) * cosine);
                let three = S::constant(3.0);
                let q3 = over(third + three * (q1 * sine - q2 * cosine) + q0 * cosine);
                [q1, q2, q3]
            }
        };
        let cubic = Cubic {
            value: whole,
            slope: slope * sign,
            curvature: curvature * sign,
            third: third * sign,
        };
        (best, cubic)
    }
}

/// Returns the position between 0 and 1 at which a cubic is largest. `up` is the slope of the cubic at 0, and `down`
/// its slope at 1. `rise` is its value at 1 minus its value at 0. If the cubic has no maximum between 0 and 1, the
/// result is 0.
fn top_between<S: Float>(up: S, down: S, rise: S) -> S {
    let zero = S::constant(0.0);
    if !(zero < up && down < zero) {
        return zero;
    }
    // The Bernstein coefficients of the derivative are `up`, `mean` and `down`.
    let mean = rise * S::constant(3.0) - up - down;
    let root = (mean * mean - up * down).sqrt();
    if zero < mean {
        (mean + root) / (mean + root - down)
    } else {
        up / (up + root - mean)
    }
}
