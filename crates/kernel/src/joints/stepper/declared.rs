//! Steppers whose tables are constants of the program, so that a constant expression can create them.

use super::{Layout, Pace, Status, Stepper};
use crate::Float;
use crate::joints::model::Model;
use crate::joints::run::Motion;
use crate::joints::size::Fixed;
use crate::joints::state::{FREE, State};
use crate::joints::tree::{NONE, Tree, UNUSED};

impl<
    S: Float,
    const N: usize,
    const NODES: usize,
    const M: usize,
    const L: usize,
    const U: usize,
    const SQUARE: usize,
    const LAW: usize,
    const ROW: usize,
    const STEP: usize,
    const C: usize,
    const ROWS: usize,
    const KEPT: usize,
    const ENTRIES: usize,
>
    Stepper<
        S,
        Fixed<N, NODES, M, L, U, SQUARE, LAW, ROW, 0, STEP, C, ROWS, KEPT>,
        &'static [S; ENTRIES],
    >
{
    /// Creates a stepper at rest. `model` has no loads, friction forces of 0, and its longest stretch. `tables` are
    /// those of the model and the pace. `zero` is the number 0.
    #[must_use]
    pub const fn declared(
        model: Model<S, Fixed<N, NODES, M, L, U, SQUARE, LAW, ROW, 0, STEP, C, ROWS, KEPT>>,
        pace: Pace<S>,
        tables: &'static [S; ENTRIES],
        zero: S,
    ) -> Self {
        let state = State {
            x: [zero; N],
            v: [zero; N],
            forces: [zero; M],
            places: [zero; M],
            phases: [FREE; M],
            zeros: [(0, 0); M],
        };
        let tree = Tree::empty([UNUSED; M], [false; M], [NONE; NODES], [zero; NODES]);
        Self {
            motion: Motion::at_start(model, state, tree, (), zero),
            pace,
            layout: Layout::of_properties((N, M, L), STEP),
            tables,
            ends: [[zero; ROW]; 2],
            status: Status::at_rest([zero; L], [zero; M], zero),
        }
    }
}
