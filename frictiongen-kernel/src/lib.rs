//! What generated friction solvers call.
//!
//! Rooms, each of which knows only those before it: [`number`], [`oscillator`], [`modal_sum`], [`contact`],
//! [`response`], [`table`], [`simulation`], [`stepper`], [`orbit`].  [`errors`] has what a question outside its domain is answered with.
#![cfg_attr(not(any(test, feature = "std")), no_std)]

pub mod contact;
#[doc(hidden)]
pub mod emitted;
pub mod errors;
pub mod modal_sum;
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
