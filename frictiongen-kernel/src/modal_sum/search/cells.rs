//! The largest value by grids: a cell is closed once nothing in it exceeds what is known.
//!
//! In a cell, between two nodes, the sum exceeds the largest Bernstein coefficient of its cubic by no more than the fourth
//! derivative allows.  Summits are looked at from the highest open cell on; what is open still is divided by a finer
//! grid, and walked over in the end (section 9 of `docs/derivation.md`).

use super::bounds::Bounds;
use super::grid::{Grid, Node, Stretch};
use super::{EQUAL, MAX_EVALUATIONS, Search, Weight};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Decay, Instant};

/// By so much of the largest value may a cubic be off: less takes more nodes, more leaves more cells open.
const SLACK: f64 = 2e-3;
/// A half period of more grids is walked over.
const MOST_GRIDS: f64 = 64.0;
/// A grid costs about as much as so many evaluations.
const COST: u32 = 2;
/// So many summits of a grid are looked at.
const SUMMITS: u32 = 6;
/// So often are open cells divided before they are walked over.
const DIVISIONS: u32 = 2;
/// Into so many cells.
const FINER: f64 = 11.0;

/// The open cells of a grid, one bit for each, for the sum and for its negative.
type Open = [u32; 2];

const NONE: Open = [0, 0];

