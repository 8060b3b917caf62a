//! A steady state, its segments, and the bounds of the search for it.

use crate::contact::sums::Chain;
use crate::motion::{Contact, ContactState, Setting};
use crate::number::scalar::Float;

/// Upper bound on the segments of a cycle.  A period of several cycles may have this number for each of its cycles.  A
/// steady state with more segments is not reported.
pub const MAX_SEGMENTS: usize = 64;

/// Upper bound on the cycles that the search follows from rest or from a given state before it gives up.
pub const MAX_CYCLES: u32 = 1024;

/// Upper bound on the steps of all searches for events in one search for a steady state.  Ordinary scenes need far
/// fewer.  A scene whose modes are a thousand times as fast as the excitation would need that number in every cycle.
pub const MAX_STEPS: u32 = 1 << 20;

/// The start of a segment of the period.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentStart<S> {
    /// State of the contact at the start, with the phase of the excitation within its cycle.
    pub(super) contact_state: ContactState<S>,
    /// Cycle of the start, counted from the cycle of the first mark.
    pub(super) cycle: S,
    /// Length of the segment in τ.
    pub(super) length: S,
    /// Relative displacement z̄ of the contact at the start of the segment.
    pub(super) relative: S,
    /// Number of segments after this one that are not stored.  They are computed again from this one.
    pub(super) more: u32,
}

impl<S: Float> SegmentStart<S> {
    /// Returns a mark with zeros everywhere, to initialise arrays.
    pub(super) fn empty() -> Self {
        let zero = S::constant(0.0);
        Self {
            contact_state: ContactState::stuck(zero),
            cycle: zero,
            length: zero,
            relative: zero,
            more: 0,
        }
    }

    /// Returns z̄ at the end of a segment in which a rigid contact sticks.  z̄ at the end then equals z̄ at the start to the
    /// last digit.  Returns `None` if the contact slides or is elastic.
    pub(super) fn stuck_at(&self) -> Option<S> {
        let rests = self.contact_state.contact == Contact::Stuck && !self.is_loaded();
        rests.then_some(self.relative)
    }

    /// Returns true if an elastic contact sticks.  It remembers its force, and may move.
    pub(super) fn is_loaded(&self) -> bool {
        self.contact_state.contact == Contact::Stuck && self.contact_state.memory.is_some()
    }

    /// Returns true if the contact may leave a maximum of z̄ in this segment: it slides backward, or it is elastic and
    /// sticks under a positive force.
    pub(super) fn leaves_top(&self) -> bool {
        let force = self.contact_state.memory.unwrap_or(S::constant(0.0));
        match self.contact_state.contact {
            Contact::Backward => true,
            Contact::Stuck => S::constant(0.0) < force,
            Contact::Forward => false,
        }
    }
}

/// A steady state: a motion that repeats after one cycle of the excitation, or after [`Orbit::period`] cycles.
///
/// `P` owns the oscillators, `V` the scalars of memory ([`numbers`](super::numbers)), and `C` the multipliers, two for
/// each mode that the contact drives.  All three are arrays in emitted code and vectors at run time.
#[derive(Clone, Debug)]
pub struct Orbit<'a, S, P, V, C, K = Chain<S>> {
    pub(super) setting: Setting<'a, S, K>,
    pub(super) parts: P,
    pub(super) numbers: V,
    pub(super) multipliers: C,
    pub(super) marks: [SegmentStart<S>; MAX_SEGMENTS],
    pub(super) count: usize,
    /// Period in cycles of the excitation.
    pub(super) period: u32,
    pub(super) stops: usize,
    pub(super) reversals: usize,
    pub(super) symmetric: bool,
    pub(super) marginal: bool,
    pub(super) settled: bool,
    /// Largest |offset| of the contact's motion among all states of the continuum to which this state belongs, if
    /// known.
    pub(super) offset_range: Option<S>,
    /// The excitation's phase in half-turns at τ = 0, where z̄ leaves its maximum.  `origin_cycle` is the cycle of that
    /// instant, counted as in [`SegmentStart`].
    pub(super) origin: S,
    pub(super) origin_cycle: S,
}
