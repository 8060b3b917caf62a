//! Question for a steady state.

use super::start::Start;
use crate::contact::sums::Chain;
use crate::motion::Dynamics;

/// The steady state that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct OrbitQuestion<'a, 's, S, K = Chain<S>> {
    /// Data of the scene.
    pub dynamics: Dynamics<'a, S, K>,
    /// Frequency ratio r.
    pub r: S,
    /// Friction ratio β.
    pub beta: S,
    /// β*_lim, from which on the motion may end with the contact stuck.
    pub sliding: S,
    /// Start at a maximum of the excitation.
    pub start: Start<'s, S>,
    /// If true, a motion that does not settle gives its last [`MAX_PERIOD`](super::MAX_PERIOD) cycles.  If false, it
    /// gives an error.
    pub last: bool,
}
