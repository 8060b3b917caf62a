//! Every answer against the scene it was asked of: by how many roundings of masses, springs, damping, r, β and τ
//! it is the exact one.

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
