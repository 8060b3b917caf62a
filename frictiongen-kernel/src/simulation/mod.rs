//! The exact motion in time: closed forms between events, and events located to rounding.
//!
//! The motion is not integrated in time steps.  The simulation searches for the next event, which is a zero of the
//! relative velocity, or the instant at which the contact force reaches μβ.

mod run;

pub use run::{FixedLinesSimulation, FixedSimulation, MAX_STRETCHES, Moment, Segment, Simulation};

pub use crate::motion::{
    Constant, Contact, Dynamics, Event, HeldMode, Level, Lines, MAX_STEEPNESS, MAX_STEPS, Part,
    Setting,
};
