//! Backward error of every answer: the number of roundings of masses, springs, damping, r, β and τ for which the answer
//! is exact.
//!
//! A rounding is the relative spacing ε of a scalar, 2⁻⁵² in double precision. A point (r, β, τ) of a scene is
//! called `Place` in the code. The largest backward error that a test accepts is called `BAR`.

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
