//! The seam between the motion of a chain and the law of its contact.
//!
//! The constants of a chain select the law by their type: [`Chain`] has a rigid contact.  Motion, simulation and steady
//! states are generic over that type, so that a scene has the code of its own law only.

use super::kinetic::KineticLine;
use super::state::{Contact, ContactState, SegmentEnd};
use crate::contact::sums::Chain;
use crate::motion::oscillator::Part;
use crate::motion::setting::Setting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use core::fmt::Debug;

/// The law of a contact under one kinetic friction force.  All its forces have one unit.
pub trait Law<S: Float>: Copy + Debug {
    /// Kinetic friction force at zero speed.
    fn level(self) -> S;

    /// Largest contact force that keeps the contact stuck.
    fn grip(self) -> S;

    /// Returns true if two motions never move apart.
    fn is_contraction(self) -> bool;

    /// Decides what follows at zero relative velocity.  `force` would keep the contact at rest.  Returns `None` if the
    /// contact sticks.
    fn leave_rest(self, force: S) -> Option<Slide<S>>;

    /// The start of sliding where the force in the stuck contact has reached its largest value.
    fn break_away(self, contact: Contact) -> Slide<S>;

    /// The start of sliding in a direction, where `force` would keep the contact at rest.
    #[inline]
    fn slide(self, contact: Contact, force: S) -> Slide<S> {
        Slide {
            contact,
            excess: force.abs() - self.level(),
        }
    }

    /// A force in the stuck contact, limited to the largest that keeps the contact stuck.
    fn limited(self, force: S) -> S {
        force.abs().min(self.grip()).copysign(force)
    }

    /// Returns true if a force that holds the contact is so near its largest value that rounding decides.  `share` is
    /// the distance, relative to the largest value.
    fn is_marginal(self, force: S, share: S) -> bool {
        let grip = self.grip();
        (force.abs() - grip).abs() <= grip * share
    }

    /// The contact force while the contact slides under constant kinetic friction.
    #[inline]
    fn kinetic(self, contact: Contact) -> S {
        contact.sign::<S>() * self.level()
    }

    /// Level and slope of the contact force over the relative velocity, on a line of the kinetic friction.
    #[inline]
    fn kinetic_on(self, line: &KineticLine<S>, contact: Contact) -> [S; 2] {
        let sign: S = contact.sign();
        [sign * self.level() * line.level, self.level() * line.slope]
    }

    /// The contact force while the contact slides at this speed, on a line of the kinetic friction.
    #[inline]
    fn kinetic_at(self, line: &KineticLine<S>, contact: Contact, speed: S) -> S {
        contact.sign::<S>() * (self.level() * (line.level + line.slope * speed))
    }
}

/// Constants of a chain and of the law of its contact.
pub trait ContactChain<S: Float>: Copy + Debug {
    /// The law of the contact.
    type Law: Law<S>;

    /// Number of modes that the chain loses while the contact sticks.
    fn lost_modes(&self) -> usize;

    /// Number of scalars that the contact remembers while it sticks, in addition to the state of the modes.
    #[inline]
    fn remembered(&self) -> usize {
        0
    }

    /// Floquet multipliers of a contact that never slides: two for each lost mode, and one for each remembered scalar.
    fn stuck_multipliers(&self) -> &'static [f64];

    /// Compliance of a spring in series with the contact: its displacement per unit of contact force.
    #[inline]
    fn compliance(&self) -> S {
        S::constant(0.0)
    }

    /// Derives the contact's state from the motion alone, at the phase `t`.
    fn contact_state(setting: &Setting<'_, S, Self>, parts: &[Part<S>], t: S) -> ContactState<S>;

    /// Derives the contact's state from the motion and from a state in which the contact slides.
    #[inline]
    fn sliding_state(
        setting: &Setting<'_, S, Self>,
        parts: &[Part<S>],
        contact_state: &ContactState<S>,
    ) -> ContactState<S> {
        Self::contact_state(setting, parts, contact_state.t)
    }

    /// Returns the number that the contact remembers after it stops, if it slid in this direction.  `None` if the law
    /// remembers nothing.
    #[inline]
    fn memory_at_stop(_: &Setting<'_, S, Self>, _: Contact) -> Option<S> {
        None
    }

    /// Returns the number that a contact remembers while it sticks at `place`.  `stuck_modes` are the oscillators of the
    /// stuck chain at this instant.  `at` is the sine and the cosine of the excitation's angle at the same instant.
    #[inline]
    fn memory_at(_: &Setting<'_, S, Self>, _: &[Part<S>], _: S, _: (S, S)) -> Option<S> {
        None
    }

    /// Adapts the oscillators of the stuck chain to what the contact remembers.  `lifted` is the displacement of the
    /// stuck contact including the base's.
    #[inline]
    fn adapt(_: &Setting<'_, S, Self>, _: &mut [Part<S>], _lifted: S, _: &ContactState<S>) {}

    /// Constants of the chain that do not belong to the law.
    fn chain(&self) -> &Chain<S>;

    /// The law under a kinetic friction force and a ratio μ of the static to the kinetic one.
    fn law_with(&self, level: S, stiction: S) -> Self::Law;

    /// The law under a kinetic friction force.
    #[inline]
    fn law(&self, level: S) -> Self::Law {
        self.law_with(level, self.chain().stiction)
    }

    /// Displacement that stays constant while the contact sticks.  `contact_state` is that of the segment's start, and
    /// `at` the sine and the cosine of the excitation's angle then.
    fn stuck_place(
        setting: &Setting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Relative velocity z̄′ while the contact sticks.  `at` is the sine and the cosine of the excitation's angle.
    fn stuck_velocity(setting: &Setting<'_, S, Self>, modes: &[Part<S>], at: (S, S)) -> S;

    /// The contact force over P while the contact sticks.  `contact_state` is the state of the contact at the start of
    /// the segment.
    fn stuck_force(
        setting: &Setting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Constant and fundamental component of the contact force while the contact sticks at `place`.  The share of the
    /// stuck chain's modes is left out.
    fn steady_stuck_force(setting: &Setting<'_, S, Self>, place: S) -> (S, Complex<S>);

    /// Sets slope, event, jump and next state at the end of a segment, where the relative velocity vanishes.
    fn halt(setting: &Setting<'_, S, Self>, modes: &[Part<S>], at: (S, S), end: &mut SegmentEnd<S>);

    /// Sets event, jump and next state at the end of a segment, where the stuck contact breaks away.
    fn break_away(setting: &Setting<'_, S, Self>, contact: Contact, end: &mut SegmentEnd<S>);

    /// Takes deviations of the modes' states (y and u in turn, column after column) through a segment.  `modes` and
    /// `stuck_modes` are the oscillators after the segment.  The states in `stuck_modes` are overwritten.
    fn carry_deviations(
        setting: &Setting<'_, S, Self>,
        oscillators: (&[Part<S>], &mut [Part<S>]),
        contact_state: &ContactState<S>,
        end: &SegmentEnd<S>,
        columns: &mut [S],
    );
}

/// Start of sliding, from rest or from a stuck contact.
#[derive(Clone, Copy, Debug)]
pub struct Slide<S> {
    /// Direction of sliding.
    pub contact: Contact,
    /// Excess over the kinetic force of the force that would keep the contact at rest.
    pub excess: S,
}
