//! Motions over time and their spectra, beside an integrator of its own, runs in other steps, steady states and the
//! balance of energy.
#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

mod energy;
mod integration;
mod refused;
mod scenes;
mod spectra;
mod steady;
mod steps;
