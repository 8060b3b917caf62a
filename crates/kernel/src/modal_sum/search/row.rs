//! Rows of four neighbouring nodes of a grid, which the code advances together. A node is an instant at which the grid
//! evaluates the modal sum.
//!
//! The code writes out all operations on the four numbers of a row. A compiler that optimises for size would keep a
//! loop, and half of the instructions would count its passes.

use crate::number::scalar::Float;

/// Number of neighbouring grid nodes in one row.
pub(super) const LANES: usize = 4;

pub(super) type LaneRow<S> = [S; LANES];

/// The 2×2 matrix with the rows (a, b) and (c, d), which advances a displacement and a velocity by one time step.
#[derive(Clone, Copy)]
pub(super) struct Matrix<S> {
    pub a: S,
    pub b: S,
    pub c: S,
    pub d: S,
}

impl<S: Float> Matrix<S> {
    /// Returns the matrix that advances displacement and velocity of a free mode by a time step. x is the natural
    /// frequency divided by the excitation frequency, and `loss` is 2ζx. `free` and `slope` are the free displacement
    /// p and its derivative p′ after the step.
    pub fn of(x: S, loss: S, (free, slope): (S, S)) -> Self {
        Self {
            a: slope + loss * free,
            b: free,
            c: -(x * x * free),
            d: slope,
        }
    }

    pub fn squared(self) -> Self {
        let Self { a, b, c, d } = self;
        let (bc, trace) = (b * c, a + d);
        Self {
            a: a * a + bc,
            b: b * trace,
            c: c * trace,
            d: d * d + bc,
        }
    }

    #[inline(always)]
    pub fn times(&self, u: S, v: S) -> (S, S) {
        (self.a * u + self.b * v, self.c * u + self.d * v)
    }
}

/// Returns four consecutive pairs (displacement, velocity): the given start, and the results of three steps. The
/// closure `step` takes a pair and the index of its node, from 0 to 2.
#[inline(always)]
pub(super) fn first_lanes<S: Float>(
    (u, v): (S, S),
    step: impl Fn(S, S, usize) -> (S, S),
) -> (LaneRow<S>, LaneRow<S>) {
    let one = step(u, v, 0);
    let two = step(one.0, one.1, 1);
    let three = step(two.0, two.1, 2);
    ([u, one.0, two.0, three.0], [v, one.1, two.1, three.1])
}

/// Applies a function to four pairs (u, v) of numbers. The function returns two numbers for each pair. The result
/// contains the four first numbers, and then the four second numbers.
#[inline(always)]
pub(super) fn pairwise<S: Float>(
    [u0, u1, u2, u3]: LaneRow<S>,
    [v0, v1, v2, v3]: LaneRow<S>,
    of: impl Fn(S, S) -> (S, S),
) -> (LaneRow<S>, LaneRow<S>) {
    let (a, b, c, d) = (of(u0, v0), of(u1, v1), of(u2, v2), of(u3, v3));
    ([a.0, b.0, c.0, d.0], [a.1, b.1, c.1, d.1])
}

#[inline(always)]
pub(super) fn advanced<S: Float>(
    matrix: &Matrix<S>,
    u: LaneRow<S>,
    v: LaneRow<S>,
) -> (LaneRow<S>, LaneRow<S>) {
    pairwise(u, v, |u, v| matrix.times(u, v))
}

#[inline(always)]
pub(super) fn add<S: Float>(row: &mut LaneRow<S>, [a, b, c, d]: &LaneRow<S>) {
    let [p, q, r, s] = *row;
    *row = [p + *a, q + *b, r + *c, s + *d];
}
