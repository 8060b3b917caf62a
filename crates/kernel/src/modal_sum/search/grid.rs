//! Grid of nodes over an interval of the half period, with upper bounds on the modal sum between the nodes.
//!
//! A constant matrix advances a mode from node to node, four nodes at a time. The loop therefore evaluates no sine and
//! no exponential function.
//!
//! Between two nodes a cubic with the same values and slopes at both nodes approximates the sum. The error of the cubic
//! is at most h⁴/384 times the fourth derivative, where h is the distance between the nodes. The Bernstein coefficients
//! of the cubic follow directly from the values and slopes (section 9 of `docs/derivation.md`).

use super::bounds::{DerivativeBounds, ModeTrack, keeps_forcing};
use super::row::{LANES, LaneRow, Matrix, add, advanced, first_lanes, pairwise};
use crate::modal_sum::wave::{Sum, Wave};
use crate::number::scalar::Float;
use crate::oscillator::decay::{Basis, Decay, Instant};

/// Largest number of rows of a grid. A row has four nodes.
const ROWS: usize = 8;

/// Open cells of a grid as two sets of bits, one bit for each cell. The first set belongs to the sum, the second set to
/// the negative of the sum. In an open cell, a larger value than the largest value found may exist.
pub(super) type OpenCells = [u32; 2];

/// Interval of the half period that one grid covers, and the width of the grid's cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch<S> {
    pub from: S,
    /// Width of a cell of the grid: the distance between two nodes, in rad.
    pub width: S,
    /// Number of rows of the grid. A row has four nodes.
    rows: usize,
    /// True if all modes are at rest at the start of the interval, and the code does not split their motions into free
    /// and forced motions. The rounding error of the sum is then 0 at the start, and grows with time.
    pub keeps_forcing: bool,
    /// Phase τ of the grid's last node, in rad.
    pub to: S,
}

impl<S: Float> Stretch<S> {
    /// Creates an interval that starts at `from`, with cells of at most the given width. The interval ends at `end`,
    /// or before `end` if one grid of such cells cannot cover the whole interval.
    pub fn new(from: S, end: S, width: S, keeps_forcing: bool) -> Self {
        let (mut rows, mut cells) = (1, S::constant(LANES as f64 - 1.0));
        let left = end - from;
        while width * cells < left && rows < ROWS {
            (rows, cells) = (rows + 1, cells + S::constant(LANES as f64));
        }
        let (width, to) = if width * cells < left {
            (width, from + width * cells)
        } else {
            (left / cells, end)
        };
        Self {
            from,
            width,
            rows,
            keeps_forcing,
            to,
        }
    }

    /// Returns true if the interval contains the phase τ.
    pub fn holds(&self, tau: S) -> bool {
        self.from <= tau && tau <= self.to
    }

    /// Returns the number of cells, one less than the number of nodes.
    pub fn cells(&self) -> usize {
        self.rows * LANES - 1
    }
}

/// Value and slope of a modal sum at one node of a grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct GridNode<S> {
    pub value: S,
    pub slope: S,
    /// Sine of the phase τ at the grid's node.
    pub sine: S,
    /// Cosine of the phase τ at the grid's node.
    pub cosine: S,
}

/// Values and slopes of a modal sum at equidistant nodes, with bounds on its derivatives from the first node on.
pub(super) struct Grid<S> {
    pub stretch: Stretch<S>,
    pub bounds: DerivativeBounds<S>,
    value: [LaneRow<S>; ROWS],
    slope: [LaneRow<S>; ROWS],
    sine: [LaneRow<S>; ROWS],
    cosine: [LaneRow<S>; ROWS],
}

/// Displacement and velocity that the force on a mode adds in one step from node to node. `value` and `slope` contain
/// the coefficients of sin τ, cos τ and 1 in the added displacement and velocity. τ is the phase at the start of the
/// step.
struct ForcedStep<S> {
    value: [S; 3],
    slope: [S; 3],
}