impl<S: Float, D: Decay<S>> Search<'_, S, D> {
    /// The whole half period by grids; false if that would take too many.
    pub(super) fn by_grids(&mut self) -> bool {
        let end = self.question.end;
        let mut from = S::constant(0.0);
        while from < end && self.peak.evaluations < MAX_EVALUATIONS {
            let bounds = Bounds::of(&self.sum, &Instant::new(from * S::inverse_pi()), end - from);
            // From h⁴/384 times the fourth derivative.
            let fourth = bounds.fourth + self.level();
            let width = (S::constant(384.0 * SLACK) * self.size() / fourth)
                .sqrt()
                .sqrt();
            let most = width * S::constant(Stretch::<S>::MOST_CELLS * MOST_GRIDS);
            if !(end - from <= most) {
                if from.is_zero() {
                    return false;
                }
                self.walk_cells(from, end);
                return true;
            }
            let stretch = Stretch::new(from, end, width.held());
            self.settle(&stretch, &bounds, DIVISIONS);
            from = stretch.to;
        }
        true
    }

    /// About how large the largest value is.
    fn size(&self) -> S {
        let known = self.question.start + self.peak.value;
        if self.question.weight == Weight::One && known.is_zero() {
            let (cosine, sine) = self.sum.start();
            return cosine.abs() + sine.abs();
        }
        known
    }

    /// A stretch by one grid, and what that leaves open by finer ones or a walk.
    fn settle(&mut self, stretch: &Stretch<S>, bounds: &Bounds<S>, divisions: u32) {
        let [plus, minus] = self.open_cells(stretch, bounds);
        let mut open = plus | minus;
        let mut left = stretch.from;
        let mut run: Option<S> = None;
        while open != 0 {
            if open & 1 == 1 {
                run = run.or(Some(left));
            } else if let Some(from) = run.take() {
                self.divide(from, left, bounds, divisions);
            }
            open >>= 1;
            left = left + stretch.width;
        }
        if let Some(from) = run {
            self.divide(from, left.min(stretch.to), bounds, divisions);
        }
    }

    /// Open cells side by side.
    fn divide(&mut self, from: S, to: S, bounds: &Bounds<S>, divisions: u32) {
        match divisions.checked_sub(1) {
            Some(left) if self.peak.evaluations < MAX_EVALUATIONS => {
                let stretch = Stretch::new(from, to, (to - from) * S::constant(1.0 / FINER));
                self.settle(&stretch, bounds, left);
            }
            _ => self.walk_cells(from, to),
        }
    }

    fn walk_cells(&mut self, from: S, to: S) {
        let signs = self.signs();
        let (mut from, mut to) = (from, to);
        if self.question.weight == Weight::Sine {
            if from.is_zero() {
                from = self.start(signs);
            }
            if self.ends_at_pi(to) {
                to = self.last(signs);
            }
        }
        self.walk(from, to);
    }

    /// Whether sum and sine both vanish here, at the end of the half period.
    fn ends_at_pi(&self, to: S) -> bool {
        !(to < self.question.end) && !(to < S::pi() * S::constant(0.75))
    }

    /// The cells of a grid that may hold more than is known, once its summits are.
    #[inline(never)]
    pub(super) fn open_cells(&mut self, stretch: &Stretch<S>, bounds: &Bounds<S>) -> Open {
        let grid = Grid::of(&self.sum, stretch, bounds);
        self.peak.evaluations += COST;
        let mut closed = NONE;
        for _ in 0..SUMMITS {
            let open = self.open(&grid, closed);
            if open == NONE {
                return NONE;
            }
            let Some(place) = self.highest(&grid, open) else {
                return open;
            };
            let Some(summit) = self.summit(&place, bounds.fourth) else {
                break;
            };
            let [plus, minus] = &mut closed;
            let known = if place.negative { minus } else { plus };
            let about = self.about(&summit, &grid);
            if about & !*known == 0 {
                break;
            }
            *known |= about;
        }
        self.open(&grid, closed)
    }

    fn open(&self, grid: &Grid<S>, closed: Open) -> Open {
        let mut open = NONE;
        for (open, (&negative, closed)) in open.iter_mut().zip(self.signs().iter().zip(closed)) {
            *open = self.open_of(grid, negative) & !closed;
        }
        open
    }

    /// The level that a cell must stay below: of a motion all maxima count that are equal.
    fn bar(&self, negative: bool) -> S {
        match self.question.weight {
            Weight::One => {
                let equal = self.peak.value * S::constant(1.0 - EQUAL * S::RESOLUTION);
                equal.max(self.rounding)
            }
            Weight::Sine => self.signed(self.level(), negative),
        }
    }

    /// ±sum − level·weight and its slope at a node.
    pub(super) fn excess_at(&self, node: &Node<S>, negative: bool, level: S) -> (S, S) {
        let Node {
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
        match self.question.weight {
            Weight::One => (value - level, slope),
            Weight::Sine => (value - level * sine, slope - level * cosine),
        }
    }

    /// The cells in which a Bernstein coefficient, value or value ± slope·h/3, leaves room for more.
    fn open_of(&self, grid: &Grid<S>, negative: bool) -> u32 {
        let zero = S::constant(0.0);
        let Stretch {
            from, to, width, ..
        } = grid.stretch;
        let bar = self.bar(negative);
        let over_sine = self.question.weight == Weight::Sine;
        let fourth = grid.bounds.fourth + if over_sine { bar } else { zero };
        let third = width * S::constant(1.0 / 3.0);
        let quartic = width * width * (width * width) * fourth;
        let slack = quartic * S::constant(1.0 / 384.0) + grid.bounds.rounding;
        let (mut open, mut bit) = (0_u32, 1_u32);
        for (_, node) in grid.nodes() {
            let (value, slope) = self.excess_at(&node, negative, bar);
            if !(value + third * slope.abs() + slack <= zero) {
                open |= if !(value + slack <= zero) {
                    bit | (bit >> 1)
                } else if slope < zero {
                    bit >> 1
                } else {
                    bit
                };
            }
            bit <<= 1;
        }
        let cells = grid.stretch.cells();
        open &= !(u32::MAX << cells);
        if over_sine && from.is_zero() {
            open = (open & !1) | u32::from(!self.starts_below(grid, negative, bar));
        }
        if over_sine && self.ends_at_pi(to) {
            let last = 1 << (cells - 1);
            let slack = quartic * S::constant(1.0 / 162.0) + grid.bounds.rounding;
            let below = self.ends_below(grid, negative, bar, slack);
            open = (open & !last) | if below { 0 } else { last };
        }
        open
    }

    /// The last cell of a sum that vanishes with sin τ: what is left of the cubic is a parabola times the distance from
    /// the end.
    fn ends_below(&self, grid: &Grid<S>, negative: bool, bar: S, slack: S) -> bool {
        let width = grid.stretch.width;
        let mut nodes = grid.nodes().skip(grid.stretch.cells() - 1);
        let mut next = || {
            let (_, node) = nodes.next()?;
            Some(self.excess_at(&node, negative, bar))
        };
        let Some(((value, slope), (_, last))) = next().zip(next()) else {
            return false;
        };
        let middle = (value + width * slope * S::constant(1.0 / 3.0)) * S::constant(1.5);
        let most = value.max(middle).max(-(width * last));
        most + slack <= S::constant(0.0)
    }

    /// The first cell of a sum that vanishes with its slope at 0: by the sum over τ², a parabola but for what the fifth
    /// derivative can add, or by the excess over τ, a cubic.
    fn starts_below(&self, grid: &Grid<S>, negative: bool, bar: S) -> bool {
        let (zero, half) = (S::constant(0.0), S::constant(0.5));
        let third = S::constant(1.0 / 3.0);
        let (width, bounds) = (grid.stretch.width, grid.bounds);
        let Some((_, node)) = grid.nodes().nth(1) else {
            return false;
        };
        let second = if negative {
            -bounds.second
        } else {
            bounds.second
        };
        let (value, slope) = self.excess_at(&node, negative, zero);
        let square = width * width;
        let rounding = bounds.rounding / square;
        let at_node = value / square + rounding;
        let between = (value + value) / square - slope * half / width
            + bounds.fifth * (square * width * S::constant(1.0 / 240.0))
            + rounding
            + rounding;
        if (second * half).max(at_node).max(between) <= bar * node.sine / square {
            return true;
        }
        // The fourth derivative of a function over τ is at most a fifth of its fifth.
        let (value, slope) = self.excess_at(&node, negative, bar);
        let slack = (bounds.fifth + bar) * (square * square * S::constant(1.0 / (5.0 * 384.0)))
            + bounds.rounding / width;
        let at_node = value / width;
        let most = (second * half * width * third - bar)
            .max(-bar)
            .max(at_node)
            .max(at_node - (slope - at_node) * third);
        most + slack <= zero
    }
}
