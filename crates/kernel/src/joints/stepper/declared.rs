//! Steppers whose tables are constants of the program, so that a constant expression can create them.

use super::{Layout, Pace, Status, Stepper};
use crate::Float;
use crate::joints::model::Model;
use crate::joints::run::Motion;
use crate::joints::size::Fixed;

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
    const ENTRIES: usize,
> Stepper<S, Fixed<N, NODES, M, L, U, SQUARE, LAW, ROW>, &'static [S; ENTRIES]>
{
    /// Creates a stepper at rest. `model` has no loads, friction forces of 0, and its longest stretch. `tables` are
    /// those of the model, the pace and the layout. `zero` is the number 0.
    #[must_use]
    pub const fn declared(
        model: Model<S, Fixed<N, NODES, M, L, U, SQUARE, LAW, ROW>>,
        (pace, layout): (Pace<S>, Layout),
        tables: &'static [S; ENTRIES],
        zero: S,
    ) -> Self {
        Self {
            motion: Motion::at_rest(model, zero),
            pace,
            layout,
            tables,
            ends: [[zero; ROW]; 2],
            status: Status::at_rest([zero; L], [zero; M], zero),
        }
    }
}