impl<S: Float> ForcedStep<S> {
    fn of<D: Decay<S>>(wave: &Wave<S, D>, loss: S, basis: &Basis<S>) -> Self {
        let x = wave.x;
        let detuning = (x - S::constant(1.0)) * (x + S::constant(1.0));
        // The code computes the differences cos h − d and sin h − p after the step h, and their derivatives. p is the
        // free displacement, and d = p′ + 2ζx·p is the free motion that starts at rest from the displacement 1.
        let of_cosine = basis.forced_slope - loss * basis.free;
        let of_sine = basis.forced;
        let of_cosine_slope = detuning * basis.free - basis.forced;
        let of_sine_slope = basis.forced_slope;
        let (b, c) = (wave.forced_slope, wave.forced);
        Self {
            value: [
                c * of_cosine - b * of_sine,
                b * of_cosine + c * of_sine,
                wave.rise * basis.rise,
            ],
            slope: [
                c * of_cosine_slope - b * of_sine_slope,
                b * of_cosine_slope + c * of_sine_slope,
                wave.rise * basis.free,
            ],
        }
    }

    #[inline(always)]
    fn at(&self, sine: S, cosine: S) -> (S, S) {
        let [s, c, one] = self.value;
        let value = s * sine + c * cosine + one;
        let [s, c, one] = self.slope;
        (value, s * sine + c * cosine + one)
    }
}

impl<S: Float> Grid<S> {
    /// Creates a grid whose values and slopes are all 0.
    #[inline(always)]
    pub fn blank(stretch: &Stretch<S>, bounds: &DerivativeBounds<S>) -> Self {
        let blank = [[S::constant(0.0); LANES]; ROWS];
        Self {
            stretch: *stretch,
            bounds: *bounds,
            value: blank,
            slope: blank,
            sine: blank,
            cosine: blank,
        }
    }

    /// Evaluates the sum at all nodes. The function writes into the existing grid, because a returned grid would be on
    /// the stack twice.
    pub fn fill<D: Decay<S>>(&mut self, sum: &Sum<'_, S, D>) {
        let (zero, stretch) = (S::constant(0.0), self.stretch);
        let at = &Instant::from_start(stretch.from);
        let width = stretch.width;
        let step = Instant::new(width * S::inverse_pi());
        self.turn(at, &step);
        // `four` is the phase advance of one row, which has four nodes. The code needs `four` only for modes whose
        // motion it does not split into a free and a forced motion.
        let mut four = None;
        let (mut constant, mut cosine, mut sine) = (zero, sum.cosine, sum.sine);
        for wave in sum.waves {
            let (track, common) = ModeTrack::of(wave, at, stretch.keeps_forcing);
            let advance = |basis: &Basis<S>| {
                let matrix = Matrix::of(track.x, track.loss, (basis.free, basis.slope));
                (matrix, ForcedStep::of(wave, track.loss, basis))
            };
            if keeps_forcing(wave, stretch.keeps_forcing) {
                let near = advance(&wave.decay.basis(wave.x, &step));
                let four = four.get_or_insert_with(|| {
                    Instant::new(width * S::constant(LANES as f64) * S::inverse_pi())
                });
                let far = advance(&wave.decay.basis(wave.x, four));
                self.add_forced(&track, &near, &far);
            } else {
                let free = wave.decay.free(wave.x, &step);
                self.add_free(&track, &Matrix::of(track.x, track.loss, free));
            }
            constant = constant + common.constant;
            cosine = cosine + common.cosine;
            sine = sine + common.sine;
        }
        self.add_common(constant, cosine, sine);
    }

    /// Computes sin τ and cos τ at all nodes of the grid.
    fn turn(&mut self, at: &Instant<S>, step: &Instant<S>) {
        let matrix = Matrix {
            a: step.cosine,
            b: step.sine,
            c: -step.sine,
            d: step.cosine,
        };
        let (sine, cosine) = first_lanes((at.sine, at.cosine), |u, v, _| matrix.times(u, v));
        let far = matrix.squared().squared();
        let (mut sine, mut cosine) = (sine, cosine);
        for (s, c) in self
            .sine
            .iter_mut()
            .zip(&mut self.cosine)
            .take(self.stretch.rows)
        {
            (*s, *c) = (sine, cosine);
            (sine, cosine) = advanced(&far, sine, cosine);
        }
    }

    fn add_free(&mut self, track: &ModeTrack<S>, matrix: &Matrix<S>) {
        let start = (track.value, track.slope);
        let (mut value, mut slope) = first_lanes(start, |u, v, _| matrix.times(u, v));
        let far = matrix.squared().squared();
        for (v, s) in self
            .value
            .iter_mut()
            .zip(&mut self.slope)
            .take(self.stretch.rows)
        {
            add(v, &value);
            add(s, &slope);
            (value, slope) = advanced(&far, value, slope);
        }
    }

