//! Functions of the contact between two events, such as its velocity or its force. Each function is a sum over
//! oscillators or a power series.

mod local;
mod power;
mod sum;

pub use local::MAX_STEPS;

pub(crate) use local::{Local, LocalSeries, ROUNDINGS, Walked};
pub(crate) use power::{Power, TERMS, WALK};
pub(crate) use sum::OscillatorSum;
