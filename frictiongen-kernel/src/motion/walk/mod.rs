//! Walks along a function: to its first zero, to a level, and to its largest values.

mod first;
mod peak;
mod step;

pub(crate) use first::{Walk, WalkStart, first_reach, first_zero};
