//! Tables with a declared accuracy, built from the exact functions of a scene.
//!
//! β_lim is a piecewise polynomial, with pieces as long as the accuracy allows. Near a known zero of β_lim, the fit
//! is to the quotient of β_lim and the distance from the zero. β*_lim, |V| and the responses while the contact is
//! stuck are products over their zeros and poles. The tables are compared with the exact values in their own
//! arithmetic, at points that the fit did not use. A proof can cover all r between those points.

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
