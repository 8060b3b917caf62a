//! Piecewise polynomials (tables) for one scene in a range of frequency ratios. Their results have a declared accuracy.
//!
//! For one scene the limit of continuous motion β_lim is a function of r alone. Three further functions of r give the
//! contact's amplitude and phase at any β. The code generator computes all four functions exactly and writes [`Table`]s
//! of them. The generator writes the limit of sliding β*_lim and |V| (amplitude of the contact without friction) as
//! [`Quotient`]s of products. The generator writes the responses of the chain with its contact stuck as
//! [`HeldResponse`]s.
//!
//! [`Compiled`] is a scene at one r whose results come from its tables. [`Compiled`] calls the exact formulas for all
//! results that the tables do not contain. `frictiongen-model` builds the tables and checks their accuracy.

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
