//! Reading a structure from measurements: recordings, the friction force in them, and a scene's parameters.
//!
//! * [`Recording`]: samples from CSV or UFF58, each channel with its unit.
//! * [`Measured`]: driving frequency, transmissibility, phase and harmonics of the steady part, with their uncertainty
//!   (thesis 4.3.3).
//! * [`System::identify`](crate::System::identify): the friction force from amplitudes, phases or both, of any mass, at one
//!   frequency or many, in any regime, with its interval, or why the measurement cannot tell it (4.5, 6.4.2).
//!
//! On a microcontroller [`crate::watch`] follows one frequency sample by sample.

mod error;
mod identify;
mod least_squares;
mod measured;
mod recording;
mod statistics;
mod steady;
mod tone;

pub use error::MeasureError;
pub use identify::{
    Datum, Estimate, Explained, Identified, IdentifyRequest, Observation, Unknown, Using, Verdict,
};
pub use measured::{Measured, Transmissibility};
pub use recording::{Channel, Column, CsvRequest, Dimension, Recording, Unit};
pub use tone::{HARMONICS, Tone};
