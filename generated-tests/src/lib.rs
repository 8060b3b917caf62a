//! Scenes whose emitted code this crate compiles, compares with its snapshot, and runs.
//!
//! The crate also has the reference values against which tests check emitted solvers and the run-time system.

pub mod data;
pub mod reference;
pub mod scenes;
pub mod shown;

/// Returns the larger of two numbers, or NaN if either is NaN, so that a NaN does not vanish in a maximum.
#[must_use]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Compiles the Rust examples of `docs/guide.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/guide.md")]
pub struct GuidePage;

/// Compiles the Rust examples of `docs/firmware.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/firmware.md")]
pub struct FirmwarePage;

/// Compiles the Rust examples of `docs/start.md`.
#[cfg(doctest)]
#[doc = include_str!("../../docs/start.md")]
pub struct StartPage;
