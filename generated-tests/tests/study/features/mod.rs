//! Tests the features of scenes, against numbers that the thesis prints and against dense samples of random scenes.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

mod beside;
mod dense;
mod scenes;
mod slopes;
