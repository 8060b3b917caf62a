//! Friction and parameters from recordings that the tests make by simulation, sampling and added noise.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

mod axis;
mod bad;
mod decay;
mod elastic;
mod files;
mod force;
mod fuzz;
mod intervals;
mod made;
mod phase;
mod recordings;
mod sweeps;
mod unexplained;
mod units;
mod weights;
