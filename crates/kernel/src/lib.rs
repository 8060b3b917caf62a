//! Functions and types that generated friction solvers call.
//!
//! The modules, from the lowest layer to the highest, are [`number`], [`oscillator`], [`modal_sum`], [`contact`],
//! [`response`], [`table`] and [`motion`]. Each module uses only modules that precede it in this list. [`simulation`],
//! [`stepper`] and [`orbit`] use the modules of this list, but not each other. [`joints`] computes the motion of scenes
//! with several contacts. [`errors`] has the error types of all modules.
#![cfg_attr(not(any(test, feature = "std")), no_std)]

pub mod combination;
pub mod contact;
#[doc(hidden)]
pub mod emitted;
pub mod errors;
pub mod joints;
pub mod modal_sum;
pub mod motion;
pub mod number;
pub mod orbit;
pub mod oscillator;
pub mod response;
pub mod simulation;
pub mod stepper;
pub mod table;
#[cfg(test)]
mod testing;

pub use num_complex::Complex;
pub use number::scalar::{Float, Plain, Scalar};
