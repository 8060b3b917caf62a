//! Scenes of mass-spring chains with Coulomb contacts. This crate describes a scene, validates it, and computes its
//! modes in double-double (about 31 digits). For scenes with one contact it also builds tables with a declared
//! accuracy.

pub mod interval;
pub mod jacobi;
pub mod joined;
pub mod modal;
mod modal_sums;
pub mod reduced;
mod roots;
mod rounding;
#[cfg(any(test, feature = "samples"))]
pub mod samples;
pub mod scene;
pub mod sensitivity;
mod special;
pub mod stepping;
pub mod stribeck;
pub mod table;
pub mod transient;
pub mod validate;

pub use rounding::rounded;
