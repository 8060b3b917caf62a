//! Law of the contact. The law decides when the contact sticks or slides, and under which force.
//!
//! [`Law`] has the forces and decisions of a law. [`ContactChain`] applies them to the modes of a chain.
//! CONTRIBUTING.md says how to add a law, under “Add a friction law”.
//!
//! | question about the contact | answered by |
//! |---|---|
//! | which force keeps it stuck | [`Law::grip`], [`ContactChain::stuck_force`], [`ContactChain::steady_stuck_force`] |
//! | what follows when it breaks away | [`ContactChain::break_away`], [`Law::break_away`] |
//! | what follows at zero relative velocity | [`ContactChain::halt`], [`Law::leave_rest`] |
//! | which force acts while it slides | [`Law::kinetic`], [`Law::kinetic_on`], [`Law::kinetic_at`] |
//! | which displacement stays constant while it sticks, and its velocity then | [`ContactChain::stuck_place`], [`ContactChain::stuck_velocity`] |
//! | how many modes the stuck chain lacks | [`ContactChain::lost_modes`] |
//! | which number it stores while it sticks | [`ContactChain::remembered`], [`ContactChain::memory_at`], [`ContactChain::memory_at_stop`] |
//! | how a deviation grows, and how it jumps at an event | [`ContactChain::carry_deviations`], [`ContactChain::stuck_multipliers`] |
//!
//! All laws use the same transformation between the modes of the chain and the modes of the chain with its contact
//! stuck (`stuck_chain`). All laws also use the same oscillators while the contact sticks and slides (`sticking`,
//! `sliding`).

mod any;
mod elastic;
pub(crate) mod kinetic;
mod law;
mod rigid;
mod sliding;
mod state;
mod sticking;
mod stuck_chain;

pub use any::AnyContact;
pub use elastic::ElasticChain;
pub use kinetic::{Constant, KineticLaw, Lines, MAX_STEEPNESS};
pub use rigid::LOST_MODES;
pub use state::{Contact, Event};

#[doc(hidden)]
pub use law::ContactChain;
pub(crate) use law::Law;
pub(crate) use state::{ContactState, SegmentEnd, SegmentOutcome, Sought};
