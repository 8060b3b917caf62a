//! The law of the contact: what decides when it sticks and slides, and under which force.
//!
//! The law answers the questions of this table.  CONTRIBUTING.md lists the files that depend on the answers, under “Add
//! a friction law”.
//!
//! | question | answered by |
//! |---|---|
//! | which force keeps it stuck, and how it breaks away | [`Rigid::grip`], [`Rigid::break_away`] |
//! | what follows at zero relative velocity | [`Rigid::leave_rest`] |
//! | which force acts while it slides | [`Rigid::kinetic`], [`Rigid::kinetic_on`], [`Rigid::kinetic_at`] |
//! | how the oscillators start to slide and to stick | `Setting::start_sliding`, `Setting::start_sticking` |
//! | how many modes the stuck chain has, and how states change to them and back | [`LOST_MODES`], `Dynamics::project`, `Dynamics::release` |
//! | how a deviation grows, and how it jumps at an event | [`carry_deviations`], [`STUCK_MULTIPLIERS`] |

pub(crate) mod kinetic;
mod rigid;
mod sliding;
mod state;

pub use kinetic::{Constant, Level, Lines, MAX_STEEPNESS};
pub use rigid::LOST_MODES;
pub use state::{Contact, Event};

pub(crate) use rigid::{Rigid, STUCK_MULTIPLIERS, carry_deviations};
pub(crate) use state::{ContactState, End, Outcome, Sought};
