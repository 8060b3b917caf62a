//! The law of the contact.

pub(crate) mod coupled;
pub(crate) mod line;
mod lines;
mod state;
mod stuck_chain;
pub(crate) mod variational;

pub use coupled::MAX_STEEPNESS;
pub use lines::{Constant, Level, Lines};
pub use state::{Contact, Event};

pub(crate) use state::{ContactState, End, Outcome, Sought};
