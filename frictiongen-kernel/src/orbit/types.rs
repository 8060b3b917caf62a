//! A steady state, its segments, and the bounds of the search for it.

use crate::contact::sums::Chain;
use crate::motion::{Contact, ContactState, Setting};
use crate::number::scalar::Float;

/// Upper bound on the segments of a cycle.  A period of several cycles may have this number for each of its cycles.  A
/// steady state with more segments is not reported.
pub const MAX_SEGMENTS: usize = 64;

/// Upper bound on the cycles followed from rest or from a given state before the search gives up.
pub const MAX_CYCLES: u32 = 1024;

/// Upper bound on the steps of all walks of one search.  Ordinary scenes need far fewer.  Modes a thousand times as
/// fast as the excitation would need as many in every cycle.
pub const MAX_STEPS: u32 = 1 << 20;

/// The start of a segment of the period.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentStart<S> {
    /// State of the contact at the start, with the phase of the excitation within its cycle.
    pub(super) contact_state: ContactState<S>,
    /// Cycle of the start, counted from that of the first mark.
    pub(super) cycle: S,
    /// Length of the segment in τ.
    pub(super) length: S,
    /// z̄ at the start.
    pub(super) relative: S,
    /// Number of following segments that are not stored.  Those segments are computed again from this one.
    pub(super) more: u32,
}

impl<S: Float> SegmentStart<S> {
    /// Returns a mark of zeros, to initialise arrays.
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

    /// z̄ at the end of a segment in which the contact sticks, or `None` if the contact slides.  While the contact
    /// sticks, z̄ at the end equals z̄ at the start to the last digit.
    pub(super) fn stuck_at(&self) -> Option<S> {
        (self.contact_state.contact == Contact::Stuck).then_some(self.relative)
    }
}

/// A steady state: a motion that repeats after one cycle of the excitation, or after [`Orbit::period`] cycles.
///
/// `P` owns the oscillators, `V` the scalars of memory ([`numbers`](super::numbers)), and `C` the multipliers, two for each mode that
/// the contact drives.  All three are arrays in emitted code and vectors at run time.  `K`, the constants of the chain,
/// selects the law of the contact.
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
    /// Largest |offset| of the contact's motion in a continuum of steady states, if known.
    pub(super) offset_range: Option<S>,
    /// The excitation's phase in half-turns at τ = 0, which is the end of a maximum of z̄.  `origin_cycle` is its
    /// cycle, as in [`SegmentStart`].
    pub(super) origin: S,
    pub(super) origin_cycle: S,
}
