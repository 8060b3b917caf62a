//! Motions over time: displacements, velocities and the friction force at evenly spaced instants, and every event.
//!
//! Samples are closed-form values, and events are exact. A history is a run from rest or from a state, or one period of a
//! steady state. Displacement over velocity of the same samples is the phase portrait.

mod run;
mod spectrum;
mod steady;

pub use spectrum::{SpectralLine, Spectrum};

use crate::{Error, Of, OutOfDomain};
use frictiongen_kernel::simulation::{Contact, Event};
use std::f64::consts::TAU;

/// The most samples of all motions of a history together, and the most cycles that are skipped.
pub const MOST_SAMPLES: u64 = 10_000_000;

/// The most events of a history.
const MOST_EVENTS: usize = 1_000_000;

/// What is asked of a run in time.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryRequest {
    /// Whose motions.
    pub of: Vec<Of>,
    /// The state at τ = 0, a maximum of the excitation: x̄ and dx̄/dτ of every mass. From rest where there is none.
    pub from: Option<(Vec<f64>, Vec<f64>)>,
    /// The load's amplitude in the scene's units, P or Y: the speeds of `friction: stribeck` need it.
    pub amplitude: Option<f64>,
    /// How many cycles of the excitation are passed before the first sample.
    pub skip: u64,
    /// How many cycles are sampled, at least 1.
    pub cycles: u32,
    /// How many samples a cycle has: an even number.
    pub samples: u32,
}

impl HistoryRequest {
    /// The first ten cycles from rest, with 200 samples each.
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

/// Why there is no history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum HistoryError {
    /// No cycle is asked for.
    NoCycle,
    /// The samples of a cycle are not an even number from 2 on.
    Samples,
    /// More than [`MOST_SAMPLES`] samples of all motions together.
    TooManySamples,
    /// More than [`MOST_SAMPLES`] cycles are skipped.
    TooManySkipped,
    /// More than a million events, or so many free vibrations in a cycle that they cannot be followed.
    TooManyEvents,
    /// The scene has no mass at this place.
    NoSuchMass(usize),
    /// What a solver refuses: a frequency ratio of 0 or ∞, a state that is not finite, no steady state.
    Solver(Error),
}

impl std::fmt::Display for HistoryError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoCycle => write!(f, "a motion over time needs at least one cycle"),
            Self::Samples => write!(f, "the samples of a cycle are an even number from 2 on"),
            Self::TooManySamples => write!(
                f,
                "more than {MOST_SAMPLES} samples of all motions together, the most there may be"
            ),
            Self::TooManySkipped => {
                write!(f, "at most {MOST_SAMPLES} cycles can be skipped")
            }
            Self::TooManyEvents => write!(
                f,
                "the contact has more than {MOST_EVENTS} events, or the masses vibrate too often in a cycle to be followed"
            ),
            Self::NoSuchMass(index) => write!(f, "the scene has no mass at place {index}"),
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
/// The first sample is at a maximum of the excitation, the last one at another; between them are whole cycles.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// How many cycles were passed before the first sample; 0 for a steady state.
    pub skipped: u64,
    /// How many cycles of the excitation it has: the period of a steady state.
    pub cycles: u32,
    /// How many samples a cycle has.
    pub samples: u32,
    /// The motions asked for, in their order.
    pub tracks: Vec<Track>,
    /// The friction force over P at each sample, for base motion over k₁Y: the kinetic one while the contact slides, what
    /// holds it while it sticks; positive against positive sliding.
    pub friction: Vec<f64>,
    /// Whether the contact sticks at each sample, or which way it slides.
    pub contact: Vec<Contact>,
    /// Every stop, break-away and reversal between the first sample and the last.
    pub events: Vec<HistoryEvent>,
}

/// The motion of the contact or of a mass over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Whose motion.
    pub of: Of,
    /// x̄ at each sample: over P/k₁, for base motion over Y.
    pub displacement: Vec<f64>,
    /// dx̄/dτ at each sample; times ω it is a velocity.
    pub velocity: Vec<f64>,
}

/// An event of the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryEvent {
    /// When: τ = ωt, from the start of the run.
    pub tau: f64,
    /// What happens.
    pub event: Event,
    /// What the contact does from then on.
    pub contact: Contact,
    /// x̄ of each motion asked for, in their order.
    pub displacements: Vec<f64>,
}

impl History {
    /// Room for whole cycles with their last instant.
    fn new(skipped: u64, cycles: u32, samples: u32, of: &[Of]) -> Self {
        let room = cycles as usize * samples as usize + 1;
        Self {
            skipped,
            cycles,
            samples,
            tracks: of.iter().map(|of| Track::new(*of, room)).collect(),
            friction: Vec::with_capacity(room),
            contact: Vec::with_capacity(room),
            events: Vec::new(),
        }
    }

    /// Adds a sample; of the motions in their order, displacement and velocity.
    fn push(&mut self, motions: impl Iterator<Item = (f64, f64)>, contact: (Contact, f64)) {
        for (track, (displacement, velocity)) in self.tracks.iter_mut().zip(motions) {
            track.displacement.push(displacement);
            track.velocity.push(velocity);
        }
        self.contact.push(contact.0);
        self.friction.push(contact.1);
    }

    /// How many instants there are: those of all cycles, and the last one's end.
    #[must_use]
    pub fn len(&self) -> usize {
        self.contact.len()
    }

    /// Whether there are none, which never is so.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.contact.is_empty()
    }

    /// τ = ωt of a sample, from the start of the run.
    #[must_use]
    pub fn tau(&self, index: usize) -> f64 {
        let samples = u64::from(self.samples.max(1));
        let index = index as u64;
        let cycles = self.skipped.saturating_add(index / samples);
        // The whole cycles apart, so that a sample has the same phase in each.
        TAU * (cycles as f64) + phase(index % samples, samples)
    }

    /// The motion of the contact or of a mass, if it was asked for.
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

    /// The displacements of whole cycles, the end of the last one left out.
    fn whole(&self) -> &[f64] {
        self.displacement.split_last().map_or(&[], |(_, rest)| rest)
    }

    /// The largest |x̄| of the samples, which may lie below that of the motion.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let sizes = self.displacement.iter().map(|value| value.abs());
        sizes.fold(0.0, f64::max)
    }

    /// The root of the mean square of x̄ over the cycles.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let values = self.whole();
        let squares: f64 = values.iter().map(|value| value * value).sum();
        (squares / values.len().max(1) as f64).sqrt()
    }
}

/// τ of a sample within its cycle.
fn phase(index: u64, samples: u64) -> f64 {
    TAU * (index as f64) / (samples as f64)
}

/// Nothing, if so many samples of these motions are to be had.
fn check(of: &[Of], masses: usize, cycles: u32, samples: u32) -> Result<(), HistoryError> {
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
    let unknown = of.iter().find_map(|of| match of {
        Of::Mass(index) if masses <= *index => Some(*index),
        _ => None,
    });
    unknown.map_or(Ok(()), |index| Err(HistoryError::NoSuchMass(index)))
}
