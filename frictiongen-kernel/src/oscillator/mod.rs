//! One mode alone: its constants, its response and half-period values at a frequency, its free motion in time.
//!
//! What is written here is written for each kind of damping: undamped, under-critically, critically and over-critically
//! damped.  A mode knows its own resonance and damping, and how strongly load and contact drive it; of other modes, and
//! of sums, it knows nothing.

pub mod decay;
pub mod mode;
