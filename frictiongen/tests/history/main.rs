//! Motions over time and their spectra, compared with runs with other steps, steady states and the energy balance.
#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

mod energy;
mod refused;
mod scenes;
mod spectra;
mod steady;
mod steps;
