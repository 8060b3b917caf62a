//! Memory of a run, and the state of a contact.

use super::Series;
use crate::number::scalar::Float;

/// What a contact does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Phase {
    /// The level is 0 or below: the contact transmits no force.
    #[default]
    Free,
    /// Sticks.  An elastic contact then loads or unloads its spring.
    Stuck,
    /// Slides with a positive relative velocity.
    Positive,
    /// Slides with a negative relative velocity.
    Negative,
}

impl Phase {
    /// Returns the phase of a contact that slides in the direction of `velocity`.
    pub(super) fn along<T: Float>(velocity: T) -> Self {
        if velocity < T::constant(0.0) {
            Self::Negative
        } else {
            Self::Positive
        }
    }
    /// Returns the sign of the relative velocity, 0 for a contact that does not slide.
    #[must_use]
    pub fn sign(self) -> i8 {
        match self {
            Self::Free | Self::Stuck => 0,
            Self::Positive => 1,
            Self::Negative => -1,
        }
    }
    /// Returns `value` times [`sign`](Self::sign).
    pub(super) fn signed<T: Float>(self, value: T) -> T {
        match self {
            Self::Free | Self::Stuck => T::constant(0.0),
            Self::Positive => value,
            Self::Negative => -value,
        }
    }
}

/// State of a contact between two stretches.
#[derive(Clone, Copy, Debug)]
pub struct JointState<T> {
    /// What the contact does.
    pub phase: Phase,
    /// Force of the contact.  An elastic contact remembers it.
    pub force: T,
    /// Relative displacement at which a rigid contact sticks.
    pub place: T,
    /// True from an event of this contact until time goes on.
    pub(super) fresh: bool,
    /// Where the contact has its next event within the stretch, if it has one.
    pub(super) next: Option<Found<T>>,
}

/// An event of a contact within a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found<T> {
    /// The instant, from 0 to 1 over the stretch.
    pub(super) at: T,
    /// What happens.
    pub(super) kind: Kind,
}

/// What happens to a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The force reaches μF in the direction of the phase.
    Breaks(Phase),
    /// The slider comes to rest.
    Stops,
    /// The level falls to 0.
    Opens,
    /// The level rises above 0.
    Closes,
}

impl<T: Float> Default for JointState<T> {
    fn default() -> Self {
        let zero = T::constant(0.0);
        Self {
            phase: Phase::Free,
            force: zero,
            place: zero,
            fresh: false,
            next: None,
        }
    }
}

/// Memory of a run, handed in by the caller.
#[derive(Debug)]
pub struct Room<'a, T> {
    pub(super) x: &'a mut [T],
    pub(super) v: &'a mut [T],
    pub(super) acceleration: &'a mut [T],
    pub(super) displacements: &'a mut [Series<T>],
    pub(super) velocities: &'a mut [Series<T>],
    pub(super) loads: &'a mut [Series<T>],
    pub(super) forces: &'a mut [Series<T>],
    pub(super) levels: &'a mut [Series<T>],
    pub(super) joints: &'a mut [JointState<T>],
}

impl<'a, T: Float> Room<'a, T> {
    /// Divides memory among the parts of a run of `masses` masses.  Returns `None` if the slices are too short: 3N
    /// numbers and 3N + 2m series for N masses and m contacts, where m is the length of `joints`.
    pub fn of(
        masses: usize,
        numbers: &'a mut [T],
        series: &'a mut [Series<T>],
        joints: &'a mut [JointState<T>],
    ) -> Option<Self> {
        let (x, numbers) = numbers.split_at_mut_checked(masses)?;
        let (v, numbers) = numbers.split_at_mut_checked(masses)?;
        let (acceleration, _) = numbers.split_at_mut_checked(masses)?;
        let (displacements, series) = series.split_at_mut_checked(masses)?;
        let (velocities, series) = series.split_at_mut_checked(masses)?;
        let (loads, series) = series.split_at_mut_checked(masses)?;
        let (forces, series) = series.split_at_mut_checked(joints.len())?;
        let (levels, _) = series.split_at_mut_checked(joints.len())?;
        Some(Self {
            x,
            v,
            acceleration,
            displacements,
            velocities,
            loads,
            forces,
            levels,
            joints,
        })
    }

    /// Returns the bytes of a run of `masses` masses and `joints` contacts.
    #[must_use]
    pub const fn bytes(masses: usize, joints: usize) -> usize {
        3 * masses * size_of::<T>()
            + (3 * masses + 2 * joints) * size_of::<Series<T>>()
            + joints * size_of::<JointState<T>>()
    }
}
