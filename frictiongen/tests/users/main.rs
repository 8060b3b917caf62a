//! What users met in their first hour, each as a test.
#![cfg(feature = "study")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of a test"
)]

mod random;
mod runs;
