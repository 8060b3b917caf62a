//! Interface between the motion of a chain and the law of its contact.
//!
//! The type of the chain's constants selects the law: [`Chain`] has a rigid contact. Motion, simulation and steady
//! states are generic over this type. A scene therefore contains only the code of its own law.

use super::kinetic::KineticLine;
use super::state::{Contact, ContactState, SegmentEnd};
use crate::contact::sums::Chain;
use crate::motion::oscillator::Part;
use crate::motion::setting::Setting;
use crate::number::complex::Complex;
use crate::number::scalar::Float;
use core::fmt::Debug;

/// The law of a contact under one kinetic friction force. All forces have the same unit.
pub trait Law<S: Float>: Copy + Debug {
    /// Returns the kinetic friction force at zero speed.
    fn level(self) -> S;

    /// Returns the largest contact force at which the contact sticks (static friction force).
    fn grip(self) -> S;

    /// Returns true if the distance of two motions never grows, whatever their initial states are.
    fn is_contraction(self) -> bool;

    /// Decides what the contact does at zero relative velocity. `force` is the force that would keep the contact at
    /// rest. Returns `None` if the contact sticks.
    fn leave_rest(self, force: S) -> Option<Slide<S>>;

    /// Returns the start of sliding when the force in the stuck contact has reached its largest value.
    fn break_away(self, contact: Contact) -> Slide<S>;

    /// Returns the start of sliding in the direction of `contact`. `force` is the force that would keep the contact at
    /// rest.
    #[inline]
    fn slide(self, contact: Contact, force: S) -> Slide<S> {
        Slide {
            contact,
            excess: force.abs() - self.level(),
        }
    }

    /// Returns the force in a stuck contact, limited to the largest force at which the contact sticks.
    fn limited(self, force: S) -> S {
        force.abs().min(self.grip()).copysign(force)
    }

    /// Returns true if the force in a stuck contact is so near its largest value that rounding decides whether the
    /// contact slides. `share` is the distance that counts as near, relative to the largest value.
    fn is_marginal(self, force: S, share: S) -> bool {
        let grip = self.grip();
        (force.abs() - grip).abs() <= grip * share
    }

    /// Returns the contact force while the contact slides under constant kinetic friction.
    #[inline]
    fn kinetic(self, contact: Contact) -> S {
        contact.sign::<S>() * self.level()
    }

    /// Returns the contact force on a line of the friction law, as a level and a slope over the relative velocity.
    #[inline]
    fn kinetic_on(self, line: &KineticLine<S>, contact: Contact) -> [S; 2] {
        let sign: S = contact.sign();
        [sign * self.level() * line.level, self.level() * line.slope]
    }

    /// Returns the contact force while the contact slides at a speed on a line of the friction law.
    #[inline]
    fn kinetic_at(self, line: &KineticLine<S>, contact: Contact, speed: S) -> S {
        contact.sign::<S>() * (self.level() * (line.level + line.slope * speed))
    }
}

/// Constants of a chain and of the law of its contact.
pub trait ContactChain<S: Float>: Copy + Debug {
    /// The law of the contact.
    type Law: Law<S>;

    /// Returns the number of modes that the chain loses while the contact sticks.
    fn lost_modes(&self) -> usize;

    /// Returns the number of scalars that the contact remembers while it sticks, in addition to the state of the modes.
    #[inline]
    fn remembered(&self) -> usize {
        0
    }

    /// Returns the Floquet multipliers of a contact that never slides: two for each lost mode, and one for each
    /// remembered scalar.
    fn stuck_multipliers(&self) -> &'static [f64];

    /// Returns the compliance of a spring in series with the contact: its displacement per unit of contact force.
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

    /// Returns the number that the contact remembers after it stops. `Contact` is the direction in which it slid.
    /// `None` if the law remembers nothing.
    #[inline]
    fn memory_at_stop(_: &Setting<'_, S, Self>, _: Contact) -> Option<S> {
        None
    }

    /// Returns the number that a contact remembers while it sticks at the displacement `place`. `stuck_modes` are the
    /// oscillators of the chain with its contact stuck. `at` is sine and cosine of the excitation's phase at the same
    /// instant.
    #[inline]
    fn memory_at(_: &Setting<'_, S, Self>, _: &[Part<S>], _: S, _: (S, S)) -> Option<S> {
        None
    }

    /// Adapts the oscillators of the chain with its contact stuck to the number that the contact remembers. `lifted` is
    /// the displacement of the stuck contact, including the displacement of the base.
    #[inline]
    fn adapt(_: &Setting<'_, S, Self>, _: &mut [Part<S>], _lifted: S, _: &ContactState<S>) {}

    /// Returns the constants of the chain that do not depend on the law of the contact.
    fn chain(&self) -> &Chain<S>;

    /// Returns the law for a kinetic friction force and a ratio μ of the static to the kinetic force.
    fn law_with(&self, level: S, stiction: S) -> Self::Law;

    /// Returns the law for a kinetic friction force, with the μ of the chain.
    #[inline]
    fn law(&self, level: S) -> Self::Law {
        self.law_with(level, self.chain().stiction)
    }

    /// Returns the displacement that stays constant while the contact sticks. `contact_state` is the state at the
    /// segment's start. `at` is sine and cosine of the excitation's phase at the same instant.
    fn stuck_place(
        setting: &Setting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Returns the relative velocity z̄′ while the contact sticks. `at` is sine and cosine of the excitation's phase.
    fn stuck_velocity(setting: &Setting<'_, S, Self>, modes: &[Part<S>], at: (S, S)) -> S;

    /// Returns the contact force over P while the contact sticks. `contact_state` is the state of the contact at the
    /// start of the segment.
    fn stuck_force(
        setting: &Setting<'_, S, Self>,
        modes: &[Part<S>],
        contact_state: &ContactState<S>,
        at: (S, S),
    ) -> S;

    /// Returns the constant and the fundamental component of the contact force while the contact sticks at the
    /// displacement `place`. The contribution of the modes is left out.
    fn steady_stuck_force(setting: &Setting<'_, S, Self>, place: S) -> (S, Complex<S>);

    /// Handles the end of a segment at which the relative velocity vanishes. Sets the slope, the event, the jump of the
    /// force and the next state.
    fn halt(setting: &Setting<'_, S, Self>, modes: &[Part<S>], at: (S, S), end: &mut SegmentEnd<S>);

    /// Handles the end of a segment at which the stuck contact breaks away. Sets the event, the jump of the force and
    /// the next state.
    fn break_away(setting: &Setting<'_, S, Self>, contact: Contact, end: &mut SegmentEnd<S>);

    /// Advances deviations of the modes' states through a segment, column after column, with y and u in turn. `modes`
    /// and `stuck_modes` are the oscillators after the segment. The function overwrites the states in `stuck_modes`.
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
    /// Force that would keep the contact at rest, minus the kinetic friction force.
    pub excess: S,
}
