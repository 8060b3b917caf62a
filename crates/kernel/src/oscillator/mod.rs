//! Formulas of a single mode of the chain: its constants, its response at a frequency, and its free motion in time.
//!
//! Each kind of damping has its own formulas in its own file: `undamped`, `underdamped`, `critical`, `overdamped`. The
//! file `values` has types and steps that several kinds share. [`mode`] and [`decay`] select the file by the kind of
//! damping. A mode has its own resonance and damping, and its own factors with which the load and the contact drive it.
//! This module contains no sum over modes.

mod critical;
pub mod decay;
pub mod mode;
mod overdamped;
mod undamped;
mod underdamped;
mod values;
