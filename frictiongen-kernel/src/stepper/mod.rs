//! The motion under a force that nobody knows in advance, by steps of a fixed length.
//!
//! Over a step the input is a polynomial, and each oscillator answers it in closed form: what it does from the
//! step's start to its end is a constant table.  A step in which the contact certainly keeps sliding, or keeps
//! sticking, is one product with that table.  Otherwise the step is looked through: the contact's velocity, or the
//! force that holds it, is a power series about an instant, whose first zero the simulation's walk finds.
//!
//! Time is counted in parts of a step, so short that no oscillator turns by more than a radian: a part's series
//! converges, and its cost is bounded.  Section 11 of docs/derivation.md derives it.

mod account;
mod cost;
mod dot;
mod drive;
mod event;
mod input;
mod motion;
mod now;
mod pace;
mod part;
mod rows;
mod run;
mod scene;
mod state;
mod table;
mod turned;

pub use account::Work;
pub use cost::{Cost, Extent};
pub use drive::Sample;
pub use input::Input;
pub use now::{ContactNow, MassNow, Stepped};
pub use pace::Pace;
pub use rows::{HeldRow, HeldStep, ModeStep, Row};
pub use run::{FixedStepper, Stepper};
pub use scene::{StepScene, Units};
pub use state::{FixedStore, Saved, Store, StoreMut, StoreRef};
pub use table::{Channel, FixedTables, HeldLoad, Tables, View, fill, series_terms};

/// In one part of a step no more events than this are followed.  For what is left of the part the contact is held at rest.
pub const MAX_EVENTS: u32 = 8;

/// A part is followed in no more stretches than this.  An event ends one; so does the next line of the friction law, and
/// the end of what a power series reaches where that law is steep.
pub const MAX_STRETCHES: u32 = 8 * MAX_EVENTS;

/// A step is cut into no more parts than this.
pub const MAX_PARTS: u32 = 1024;
