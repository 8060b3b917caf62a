//! Types for a steady state and its segments, and the bounds of the search for a steady state.

use crate::contact::sums::Chain;
use crate::motion::{Contact, ContactState, MotionSetting};
use crate::number::scalar::Float;

/// Largest number of segments in a cycle of a reported steady state. If the period has n cycles, the largest number is
/// n times as large.
pub const MAX_SEGMENTS: usize = 64;

/// Largest number of cycles that the search follows from rest or from a given state.
pub const MAX_CYCLES: u32 = 1024;

/// Largest number of steps that the searches for events may take together in one search for a steady state. Ordinary
/// scenes need far fewer steps. A scene whose modes are a thousand times as fast as the excitation would need this
/// number in every cycle.
pub const MAX_STEPS: u32 = 1 << 20;

/// Start of one segment of the period. In a segment the contact either sticks, or slides in one direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentStart<S> {
    /// State of the contact at the start of the segment. It includes the phase of the excitation within its cycle.
    pub(super) contact_state: ContactState<S>,
    /// Number of the cycle in which the segment starts. The cycle of the first mark has the number 0.
    pub(super) cycle: S,
    /// Length of the segment in rad of the excitation (τ).
    pub(super) length: S,
    /// Relative displacement z̄ of the contact at the start of the segment.
    pub(super) relative: S,
    /// Number of further segments before the next stored segment. The code recomputes these segments from this
    /// segment.
    pub(super) more: u32,
}

impl<S: Float> SegmentStart<S> {
    /// Returns a segment start whose numbers are all 0. The code uses it to initialise arrays.
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

    /// Returns the relative displacement z̄ at the end of a segment in which a rigid contact sticks. The result is
    /// exactly the z̄ at the start. Returns `None` if the contact slides or is elastic.
    pub(super) fn stuck_at(&self) -> Option<S> {
        let rests = self.contact_state.contact == Contact::Stuck && !self.is_loaded();
        rests.then_some(self.relative)
    }

    /// Returns true if the contact is elastic and sticks in this segment. A stuck elastic contact stores its force, and
    /// its spring lets it move.
    pub(super) fn is_loaded(&self) -> bool {
        self.contact_state.contact == Contact::Stuck && self.contact_state.memory.is_some()
    }

    /// Returns true if the relative displacement z̄ may fall from a maximum in this segment. The contact then slides
    /// backward, or is an elastic contact that sticks under a positive force.
    pub(super) fn leaves_top(&self) -> bool {
        let force = self.contact_state.memory.unwrap_or(S::constant(0.0));
        match self.contact_state.contact {
            Contact::Backward => true,
            Contact::Stuck => S::constant(0.0) < force,
            Contact::Forward => false,
        }
    }
}

/// A steady state. Its motion repeats after one cycle of the excitation, or after [`Orbit::period`] cycles.
///
/// `P` owns the oscillators. `V` owns the scalars of memory ([`numbers`](super::numbers)). `C` owns the Floquet
/// multipliers: two for each mode that the contact drives, and one more for an elastic contact. All three are arrays
/// in emitted code and vectors at run time.
#[derive(Clone, Debug)]
pub struct Orbit<'a, S, P, V, C, K = Chain<S>> {
    pub(super) setting: MotionSetting<'a, S, K>,
    pub(super) parts: P,
    pub(super) numbers: V,
    pub(super) multipliers: C,
    pub(super) marks: [SegmentStart<S>; MAX_SEGMENTS],
    pub(super) count: usize,
    /// Period of the motion, in cycles of the excitation.
    pub(super) period: u32,
    pub(super) stops: usize,
    pub(super) reversals: usize,
    pub(super) symmetric: bool,
    pub(super) marginal: bool,
    pub(super) settled: bool,
    /// Relative displacement z̄ at which the motion from rest leaves a contact that never slides. The steady state is
    /// then the one with z̄ = 0 in the middle. `None` for every other steady state.
    pub(super) left_at: Option<S>,
    /// Largest absolute offset of the contact in the continuum to which this steady state belongs, if known.
    pub(super) offset_range: Option<S>,
    /// Phase of the excitation at τ = 0, in half-turns (π rad). At τ = 0 the relative displacement z̄ leaves its
    /// maximum. `origin_cycle` is the number of the cycle at τ = 0, as [`SegmentStart`] defines it.
    pub(super) origin: S,
    pub(super) origin_cycle: S,
}