    fn add_forced(
        &mut self,
        track: &ModeTrack<S>,
        near: &(Matrix<S>, ForcedStep<S>),
        far: &(Matrix<S>, ForcedStep<S>),
    ) {
        let start = (track.value, track.slope);
        let [sines, ..] = &self.sine;
        let [cosines, ..] = &self.cosine;
        let (mut value, mut slope) = first_lanes(start, |u, v, lane| {
            let (value, slope) = near.0.times(u, v);
            let angle = sines.iter().zip(cosines).nth(lane);
            let (of_value, of_slope) = angle.map_or((u, v), |(s, c)| near.1.at(*s, *c));
            (value + of_value, slope + of_slope)
        });
        let rows = self
            .value
            .iter_mut()
            .zip(&mut self.slope)
            .take(self.stretch.rows);
        let angles = self.sine.iter().zip(&self.cosine);
        for ((v, s), (sine, cosine)) in rows.zip(angles) {
            add(v, &value);
            add(s, &slope);
            (value, slope) = advanced(&far.0, value, slope);
            let (of_value, of_slope) = pairwise(*sine, *cosine, |s, c| far.1.at(s, c));
            add(&mut value, &of_value);
            add(&mut slope, &of_slope);
        }
    }

    /// Adds the function constant + cosine·cos τ + sine·sin τ to the values of all nodes, and its derivative to the
    /// slopes.
    fn add_common(&mut self, constant: S, cosine: S, sine: S) {
        let rows = self
            .value
            .iter_mut()
            .zip(&mut self.slope)
            .take(self.stretch.rows);
        let angles = self.sine.iter().zip(&self.cosine);
        for ((values, slopes), (sines, cosines)) in rows.zip(angles) {
            let (value, slope) = pairwise(*sines, *cosines, |s, c| {
                (constant + cosine * c + sine * s, sine * c - cosine * s)
            });
            add(values, &value);
            add(slopes, &slope);
        }
    }

    /// Returns an upper bound on the rounding error of the modal sum at the node with phase `tau`.
    pub fn rounding(&self, tau: S) -> S {
        let DerivativeBounds {
            rounding, drift, ..
        } = self.bounds;
        if self.stretch.keeps_forcing && self.stretch.from.is_zero() {
            rounding.min(drift * tau)
        } else {
            rounding
        }
    }

    /// Calls `visit` for both nodes of each cell in `cells`, in ascending order. The arguments of `visit` are the bit
    /// of the cell after the node, the phase τ of the node, and the node.
    pub fn beside(&self, cells: u32, mut visit: impl FnMut(u32, S, GridNode<S>)) {
        let values = self.value.as_flattened().iter();
        let slopes = self.slope.as_flattened();
        let angles = self.sine.as_flattened().iter();
        let angles = angles.zip(self.cosine.as_flattened());
        let (mut tau, mut bit) = (self.stretch.from, 1_u32);
        let mut nodes = cells | (cells << 1);
        let all = values.zip(slopes).zip(angles);
        for ((value, slope), (sine, cosine)) in all.take(self.stretch.rows * LANES) {
            if nodes & 1 != 0 {
                let node = GridNode {
                    value: *value,
                    slope: *slope,
                    sine: *sine,
                    cosine: *cosine,
                };
                visit(bit, tau, node);
            }
            nodes >>= 1;
            if nodes == 0 {
                break;
            }
            bit <<= 1;
            tau = tau + self.stretch.width;
        }
    }

    /// Returns the bit of the cell that contains the phase τ. The result is 0 if τ is before the first node or after
    /// the last.
    pub fn cell_of(&self, tau: S) -> u32 {
        let (mut cell, mut right) = (1_u32, self.stretch.from);
        if tau < right {
            return 0;
        }
        for _ in 0..self.stretch.cells() {
            right = right + self.stretch.width;
            if tau <= right {
                return cell;
            }
            cell <<= 1;
        }
        0
    }

    /// Returns the node with an index, counted from 0, or `None` after the last node.
    pub fn node(&self, index: usize) -> Option<GridNode<S>> {
        if index > self.stretch.cells() {
            return None;
        }
        let of = |rows: &[LaneRow<S>; ROWS]| rows.get(index / LANES)?.get(index % LANES).copied();
        Some(GridNode {
            value: of(&self.value)?,
            slope: of(&self.slope)?,
            sine: of(&self.sine)?,
            cosine: of(&self.cosine)?,
        })
    }
}
