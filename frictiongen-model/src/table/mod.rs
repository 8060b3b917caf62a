//! Tables with a declared accuracy, built from the exact functions of a scene.
//!
//! Polynomials approximate the limit of continuous motion β_lim over intervals of r that are as long as the accuracy
//! allows. Near a known zero r₀ of β_lim the polynomial is fitted to β_lim/(r − r₀). The limit of sliding β*_lim, |V|
//! and the responses while the contact is stuck are written as products over their zeros and poles. A check compares
//! the tables with the exact values at points that the fit did not use, in the arithmetic of the tables. A proof can
//! cover all r between these points.

mod check;
mod cover;
mod digits;
mod errors;
mod exact;
mod fit;
mod held;
mod held_build;
mod held_zeros;
mod index;
mod kinks;
mod product;
mod proof;
mod proportional;
mod quotients;
mod reach;
mod request;
mod shares;
mod split;
mod tables;
mod verified;
mod worst;
mod zeros;

pub use errors::FRICTION_SHARES;
pub use fit::Fitted;
pub use held::{Held, HeldForm};
pub use index::Index;
pub use product::Product;
pub use proof::{Evidence, Proof, Work};
pub use reach::Reach;
pub use request::{COARSEST, FINEST, FINEST_PROVEN, FINEST_SINGLE, Request, TableError};
pub use tables::{Report, Tables};
pub use worst::Worst;

#[cfg(test)]
mod held_tests;
#[cfg(test)]
mod tests;
