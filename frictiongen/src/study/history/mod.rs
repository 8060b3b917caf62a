//! Motions over time: displacements, velocities and the friction force at evenly spaced instants, and every event
//! (stop, break-away, reversal) of the contact.
//!
//! Samples are values of the closed form, and events are exact. A history is one of four motions: a run from rest, a
//! run from a given state, a free vibration, or one period of a steady state. A plot of displacement against velocity is
//! the phase portrait.

mod run;
mod spectrum;
mod steady;

pub use spectrum::{SpectralLine, Spectrum};

use super::error::no_such_motion;
use super::system::System;
use crate::{Error, Of, OutOfDomain};
use frictiongen_kernel::simulation::{Contact, Event};
use std::f64::consts::TAU;

/// Largest number of samples of all motions of a history together, and largest number of skipped cycles.
pub const MOST_SAMPLES: u64 = 10_000_000;

/// Largest number of events of a history.
const MOST_EVENTS: usize = 1_000_000;

/// A request for a history, which is a sampled motion over time: the requested motions, the initial state and the
/// samples.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryRequest {
    /// The motions that the history contains.
    pub of: Vec<Of>,
    /// The state at τ = 0, a maximum of the excitation: x̄ and dx̄/dτ of every mass. `None` is rest.
    pub from: Option<(Vec<f64>, Vec<f64>)>,
    /// Amplitude of the load in the scene's units, P or Y. The friction law `friction: stribeck` requires the
    /// amplitude, to convert its speeds to non-dimensional groups.
    pub amplitude: Option<f64>,
    /// Number of cycles of the excitation before the first sample.
    pub skip: u64,
    /// Number of cycles of the excitation with samples, at least 1.
    pub cycles: u32,
    /// Number of samples in a cycle, an even number.
    pub samples: u32,
}

impl HistoryRequest {
    /// Requests the motion from rest over the first ten cycles, with 200 samples in each.
    #[must_use]
    pub fn new(of: &[Of]) -> Self {
        Self {
            of: of.to_vec(),
            from: None,
            amplitude: None,
            skip: 0,
            cycles: 10,
            samples: 200,
        }
    }
}

/// A request for a free vibration: the requested motions, the initial state and the samples.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeRequest {
    /// The motions that the history contains.
    pub of: Vec<Of>,
    /// The displacement in m and the velocity in m/s of every mass at the start.
    pub from: (Vec<f64>, Vec<f64>),
    /// The time from the start to the last sample, in s.
    pub until: f64,
    /// Number of intervals between two samples, an even number.
    pub samples: u32,
}

impl FreeRequest {
    /// Requests the free vibration from a state, in m and m/s, until a time in s, with 1000 intervals between samples.
    #[must_use]
    pub fn new(of: &[Of], from: (Vec<f64>, Vec<f64>), until: f64) -> Self {
        Self {
            of: of.to_vec(),
            from,
            until,
            samples: 1000,
        }
    }
}

/// The reason why a request gives no history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum HistoryError {
    /// The request has no cycle with samples.
    NoCycle,
    /// The requested number of samples in a cycle is odd, or less than 2.
    Samples,
    /// The motions have more than [`MOST_SAMPLES`] samples together.
    TooManySamples,
    /// The request skips more than [`MOST_SAMPLES`] cycles.
    TooManySkipped,
    /// The run has more than a million events, or a cycle has too many free vibrations.
    TooManyEvents,
    /// The scene does not have the mass or the spring of the requested motion.
    NoSuchMotion(Of),
    /// A solver rejects the request: r = 0 or r = ∞, a state that is not finite, or no steady state.
    Solver(Error),
}

impl std::fmt::Display for HistoryError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoCycle => write!(f, "a motion over time needs at least one cycle"),
            Self::Samples => write!(
                f,
                "the number of samples in a cycle must be even, and 2 or more"
            ),
            Self::TooManySamples => write!(
                f,
                "all motions together have more than {MOST_SAMPLES} samples, the largest possible number"
            ),
            Self::TooManySkipped => {
                write!(f, "at most {MOST_SAMPLES} cycles can be skipped")
            }
            Self::TooManyEvents => write!(
                f,
                "the contact has more than {MOST_EVENTS} events, or the masses vibrate too often in a cycle to be followed"
            ),
            Self::NoSuchMotion(of) => no_such_motion(f, *of),
            Self::Solver(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for HistoryError {}

impl From<Error> for HistoryError {
    fn from(error: Error) -> Self {
        Self::Solver(error)
    }
}

impl From<OutOfDomain> for HistoryError {
    fn from(error: OutOfDomain) -> Self {
        Self::Solver(error.into())
    }
}

/// A motion over time, at evenly spaced instants.
///
/// The first and the last sample are at maxima of the excitation. A whole number of cycles lies between them.
///
/// A free vibration has no excitation. Its history is one cycle, with times in s in place of τ, displacements in m,
/// velocities in m/s and forces in N.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// Length of a cycle: 2π, or the length of a free vibration in s.
    pub cycle: f64,
    /// Number of cycles of the excitation before the first sample. It is 0 for a steady state.
    pub skipped: u64,
    /// Number of cycles of the excitation with samples. For a steady state it is the period.
    pub cycles: u32,
    /// Number of samples in a cycle of the excitation.
    pub samples: u32,
    /// The requested motions, in the order of the request.
    pub tracks: Vec<Track>,
    /// The friction force at each sample, divided by P (by k₁Y for base motion). While the contact slides, it is the
    /// kinetic friction force. While the contact sticks, it is the force that keeps the contact at rest. A positive
    /// force opposes positive sliding.
    pub friction: Vec<f64>,
    /// State of the contact at each sample: stuck, or sliding forward or backward.
    pub contact: Vec<Contact>,
    /// Every stop, break-away and reversal between the first sample and the last.
    pub events: Vec<HistoryEvent>,
}

