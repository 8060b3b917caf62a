//! Searches along a function in steps that skip no zero (*walks*). They find its first zero, the instant at which it
//! reaches a level, and its largest values.

mod first;
mod peak;
mod step;

pub(crate) use first::{Walk, WalkStart, first_reach, first_zero};
