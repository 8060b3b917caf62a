//! Search of a modal sum by grids. A cell is the interval between two nodes of a grid. The search closes a cell once it
//! has proven that no value in the cell exceeds the largest value found.
//!
//! In each cell a cubic approximates the sum. At both nodes, the cubic has the value and slope of the sum. The largest
//! Bernstein coefficient of the cubic, plus an error from the fourth derivative, is an upper bound on the sum. The
//! search refines local maxima by Newton's method, starting in the highest open cell. A finer grid divides the cells
//! that remain open. The division ends when rounding errors limit the bounds (section 9 of `docs/derivation.md`).

use super::bounds::DerivativeBounds;
use super::grid::{Grid, GridNode, OpenCells, Stretch};
use super::summit::EVALUATIONS;
use super::{EQUAL, MaximumSearch, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};

/// Permitted error of the cubic that approximates the sum in a cell, divided by the largest value of the sum. The code
/// chooses the width of the cells from this error. A smaller error needs more nodes. A larger error leaves more cells
/// open.
const SLACK: f64 = 2e-3;
/// Smallest estimate of the sum's largest value, divided by the sum of the modal amplitudes. The code estimates the
/// largest value to choose the cell width of the first grid. The largest value may be far below the sum of the
/// amplitudes, because the terms of the modes may nearly cancel.
const CANCELLED: f64 = 1e-3;
/// Cost of evaluating one grid, counted as this number of evaluations of the modal sum.
const COST: u32 = 2;
/// Largest number of local maxima that the search refines by Newton's method on one grid.
const SUMMITS: u32 = 6;
/// Number of cells into which a finer grid divides one cell, if at most three adjacent cells are open.
const FINER: f64 = 10.0;

const NONE: OpenCells = [0, 0];

