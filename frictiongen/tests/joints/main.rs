//! Several joints: the engine `kernel::joints`, which follows chains of rigid and elastic contacts and dashpots.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panics"
)]

mod clutches;
mod creep;
mod energy;
mod oscillator;
mod patterns;
mod reference;
mod scene;
