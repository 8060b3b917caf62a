//! Tests of the features of scenes: numbers that the thesis prints, and random scenes against dense samples.
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
