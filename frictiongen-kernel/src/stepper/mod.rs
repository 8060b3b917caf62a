//! The motion under a force that is known sample by sample, in steps of a fixed length.
//!
//! A step is cut into equal sub-intervals, called `parts` in the code.  A sub-interval is so short that no oscillator
//! turns by more than a radian in it.  A power series over a sub-interval therefore converges, and its cost is bounded.
//!
//! Over a sub-interval the input is a polynomial, and each oscillator has a closed-form response.  A constant table
//! takes the oscillator's state from the start of the sub-interval to its end.  Where the contact certainly keeps
//! sliding, or certainly keeps sticking, the motion over the sub-interval is one product with that table.
//!
//! Otherwise the stepper searches the sub-interval for events, and follows the motion in *pieces* between them.  The
//! contact's velocity, or the force that keeps the contact stuck, is then a power series about an instant.  The
//! simulation's walk finds the first zero of that series.  The *stuck chain* is the chain whose contact sticks.  The
//! code calls its modes `held`.  Section 11 of docs/derivation.md derives the method.

mod account;
mod advance;
mod cost;
mod dot;
mod drive;
mod elastic;
mod events;
mod input;
mod interval;
mod law;
mod now;
mod pace;
mod reaction;
mod rigid;
mod rows;
mod run;
mod saved;
mod scene;
mod sliding;
mod state;
mod sticking;
mod stuck_force;
mod table;
mod turned;
mod types;

pub use account::Work;
pub use cost::{Cost, Extent};
pub use drive::Sample;
pub use input::Input;
pub use pace::Pace;
pub use rows::{HeldRow, HeldStep, ModeStep, Row};
pub use saved::Saved;
pub use scene::{StepScene, Units};
pub use state::{FixedStore, Store, StoreMut, StoreRef};
pub use table::{Channel, FixedTables, HeldLoad, Tables, View, fill, series_terms};
pub use types::{ContactNow, FixedStepper, MassNow, Stepped, Stepper};

/// Upper bound on the events that the stepper follows in one sub-interval of a step.  After this number of events, a
/// contact at rest stays stuck for the rest of the sub-interval, and a sliding contact slides without friction.
pub const MAX_EVENTS: u32 = 8;

/// Upper bound on the pieces of motion that the stepper follows in one sub-interval of a step.  A piece ends at an
/// event, or where the speed reaches the next straight line of the friction law.  It also ends where the power series
/// of a steep law stops converging.
pub const MAX_STRETCHES: u32 = 8 * MAX_EVENTS;

/// Upper bound on the sub-intervals of one step.
pub const MAX_PARTS: u32 = 1024;
