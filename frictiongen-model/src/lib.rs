//! Scenes of mass-spring chains with one Coulomb contact. The crate has their description, their validation, their
//! modal analysis in double-double, and their tables of a declared accuracy.

pub mod interval;
pub mod jacobi;
pub mod modal;
mod modal_sums;
pub mod reduced;
mod roots;
mod rounding;
#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub mod samples;
pub mod scene;
pub mod sensitivity;
mod special;
pub mod stepping;
pub mod table;
pub mod transient;
pub mod validate;

pub use rounding::rounded;
