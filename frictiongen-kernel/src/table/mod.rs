//! Answers of a declared accuracy: over a range of r a scene's limits are piecewise polynomials.
//!
//! For one scene β_lim is a function of r alone, and so are the three functions from which the contact's amplitude
//! and phase follow at any β.  A generator knows them exactly and writes [`Table`]s of them; β*_lim and |V| are
//! [`Quotient`]s of products, and so are the responses while the contact is stuck, as [`HeldResponse`]s.  [`Compiled`] is
//! a scene at one r that answers from them, and passes on to the exact formulas what they do not hold.  How tables are
//! built, and how far they are from the exact values, is not known here.

mod compiled;
mod held;
mod motion;
mod pieces;
mod quotient;
mod sticking;

pub use compiled::{Compiled, Domain, Tabled};
pub use held::{HeldResponse, Root, Transfer};
pub use motion::{ContactTable, Moving, SteadyContact, TabledMotion};
pub use pieces::{Piece, Table, polynomial};
pub use quotient::{Factor, Quotient};
pub use sticking::{Sticking, TabledStuck};
