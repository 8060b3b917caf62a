//! Motion in time of a chain with several joints: rigid contacts, elastic contacts and dashpots.
//!
//! Between two events the chain is linear.  A [`Run`] writes the motion of a *stretch*, at most a radian of the fastest
//! mode, as power series.  It locates the first event on these series, and goes on behind it.  One code covers every
//! pattern of stuck contacts, modes of frequency 0, double roots and every damping.  After an event of a rigid contact
//! [`decide`] finds which contacts stick and which contacts go.
//!
//! The caller hands in all memory.  [`Room::of`] says how much, for N masses and m joints.

mod chain;
mod drive;
mod events;
mod first;
mod patterns;
mod room;
mod run;
mod stretch;
mod tied;

pub use chain::{Chain, Joint, Link};
pub use drive::{Drive, harmonic};
pub use patterns::{Candidate, MAX_PATTERNS, Resting, decide};
pub use room::{JointState, Phase, Room};
pub use run::{MAX_EVENTS_AT_ONCE, Run, Step, Trouble};

/// Largest number of joints of a chain that are contacts.
pub const MAX_JOINTS: usize = 16;
/// Orders of a power series that the motion uses.
pub const ORDERS: usize = 20;
/// Coefficients of a [`Series`]: those of the motion, and two more for the base's acceleration.
pub const TERMS: usize = ORDERS + 3;
/// Coefficients of a power series in u, the time since the start of a stretch over the stretch's length.
pub type Series<T> = [T; TERMS];

use crate::number::scalar::Float;

/// Returns the number of a series at `index`, or 0 where it has none.
fn term<T: Float>(series: &[T], index: usize) -> T {
    series.get(index).copied().unwrap_or(T::constant(0.0))
}

/// Returns the value of a power series at `u`.
fn value<T: Float>(series: &Series<T>, u: T) -> T {
    let terms = series.iter().take(ORDERS + 1).rev();
    terms.fold(T::constant(0.0), |sum, &term| sum * u + term)
}

/// Returns `count` as a number.
#[allow(clippy::cast_precision_loss, reason = "at most a few dozen")]
fn whole<T: Float>(count: usize) -> T {
    T::constant(count as f64)
}
