//! What generated friction solvers call.
#![cfg_attr(not(any(test, feature = "std")), no_std)]

pub mod absorber;
mod apart;
pub mod chain;
pub mod complex;
pub mod constraint;
pub mod dd;
pub mod decay;
pub mod dual;
#[doc(hidden)]
pub mod emitted;
pub mod errors;
mod float;
pub mod limits;
#[doc(hidden)]
pub mod locals;
#[doc(hidden)]
pub mod missing;
pub mod mode;
pub mod motion;
pub mod orbit;
mod pairs;
pub mod regime;
pub mod response;
pub mod scalar;
pub mod search;
pub mod simulation;
pub mod special;
pub mod steady;
mod sway;
#[cfg(test)]
mod testing;
pub mod trig;
pub mod two_stops;
pub mod wave;

pub use num_complex::Complex;
pub use scalar::{Float, Plain, Scalar};
