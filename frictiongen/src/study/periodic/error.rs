//! The reasons why the search finds no steady state under a periodic load.

use crate::study::error::no_such_motion;
use crate::{Of, OutOfDomain};
use std::fmt;

/// The reason why the search finds no steady state under a periodic load.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PeriodicError {
    /// The table of the load has fewer than three samples.
    Short,
    /// A sample, a time step or an amplitude is not finite, or a time step or a frequency is not positive.
    Number,
    /// The last sample of a table differs from the first sample. The last sample must repeat the first sample, because
    /// the load is periodic.
    Open(f64, f64),
    /// The mean acceleration or velocity of the base is not 0. The base would then not return to its position. The
    /// fields are the name of the quantity and its mean.
    Drifts(&'static str, f64),
    /// The list of harmonics is empty.
    NoHarmonics,
    /// A harmonic of the load has an order above 1000.
    Order(u32),
    /// The load is a force, but the base of the scene moves.
    BaseMoves,
    /// The load is a base motion, but a force on a mass drives the scene.
    BaseAtRest,
    /// The description has `input: hold`, which is possible only for a table of forces.
    Held,
    /// The period of the load needs more steps than the search permits.
    Long,
    /// The scene does not have the mass or the spring of the requested motion.
    NoSuchMotion(Of),
    /// The stepper rejects a number of the request, for example a negative friction force.
    Step(OutOfDomain),
    /// The motion from rest does not settle to a period of at most 64 periods of the load.
    NotSteady,
}

impl fmt::Display for PeriodicError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Short => "one period needs at least three samples",
            Self::Number => {
                "the samples and amplitudes must be finite, and the time between samples and the frequency above 0"
            }
            Self::Open(first, last) => {
                return write!(
                    f,
                    "the period does not close: its first sample is {first} and its last one {last}; end the table with the sample with which the next period begins"
                );
            }
            Self::Drifts(quantity, mean) => {
                let belt = match *quantity {
                    "velocity" => "compute the motion of a belt in time (`drive`), or ",
                    _ => "",
                };
                return write!(
                    f,
                    "the period does not close: the mean {quantity} of the base is {mean}, so the base does not come back; {belt}subtract the mean"
                );
            }
            Self::NoHarmonics => "a sum of harmonics needs at least one harmonic",
            Self::Order(order) => {
                return write!(f, "the order {order} of a harmonic is above 1000");
            }
            Self::BaseMoves => {
                "the excitation of the scene is the base; give its motion in m, m/s, m/s2 or g, not a force"
            }
            Self::BaseAtRest => {
                "the excitation of the scene is a mass; give the force on it in N, not a motion of the base"
            }
            Self::Held => {
                "a motion of the base cannot be held between samples; leave `input: hold` out of the description"
            }
            Self::Long => {
                "the period needs more than 65536 steps of the fastest mode; give fewer samples or a shorter period"
            }
            Self::NoSuchMotion(of) => return no_such_motion(f, *of),
            Self::Step(error) => return error.fmt(f),
            Self::NotSteady => {
                "the motion from rest repeats neither after one period of the load nor after up to 64"
            }
        })
    }
}

impl std::error::Error for PeriodicError {}

impl From<OutOfDomain> for PeriodicError {
    fn from(error: OutOfDomain) -> Self {
        Self::Step(error)
    }
}
