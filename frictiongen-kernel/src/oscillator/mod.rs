//! One mode alone, with its constants, its response and half-period values at a frequency, and its free motion in time.
//!
//! Each kind of damping has its own formulas in its own file: `undamped`, `underdamped`, `critical`, `overdamped`. They
//! use numbers and `values`, which contains what they have in common. [`mode`] and [`decay`] choose between them. A
//! mode knows its own resonance and damping, and how strongly load and contact drive it. It knows neither other modes
//! nor sums.

mod critical;
pub mod decay;
pub mod mode;
mod overdamped;
mod undamped;
mod underdamped;
mod values;
