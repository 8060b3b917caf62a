//! Backward error of every answer: the number of roundings of masses, springs, damping, r, β and τ for which the answer
//! is exact.

mod asked;
mod extremes;
mod fit;
mod inputs;
mod instant;
mod judge;
mod orbits;
mod property;
mod questions;
mod random;
mod seen;
mod tally;
