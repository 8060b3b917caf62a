//! Features of scenes: the thesis's printed numbers, and random scenes against dense samples.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

mod beside;
mod dense;
mod facts;
mod scenes;
mod slopes;