/// The motion of the contact or of a mass over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The motion that the samples describe: that of the contact, of a mass, or a combination.
    pub of: Of,
    /// x̄ at each sample, where x̄ = x/(P/k₁) (x/Y for base motion).
    pub displacement: Vec<f64>,
    /// dx̄/dτ at each sample. Multiplied by ω and by P/k₁ (by ω and Y for base motion), it is the velocity.
    pub velocity: Vec<f64>,
}

/// An event of the contact in a history.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryEvent {
    /// Instant of the event, as τ = ωt since the start of the run.
    pub tau: f64,
    /// Kind of event: a stop, a break-away or a reversal.
    pub event: Event,
    /// State of the contact just after the event.
    pub contact: Contact,
    /// Displacement x̄ of each requested motion at this instant, in the order of the request.
    pub displacements: Vec<f64>,
}

impl History {
    /// Returns an empty history. It has room for the samples of all cycles, and for one more sample at the end of the
    /// last cycle.
    fn new(skipped: u64, cycles: u32, samples: u32, of: &[Of]) -> Self {
        let room = cycles as usize * samples as usize + 1;
        Self {
            cycle: TAU,
            skipped,
            cycles,
            samples,
            tracks: of.iter().map(|of| Track::new(*of, room)).collect(),
            friction: Vec::with_capacity(room),
            contact: Vec::with_capacity(room),
            events: Vec::new(),
        }
    }

    /// Adds a sample: displacement and velocity of each motion in the order of the request, and the contact's state and
    /// force.
    fn push(&mut self, motions: impl Iterator<Item = (f64, f64)>, contact: (Contact, f64)) {
        for (track, (displacement, velocity)) in self.tracks.iter_mut().zip(motions) {
            track.displacement.push(displacement);
            track.velocity.push(velocity);
        }
        self.contact.push(contact.0);
        self.friction.push(contact.1);
    }

    /// Returns the number of samples. Each cycle has the same number, and one more sample is at the end of the last
    /// cycle.
    #[must_use]
    pub fn len(&self) -> usize {
        self.contact.len()
    }

    /// Returns false, because a history always has samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.contact.is_empty()
    }

    /// Returns τ = ωt of a sample, or the time in s for a free vibration, from the start of the run.
    #[must_use]
    pub fn tau(&self, index: usize) -> f64 {
        let samples = u64::from(self.samples.max(1));
        let index = index as u64;
        let cycles = self.skipped.saturating_add(index / samples);
        // The phase within the cycle is computed separately from the whole cycles. Rounding of this phase is then the
        // same in every cycle.
        self.cycle * (cycles as f64) + self.cycle * ((index % samples) as f64) / (samples as f64)
    }

    /// Returns the samples of the motion `of`. Returns `None` if the request does not include this motion.
    #[must_use]
    pub fn track(&self, of: Of) -> Option<&Track> {
        self.tracks.iter().find(|track| track.of == of)
    }
}

impl Track {
    fn new(of: Of, room: usize) -> Self {
        Self {
            of,
            displacement: Vec::with_capacity(room),
            velocity: Vec::with_capacity(room),
        }
    }

    /// Returns the displacements of whole cycles, without the sample at the end of the last cycle.
    fn whole(&self) -> &[f64] {
        self.displacement.split_last().map_or(&[], |(_, rest)| rest)
    }

    /// Returns the largest |x̄| of all samples. Between two samples, |x̄| may be larger.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let sizes = self.displacement.iter().map(|value| value.abs());
        sizes.fold(0.0, f64::max)
    }

    /// Returns the root mean square of x̄ over whole cycles.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let values = self.whole();
        let squares: f64 = values.iter().map(|value| value * value).sum();
        (squares / values.len().max(1) as f64).sqrt()
    }
}

/// Returns the phase τ of a sample within its cycle.
fn phase(index: u64, samples: u64) -> f64 {
    TAU * (index as f64) / (samples as f64)
}

/// Checks a request. Fails if the number of cycles or samples is invalid, or if the system does not have a requested
/// motion.
fn check(system: &System, of: &[Of], cycles: u32, samples: u32) -> Result<(), HistoryError> {
    if cycles == 0 {
        return Err(HistoryError::NoCycle);
    }
    if samples < 2 || !samples.is_multiple_of(2) {
        return Err(HistoryError::Samples);
    }
    let motions = u64::try_from(of.len().max(1)).unwrap_or(u64::MAX);
    let samples = u64::from(samples).saturating_mul(cycles.into());
    if MOST_SAMPLES < samples.saturating_mul(motions) {
        return Err(HistoryError::TooManySamples);
    }
    match of.iter().find(|of| !system.has_motion(**of)) {
        Some(of) => Err(HistoryError::NoSuchMotion(*of)),
        None => Ok(()),
    }
}
