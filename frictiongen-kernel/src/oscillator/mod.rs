//! One mode alone: its constants, its response and half-period values at a frequency, its free motion in time.
//!
//! What is written here is written for each kind of damping, and each kind has its file: `undamped`, `underdamped`,
//! `critical`, `overdamped`.  They know numbers and `values`, what they have in common; [`mode`] and [`decay`] choose
//! between them.  A mode knows its own resonance and damping, and how strongly load and contact drive it; of other
//! modes, and of sums, it knows nothing.

mod critical;
pub mod decay;
pub mod mode;
mod overdamped;
mod undamped;
mod underdamped;
mod values;
