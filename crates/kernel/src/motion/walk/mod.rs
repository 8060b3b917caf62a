//! Searches along a function in steps that skip no zero (*walks*). The searches find the first zero, the instant at
//! which the function reaches a level, and the largest values.

mod first;
mod peak;
mod step;

pub(crate) use first::{WalkResult, WalkStart, first_reach, first_zero};
