//! Tables (piecewise polynomials) for one scene in a range of frequency ratios. The results of the tables have a
//! declared accuracy.
//!
//! For one scene the limit of continuous motion β_lim depends on the frequency ratio r alone. Three other functions of
//! r give the contact's amplitude and phase at any friction ratio β. The code generator computes all four functions
//! exactly and writes [`Table`]s of them. The generator writes the limit of sliding β*_lim, and the amplitude |V| of
//! the contact without friction, as [`Quotient`]s of products. It writes the responses of the chain with its contact
//! stuck as [`HeldResponse`]s.
//!
//! [`Compiled`] is a scene at one r whose results come from its tables. If the tables do not contain a result,
//! [`Compiled`] calls the exact formulas. `frictiongen-model` builds the tables and checks their accuracy.

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