impl<S: Float, D: Decay<S>> MaximumSearch<'_, S, D> {
    /// Returns true if the search may evaluate one more grid and its local maxima. If the bound on the evaluations does
    /// not permit this, marks the search as incomplete and returns false.
    fn has_room(&mut self) -> bool {
        self.peak.exceeded |= self.most - self.peak.evaluations < COST + SUMMITS * EVALUATIONS;
        !self.peak.exceeded
    }

    /// Searches the whole half period by grids, until the search is complete or reaches its bound on evaluations.
    pub(super) fn by_grids(&mut self) {
        let end = self.problem.end;
        let mut from = S::constant(0.0);
        while from < end && self.has_room() {
            let bounds = DerivativeBounds::of(&self.sum, &Instant::from_start(from), end - from);
            // A cubic on a cell of width h has an error of at most h⁴/384 times the fourth derivative. The code
            // computes the width from the permitted error of the cubic.
            let fourth = bounds.fourth + self.level();
            let width = (S::constant(384.0 * SLACK) * self.size(&bounds) / fourth)
                .sqrt()
                .sqrt();
            let stretch = Stretch::new(from, end, width.primal(), false);
            self.settle(&stretch, &bounds);
            from = stretch.to;
        }
    }

    /// Estimates the largest value that the search will find. The width of the cells follows from this estimate.
    fn size(&self, bounds: &DerivativeBounds<S>) -> S {
        let mut known = self.problem.start + self.peak.value;
        if self.problem.weight == Weight::One && known.is_zero() {
            let (cosine, sine) = self.sum.start();
            known = cosine.abs() + sine.abs();
        }
        known.max(bounds.size * S::constant(CANCELLED))
    }

    /// Searches an interval by one grid, and then divides the cells that may still contain a larger value. The function
    /// does not divide cells once the error of their cubics is smaller than the rounding error.
    fn settle(&mut self, stretch: &Stretch<S>, bounds: &DerivativeBounds<S>) {
        let [plus, minus] = self.open_cells(stretch, bounds);
        let mut open = plus | minus;
        let square = stretch.width * stretch.width;
        if square * square * bounds.fourth * S::constant(1.0 / 384.0) <= bounds.rounding {
            return;
        }
        let (mut left, mut run) = (stretch.from, None);
        while open != 0 {
            if open & 1 == 1 {
                run = run.or(Some(left));
            } else if let Some(from) = run.take() {
                self.divide(from, left, stretch.width, bounds);
            }
            open >>= 1;
            left = left + stretch.width;
        }
        if let Some(from) = run {
            self.divide(from, left.min(stretch.to), stretch.width, bounds);
        }
    }

    /// Searches an interval of adjacent open cells by finer grids. An interval of at most three cells gets a finer
    /// division than a longer interval.
    fn divide(&mut self, from: S, to: S, width: S, bounds: &DerivativeBounds<S>) {
        let few = to - from < width * S::constant(3.5);
        let share = S::constant(if few { 1.0 / FINER } else { 0.25 });
        let starts = self.problem.weight == Weight::Sine && from.is_zero();
        let mut from = from;
        while from < to && self.has_room() {
            let stretch = Stretch::new(from, to, width * share, starts && from.is_zero());
            self.settle(&stretch, bounds);
            from = stretch.to;
        }
    }

    /// Returns true if `to` is the end of the half period, τ = π. The sum and sin τ both vanish at this phase.
    fn ends_at_pi(&self, to: S) -> bool {
        !(to < self.problem.end) && !(to < S::pi() * S::constant(0.75))
    }

    /// Evaluates the sum at the nodes of a grid, and refines its highest local maxima. Returns the cells that may still
    /// contain a value larger than the largest value found.
    #[inline(never)]
    pub(super) fn open_cells(
        &mut self,
        stretch: &Stretch<S>,
        bounds: &DerivativeBounds<S>,
    ) -> OpenCells {
        let mut grid = Grid::blank(stretch, bounds);
        grid.fill(&self.sum);
        self.peak.evaluations += COST;
        let mut open = if self.knows_nothing() {
            [!(u32::MAX << stretch.cells()); 2]
        } else {
            self.open(&grid, [u32::MAX; 2])
        };
        // Some cells next to a local maximum may stay open. From these cells, Newton's method on this grid would lead
        // to the same maximum. A finer grid therefore searches these cells.
        let mut left = [u32::MAX; 2];
        for _ in 0..SUMMITS {
            let [plus, minus] = [open[0] & left[0], open[1] & left[1]];
            if [plus, minus] == NONE {
                return open;
            }
            let led = self.guess.take_if(|guess| stretch.holds(guess.tau));
            let Some(place) = led.or_else(|| self.highest(&grid, [plus, minus])) else {
                return open;
            };
            let Some(summit) = self.summit(&place, &grid) else {
                if led.is_some() {
                    continue;
                }
                break;
            };
            let about = self.about(&summit, &grid, open);
            if about == NONE {
                break;
            }
            for (open, about) in open.iter_mut().zip(about) {
                *open &= !about;
            }
            open = self.open(&grid, open);
            let [of_plus, of_minus] = &mut left;
            let of = if summit.negative { of_minus } else { of_plus };
            let cell = grid.cell_of(summit.tau);
            *of &= !(cell | (cell << 1) | (cell >> 1));
        }
        self.open(&grid, open)
    }

    /// Returns true if the search is for the maximum of a motion and has not found any value yet. Without a value, the
    /// search cannot close a cell.
    fn knows_nothing(&self) -> bool {
        self.problem.weight == Weight::One && self.peak.value.is_zero()
    }

    /// Returns the cells of `among` in which the sum or its negative may exceed the largest value found.
    fn open(&self, grid: &Grid<S>, among: OpenCells) -> OpenCells {
        let mut open = NONE;
        for (open, (&negative, among)) in open.iter_mut().zip(self.signs().iter().zip(among)) {
            if among != 0 {
                *open = self.open_of(grid, negative, among);
            }
        }
        open
    }

    /// Returns the level with which the search compares the upper bound of a cell. The search closes a cell if its
    /// upper bound does not exceed the level. For a motion the level is slightly less than the largest value found. The
    /// search then also finds other maxima of the same height.
    fn bar(&self, negative: bool) -> S {
        match self.problem.weight {
            // This case means that the search has not found any value yet. If the sum consists only of rounding errors,
            // the search must still return its largest value.
            Weight::One if self.peak.places[0].is_none() => self.peak.value,
            Weight::One => {
                let equal = self.peak.value * S::constant(1.0 - EQUAL * S::RESOLUTION);
                equal.max(self.rounding)
            }
            Weight::Sine => self.signed(self.level(), negative),
        }
    }

    /// Returns ±sum − level at a node, and the derivative of this difference. For a search of sum/sin τ the level is
    /// multiplied by sin τ.
    pub(super) fn excess_at(&self, node: &GridNode<S>, negative: bool, level: S) -> (S, S) {
        let GridNode {
            value,
            slope,
            sine,
            cosine,
        } = *node;
        let (value, slope) = if negative {
            (-value, -slope)
        } else {
            (value, slope)
        };
        match self.problem.weight {
            Weight::One => (value - level, slope),
            Weight::Sine => (value - level * sine, slope - level * cosine),
        }
    }

    /// Returns the cells of `among` in which the sum may exceed the level. In these cells a Bernstein coefficient of
    /// the cubic exceeds the level minus the error of the cubic. The four coefficients are the values at the two nodes
    /// of the cell, and value ± slope·h/3 at each node.
    pub(super) fn open_of(&self, grid: &Grid<S>, negative: bool, among: u32) -> u32 {
        let zero = S::constant(0.0);
        let Stretch {
            from, to, width, ..
        } = grid.stretch;
        let bar = self.bar(negative);
        let over_sine = self.problem.weight == Weight::Sine;
        let fourth = grid.bounds.fourth + if over_sine { bar.abs() } else { zero };
        let third = width * S::constant(1.0 / 3.0);
        let quartic = width * width * (width * width) * fourth;
        let slack = quartic * S::constant(1.0 / 384.0);
        let mut open = 0_u32;
        grid.beside(among, |after, tau, node| {
            let before = after >> 1;
            let (value, slope) = self.excess_at(&node, negative, bar);
            let slack = slack + grid.rounding(tau + width);
            if !(value + third * slope.abs() + slack <= zero) {
                open |= if !(value + slack <= zero) {
                    before | after
                } else if slope < zero {
                    before
                } else {
                    after
                };
            }
        });
        let cells = grid.stretch.cells();
        open &= !(u32::MAX << cells);
        if over_sine && from.is_zero() && among & 1 != 0 {
            open = (open & !1) | u32::from(!self.starts_below(grid, negative, bar));
        }
        let last = 1 << (cells - 1);
        if over_sine && self.ends_at_pi(to) && among & last != 0 {
            let slack = quartic * S::constant(1.0 / 162.0) + grid.bounds.rounding;
            let below = self.ends_below(grid, negative, bar, slack);
            open = (open & !last) | if below { 0 } else { last };
        }
        open & among
    }

    /// Returns true if the code proves that ±sum/sin τ stays below the level `bar` in the last cell before τ = π. The
    /// sum and sin τ both vanish at π. The cubic of the cell is therefore the distance from π times a parabola.
    fn ends_below(&self, grid: &Grid<S>, negative: bool, bar: S, slack: S) -> bool {
        let width = grid.stretch.width;
        let cells = grid.stretch.cells();
        let (Some(before), Some(last)) = (grid.node(cells - 1), grid.node(cells)) else {
            return false;
        };
        let (value, slope) = self.excess_at(&before, negative, bar);
        let (_, last) = self.excess_at(&last, negative, bar);
        let middle = (value + width * slope * S::constant(1.0 / 3.0)) * S::constant(1.5);
        let most = value.max(middle).max(-(width * last));
        most + slack <= S::constant(0.0)
    }

    /// Returns true if the code proves that ±sum/sin τ stays below the level `bar` in the first cell. At τ = 0 the sum
    /// and its slope vanish. The function first bounds sum/τ², which is a parabola apart from a term with the fifth
    /// derivative. If this bound exceeds the level, the function bounds (sum − bar·sin τ)/τ by a cubic.
    fn starts_below(&self, grid: &Grid<S>, negative: bool, bar: S) -> bool {
        let (zero, half) = (S::constant(0.0), S::constant(0.5));
        let third = S::constant(1.0 / 3.0);
        let (width, bounds) = (grid.stretch.width, grid.bounds);
        let Some(node) = grid.node(1) else {
            return false;
        };
        let second = if negative {
            -bounds.second
        } else {
            bounds.second
        };
        let (value, slope) = self.excess_at(&node, negative, zero);
        let square = width * width;
        let error = grid.rounding(width);
        let rounding = error / square;
        let at_node = value / square + rounding;
        let between = (value + value) / square - slope * half / width
            + bounds.fifth * (square * width * S::constant(1.0 / 240.0))
            + rounding
            + rounding;
        if (second * half).max(at_node).max(between) <= bar * node.sine / square {
            return true;
        }
        // The fourth derivative of E/τ is at most a fifth of the fifth derivative of E, where E is sum − bar·sin τ.
        let (value, slope) = self.excess_at(&node, negative, bar);
        let slack = (bounds.fifth + bar) * (square * square * S::constant(1.0 / (5.0 * 384.0)))
            + error / width;
        let at_node = value / width;
        let most = (second * half * width * third - bar)
            .max(-bar)
            .max(at_node)
            .max(at_node - (slope - at_node) * third);
        most + slack <= zero
    }
}
