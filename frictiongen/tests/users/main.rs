//! Problems that users met in their first hour, each as a test.
#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

mod builder;
#[cfg(feature = "event-times")]
mod instants;
mod limits;
mod runs;
mod slices;
mod traits;
mod units;
