//! Arguments of the search for a steady state.

use super::start::Start;
use crate::contact::sums::Chain;
use crate::motion::Dynamics;

/// Arguments of the search for a steady state: the scene, the ratios r and β, and the start.
#[derive(Clone, Copy, Debug)]
pub struct OrbitQuestion<'a, 's, S, K = Chain<S>> {
    /// Data of the scene.
    pub dynamics: Dynamics<'a, S, K>,
    /// Frequency ratio r.
    pub r: S,
    /// Friction ratio β.
    pub beta: S,
    /// β*_lim, the limit of sliding. For β ≥ β*_lim the motion may end with the contact stuck.
    pub sliding: S,
    /// Initial state of the motion, at a maximum of the excitation.
    pub start: Start<'s, S>,
    /// If true, a motion that does not settle returns its last [`MAX_PERIOD`](super::MAX_PERIOD) cycles. If false, such
    /// a motion returns an error.
    pub last: bool,
}
