//! Arguments of the search for a steady state.

use super::start::Start;
use crate::contact::sums::Chain;
use crate::motion::Dynamics;

/// Arguments of the search for a steady state: the data of the scene, the ratios r and β, and the initial state.
#[derive(Clone, Copy, Debug)]
pub struct OrbitQuestion<'a, 's, S, K = Chain<S>> {
    /// Data of the scene from which the search computes its motion.
    pub dynamics: Dynamics<'a, S, K>,
    /// Frequency ratio r of the steady state.
    pub r: S,
    /// Friction ratio β of the steady state.
    pub beta: S,
    /// β*_lim, the limit of sliding. For β ≥ β*_lim the motion may end in a stuck state.
    pub sliding: S,
    /// Initial state of the motion, at a maximum of the excitation.
    pub start: Start<'s, S>,
    /// If true, and the motion does not settle, the result contains the last [`MAX_PERIOD`](super::MAX_PERIOD) cycles
    /// of the motion. If false, a motion that does not settle causes an error.
    pub last: bool,
}
