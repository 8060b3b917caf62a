//! Exact motion as a function of time. Between events of the contact the motion has a closed form. The simulation
//! computes the instants of the events to the precision of the number type.
//!
//! The simulation makes no time steps, but searches for the next event. An event is a zero of the relative velocity, or
//! the instant at which the force in the stuck contact reaches μβ.

mod run;

pub use run::{FixedLinesSimulation, FixedSimulation, MAX_STRETCHES, Moment, Segment, Simulation};

pub use crate::motion::{
    Constant, Contact, Dynamics, Event, HeldMode, KineticLaw, Lines, MAX_STEEPNESS, MAX_STEPS,
    MotionSetting, Part,
};
