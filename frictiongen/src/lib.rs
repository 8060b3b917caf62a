//! Exact solvers for mass-spring chains with one Coulomb friction contact.
//!
//! TODO
#![cfg_attr(not(feature = "std"), no_std)]

pub mod system;

#[cfg(feature = "study")]
pub mod study;

pub use frictiongen_kernel as kernel;
pub use frictiongen_kernel::Complex;
pub use frictiongen_kernel::errors::{Error, NotContinuous, OutOfDomain, Regime, StuckResonance};
pub use frictiongen_macros::friction_system;
#[cfg(feature = "study")]
pub use study::System;
pub use system::{ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StuckAt};
