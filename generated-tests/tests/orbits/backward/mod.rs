//! Tests the backward error of every answer: the number of rounding units by which masses, springs, damping, r, β and
//! τ must change so that the answer is exact.
//!
//! A rounding unit is the relative spacing ε of a scalar type, 2⁻⁵² in double precision. The code calls a point (r,
//! β, τ) of a scene `Place`, and the largest backward error that a test accepts `BAR`.

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
