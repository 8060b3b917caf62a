//! Tables with a declared accuracy, built from the exact functions of a scene.
//!
//! Polynomials approximate β_lim over pieces of r that are as long as the accuracy allows. Near a known zero r₀ of
//! β_lim the code fits a polynomial to β_lim/(r − r₀). β*_lim, the amplitude |V| of the contact without friction, and
//! the responses while the contact is stuck are products over their zeros and poles. A check compares the tables with
//! the exact values, at points that the fit did not use, in the arithmetic of the tables. `frictiongen-proof` proves
//! the accuracy at all r between these points.

mod bounds;
mod check;
mod cover;
mod digits;
mod errors;
mod evidence;
mod exact;
mod fit;
mod held;
mod held_build;
mod held_zeros;
mod index;
mod kinks;
mod product;
mod proportional;
mod quotients;
mod reach;
mod request;
mod rounding;
mod shares;
mod split;
mod tables;
mod verified;
mod worst;
mod zeros;

pub use errors::{FRICTION_SHARES, MOST_SHARE};
pub use evidence::{Evidence, Proof, ProofWork};
pub use fit::Fitted;
pub use held::{Held, HeldForm};
pub use index::Index;
pub use product::Product;
pub use reach::Reach;
pub use request::{COARSEST, FINEST, FINEST_PROVEN, FINEST_SINGLE, Request, TableError};
pub use tables::{TableReport, Tables};
pub use worst::Worst;

/// Functions of the table builder that the proof of a table also needs.
#[doc(hidden)]
pub mod building {
    pub use super::exact::{ANGLE, Exact, ExactValues, SIZE};
    pub use super::fit::interpolated;
    pub use super::rounding::rounding;
    pub use super::split::{Landmarks, LimitZero};
    pub use super::zeros::{ContactMode, Zero, Zeros, contact_modes};
}

#[cfg(test)]
mod held_tests;
#[cfg(test)]
mod tests;
