//! Motion of a chain between two events of the contact, and the events themselves. Simulation, stepper and steady
//! states use this module.
//!
//! While the contact slides, every mode of the chain moves independently under a constant friction force. The *stuck
//! chain* is the chain with its contact stuck. While the contact sticks, every mode of the stuck chain moves
//! independently. Emitted code calls the modes of the stuck chain `held`. A [`Part`] is one oscillator in time: a mode
//! of the chain or of the stuck chain.
//!
//! A *series* is a function of time that describes the contact, such as its velocity or its force. A *walk* is a search
//! for the first zero of a series. `contact` has the law of the contact, which decides what follows an event.

mod clock;
pub(crate) mod contact;
mod dynamics;
mod oscillator;
mod segment;
mod series;
mod setting;
mod walk;

pub use contact::{
    AnyContact, Constant, Contact, ContactChain, ElasticChain, Event, KineticLaw, LOST_MODES,
    Lines, MAX_STEEPNESS,
};
pub use dynamics::{Dynamics, HeldMode};
pub use oscillator::Part;
pub use series::MAX_STEPS;
pub use setting::MotionSetting;

pub(crate) use clock::{Clock, Total, phase};
pub(crate) use contact::kinetic::{KineticLine, line, line_at, steepest};
pub(crate) use contact::{ContactState, Law, Sought};
pub(crate) use dynamics::{lift, rotated};
pub(crate) use segment::{ended, leap, seek, span};
pub(crate) use series::{OscillatorSum, Power, ROUNDINGS as SUM_ROUNDINGS, TERMS, WALK};
pub(crate) use walk::{WalkResult, WalkStart, first_reach, first_zero};
