//! Searches along a function in steps that miss no zero (*walks*): for its first zero, for a level, and for its largest
//! values.

mod first;
mod peak;
mod step;

pub(crate) use first::{Walk, WalkStart, first_reach, first_zero};
