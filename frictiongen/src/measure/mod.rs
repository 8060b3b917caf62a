//! Measurements of a structure: recordings, friction forces from recordings, and parameters of a scene from sweeps.
//!
//! * [`Recording`]: samples from CSV or UFF58, each channel with its unit.
//! * [`Measured`]: driving frequency, transmissibility, phase and harmonics of the steady interval, with their
//!   uncertainty (thesis 4.3.3).
//! * [`System::identify`](crate::System::identify): the friction force from amplitudes, phases or both, of any mass, at
//!   one frequency or many, in any regime. It returns the force with its interval, or the reason why the measurement
//!   does not determine it (4.5, 6.4.2).
//! * [`System::free_decay`](crate::System::free_decay): friction and damping from a free vibration (4.2, 4.3).
//! * [`System::fit_sweep`](crate::System::fit_sweep): frequencies, mass and stiffness ratios from sweeps without
//!   friction (4.1, 6.15 to 6.20).
//! * [`Inputs`]: inputs of a scene's stepper, from a recording.
//! * [`Signal`]: an input in closed form, such as a step, a pulse or a chirp.
//! * [`Recording::regression`]: mass and friction of an axis that has no spring.
//!
//! On a microcontroller, [`crate::watch`] computes the amplitude of a signal at one frequency, sample by sample.

#[doc(hidden)]
pub mod columns;
mod decay;
mod drive;
mod driven;
mod error;
mod identify;
mod least_squares;
mod measured;
mod motion;
mod recording;
mod regression;
mod signal;
mod spectrum;
mod statistics;
mod steady;
mod sweep;
mod tone;

pub use decay::FreeDecay;
pub use drive::DriveSample;
pub use drive::Inputs;
#[doc(hidden)]
pub use driven::{Drive, DriveError, DrivenMotion};
pub use error::MeasureError;
pub use error::unit_of;
pub use identify::{
    Datum, Estimate, Explained, Identified, IdentifyRequest, Observation, Unknown, Using, Verdict,
};
pub use measured::{Measured, Transmissibility};
pub use motion::MotionFit;
pub use recording::{Channel, CsvColumn, CsvRequest, Dimension, Recording, Unit};
pub use regression::Regression;
pub use signal::{Signal, SignalInputs};
pub use spectrum::{PeakResponse, periods, response_spectrum};
pub use sweep::{SweepFit, SweepPoint, two_storeys};
pub use tone::HARMONICS;
pub use tone::Tone;
