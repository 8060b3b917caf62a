//! State of the contact, the events that change it, and the segments of the motion between two events.

use crate::number::scalar::Float;

/// State of the contact: stuck, or sliding in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Contact {
    /// The contact sticks.
    Stuck,
    /// The contact slides with positive relative velocity.
    Forward,
    /// The contact slides with negative relative velocity.
    Backward,
}

impl Contact {
    /// Returns the sign of the relative velocity: 1, −1, or 0 while the contact sticks.
    pub(crate) fn sign<S: Float>(self) -> S {
        S::constant(match self {
            Self::Stuck => 0.0,
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        })
    }

    /// Returns the state of a contact that slides in the direction of a force.
    pub(crate) fn along<S: Float>(force: S) -> Self {
        if force < S::constant(0.0) {
            Self::Backward
        } else {
            Self::Forward
        }
    }

    /// Returns the state of a contact that slides in the negative direction if `negative` is true, otherwise in the
    /// positive direction.
    pub(crate) fn towards(negative: bool) -> Self {
        if negative {
            Self::Backward
        } else {
            Self::Forward
        }
    }

    /// Returns the opposite direction of sliding. A stuck contact stays stuck.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Stuck => Self::Stuck,
            Self::Forward => Self::Backward,
            Self::Backward => Self::Forward,
        }
    }
}

/// Event that ends a segment of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Event {
    /// The contact stops and sticks.
    Stop,
    /// The stuck contact breaks away.
    Slip,
    /// The direction of sliding changes without a stop.
    Reversal,
}

/// State of the contact at an instant of the motion.
#[derive(Clone, Copy, Debug)]
pub struct ContactState<S> {
    /// The excitation's phase in half-turns (units of π rad), in [0, 2).
    pub t: S,
    /// State of the contact: stuck, or its direction of sliding.
    pub contact: Contact,
    /// Number that the contact stores at the start of a segment, or `None`. If the contact starts to slide from zero
    /// velocity, the number is the relative acceleration in the direction of sliding. If an elastic contact sticks,
    /// the number is the contact force divided by P.
    pub memory: Option<S>,
    /// True if the contact has just failed to start sliding. A contact force that exceeds μβ only by rounding must then
    /// not make the contact slide a second time.
    pub wedged: bool,
}

impl<S: Float> ContactState<S> {
    /// Returns the state of a contact that sticks at the phase `t`.
    pub(crate) fn stuck(t: S) -> Self {
        Self {
            t,
            contact: Contact::Stuck,
            memory: None,
            wedged: false,
        }
    }
}

/// End of a segment of the motion: its length, its event, and the state of the contact after the event.
#[derive(Clone, Copy, Debug)]
pub struct SegmentEnd<S> {
    /// Length of the segment in rad of the excitation (τ).
    pub tau: S,
    /// Event that ends the segment, or `None` if the segment ends without an event.
    pub event: Option<Event>,
    /// State of the contact after the event.
    pub contact_state: ContactState<S>,
    /// Slope, at the event, of the function whose zero is the event. If the contact slides in the segment, the function
    /// is the relative velocity z̄′, and the slope is z̄″ just before the event. If the contact sticks, the function is
    /// the contact force.
    pub slope: S,
    /// Jump of the contact force at the event: the force before the event minus the force after the event.
    pub jump: S,
    /// Number of steps of the search that found the end of the segment.
    pub steps: u32,
}

/// A segment of the motion whose end the search has found. The oscillators are still in their state at the start of the
/// segment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sought<S> {
    /// State of the contact at the segment's start.
    pub contact_state: ContactState<S>,
    /// Length of the segment in rad of the excitation (τ).
    pub tau: S,
    /// If the contact sticks in the segment, the displacement that stays constant: z̄ for a rigid contact, and the
    /// displacement of the slider for an elastic contact.
    pub offset: S,
    /// The way in which the segment ends.
    pub outcome: SegmentOutcome,
    /// Slope of the contact force at the end of the segment, if the contact sticks.
    pub slope: S,
    /// Number of steps of the search that found the end of the segment.
    pub steps: u32,
}

/// The way in which a segment of the motion ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SegmentOutcome {
    /// No event ends the segment within the searched time.
    Goes,
    /// The segment ends because the relative velocity of the contact reaches 0.
    Halts,
    /// The segment ends because the force in the stuck contact reaches its bound. The contact then slides in the given
    /// direction.
    Breaks(Contact),
    /// The segment has the length 0, because the contact cannot start to move from zero velocity.
    Holds,
}

impl<S: Float> Sought<S> {
    /// Creates a segment whose end is still unknown.
    pub(crate) fn none(contact_state: ContactState<S>) -> Self {
        let zero = S::constant(0.0);
        Self {
            contact_state,
            tau: zero,
            offset: zero,
            outcome: SegmentOutcome::Goes,
            slope: zero,
            steps: 0,
        }
    }

    /// Returns true if the contact cannot start to move from zero velocity. The contact then sticks.
    pub(crate) fn holds(&self) -> bool {
        self.outcome == SegmentOutcome::Holds
    }
}
