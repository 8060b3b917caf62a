//! Computes the motion of a chain step by step, under an input that is known at samples. The input consists of the
//! forces on the masses and of the motion of the base. All time steps have equal length.
//!
//! The stepper divides a step into equal sub-intervals, called `parts` in the code. It computes the motion of
//! oscillators: the modes of the chain, or the modes of the *stuck chain* (the chain with its contact stuck). The code
//! calls the modes of the stuck chain `held`. In a sub-interval no oscillator advances by more than one radian. A
//! power series of the motion over a sub-interval therefore needs few terms, and its cost is bounded.
//!
//! Over a sub-interval the input is a polynomial, and the response of each oscillator has a closed form. A constant
//! table advances the state of the oscillator from the start of the sub-interval to its end. If the contact provably
//! keeps sliding, or provably keeps sticking, one product with this table gives the motion.
//!
//! In every other case the stepper searches the sub-interval for events (stops, break-aways and reversals). Between
//! two events it follows the motion in one or more *pieces*. In a piece, the velocity of the sliding contact, or the
//! force in the stuck contact, is a power series about the start of the piece. The piece ends at an event if this
//! velocity reaches zero, or if this force reaches μF. The search for this instant is the same as in a simulation
//! ([`motion`](crate::motion)). Section 11 of docs/derivation.md derives the method.

mod account;
mod advance;
mod budget;
mod cost;
mod dot;
mod drive;
mod elastic;
mod events;
mod graze;
pub(crate) mod image;
mod input;
#[cfg(feature = "event-times")]
mod instant;
mod interval;
mod law;
pub(crate) mod now;
mod pace;
mod periodic;
mod reaction;
mod rigid;
mod rows;
mod run;
pub(crate) mod saved;
mod scene;
mod sliding;
mod state;
mod sticking;
mod stuck_force;
mod table;
mod turned;
mod types;
#[cfg(feature = "serde")]
mod written;

pub use account::Work;
pub use cost::{Cost, Extent};
pub use drive::Sample;
pub use image::{image_bytes, image_step};
pub use input::Input;
pub use pace::Pace;
pub use rows::{HeldRow, HeldStep, ModeStep, Row};
pub use saved::Saved;
pub use scene::{StepScene, Units};
pub use state::{FixedStore, Store, StoreMut, StoreRef};
pub use table::{Channel, FixedTables, HeldLoad, StepTables, View, fill, series_terms};
pub use types::{ContactNow, DeclaredStepper, FixedStepper, MassNow, Stepped, Stepper};
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use written::NOT_FINITE;

/// Largest number of events (stops, break-aways and reversals) that the stepper follows in one sub-interval of a step
/// without an event budget. After these events the stepper ends the sub-interval without a search. A contact at rest
/// then stays stuck for the rest of the sub-interval, if its force does not exceed μF. In every other case the
/// friction force is constant for the rest of the sub-interval. The stepper chooses this force so that the contact
/// moves as little as possible.
pub const MAX_EVENTS: u32 = 8;

/// Largest number of pieces of motion that the stepper follows in one sub-interval of a step without an event budget.
/// A piece ends at an event. It also ends when the speed reaches the next straight line of a friction law over the
/// speed. Under a steep law a piece also ends where its power series stops converging. The rule that ends a
/// sub-interval without a search counts as four pieces.
pub const MAX_STRETCHES: u32 = 8 * MAX_EVENTS;

/// Largest number of sub-intervals in one step of a stepper.
pub const MAX_PARTS: u32 = 1024;
